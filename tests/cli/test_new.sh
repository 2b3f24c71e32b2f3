#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests new campaigns, from options and from answers on a terminal.
. "$(dirname "$0")/common.sh"

place=(--latitude 42.03 --longitude -93.63 --date 2021-07-01)
field=(--row 0.762 --plant-spacing 0.15)
mkdir own other

# A new campaign can be checked from any folder; its crop file is in its own
# folder.
expect 0 "$ideotype" new own/my.toml "${place[@]}" "${field[@]}" --plant maize
says "^next: ideotype check own/my.toml$"
cmp own/maize.toml campaigns/crops/maize.toml
# The schema is copied to the same folder, where editors find it.
says "^own/maize.toml$"
says "^own/campaign.schema.json$"
[ "$(head -n 1 own/my.toml)" = "#:schema campaign.schema.json" ] ||
    fail "no schema in $(cat own/my.toml)"
"$ideotype" schema | cmp - own/campaign.schema.json
expect 0 "$ideotype" check own/my.toml
says "^own/my.toml: no errors$"
! grep -q "^advice" out.log || fail "a new campaign needs advice: $(cat out.log)"
expect 0 "$ideotype" check own/my.toml --set light.fields=1
says "^advice    standard errors of rows omit differences between fields; .*: light.fields = 4$"
says "^campaign  my, 3 cases (--cases lists them)$"
says "^sun$"
says "  elevation  *left out"
says " 0.0 % "
(cd own && "$ideotype" check my.toml --cases) | grep -q "my_0701_762x150_all_r1" ||
    fail "not the campaign that was asked for"
for line in 'latitude = 42.03  *# .*\[deg\]' 'utc_offset = -6  *#' \
    'start = 04:00:00' 'end = 20:00:00' 'row = 0.762  *# .*\[m\]' \
    'maximise = "carbon_balance"  *#' 'replicates = 3  *#' \
    'bounds = "breedable"  *#' 'baseline = "maize.toml"  *#' \
    'rows = 2  *#' 'plants = 2  *#' 'fields = 4  *#' 'randomisations = 64  *#'; do
    grep -q "^$line" own/my.toml || fail "no '$line' in $(cat own/my.toml)"
done
if grep -E '^[a-z_]+ = ' own/my.toml | grep -v '#'; then
    fail "a key is not explained"
fi

