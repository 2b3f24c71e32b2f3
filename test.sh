#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs missing packages, builds, and runs all unit tests and a test of each
# guarantee of the contract. `./test.sh --all` also runs the long tests: of kills,
# SLURM, scale, browsers, the manual and the study. Other arguments are options of
# ctest.
set -euo pipefail
cd "$(dirname "$0")"
. .ci/install

packages=(libgtest-dev libgmock-dev hdf5-tools procps chromium)
targets=(all) label=(-LE long) mark=(-m "not long")
is_all=no
if [ "${1:-}" = --all ]; then
    shift
    is_all=yes
    packages+=(libbenchmark-dev slurmctld slurmd slurm-client munge
        doxygen "libsimgrid-dev?")
    targets+=(measurements) label=() mark=(--hypothesis-profile=long)
fi
install_packages "${packages[@]}"
cmake --preset dev >build-dev.log 2>&1 || { cat build-dev.log; exit 1; }
cmake --build --preset dev --target "${targets[@]}"
rm -f build-dev.log
install_python dev test,docs,lint

[ $is_all = no ] || docs/build
# Tests spend half of their time waiting for ranks, browsers and clusters.
processes=$(($(nproc) + 1))
ctest --preset dev --timeout 600 --parallel $processes "${label[@]}" "$@"
IDEOTYPE_EXECUTABLE=$PWD/build/dev/src/ideotype \
    .venv/bin/python -m pytest -q --numprocesses $processes "${mark[@]}" \
    --dist loadfile --no-loadscope-reorder tests/analysis
