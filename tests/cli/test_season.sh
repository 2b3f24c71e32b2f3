#!/usr/bin/env bash
# A season of weather: the same bits with any number of ranks, and after a kill.
. "$(dirname "$0")/common.sh"
cp -r "$project/campaigns/weather" campaigns

write_campaign season 8 60
python3 - campaigns/season.toml <<'PYTHON'
import re
import sys

with open(sys.argv[1], encoding="utf-8") as file:
    text = file.read()
climate = """[climate]
name = "july"
file = "weather/bondville_2011_0721_0920.csv"
from = 2011-07-21
to = 2011-07-30
time = ["time"]
stamp = "middle"
global = ["ppfd_umol", "umol/m2/s"]
diffuse_fraction = ["diffuse_fraction_erbs", "1"]
"""
text = re.sub(r"\[day\][^[]*", climate, text)
text = text.replace("42.0", "40.05").replace("-93.6", "-88.37")
text = text.replace("utc_offset = -5", "utc_offset = -6")
with open(sys.argv[1], "w", encoding="utf-8") as file:
    file.write(text)
PYTHON
expect 0 "$ideotype" check campaigns/season.toml
says "suns of 3 of 10 dates"
says "Ames .* july  *10 .* MJ m-2 .* %"

expect 0 "$ideotype" run campaigns/season.toml --out whole
whole=$(history_of whole season july)
expect 0 mpirun -n 3 "$ideotype" run campaigns/season.toml --out ranks
same_results "$whole" "$(history_of ranks season july)"

"$ideotype" run campaigns/season.toml --out killed >killed.log 2>&1 &
job=$!
for _ in $(seq 200); do
    left=$("$ideotype" plan campaigns/season.toml --left --out killed | cut -f 2)
    [ "${left:-0}" -lt 40 ] || break
    sleep 0.05
done
kill -KILL $job || fail "it had ended: $(cat killed.log)"
wait $job || true
expect 0 mpirun -n 2 "$ideotype" run campaigns/season.toml --out killed --resume
same_results "$whole" "$(history_of killed season july)"

# What was read is in the history: nothing of the files is needed.
mkdir alone
cp "$whole" alone/history.h5
rm -r campaigns
expect 0 "$ideotype" evaluate alone/history.h5 --best
