#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A program outside of this project links what find_package(ideotype) finds.
. "$(dirname "$0")/../cli/common.sh"
export CMAKE_GENERATOR=Ninja  # as the presets; there may be no make
build=$4

expect 0 cmake --install "$build" --prefix "$folder/prefix"
# It must not need anything from where it was built.
mv prefix elsewhere
cp -r "$project/tests/install/consumer" .
consumer=(cmake -S consumer -B built -DCMAKE_PREFIX_PATH="$folder/elsewhere"
    "${@:5}")
expect 0 "${consumer[@]}"
expect 0 cmake --build built
expect 0 built/one_mesh
says "^0.24[0-9]* +- 0.00"
expect 1 "${consumer[@]}" -DVERSION=0.0.1
says 'compatible with requested version "0.0.1"'
