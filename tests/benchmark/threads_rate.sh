#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Evaluations per second of `run --threads N` beside `mpirun -n N+1`, one after
# the other and in turns, since other programs may use the machine:
# threads_rate.sh IDEOTYPE CAMPAIGN [THREADS=2] [REPETITIONS=7] [KEY=VALUE...]
# Prints the wall and processor time of each, and the medians of the ratios.
set -euo pipefail
ideotype=$(realpath "$1")
campaign=$2
threads=${3:-2}
repetitions=${4:-7}
settings=(--set stop.generations=6 --set replicates=1)
for setting in "${@:5}"; do settings+=(--set "$setting"); done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
    OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1 \
    OMPI_MCA_hwloc_base_binding_policy=none \
    PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe \
    PRTE_MCA_hwloc_default_binding_policy=none
TIMEFORMAT='%R %U %S'

# Runs the command $2... and prints its evaluations per second, from the log,
# and the wall and processor time of the whole command [s].
measure() {
    local rate seconds
    rm -rf "$folder/out"
    { time "${@:2}" run "$campaign" "${settings[@]}" --out "$folder/out" \
        "${extra[@]}" >"$folder/log" 2>&1; } 2>"$folder/time" ||
        { cat "$folder/log" >&2; exit 1; }
    rate=$(grep -o "[0-9.]* evaluations per second" "$folder/log" | tail -n 1 | cut -d ' ' -f 1)
    read -r -a seconds <"$folder/time"
    echo "$1 $rate ${seconds[0]} $(echo "${seconds[1]} + ${seconds[2]}" | bc)"
}

echo "kind evaluations/s wall[s] processor[s]"
for _ in $(seq "$repetitions"); do
    extra=(--threads "$threads")
    measure threads "$ideotype"
    extra=()
    measure ranks mpirun -n $((threads + 1)) "$ideotype"
done | tee "$folder/table"
median() {
    sort -g | awk '{ all[NR] = $1 } END { print all[int((NR + 1) / 2)] }'
}
for column in 2 3 4; do
    paste -d ' ' <(grep ^threads "$folder/table") <(grep ^ranks "$folder/table") |
        awk -v c=$column '{ print $c / $(c + 4) }' | median
done | paste -s -d ' ' | awk '{ print "threads / ranks, medians of pairs: rate " \
    $1 ", wall " $2 ", processor " $3 }'
