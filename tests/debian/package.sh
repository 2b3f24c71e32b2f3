#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds Debian packages in a root of a Debian, and installs and tries them in
# another root, which is new:
#
#     tests/debian/package.sh SUITE [DIRECTORY]      # such as trixie
#
# Has the requirements of run.sh. The roots are DIRECTORY/build and
# DIRECTORY/bare (/tmp/ideotype-package-SUITE); a second run keeps the first of
# them, with ccache. Packages will be in DIRECTORY.
set -euo pipefail
suite=${1:?usage: tests/debian/package.sh SUITE [DIRECTORY]}
folder=${2:-/tmp/ideotype-package-$suite}
here=$(cd "$(dirname "$0")" && pwd)

mkdir -p "$folder"
rm -f "$folder/build/srv/packages"/*.deb
"$here/run.sh" "$suite" "$folder/build" \
    env CCACHE_DIR=/srv/ccache .ci/deb /srv/packages
cp "$folder"/build/srv/packages/ideotype_*.deb "$folder"

rm -rf "$folder/bare"
"$here/run.sh" "$suite" "$folder/bare" true
cp "$folder"/build/srv/packages/*.deb "$folder/bare/srv"
"$here/run.sh" "$suite" "$folder/bare" tests/debian/try_package.sh /srv