# No file is ever overwritten.
sum=$(cat own/* | sha256sum)
expect 4 "$ideotype" new own/my.toml "${place[@]}" "${field[@]}" --plant maize
says "own/my.toml: exists already and is not overwritten"
[ "$(cat own/* | sha256sum)" = "$sum" ] || fail "something was overwritten"
mkdir links
for name in my.toml maize.toml campaign.schema.json; do
    ln -s elsewhere.toml links/$name
    expect 4 "$ideotype" new links/my.toml "${place[@]}" "${field[@]}" --plant maize
    says "links/$name: this is a symbolic link"
    [ ! -e links/elsewhere.toml ] || fail "a link was followed"
    rm links/*
done
# A schema of another version is replaced; an unrelated file of this name is
# not.
sed -i 's/seed of all random numbers/seed/' own/campaign.schema.json
expect 0 "$ideotype" new own/newer.toml "${place[@]}" "${field[@]}" --plant maize
[ "$(cat out.log)" = "$(printf 'own/newer.toml\nnext: ideotype check own/newer.toml')" ] ||
    fail "more than the campaign is new: $(cat out.log)"
"$ideotype" schema | cmp - own/campaign.schema.json
for text in '{"title": 1}' '{"title": "Campaign"}' '[]' 'no JSON' ''; do
    echo "$text" >links/campaign.schema.json
    expect 4 "$ideotype" new links/my.toml "${place[@]}" "${field[@]}" --plant maize
    says "links/campaign.schema.json: exists already .*not a JSON Schema of campaigns"
    [ "$(cat links/*)" = "$text" ] || fail "something else is there: $(ls links)"
done
rm links/campaign.schema.json
# A second campaign uses the same crop file, but a changed file is not accepted
# as the original.
expect 0 "$ideotype" new own/second.toml "${place[@]}" "${field[@]}" \
    --plant maize --objective net_assimilation --name bread --utc-offset -5
expect 0 "$ideotype" check own/second.toml
says "^campaign  bread, "
! grep -q leaf_reflectance own/my.toml || fail "optics of the plant are hidden"
sed -i 's/^height = 1.61/height = 1.62/' own/maize.toml
expect 4 "$ideotype" new own/third.toml "${place[@]}" "${field[@]}" --plant maize
says "own/maize.toml: exists already .*--plant own/maize.toml"
[ ! -e own/third.toml ] || fail "half of it was written"
expect 0 "$ideotype" new other/third.toml "${place[@]}" "${field[@]}" \
    --plant own/maize.toml
grep -q '^baseline = "../own/maize.toml"' other/third.toml ||
    fail "not a path from the campaign: $(cat other/third.toml)"
expect 0 "$ideotype" check other/third.toml
[ ! -e other/maize.toml ] || fail "a plant of the user's was copied"

# The within-line variation is taken from the crop file, or unknown; the cell is
# large enough for dense plants.
expect 0 "$ideotype" new own/broad.toml "${place[@]}" --row 0.76 \
    --plant-spacing 0.04 --plant soybean
for line in 'jitter = 180  *#' 'insertion_angle = 15  *#' 'azimuth = 20  *#' \
    'rows = 2  *#' 'plants = 8  *#'; do
    grep -q "^$line" own/broad.toml || fail "no '$line' in $(cat own/broad.toml)"
done
grep -qE '^(across_row|twist|roll|late|missing) ' own/broad.toml &&
    fail "soybean varies as maize does"
expect 0 "$ideotype" check own/broad.toml
says "^field     2 x 8 plants"
expect 0 "$ideotype" new own/panicle.toml "${place[@]}" "${field[@]}" \
    --plant sorghum
grep -q '^\[field.variation\]' own/panicle.toml && fail "values of another crop"
grep -q '^# The crop file has no \[variation\]: the within-line variation' \
    own/panicle.toml || fail "$(cat own/panicle.toml)"
expect 0 "$ideotype" check own/panicle.toml

# A season of weather, from a table with units in its column names.
cp "$project/campaigns/weather/bondville_2011_0721_0920.csv" own/bondville.csv
season=(--latitude 40.05 --longitude -88.37)
expect 0 "$ideotype" new other/season.toml "${season[@]}" "${field[@]}" \
    --plant campaigns/crops/maize.toml --weather own/bondville.csv
for line in 'file = "../own/bondville.csv"  *#' 'from = 2011-07-21  *#' \
    'to = 2011-09-19  *#' 'time = \["time"\]  *#' 'stamp = "end"  *#' \
    'global = \["ppfd_umol", "umol/m2/s"\] #' \
    'temperature = \["temp_c", "C"\] #' 'wind = \["wind_m_s", "m/s"\]  *#'; do
    grep -q "^$line" other/season.toml || fail "no '$line': $(cat other/season.toml)"
done
grep -q '^\[\[day\]\]' other/season.toml && fail "a day and a climate"
expect 0 "$ideotype" check other/season.toml
says "the light comes 0.5 h earlier .* set stamp = \"middle\" if"
# The table of a logger has dates with the month first; their order is inferred
# from the rows.
awk -F '[,T-]' 'NR == 1 { print "Date,Time,Solar rad (W/m2),Air temp (F),RH" }
    NR > 1 { print $2 "/" $3 "/" $1 "," substr($4, 1, 5) "," $6 / 2.06 "," 9 * $8 / 5 + 32 ",0.5" }' \
    own/bondville.csv >own/logger.csv
expect 0 "$ideotype" new other/logger.toml "${season[@]}" "${field[@]}" \
    --plant campaigns/crops/maize.toml --weather own/logger.csv
for line in 'time = \["Date", "Time"\]  *#' 'date_order = "month_day_year"  *#' \
    'global = \["Solar rad (W/m2)", "W/m2"\] #' \
    'temperature = \["Air temp (F)", "F"\] #'; do
    grep -q "^$line" other/logger.toml || fail "no '$line': $(cat other/logger.toml)"
done
grep -q '^humidity' other/logger.toml && fail "a humidity without a unit"
expect 0 "$ideotype" check other/logger.toml
# If the order is not stated, one error reports it for all rows.
sed '/^date_order/d' other/logger.toml >other/no_order.toml
expect 3 "$ideotype" check other/no_order.toml
says '"07/21/2011,00:00" is not a date and time; set date_order = "month_day_year" (this line and 1487 others)$'
[ "$(grep -c 'is not a date' out.log)" -eq 1 ] || fail "the same again and again"
# For files written by `ideotype weather` no columns need to be stated.
cp "$project/tests/data/weather/converted.csv" own/native.csv
expect 0 "$ideotype" new other/native.toml --latitude 36.1 --longitude -79.95 \
    "${field[@]}" --plant campaigns/crops/maize.toml --weather own/native.csv
grep -qE '^(time|global|stamp) = ' other/native.toml && fail "columns are named"
sed 's/ppfd_umol/light/' own/bondville.csv >own/dark.csv
expect 3 "$ideotype" new other/dark.toml "${season[@]}" "${field[@]}" \
    --plant campaigns/crops/maize.toml --weather own/dark.csv
says "no columns of time and light are recognised (the file has time, light, "

# The lowest leaf is small, beyond the ranges of the crop.
sed -e 's/"breedable"/"other"/' \
    -e '/^\[\[leaf\]\] # 1$/,/^$/ { s/^length.*/length = 0.03/; s/^width.*/width = 0.02/ }' \
    campaigns/crops/sorghum.toml >own/short.toml
