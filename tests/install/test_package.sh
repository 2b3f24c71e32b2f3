#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A program outside the project links the library that find_package(ideotype)
# finds.
. "$(dirname "$0")/../cli/common.sh"
export CMAKE_GENERATOR=Ninja  # generator of the presets; there may be no make
build=$4

expect 0 cmake --install "$build" --prefix "$folder/prefix"
# The installed library must not depend on files of the build.
mv prefix elsewhere
cp -r "$project/analysis/examples" .
consumer=(cmake -S examples -B built -DCMAKE_PREFIX_PATH="$folder/elsewhere"
    "${@:5}")
expect 0 "${consumer[@]}"
expect 0 cmake --build built
for example in 07_mesh 13_responses 18_field; do
    expect 0 "built/$example"
done
says "^12,0.2[0-9]*,0.3[0-9]*"  # of 18_field: level leaves absorb more
expect 1 "${consumer[@]}" -DVERSION=0.0.1
says 'compatible with requested version "0.0.1"'

# pkg-config finds the same library, and its version agrees with the macros.
for option in "${@:5}"; do
    case $option in
    -DCMAKE_CXX_COMPILER=*) compiler=${option#*=} ;;
    -DCMAKE_CXX_FLAGS=*) flags=${option#*=} ;;
    -DVERSION=*) version=${option#*=} ;;
    esac
done
PKG_CONFIG_PATH=$(dirname "$(find "$folder/elsewhere" -name ideotype.pc)")
export PKG_CONFIG_PATH
[ "$(pkg-config --modversion ideotype)" = "$version" ] ||
    fail "ideotype.pc is not of version $version"
read -ra words < <(echo "$flags" "$(pkg-config --cflags --libs ideotype)")
expect 0 "$compiler" -std=c++20 examples/18_field.cpp "${words[@]}" -o field
expect 0 ./field
says "^12,0.2[0-9]*,0.3[0-9]*"
IFS=. read -r major minor patch <<<"$version"
cat >version.cpp <<CPP
#include <ideotype/version.hpp>
static_assert(IDEOTYPE_VERSION_MAJOR == $major);
static_assert(IDEOTYPE_VERSION_MINOR == $minor);
static_assert(IDEOTYPE_VERSION_PATCH == $patch);
CPP
expect 0 "$compiler" -std=c++20 -fsyntax-only version.cpp "${words[@]}"
