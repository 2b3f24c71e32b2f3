#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A drained and resumed run gives the same bits as an uninterrupted run, and
# resumes that would break this are refused. Kills: tests/stress.
. "$(dirname "$0")/common.sh"

write_campaign long 12 200
"$ideotype" run campaigns/long.toml --out whole >/dev/null
whole=$(history_of whole long)

# SIGUSR1 sent to mpirun drains the run: the exit code is 5, and a message
# states the command that resumes it.
mpirun -wdir "$PWD" -n 3 "$ideotype" run campaigns/long.toml --out drained >drain.log &
job=$!
for _ in $(seq 100); do
    [ ! -e "$(history_of drained long)" ] || break
    sleep 0.05
done
sleep 0.1
"$ideotype" status drained | grep ": running, " || fail "does not look running"
# A second writer is refused and does not disturb the first.
code=0
"$ideotype" run campaigns/long.toml --out drained --resume 2>second.log || code=$?
[ $code -eq 4 ] || fail "a second writer ended with $code: $(cat second.log)"
grep -q "in use by process" second.log || fail "$(cat second.log)"
kill -USR1 $job
code=0
wait $job || code=$?
is_stopped $code || fail "a drain must end with 5, not $code"
"$ideotype" status drained >status.log
grep ": drained, " status.log || fail "does not look drained"
grep -qx "  mpirun -n 3 $ideotype run campaigns/long.toml --out drained --resume" \
    status.log || fail "no command to resume: $(cat status.log)"
grep -q "^(histories do not record options of mpirun, such as" status.log ||
    fail "the hint on options of mpirun is missing: $(cat status.log)"
[ "$("$ideotype" check campaigns/long.toml --left --out drained | cut -f 1)" = 0 ] ||
    fail "a drained case is left"
[ "$("$ideotype" check campaigns/long.toml --left --out drained | cut -f 2)" -gt 0 ] ||
    fail "no evaluation of a drained case counts"
# The printed command contains the words with which mpirun was called.
grep -qF -- " -wdir $PWD -n 3 $ideotype run campaigns/long.toml --out drained --resume" \
    drain.log || fail "a different command to resume: $(cat drain.log)"
# If two processes resume the same run, one continues and the other is refused.
codes=()
jobs=()
for start in 1 2; do
    "$ideotype" run campaigns/long.toml --out drained --resume \
        >resume$start.log 2>&1 &
    jobs+=($!)
done
for job in "${jobs[@]}"; do
    code=0
    wait "$job" || code=$?
    codes+=("$code")
done
case "${codes[*]}" in
"0 4" | "4 0") grep -q "in use by process" resume?.log || fail "no reason" ;;
*) fail "two resumes at once ended with ${codes[*]}: $(cat resume?.log)" ;;
esac
same_results "$whole" "$(history_of drained long)"

# A run never overwrites results, and the message names the campaign that
# differs.
if "$ideotype" run campaigns/long.toml --out whole 2>refused.log; then
    fail "a second run overwrote the first"
elif [ $? -ne 4 ]; then
    fail "exit code is not 4"
fi
sed -i 's/paths = 256/paths = 512/' campaigns/long.toml
if "$ideotype" run campaigns/long.toml --out whole --resume 2>changed.log; then
    fail "a changed campaign was resumed"
elif [ $? -ne 4 ]; then
    fail "exit code is not 4"
fi
grep -q "light.paths was 256, is 512" changed.log || fail "$(cat changed.log)"