expect 0 "$ideotype" new other/short.toml "${place[@]}" "${field[@]}" \
    --plant own/short.toml
grep -q '^length = \[0.03, ' other/short.toml ||
    fail "bounds that the baseline is beyond: $(cat other/short.toml)"
expect 0 "$ideotype" check other/short.toml
# A small number is not rounded to 0.
sed -i 's/^width = 0.02$/width = 0.004/' own/short.toml
expect 0 "$ideotype" new other/narrow.toml "${place[@]}" "${field[@]}" \
    --plant own/short.toml
grep -q '^width = \[0.004, ' other/narrow.toml || fail "$(cat other/narrow.toml)"
expect 0 "$ideotype" check other/narrow.toml
# A table of measured leaves is not accepted as a crop file.
printf '# crop: maize\nlength_cm\n30\n' >own/field.csv
expect 3 "$ideotype" new other/bad.toml "${place[@]}" "${field[@]}" \
    --plant own/field.csv
says "make a crop file of it: ideotype fit own/field.csv"

# Polar day and polar night.
expect 0 "$ideotype" new own/north.toml --latitude 70 --longitude 25 \
    --date 2021-06-21 "${field[@]}" --plant sorghum
grep -q '^end = "24:00"' own/north.toml || fail "no polar day"
expect 0 "$ideotype" check own/north.toml
expect 2 "$ideotype" new own/night.toml --latitude 70 --longitude 25 \
    --date 2021-12-21 "${field[@]}" --plant own/maize.toml
says "the sun does not rise on 2021-12-21"

