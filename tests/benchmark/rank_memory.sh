#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints the memory that the ranks of a run take, with MPI and HDF5: the peak,
# and the private, file-backed and shared parts of it; libraries are counted in
# every rank, though all share them.
# Usage: tests/benchmark/rank_memory.sh IDEOTYPE CAMPAIGN [RANKS]
set -euo pipefail
if [ $# -lt 2 ]; then
    sed -n '3,6s/^# //p' "$0" >&2
    exit 2
fi
program=$1
campaign=$2
ranks=${3:-3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

mpirun -n "$ranks" "$program" run "$campaign" --case 0 --out "$folder" \
    --wall-time 00:00:10 >"$folder/log" 2>&1 &
run=$!
# The run is long enough for each rank to evaluate many plants.
sleep 6
for pid in $(pgrep -P "$run"); do
    [ "$(readlink "/proc/$pid/exe")" -ef "$program" ] || continue
    rank=$(tr '\0' '\n' <"/proc/$pid/environ" |
        sed -n 's/^OMPI_COMM_WORLD_RANK=//p')
    awk -v rank="$rank" '
        { mib[$1] = $2 / 1024 }
        END {
            printf "rank %s: peak %.1f MiB; private %.1f, files %.1f, " \
                "shared %.1f\n", rank, mib["VmHWM:"], mib["RssAnon:"],
                mib["RssFile:"], mib["RssShmem:"]
        }' "/proc/$pid/status"
done
wait "$run" || true
