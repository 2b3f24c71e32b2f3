#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# One machine without a launcher: the same bits on any number of threads, also
# of several ranks; signals end a run in order with exit code 5, and what it
# says goes on, typed as it is said.
. "$(dirname "$0")/common.sh"
plain=(env)
for name in "${!OMPI_@}" "${!PRTE_@}"; do plain+=(-u "$name"); done
time_limit=(timeout 120)

write_campaign long 12 100
"$ideotype" run campaigns/long.toml --out whole --threads 1 >/dev/null
write_campaign short 8 3
"$ideotype" run campaigns/short.toml --out whole --threads 1 >/dev/null
short=$(history_of whole short)

for threads in auto 2 5 12; do
    expect 0 "${plain[@]}" "$ideotype" run campaigns/short.toml --threads $threads --out "of $threads"
    same_results "$short" "$(history_of "of $threads" short)"
done
for start in "2 2" "3 1" "3 4"; do
    read -r ranks threads <<<"$start"
    expect 0 mpirun -n "$ranks" "$ideotype" run campaigns/short.toml \
        --threads "$threads" --out "both $start"
    same_results "$short" "$(history_of "both $start" short)"
done
expect 0 mpirun -n 4 "$ideotype" run campaigns/long.toml --threads 2 --out both
same_results "$(history_of whole long)" "$(history_of both long)"
# Ranks and their threads have all worked.
[ "$(h5dump -d /evaluations/worker "$(history_of both long)" |
    grep -o ": [0-9, ]*" | tr -d ': ' | tr , '\n' | sort -u | grep -c .)" = 8 ] ||
    fail "not all of 8 workers have worked"

for threads in 0 -1 2.5 two 4097; do
    expect 2 "$ideotype" run campaigns/short.toml --out no "--threads=$threads"
    says "--threads"
done
expect 2 taskset -c 0 "$ideotype" run campaigns/short.toml --out no --threads none
says "'none' is no number of threads; give 1 to 4096, or auto, which is 1 here"
expect 2 "$ideotype" run campaigns/short.toml --out no --ranks auto
says "^ideotype: --ranks is gone: .*--threads N$"
expect 2 "$ideotype" run campaigns/short.toml --out no --rank 3
says "^ideotype: --ranks is gone"
expect 4 "$ideotype" run campaigns/short.toml --out whole --threads 3
says "exists already"
[ ! -e no ] || fail "something was begun: $(ls -R no)"

# Starts a run and waits for its first generation; $1 its folder.
start() {
    rm -f out.log # the log of an earlier run
    "$ideotype" run campaigns/long.toml --out "$1" --threads 2 >out.log 2>&1 &
    job=$!
    for _ in $(seq 300); do
        ! grep -qs "generation 0, " out.log || return 0
        sleep 0.02
    done
    fail "it does not begin: $(cat out.log)"
}

# Resumes by the command in out.log; $1 the folder.
go_on() {
    local line
    line=$(grep -m 1 "^  .* run .*--resume$" out.log)
    [ "$line" = "  $ideotype run campaigns/long.toml --out '$1' --threads 2 --resume" ] ||
        fail "not how it was started: $(cat out.log)"
    "$ideotype" status "$1" | grep -qxF -- "$line" ||
        fail "status tells another way to go on: $("$ideotype" status "$1")"
    eval "$line" >/dev/null || fail "'$line' ended with $?"
    same_results "$(history_of whole long)" "$(history_of "$1" long)"
}

for signal in INT TERM USR1; do
    start "on $signal"
    kill -$signal $job
    code=0
    wait $job || code=$?
    [ $code -eq 5 ] || fail "$signal ended with $code: $(cat out.log)"
    says "stopped before the end"
    go_on "on $signal"
done

# A second Ctrl-C ends a run at once, whatever the work in flight does.
start twice
kill -INT $job
kill -INT $job
code=0
wait $job || code=$?
[ $code -eq 130 ] || [ $code -eq 5 ] || fail "Ctrl-C twice ended with $code: $(cat out.log)"
expect 0 "$ideotype" run campaigns/long.toml --out twice --resume
same_results "$(history_of whole long)" "$(history_of twice long)"

expect 5 "$ideotype" run campaigns/long.toml --out timed --threads 2 --wall-time 1
says "stopped before the end"
# A job that stands still, as after Ctrl-Z, is not late.
printf '[parallel]\ndeadline = 2\n' >>campaigns/long.toml
"$ideotype" run campaigns/long.toml --out timed --threads 2 --resume >out.log 2>&1 &
job=$!
sleep 0.2
kill -STOP $job
sleep 3
kill -CONT $job
wait $job || fail "a run that stood still ended with $?: $(cat out.log)"
! grep "no answer" out.log || fail "standing still was late"
same_results "$(history_of whole long)" "$(history_of timed long)"
