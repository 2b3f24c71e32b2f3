#!/usr/bin/env bash
# Results are bitwise the same alone, under mpirun, and for any number of
# ranks, also more than there are candidates.
. "$(dirname "$0")/common.sh"

write_campaign same 8 3
# Each evaluation finds out for itself how many paths it needs.
sed -i '/^\[light\]/,/^\[evolution\]/ {
    s/^paths = .*/paths = 4096/
    s/^randomisations = .*/randomisations = 8\ntolerance = 0.01\nfirst_tolerance = 0.03/
}' campaigns/same.toml
"$ideotype" run campaigns/same.toml --out alone
for ranks in 1 2 5 12; do
    mpirun -n $ranks "$ideotype" run campaigns/same.toml --out ranks$ranks
    same_results "$(history_of alone same)" "$(history_of ranks$ranks same)"
done

# The comparison itself must be able to fail.
sed -i 's/seed = 7/seed = 8/' campaigns/same.toml
"$ideotype" run campaigns/same.toml --out other >/dev/null
if (same_results "$(history_of alone same)" "$(history_of other same)") \
    >/dev/null 2>&1; then
    fail "another seed gave the same results"
fi
