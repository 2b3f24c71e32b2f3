#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the start of CMA-ES, and exports from each kind of search.
. "$(dirname "$0")/common.sh"

write_campaign searches 8 4
for search in cma_es random; do
    "$ideotype" run campaigns/searches.toml --out $search \
        --set search.optimizer=$search >search.log
done

# A search starts from the plant of a file, and another from the best plant of a
# history. The first plant of a search is its start.
write_campaign start 8 3
first=$(history_of cma_es searches)
start=(run campaigns/start.toml --set search.optimizer=auto)
"$ideotype" "${start[@]}" --out history --start "$first" >start.log
"$ideotype" export "$first" --best --to best.toml
"$ideotype" "${start[@]}" --out file --start best.toml >start.log
same_results "$(history_of history start)" "$(history_of file start)"
"$ideotype" export "$(history_of file start)" --generation 0 --slot 0 \
    --to again.toml
lengths() { grep -o 'length = [0-9.]*' "$1" | cut -c1-13 | head -10; }
cmp <(lengths best.toml) <(lengths again.toml) ||
    fail "the search does not begin around its start"

# Invalid numbers for a start are refused before anything is written.
code=0
"$ideotype" "${start[@]}" --out none --start missing.h5 >start.log 2>&1 || code=$?
[ $code -eq 1 ] || fail "a missing start ended with $code: $(cat start.log)"
[ ! -e none ] || fail "a missing start left a folder"

# The origin of each candidate has a name in exports.
for each in cma_es random; do
    "$ideotype" export "$(history_of $each searches)" --generations --to $each.csv
done
grep -q ",sample," cma_es.csv || fail "no row has the origin of CMA-ES"
grep -q ",random," random.csv || fail "no row has the origin of random search"
