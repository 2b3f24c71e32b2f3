#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A program outside of this project links what find_package(ideotype) finds.
. "$(dirname "$0")/../cli/common.sh"
export CMAKE_GENERATOR=Ninja  # generator of the presets; there may be no make
build=$4

expect 0 cmake --install "$build" --prefix "$folder/prefix"
# The installed library must not need files of its build.
mv prefix elsewhere
cp -r "$project/analysis/examples" .
consumer=(cmake -S examples -B built -DCMAKE_PREFIX_PATH="$folder/elsewhere"
    "${@:5}")
expect 0 "${consumer[@]}"
expect 0 cmake --build built
for example in 07_mesh 13_responses 18_field; do
    expect 0 "built/$example"
done
says "^12,0.2[0-9]*,0.3[0-9]*"  # of 18_field: level leaves take more
expect 1 "${consumer[@]}" -DVERSION=0.0.1
says 'compatible with requested version "0.0.1"'
