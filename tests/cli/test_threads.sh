#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests runs on one machine without a launcher: results are bitwise equal for
# any number of threads, also on several ranks. After a signal the run ends in
# order with exit code 5, and the printed command resumes it.
. "$(dirname "$0")/common.sh"
plain=(env)
for name in "${!OMPI_@}" "${!PRTE_@}"; do plain+=(-u "$name"); done
time_limit=(timeout 120)

write_campaign long 12 60
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
# All ranks and all of their threads have evaluated plants.
[ "$(h5dump -d /evaluations/worker "$(history_of both long)" |
    grep -o ": [0-9, ]*" | tr -d ': ' | tr , '\n' | sort -u | grep -c .)" = 8 ] ||
    fail "not all of 8 workers have worked"

for threads in 0 -1 2.5 two 4097; do
    expect 2 "$ideotype" run campaigns/short.toml --out no "--threads=$threads"
    says "--threads"
done
expect 2 taskset -c 0 "$ideotype" run campaigns/short.toml --out no --threads none
says "'none' is not a number of threads; give 1 to 4096, or auto (1 here)"
expect 2 "$ideotype" run campaigns/short.toml --out no --ranks auto
says "^ideotype: --ranks was removed: .*--threads N$"
expect 2 "$ideotype" run campaigns/short.toml --out no --rank 3
says "^ideotype: --ranks was removed"
expect 4 "$ideotype" run campaigns/short.toml --out whole --threads 3
says "exists already"
[ ! -e no ] || fail "something was begun: $(ls -R no)"

# Starts a run with the given command and returns when the first generation is
# reported. wait_for_job sets its exit code.
start() {
    exec 3< <(exec "$@" 2>&1)
    job=$!
    : >out.log
    local line=
    while IFS= read -r line <&3; do
        echo "$line" >>out.log
        [[ $line != *"generation "[0-9]*", "* ]] || break
    done
    [ -n "$line" ] || fail "it does not begin: $(cat out.log)"
    cat <&3 >>out.log &
    reader=$!
}
wait_for_job() {
    code=0
    wait $job || code=$?
    wait $reader
}

# One run is stopped by each signal in turn, and resumed with the printed
# command.
begun=("$ideotype" run campaigns/long.toml --out "on signals" --threads 2)
go_on=("${begun[@]}")
for signal in INT TERM USR1; do
    start "${go_on[@]}"
    kill -$signal $job
    wait_for_job
    [ $code -eq 5 ] || fail "$signal ended with $code: $(cat out.log)"
    says "stopped before the end"
    line=$(grep -m 1 "^  .* run .*--resume$" out.log)
    [ "$line" = "  $ideotype run campaigns/long.toml --out 'on signals' --threads 2 --resume" ] ||
        fail "not how it was started: $(cat out.log)"
    "$ideotype" status "on signals" | grep -qxF -- "$line" ||
        fail "status prints another command to resume: $("$ideotype" status "on signals")"
    eval "go_on=($line)"
done

# A second Ctrl-C ends a run immediately, whatever is being evaluated.
start "${go_on[@]}"
kill -INT $job
kill -INT $job
wait_for_job
[ $code -eq 130 ] || [ $code -eq 5 ] || fail "Ctrl-C twice ended with $code: $(cat out.log)"
expect 0 "${go_on[@]}"
same_results "$(history_of whole long)" "$(history_of "on signals" long)"

# Time limits include the time in which a job is suspended, but evaluations do
# not exceed their deadline because of it.
start "$ideotype" run campaigns/long.toml --out timed --threads 2 --wall-time 5
kill -STOP $job
sleep 5
kill -CONT $job
wait_for_job
[ $code -eq 5 ] || fail "a time limit ended with $code: $(cat out.log)"
says "stopped before the end"
printf '[parallel]\ndeadline = 2\n' >>campaigns/long.toml
start "$ideotype" run campaigns/long.toml --out timed --threads 2 --resume
kill -STOP $job
sleep 3
kill -CONT $job
wait_for_job
[ $code -eq 0 ] || fail "a run that stood still ended with $code: $(cat out.log)"
! grep "no answer" out.log || fail "standing still was late"
same_results "$(history_of whole long)" "$(history_of timed long)"
