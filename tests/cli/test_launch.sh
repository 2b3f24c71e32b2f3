#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `run --ranks` starts MPI by itself, with nothing set for it; signals end it in
# order with exit code 5, and what it says goes on, typed as it is said.
. "$(dirname "$0")/common.sh"
unset "${!OMPI_@}" "${!PRTE_@}"

write_campaign long 12 100
"$ideotype" run campaigns/long.toml --out whole >/dev/null
write_campaign short 8 3
"$ideotype" run campaigns/short.toml --out whole >/dev/null

# The launcher adds nothing of its own; that of Open MPI 5 cannot be told not to.
says_no_more() {
    "$ideotype" --version | grep -q "Open MPI v5" ||
        ! grep -q "non-zero" out.log || fail "a word of mpirun: $(cat out.log)"
}

for ranks in auto 1 4; do
    expect 0 "$ideotype" run campaigns/short.toml --ranks $ranks --out "of $ranks"
    same_results "$(history_of whole short)" "$(history_of "of $ranks" short)"
done
for ranks in 0 -1 2.5 two 4097; do
    expect 2 "$ideotype" run campaigns/short.toml --out no "--ranks=$ranks"
    says "--ranks"
done
expect 2 taskset -c 0 "$ideotype" run campaigns/short.toml --out no --ranks none
says "'none' is no number of ranks; give 1 to 4096, or auto, which is 1 here"
expect 4 "$ideotype" run campaigns/short.toml --out whole --ranks 3
says "exists already"
says_no_more
code=0
env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
    OMPI_MCA_rmaps_base_oversubscribe=1 mpirun -n 2 \
    "$ideotype" run campaigns/short.toml --out no --ranks 3 >out.log 2>&1 || code=$?
[ $code -eq 2 ] || fail "--ranks under mpirun ended with $code: $(cat out.log)"
[ "$(grep -c "^ideotype: run: --ranks .* leave out one of them" out.log)" = 1 ] ||
    fail "not told once: $(cat out.log)"
[ ! -e no ] || fail "something was begun: $(ls -R no)"

# Starts a run and waits for its first generation; $1 its folder.
start() {
    "$ideotype" run campaigns/long.toml --out "$1" --ranks 3 >out.log 2>&1 &
    job=$!
    for _ in $(seq 300); do
        ! grep -q "1 of 100 complete" out.log || return 0
        sleep 0.05
    done
    fail "it does not begin: $(cat out.log)"
}

# Goes on as out.log says, $1 the folder.
go_on() {
    local line
    line=$(grep -m 1 "^  .* run .*--resume$" out.log)
    [ "$line" = "  $ideotype run campaigns/long.toml --out '$1' --ranks 3 --resume" ] ||
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
    says_no_more
done
go_on "on USR1"

# A second Ctrl-C ends it at once, whatever the work in flight does.
start twice
kill -STOP "$(rank_of $job 2)"
kill -INT $job
sleep 0.05
kill -INT $job
code=0
wait $job || code=$?
[ $code -eq 130 ] || fail "Ctrl-C twice ended with $code: $(cat out.log)"
says "--resume$"
for _ in $(seq 50); do
    pgrep -f "run campaigns/long.toml --out twice" >/dev/null || break
    sleep 0.1
done
! pgrep -f "run campaigns/long.toml --out twice" || fail "ranks live on"

start "a rank"
kill -KILL "$(rank_of $job 2)"
code=0
wait $job || code=$?
[ $code -eq 137 ] || fail "a killed rank ended with $code: $(cat out.log)"
says "a rank was ended by signal 9"
go_on "a rank"
