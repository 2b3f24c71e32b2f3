#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds, and runs every test.
set -euo pipefail
cd "$(dirname "$0")"
. .ci/install

install_packages libgtest-dev libgmock-dev libbenchmark-dev hdf5-tools \
    slurmctld slurmd slurm-client munge procps chromium doxygen \
    "libsimgrid-dev?"
cmake --preset dev >build-dev.log 2>&1 || { cat build-dev.log; exit 1; }
cmake --build --preset dev
rm -f build-dev.log
install_python dev test,docs,lint

docs/build
# Tests wait for ranks, browsers and clusters half of the time.
processes=$(($(nproc) + 1))
ctest --preset dev --timeout 600 --parallel $processes "$@"
IDEOTYPE_EXECUTABLE=$PWD/build/dev/src/ideotype \
    .venv/bin/python -m pytest -q --numprocesses $processes \
    --dist loadfile --no-loadscope-reorder tests/analysis
