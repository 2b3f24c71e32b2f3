#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Results are bitwise equal for a single process, for mpirun, and for any number
# of ranks, including more ranks than candidates.
. "$(dirname "$0")/common.sh"

write_campaign same 8 3
# Each evaluation determines the number of its paths.
sed -i '/^\[light\]/,/^\[search\]/ {
    s/^paths = .*/paths = 4096/
    s/^randomisations = .*/randomisations = 8\ntolerance = 0.01/
}' campaigns/same.toml
# same_for_ranks "RANKS..." FOLDER [OPTION...]
same_for_ranks() {
    "$ideotype" run campaigns/same.toml --out "$2" "${@:3}"
    for ranks in $1; do
        mpirun -n "$ranks" "$ideotype" run campaigns/same.toml \
            --out "$2$ranks" "${@:3}"
        same_results "$(history_of "$2" same)" "$(history_of "$2$ranks" same)"
    done
}
# The number of ranks affects only the order of answers, so that one number is
# enough for each further optimizer. Streams occupy more ranks than a generation
# has plants. The tenth generation of auto is the last with response surfaces.
same_for_ranks "1 2 5 12" alone
same_for_ranks 5 auto --set search.optimizer=auto --set stop.generations=12
same_for_ranks 5 nsga2 --set search.optimizer=nsga2 \
    --set objective.minimise=lai
same_for_ranks 12 streams --set search.optimizer=auto --set search.streams=3
axes='{quantity="lai", range=[1, 9], cells=4}, {quantity="plant_height", range=[1, 4], cells=3}'
axes+=', {quantity="top_leaf_angle", range=[0, 90], cells=3}'
same_for_ranks 5 atlas --set search.optimizer=atlas --set "search.axes=[$axes]"
same_for_ranks 5 sobol --set search.optimizer=sobol
same_for_ranks 5 mixture --set 'band=[{name="nir"}]' \
    --set 'component=[{name="weed", crop="crops/sorghum.toml", rows=[2], free=["width"]}]'

# Growing plants: without water on several ranks, with water on several threads.
write_campaign grown 4 2
give_growth grown
for leaves in grown wet; do
    with=()
    [ $leaves = grown ] ||
        with=(--set 'water={limit=400}' --set photosynthesis.model=collatz)
    "$ideotype" run campaigns/grown.toml --out $leaves "${with[@]}"
    many=(mpirun -n 5 "$ideotype" run campaigns/grown.toml)
    [ $leaves = grown ] ||
        many=("$ideotype" run campaigns/grown.toml --threads 5)
    "${many[@]}" --out $leaves-many "${with[@]}"
    same_results "$(history_of $leaves grown july)" \
        "$(history_of $leaves-many grown july)"
done

# A different seed must make the comparison fail.
sed -i 's/seed = 7/seed = 8/' campaigns/same.toml
"$ideotype" run campaigns/same.toml --out other >/dev/null
if (same_results "$(history_of alone same)" "$(history_of other same)") \
    >/dev/null 2>&1; then
    fail "another seed gave the same results"
fi

# Commands that cannot share work among ranks are refused, with a single
# message.

# $1 a pattern of the message, the rest a command
refused_once() {
    local code=0
    mpirun -n 3 "$ideotype" "${@:2}" >refused.log 2>&1 || code=$?
    [ $code -eq 2 ] || fail "'${*:2}' ended with $code: $(cat refused.log)"
    [ "$(grep -c "ideotype: .*$1" refused.log)" -eq 1 ] ||
        fail "'${*:2}' is not refused once: $(cat refused.log)"
}
write_campaign one 8 3
for command in check evaluate; do
    refused_once "$command: 3 copies" $command campaigns/one.toml
done
refused_once "status: 3 copies" status alone

# Ranks started by the launcher of another MPI cannot find each other, as reported
# once; here its variables take the place of that launcher.
foreign=PMI
! is_mpich || foreign=OMPI_COMM_WORLD
for command in "run campaigns/one.toml --out apart" "serve campaigns/one.toml"; do
    # shellcheck disable=SC2086  # words
    expect 2 env ${foreign}_RANK=0 ${foreign}_SIZE=2 "$ideotype" $command
    says "^ideotype: 2 ranks were started but cannot find each other"
    # shellcheck disable=SC2086  # words
    expect 0 env ${foreign}_RANK=1 ${foreign}_SIZE=2 "$ideotype" $command
    [ ! -s out.log ] || fail "reported twice: $(cat out.log)"
done
[ ! -e apart ] || fail "something was begun"
