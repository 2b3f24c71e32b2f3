#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A sensitivity study: the same bits for any number of ranks and after a stop,
# rows that can be computed again, failed rows, and what is refused.
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
expect 0 "${sensitivity[@]}" --out alone --json alone.json --quantity lai
says "absorbed_par \[MJ m-2 day-1\]: mean "
says "^  spacing.row "
says "lai \[m2 m-2\]: mean "
# Both keys at once may be more than all light.
says "of 40 samples have rows that failed"
whole=$(history_of alone study)
"$ideotype" status alone | grep ": finished by generations, 3 of 3 generations" ||
    fail "not finished"
"$ideotype" verify "$whole"
"$ideotype" evaluate "$whole" --generation 1 --slot 20 | grep "agrees bit for bit" ||
    fail "a row cannot be computed again"
for ranks in 1 2 5 12; do
    mpirun -n $ranks "${sensitivity[@]}" --out ranks$ranks --json ranks.json >/dev/null
    same_results "$whole" "$(history_of ranks$ranks study)"
    cmp alone.json ranks.json || fail "$ranks ranks find other indices"
done

# The comparison itself must be able to fail.
"${sensitivity[@]}" --set seed=8 --out other >/dev/null
if (same_group "$whole" "$(history_of other study)" /sensitivity) \
    >/dev/null 2>&1; then
    fail "another seed gave the same indices"
fi

# Stopped and resumed; nothing else may be written over it.
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
    fail "no word about how to go on: $(cat drain.log)"
expect 4 "${longer[@]}" --out drained
expect 4 "$ideotype" run campaigns/study.toml --out drained --resume
says "search.optimizer was"
expect 0 "${longer[@]}" --out drained --resume
same_results "$(history_of whole study)" "$(history_of drained study)"
# What is finished is told again.
expect 0 "${longer[@]}" --out drained --resume --quantity absorbed_fraction
says "absorbed_fraction \[1\]: mean"
expect 2 "${longer[@]}" --out drained --resume --quantity absorbed_fractio
says "did you mean 'absorbed_fraction'?"

expect 0 "${sensitivity[@]}" --set sensitivity.method=morris \
    --set sensitivity.groups=gene --set sensitivity.samples=16 --out morris
says "mu_star_of_noise"
says "^  leaf03_width "
expect 3 "${sensitivity[@]}" --set sensitivity.traits=3 --set sensitivity.levels=3
says "sensitivity.traits is an integer"
says "sensitivity.levels is 3"