# Wrong options are reported at once, and no file remains.
expect 2 "$ideotype" new none.toml --latitude 42 </dev/null
says "new: missing --longitude, --date, --row, --plant-spacing, --plant (on"
[ "$(wc -l <out.log)" -eq 1 ] || fail "not one line"
expect 2 "$ideotype" new none.toml --latitude 95 </dev/null
says "new: --latitude: site.latitude is 95 deg (above the range -90 .. 90 deg)"
# All wrong options are reported together; for lengths the message suggests the
# likely unit.
expect 2 "$ideotype" new none.toml --latitude north --longitude -93.63 \
    --row 30 --plant-spacing 0.15 --plant corn --objective light \
    --date 2021-02-30 --weather none.csv </dev/null
says 'new: --latitude: "north" is not a valid latitude (expected: a number, -90 .. 90 deg)'
says "new: --row: spacing.row is 30 m .* looks like centimetres or inches)"
says "give metres: 0.3 or 0.762"
says "new: --plant: there is no crop (and no file) 'corn'; did you mean 'maize'?"
says "new: --date: .* is not a date"
says "new: --weather: cannot read none.csv"
says "new: --date and --weather are both given (the days are those of the weather file)"
says "new: --objective: there is no objective 'light'; use one of carbon_balance, net_assimilation, absorbed_par, net_assimilation_per_leaf_area, or"
[ "$(wc -l <out.log)" -eq 7 ] || fail "not a line for each: $(cat out.log)"
expect 2 "$ideotype" new none.toml "${place[@]}" --date 2021-02-30
expect 2 "$ideotype" new none.toml --date 2021-02-30 </dev/null
says '"2021-02-30" is not a date'
expect 2 "$ideotype" new none.toml --plant maze </dev/null
says "did you mean 'maize'"
expect 2 "$ideotype" new none.toml --objective light </dev/null
says "there is no objective 'light'; use one of carbon_balance, net_assimilation,"
! grep -qE "paths|capped|balance_error" out.log || fail "internals are offered"
expect 2 "$ideotype" new none.toml --objective net_assimilaton </dev/null
says "did you mean 'net_assimilation'"
expect 2 "$ideotype" new none.toml "${place[@]}" "${field[@]}" \
    --plant maize --objective transpiration
says "needs leaves that transpire" "edit a copy of campaigns/growing_season.toml"
expect 2 "$ideotype" new nowhere/none.toml "${place[@]}" "${field[@]}" \
    --plant maize
says "there is no folder nowhere"
expect 3 "$ideotype" new none.toml "${place[@]}" "${field[@]}" --plant maize \
    --name "my own"
says 'none.toml:.*name is "my own"'
[ -z "$(ls none.toml maize.toml campaign.schema.json 2>/dev/null)" ] || fail "something is left"

# On a terminal the command asks for each missing option until the answer is
# valid.
{
    echo 42.03
    echo west
    echo -93.63
    echo
    echo 2021-13-01
    echo 2021-07-01
    echo 0.762
    echo 0.15
    echo
    echo paths
    echo yield
    echo carbon_balance
} >answers
expect 0 script -qec "'$ideotype' new asked.toml" /dev/null <answers
says "Latitude of the site"
says '"west" is not a valid longitude (expected: a number, -180 .. 180 deg)'
says "Weather file, hourly CSV (leave empty for a clear day): "
says '"2021-13-01" is not a date'
says "(maize): "
says "^  carbon_balance"
says "^  net_assimilation_per_leaf_area"
says "^Name (carbon_balance): "
says "there is no objective 'paths'"
says "there is no objective 'yield'"
! grep -qE "capped|balance_error" out.log || fail "internals are offered"
expect 0 "$ideotype" check asked.toml
diff -b <(sed 's/my/asked/g' own/my.toml) asked.toml ||
    fail "answers make another campaign than options"
# The command does not ask for options that are given.
expect 0 script -qec "'$ideotype' new rest.toml ${place[*]} ${field[*]} \
    --plant maize" /dev/null <<<$'\n'
grep -q "Latitude" out.log && fail "a given option is asked for"
expect 2 script -qec "'$ideotype' new ended.toml" /dev/null </dev/null
says "the input ended before --latitude was given"
