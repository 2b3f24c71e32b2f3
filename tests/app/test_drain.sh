#!/usr/bin/env bash
# A run that is killed in the middle of a generation, again and again, and
# resumed gives bitwise what an uninterrupted run gives. A drained one too.
. "$(dirname "$0")/common.sh"

write_campaign long 12 300
"$ideotype" run campaigns/long.toml --out whole >/dev/null
whole=$(history_of whole long)
killed=$(history_of killed long)

kills=0
for delay in 0.9 1.0 1.2 0.8 1.1; do
    mpirun -n 3 "$ideotype" run campaigns/long.toml --out killed --resume \
        >/dev/null 2>&1 &
    job=$!
    sleep $delay
    if pkill -KILL -f "run campaigns/long.toml --out killed"; then
        kills=$((kills + 1))
    fi
    wait $job || true
    # mpirun may be gone before the ranks are.
    while pgrep -f "run campaigns/long.toml --out killed" >/dev/null; do
        sleep 0.05
    done
    # The contract: the file can be read after any kill.
    [ ! -e "$killed" ] || "$ideotype" status killed |
        grep -E ": (dead|finished by generations), " ||
        fail "a killed run does not look dead: $("$ideotype" status killed)"
done
[ $kills -ge 3 ] || fail "only $kills kills hit a run"
mpirun -n 3 "$ideotype" run campaigns/long.toml --out killed --resume
same_results "$whole" "$killed"

# SIGUSR1 to mpirun drains: exit 0, a message with the command to go on.
mpirun -n 3 "$ideotype" run campaigns/long.toml --out drained >drain.log &
job=$!
for _ in $(seq 100); do
    [ ! -e "$(history_of drained long)" ] || break
    sleep 0.1
done
sleep 0.5
"$ideotype" status drained | grep ": running, " || fail "does not look running"
kill -USR1 $job
wait $job || fail "a drain must end with 0"
"$ideotype" status drained | grep ": drained, " || fail "does not look drained"
[ "$("$ideotype" status --resumable drained)" = "$(history_of drained long)" ] ||
    fail "a drained run is resumable"
grep -q -- "--resume" drain.log || fail "no word about how to go on"
"$ideotype" run campaigns/long.toml --out drained --resume >/dev/null
same_results "$whole" "$(history_of drained long)"

# A run never overwrites, and another campaign is refused by name.
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
