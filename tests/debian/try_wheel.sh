#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs a wheel of .ci/wheel on a system that has no Embree, no compiler and
# no MPI, and breeds with pycma there:
#
#     cp dist/*.whl dist/SHA256SUMS /tmp/bare/srv/    # once the root is there
#     tests/debian/run.sh bookworm /tmp/bare tests/debian/try_wheel.sh /srv/*.whl
set -euo pipefail
wheel=${1:?usage: tests/debian/try_wheel.sh WHEEL}
(cd "$(dirname "$wheel")" && sha256sum --check SHA256SUMS)
apt-get -qq install -y --no-install-recommends python3-venv >/dev/null
for command in c++ mpirun; do
    ! command -v "$command" || { echo "$command is there" >&2; exit 1; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
time "$folder/venv/bin/pip" install --quiet --disable-pip-version-check \
    "$wheel" "cma>=4.0"
grep PRETTY_NAME /etc/os-release
"$folder/venv/bin/python" --version
time "$folder/venv/bin/python" analysis/examples/10_pycma.py
