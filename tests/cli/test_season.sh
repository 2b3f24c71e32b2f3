#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests a season of weather: results are bitwise equal for any number of ranks,
# and after a kill.
. "$(dirname "$0")/common.sh"
write_campaign season 8 40
give_season season
expect 0 "$ideotype" check campaigns/season.toml
says "suns of 3 of 10 dates"
says "Ames .* july  *10 .* MJ m-2 .* %"

expect 0 "$ideotype" run campaigns/season.toml --out whole
whole=$(history_of whole season july)
expect 0 mpirun -n 3 "$ideotype" run campaigns/season.toml --out ranks
same_results "$whole" "$(history_of ranks season july)"

# same_after_kill WHOLE FOLDER [OPTION...]
same_after_kill() {
    local run=("$ideotype" run campaigns/season.toml --out "$2" "${@:3}")
    "${run[@]}" >killed.log 2>&1 &
    local job=$! left
    for _ in $(seq 200); do
        left=$("$ideotype" check campaigns/season.toml --left --out "$2" "${@:3}" |
            cut -f 2)
        [ "${left:-0}" -lt 40 ] || break
        sleep 0.05
    done
    kill -KILL $job || fail "it had ended: $(cat killed.log)"
    wait $job || true
    expect 0 mpirun -n 2 "${run[@]}" --resume
    same_results "$1" "$(history_of "$2" season july)"
}
same_after_kill "$whole" killed

# After a kill an atlas restores its cells from the history.
atlas=(--set search.optimizer=atlas --set
    'search.axes=[{quantity="lai", range=[1, 9], cells=4}, {quantity="plant_height", range=[1, 4], cells=3}]')
expect 0 "$ideotype" run campaigns/season.toml --out atlas "${atlas[@]}"
says "the best of [0-9]* kinds of plants"
expect 0 mpirun -n 3 "$ideotype" run campaigns/season.toml --out atlas3 "${atlas[@]}"
same_results "$(history_of atlas season july)" "$(history_of atlas3 season july)"
same_after_kill "$(history_of atlas season july)" atlas_killed "${atlas[@]}"

# The history contains all input data, so that no weather file is needed.
mkdir alone
cp "$whole" alone/history.h5
rm -r campaigns
expect 0 "$ideotype" evaluate alone/history.h5 --best
