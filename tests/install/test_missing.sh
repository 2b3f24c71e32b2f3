#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The build lists all missing libraries in one message.
. "$(dirname "$0")/../cli/common.sh"
export CMAKE_GENERATOR=Ninja  # generator of the presets; there may be no make

# Expects an exit code ($1) with an option ($2); the rest are missing libraries.
configure() {
    local without=()
    for library in "${@:3}"; do
        without+=("-DCMAKE_DISABLE_FIND_PACKAGE_$library=ON")
    done
    rm -rf built
    expect "$1" cmake -S "$project" -B built "$2" "${without[@]}"
}

configure 1 -DIDEOTYPE_PROGRAM=ON embree CLI11 HDF5
says "^ *Embree 3 or 4$"
says "^ *HDF5 with its high-level library$"
says "^ *CLI11$"
says "apt install libembree-dev libcli11-dev libhdf5-dev$"
says "dnf install embree-devel cli11-devel hdf5-devel$"
says "spack install embree cli11 hdf5+hl$"
says "conda-forge embree cli11 hdf5$"
configure 1 -DIDEOTYPE_PROGRAM=ON MPI OpenSSL fmt glm \
    tomlplusplus Eigen3 nlohmann_json
says "apt install libglm-dev libfmt-dev libssl-dev libeigen3-dev libtomlplusplus-dev libopenmpi-dev openmpi-bin nlohmann-json3-dev$"
configure 0 -DIDEOTYPE_PROGRAM=ON GTest
says "GoogleTest is missing: tests are not built$"
# Without the program, the library does not need most of them.
configure 0 -DIDEOTYPE_PROGRAM=OFF tomlplusplus MPI HDF5 CLI11 \
    nlohmann_json
