#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A worker that hangs, here one that is stopped, is skipped: the run goes
# on without it and ends in order, with the results that it would have had.
. "$(dirname "$0")/common.sh"

write_campaign hang 12 60
printf '[parallel]\ndeadline = 1\n' >>campaigns/hang.toml
"$ideotype" run campaigns/hang.toml --out whole >/dev/null

# Starts a run of three workers in folder $1 and waits until it has begun.
start() {
    log=$1.log
    mpirun -n 4 "$ideotype" run campaigns/hang.toml --out "$1" --resume \
        >"$log" 2>&1 &
    job=$!
    for _ in $(seq 300); do
        ! grep -q "generation 1, " "$log" || return 0
        sleep 0.02
    done
    fail "it does not begin: $(cat "$log")"
}

# Stops the given ranks by a signal.
freeze() {
    local rank
    for rank in "$@"; do kill -STOP "$(rank_of $job "$rank")"; done
}

# Waits until the log says $1 and all ranks are gone. With ranks to kill mpirun
# 4.1 itself may crash or hang at its end, so its exit code is not looked at.
await_end() {
    for _ in $(seq 600); do
        if grep -q -- "$1" "$log" && are_gone $job; then
            kill -KILL $job 2>/dev/null || true
            wait $job 2>/dev/null || true
            return 0
        fi
        sleep 0.1
    done
    mapfile -t left < <(descendants_of $job)
    ps -o pid,ppid,stat,wchan:20,cmd -p $job "${left[@]}" >&2 || true
    kill -KILL $job "${left[@]}" || true
    fail "it does not end with '$1': $(cat "$log")"
}

start one
freeze 2
await_end ": finished (reached "
grep -q "no answer from worker 2 within .*trying again" "$log" || fail "$(cat "$log")"
same_results "$(history_of whole hang)" "$(history_of one hang)"

start drained
freeze 1 3
kill -USR1 $job
await_end "stopped before the end"

start all
freeze 1 2 3
await_end "no worker responds any more"
grep -q "  .* run .*--resume" "$log" || fail "the log lacks the command that resumes the run"

# A changed deadline does not make it another campaign.
sed -i 's/^deadline = 1/deadline = "00:01:00"/' campaigns/hang.toml
for folder in drained all; do
    "$ideotype" run campaigns/hang.toml --out $folder --resume >/dev/null
    same_results "$(history_of whole hang)" "$(history_of $folder hang)"
done
