#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures the share of their time in which workers evaluate: a sweep of 6 latitudes and 20
# generations, all cases in one job and one case after the other, these also
# with three times as many plants under way as there are ranks, in streams.
# Usage: tests/stress/worker_share.sh [RANKS...]    with preset dev or release
# PATHS (light paths per randomisation) and POPULATION set how long it takes.
set -euo pipefail
cd "$(dirname "$0")/../.."
ideotype=${IDEOTYPE:-$PWD/build/release/src/ideotype}
[ -x "$ideotype" ] || ideotype=$PWD/build/dev/src/ideotype
[ $# -gt 0 ] || set -- 3 5 9
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
    OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1 \
    OMPI_MCA_hwloc_base_binding_policy=none \
    PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe \
    PRTE_MCA_hwloc_default_binding_policy=none
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r campaigns/plants "$folder"

campaign=$folder/latitudes.toml
{
    printf 'name = "latitudes"\nseed = 1\n'
    for latitude in 0 12 24 36 48 60; do
        printf '[[site]]\nname = "north%s"\nlatitude = %s\n' $latitude $latitude
        printf 'longitude = 0\nutc_offset = 0\n'
    done
    cat <<TOML
[[day]]
date = 2025-06-21
start = 06:00:00
end = 18:00:00
step_minutes = 60
[[spacing]]
row = 0.762
plant = 0.1524
[field]
rows = 6
plants = 6
[plant]
baseline = "crops/maize.toml"
[light]
paths = ${PATHS:-4096}
randomisations = 8
[search]
optimizer = "ga"
population = ${POPULATION:-50}
[stop]
generations = 20
[final]
candidates = 3
TOML
} >"$campaign"

# Seconds that all workers spent on evaluations. Copied outcomes are excluded;
# their attempt is 0.
evaluating() {
    local file group
    for file in "$1"/latitudes/*.h5; do
        for group in evaluations final; do
            paste <(h5dump -y -w 1 -d /$group/attempt "$file" | values) \
                <(h5dump -y -w 1 -d /$group/seconds "$file" | values)
        done
    done | awk '$1 > 0 { sum += $2 } END { print sum }'
}
values() {
    awk '/DATA \{/ { on = 1; next } /\}/ { on = 0 } on { print $1 + 0 }'
}

# $1 ranks, $2 a name, the rest commands' options, one run for each
measure() {
    local ranks=$1 name=$2 began each
    shift 2
    began=$(date +%s.%N)
    for each in "$@"; do
        # The option is a word or two.
        # shellcheck disable=SC2086
        mpirun -n "$ranks" "$ideotype" run "$campaign" $each \
            --out "$folder/$ranks$name" >"$folder/log"
    done
    awk -v ranks="$ranks" -v name="$name" -v began="$began" \
        -v ended="$(date +%s.%N)" -v sum="$(evaluating "$folder/$ranks$name")" \
        'BEGIN { wall = ended - began
                 printf "%5d  %-12s %8.1f %13.1f %7.1f %%\n", ranks, name,
                     wall, sum, 100 * sum / (ranks - 1) / wall }'
}

echo "ranks  cases          wall/s  evaluating/s   share"
for ranks in "$@"; do
    measure "$ranks" together ""
    cases=("--case 0" "--case 1" "--case 2" "--case 3" "--case 4" "--case 5")
    measure "$ranks" one-by-one "${cases[@]}"
    measure "$ranks" streams \
        "${cases[@]/%/ --set search.streams=$(((3 * ranks + 99) / 100))}"
done
