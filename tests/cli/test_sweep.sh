#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Many cases in one job give bitwise the results of each case alone, also when
# the job is drained and resumed. A case that fails does not stop the others.
. "$(dirname "$0")/common.sh"

write_campaign sweep 8 4
sed -i 's/^seed = 7/seed = 7\nreplicates = 3/' campaigns/sweep.toml

# Compares the results in folder $1 with those of each case alone.
same_as_alone() {
    for r in 1 2 3; do
        same_results "alone/sweep/ames_0807_762x152_all_r$r.h5" \
            "$1/sweep/ames_0807_762x152_all_r$r.h5"
    done
}

for index in 0 1 2; do
    "$ideotype" run campaigns/sweep.toml --out alone --case $index
done
for ranks in 1 3 12; do
    mpirun -n $ranks "$ideotype" run campaigns/sweep.toml --out ranks$ranks \
        >ranks$ranks.log
    same_as_alone ranks$ranks
    [ "$(grep -c ': finished (reached ' ranks$ranks.log)" -eq 3 ] ||
        fail "not three summaries: $(cat ranks$ranks.log)"
done


# Masters that share the cases give bitwise equal results, and evaluations are
# recorded with the rank in the job.
mpirun -n 6 "$ideotype" run campaigns/sweep.toml --out shared --masters 2 \
    >shared.log
same_as_alone shared
[ "$(grep -c ': finished (reached ' shared.log)" -eq 3 ] ||
    fail "not three summaries: $(cat shared.log)"
workers=$(h5dump -y -w 1 -d /evaluations/worker \
        shared/sweep/ames_0807_762x152_all_r3.h5 |
    sed -n 's/^ *\([0-9][0-9]*\),*$/\1/p' | sort -un | tr '\n' ' ')
[ "$workers" = "5 " ] || fail "not evaluated by rank 5 alone: $workers"

# Time limits interrupt the job at various points; the command that resumes it
# is printed once.
write_campaign cut 12 40
sed -i 's/^seed = 7/seed = 7\nreplicates = 3/' campaigns/cut.toml
mpirun -n 5 "$ideotype" run campaigns/cut.toml --out whole >/dev/null
stops=0
for start in $(seq 100); do
    code=0
    mpirun -n 5 "$ideotype" run campaigns/cut.toml --out drained --resume \
        --wall-time 1s >"drain$start.log" || code=$?
    [ $code -ne 0 ] || break
    [ $code -eq 5 ] || fail "a drain must end with 5, not $code"
    grep -q "stopped before the end" "drain$start.log" || fail "no message about the stop"
    stops=$((stops + 1))
    [ "$(grep -c -- "^  .* run .*--resume" "drain$start.log")" -eq 1 ] ||
        fail "not one command to resume: $(cat "drain$start.log")"
done
[ $stops -ge 1 ] || fail "no time limit hit the run"
for r in 1 2 3; do
    same_results "whole/cut/ames_0807_762x152_all_r$r.h5" \
        "drained/cut/ames_0807_762x152_all_r$r.h5"
done

# Lets a program that pauses, `holder`, lock case $2 in folder $1.
hold() {
    rm -f "hold$2.log"
    "$ideotype" run campaigns/cut.toml --out "$1" --case "$2" >"hold$2.log" 2>&1 &
    holder=$!
    until grep -qs "generation 1," "hold$2.log"; do sleep 0.02; done
    kill -STOP $holder
    holders+=("$holder")
}
holders=()
trap 'kill -KILL "${holders[@]}" 2>/dev/null || true' EXIT

# One case is locked by another program.
hold busy 1
in_use=busy/cut/ames_0807_762x152_all_r2.h5
code=0
mpirun -n 5 "$ideotype" run campaigns/cut.toml --out busy --resume \
    >busy.log 2>&1 || code=$?
kill -CONT $holder
[ $code -eq 0 ] || fail "a case of another job is no failure: $code $(cat busy.log)"
grep -q "ames_0807_762x152_all_r2  skipped: $in_use: this history is in use by process $holder " \
    busy.log || fail "$(cat busy.log)"
