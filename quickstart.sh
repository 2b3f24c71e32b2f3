#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# From a fresh Debian 12 or 13 to an evolved canopy: installs what is missing,
# builds, runs the quick Ames campaign on all cores, writes its report.
# May be run again: finished parts are not repeated.
set -euo pipefail
cd "$(dirname "$0")"
. .ci/install

install_packages
cmake --preset release >build-release.log 2>&1 || { cat build-release.log; exit 1; }
cmake --build --preset release
rm -f build-release.log
install_python release

campaign=campaigns/ames_quick.toml
out=${1:-results}
ideotype=build/release/src/ideotype

echo
"$ideotype" check "$campaign"
echo
"$ideotype" plan "$campaign"
echo
"$ideotype" run "$campaign" --ranks auto --out "$out" --resume

echo
.venv/bin/ideotype-summary "$out/ames_quick"
echo
.venv/bin/ideotype-report "$out/ames_quick" -o "$out/ames_quick/report"
echo
echo "everything is in $(cd "$out/ames_quick" && pwd)"
