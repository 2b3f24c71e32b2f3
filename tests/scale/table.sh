#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Efficiency on a simulated cluster: see README.md.
# Usage: tests/scale/table.sh [RANKS...]    after a build of preset dev
# EVALUATIONS for each worker in a generation of all cases; GENERATIONS.
set -euo pipefail
cd "$(dirname "$0")/../.."
[ $# -gt 0 ] || set -- 64 256 1024 4096 10000
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
echo " ranks  cases masters population  each/ms   wall/s master/% efficiency/%"
for ranks in "$@"; do
    for cases in ${CASES:-1 15 75}; do
        population=$((${EVALUATIONS:-16} * ranks / cases))
        for evaluation in ${SECONDS_EACH:-.005 .025 .1}; do
            build/dev/tests/scale/scale --log=root.thres:error \
                --ranks "$ranks" --cases "$cases" --evaluation "$evaluation" \
                --population $((population > 100 ? population : 100)) \
                --generations "${GENERATIONS:-3}" --folder "$folder/histories"
        done
    done
done
