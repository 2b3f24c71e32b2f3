#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests sensitivity studies: bitwise equal results for any number of ranks and
# after a stop, rows that can be recomputed, failed rows, and refusals.
. "$(dirname "$0")/common.sh"

write_campaign study 8 3
cat >>campaigns/study.toml <<'TOML'
[sensitivity]
samples = 40
[[sensitivity.keys]]
key = "optics.leaf_reflectance"
range = [0.1, 0.65]
[[sensitivity.keys]]
key = "optics.leaf_transmittance"
range = [0.1, 0.65]
[[sensitivity.keys]]
key = "spacing.row"
range = [0.5, 0.9]
TOML
sensitivity=("$ideotype" sensitivity campaigns/study.toml)
expect 0 "${sensitivity[@]}" --out alone
says "^next: ideotype indices alone/.*.h5$"
says "all rows of the design are evaluated; evaluating the baseline"
# A study has no best plant that would be re-evaluated.
"$ideotype" status alone >>out.log
! grep -E "best|finalists|reached|re-evaluated" out.log ||
    fail "words of a search in a study"
whole=$(history_of alone study)
"$ideotype" status alone | grep ": finished, [0-9]* of [0-9]* plants in 3 generations" ||
    fail "not finished"
# The sum of both keys may exceed 1, which makes rows fail.
"$ideotype" status alone | grep -E ", [1-9][0-9]* failed" || fail "no row failed"
"$ideotype" verify "$whole"
"$ideotype" evaluate "$whole" --generation 1 --slot 20 | grep "agrees bit for bit" ||
    fail "a row cannot be computed again"
for ranks in 1 2 5 12; do
    mpirun -n $ranks "${sensitivity[@]}" --out ranks$ranks >/dev/null
    same_results "$whole" "$(history_of ranks$ranks study)"
done

# A different seed must make the comparison fail.
"${sensitivity[@]}" --set seed=8 --out other >/dev/null
if (same_results "$whole" "$(history_of other study)") >/dev/null 2>&1; then
    fail "another seed gave the same rows"
fi

# The study is stopped and resumed; no other study may overwrite it.
longer=("${sensitivity[@]}" --set sensitivity.samples=240)
"${longer[@]}" --out whole >/dev/null
mpirun -n 3 "${longer[@]}" --out drained >drain.log &
job=$!
for _ in $(seq 100); do
    [ ! -e "$(history_of drained study)" ] || break
    sleep 0.1
done
sleep 0.5
kill -USR1 $job
code=0
wait $job || code=$?
is_stopped $code || fail "a drain must end with 5, not $code: $(cat drain.log)"
grep -q -- "sensitivity campaigns/study.toml.*--resume" drain.log ||
    fail "no command to resume: $(cat drain.log)"
expect 4 "${longer[@]}" --out drained
expect 4 "$ideotype" run campaigns/study.toml --out drained --resume
says "sensitivity.samples was 240, is absent"
expect 0 "${longer[@]}" --out drained --resume
same_results "$(history_of whole study)" "$(history_of drained study)"

expect 0 "${sensitivity[@]}" --set sensitivity.method=morris \
    --set sensitivity.groups=gene --set sensitivity.samples=16 --out morris
expect 3 "${sensitivity[@]}" --set sensitivity.traits=3 --set sensitivity.levels=3
says "sensitivity.traits is an integer"
says "sensitivity.levels is 3"
