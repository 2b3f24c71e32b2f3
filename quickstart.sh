#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# From a fresh Debian 12 or 13 to an optimised canopy: installs missing packages,
# builds, runs a quick campaign on all cores and writes its report. It can be run
# again: finished parts are not repeated.
#
#     ./quickstart.sh [FOLDER]     # of the results; default: results
set -euo pipefail
case ${1:-} in
-h | --help)
    sed -n '3,7s/^# \{0,1\}//p' "$0"
    exit
    ;;
-*)
    echo "$0: there is no option $1; see $0 --help" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")"
. .ci/install

install_packages
cmake --preset release >build-release.log 2>&1 || { cat build-release.log; exit 1; }
cmake --build --preset release
rm -f build-release.log

campaign=campaigns/quickstart.toml
out=${1:-results}
ideotype=build/release/src/ideotype
export IDEOTYPE_PYTHON=$PWD/.venv/bin/python

echo
"$ideotype" check "$campaign"
echo
"$ideotype" run "$campaign" --out "$out" --resume || {
    status=$?
    echo "to use another folder than $out: $0 FOLDER" >&2
    exit "$status"
}

# Reports draw plants with the compiled module. The extras are those of commands
# in the manual: crate, environments, fit, indices and weather.
install_python release crate,environments,fit,sensitivity,weather
echo
"$ideotype" summary "$out/quickstart"
echo
"$ideotype" report "$out/quickstart" -o "$out/quickstart/report"
echo
echo "open $(cd "$out/quickstart/report" && pwd)/report.html"