grep -q "other programs work on 1 of 3 cases: ames_0807_762x152_all_r2" busy.log ||
    fail "$(cat busy.log)"
! grep -q "resume with" busy.log || fail "a command to resume is printed, but no case is left: $(cat busy.log)"
wait $holder || fail "the holder ended with $?: $(cat hold1.log)"
for r in 1 2 3; do
    same_results "whole/cut/ames_0807_762x152_all_r$r.h5" \
        "busy/cut/ames_0807_762x152_all_r$r.h5"
done

# Other programs lock all cases, so that nothing can be evaluated.
for index in 0 1 2; do hold all $index; done
code=0
"$ideotype" run campaigns/cut.toml --out all --resume >all.log 2>&1 || code=$?
[ $code -eq 4 ] || fail "nothing to do must end with 4, not $code"
grep -q "other programs work on 3 of 3 cases" all.log || fail "$(cat all.log)"

# One history is deleted while it is written: this case fails, and the others
# continue.
mpirun -n 3 "$ideotype" run campaigns/cut.toml --out deleted >deleted.log 2>&1 &
job=$!
gone=deleted/cut/ames_0807_762x152_all_r2.h5
until [ -e $gone ]; do sleep 0.02; done
rm $gone
code=0
wait $job || code=$?
[ $code -eq 1 ] || fail "a failed case must end with 1, not $code"
grep -q "1 of 3 cases failed, 2 finished" deleted.log || fail "$(cat deleted.log)"
grep -q "  ames_0807_762x152_all_r2: $gone: this file was deleted" deleted.log ||
    fail "$(cat deleted.log)"
for r in 1 3; do
    same_results "whole/cut/ames_0807_762x152_all_r$r.h5" \
        "deleted/cut/ames_0807_762x152_all_r$r.h5"
done

# Cases may be added, also before the existing ones. Existing cases are resumed
# or skipped, and finished histories stay unchanged. The definition of an
# existing case must not change.
write_campaign grid 6 3
"$ideotype" run campaigns/grid.toml --out grown >/dev/null
sed -i 's/^\[site\]/[[site]]/' campaigns/grid.toml
old=grown/grid/ames_0807_762x152_all_r1.h5
digest=$(sha256sum $old)
{
    sed '/^\[\[site\]\]/,$d' campaigns/grid.toml
    printf '[[site]]\nname = "Boone"\nlatitude = 50.0\nlongitude = -93.6\nutc_offset = -5\n'
    sed -n '/^\[\[site\]\]/,$p' campaigns/grid.toml
} >campaigns/more.toml
expect 0 "$ideotype" check campaigns/more.toml --left --out grown
[ "$(cat out.log)" = "0	0" ] || fail "one case is to be begun: $(cat out.log)"
expect 0 mpirun -n 3 "$ideotype" run campaigns/more.toml --out grown --resume
"$ideotype" run campaigns/more.toml --out both >/dev/null
for site in ames boone; do
    same_results both/grid/${site}_0807_762x152_all_r1.h5 \
        grown/grid/${site}_0807_762x152_all_r1.h5
done
[ "$(sha256sum $old)" = "$digest" ] || fail "a finished history was written"
expect 0 "$ideotype" check campaigns/more.toml --left --out grown
[ ! -s out.log ] || fail "nothing is left: $(cat out.log)"
expect 0 "$ideotype" check campaigns/grid.toml --left --out grown
[ ! -s out.log ] || fail "nothing is left: $(cat out.log)"
expect 0 "$ideotype" status grown
says "2 cases: 2 finished"
sed -i 's/^latitude = 50.0/latitude = 51.0/' campaigns/more.toml
for command in "run --resume" "run --resume --case 0" "check --left"; do
    read -r command options <<<"$command"
    # shellcheck disable=SC2086
    expect 4 "$ideotype" $command campaigns/more.toml --out grown $options
    says "grown/grid/boone_0807_762x152_all_r1.h5: the campaign has changed"
    says "  site.latitude was 50, is 51$"
done
expect 0 "$ideotype" run campaigns/more.toml --out grown --resume --case 1
