#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs inside the new root of run.sh: a given command, or both commands of
# README.md, followed by versions, times and digests of results for a comparison
# between two Debian releases.
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive
apt-get -qq update
apt-get -qq install -y --no-install-recommends git >/dev/null
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/ideotype"
[ $# -eq 0 ] || exec "$@"

rm -rf results
start=$SECONDS
./quickstart.sh
quick=$((SECONDS - start))
code=0
./test.sh 2>&1 | tee "$here/test.log" || code=$?

echo
. /etc/os-release
echo "$PRETTY_NAME, $(git describe --tags --always)"
dpkg-query -W -f '${Package} ${Version}\n' g++ cmake libembree-dev libhdf5-dev \
    libopenmpi-dev libcli11-dev libtomlplusplus-dev slurmctld python3
tests/debian/digests.sh build/release/src/ideotype
echo "quickstart.sh: $quick s; test.sh: $((SECONDS - start - quick)) s"
grep -E 'tests passed|[0-9]+ (passed|failed)' "$here/test.log" || true
exit $code
