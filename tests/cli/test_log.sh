#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests that runs print the requested amount of progress, and that lines of a
# log begin with the time.
. "$(dirname "$0")/common.sh"
write_campaign told 6 2
time='^[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]{8}Z  '
told() {
    timeout 60 "$ideotype" run campaigns/told.toml --out "$1" "${@:2}" \
        >out.log 2>err.log || fail "ended with $?: $(cat err.log)"
}
told info
grep -Eq "${time}ames.* generation 1, 12 of 12 plants" out.log || fail "$(cat out.log)"
! grep -q "worker [0-9]" out.log || fail "each evaluation is printed: $(cat out.log)"

told debug --log-level debug
[ "$(grep -Ec "${time}ames.*  generation [01] slot [0-5]: worker [0-9]+, [0-9.]* s, [0-9.]* ± " out.log)" = 12 ] ||
    fail "not each evaluation: $(cat out.log)"
[ "$(grep -c "  final slot [0-3]: worker [0-9]*, " out.log)" = 4 ] || fail "$(cat out.log)"

# The result is printed at every log level.
told quiet --quiet
[ ! -s err.log ] || fail "--quiet prints $(cat err.log)"
grep -q "finished (reached stop.generations), .*gain " out.log || fail "no result: $(cat out.log)"
! grep -q "generation [0-9]" out.log || fail "--quiet prints $(cat out.log)"

# Errors are printed at every log level too, with the time.
expect 4 "$ideotype" run campaigns/told.toml --out quiet --log-level error
grep -Eq "${time}ideotype: .*exists already" out.log || fail "$(cat out.log)"
expect 2 "$ideotype" run campaigns/told.toml --log-level loud
expect 2 "$ideotype" run campaigns/told.toml --quiet --log-level debug
