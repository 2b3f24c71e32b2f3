#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the output and the exit code of every command.
. "$(dirname "$0")/common.sh"

write_campaign commands 6 2
expect 0 "$ideotype" --version
says "Embree [34]\."
says "HDF5 1"
expect 0 "$ideotype" --help
says "evaluate"
expect 2 "$ideotype" fly
says "use one of new, check, schema, run"
expect 2 "$ideotype" chek campaigns/commands.toml
says "did you mean 'check'"
expect 3 "$ideotype" evaluate campaigns/crops/maize.toml
says "maize.toml:1:1: this is a crop file .*ideotype compare PLANT --under CAMPAIGN"
expect 2 "$ideotype"
expect 2 "$ideotype" run campaigns/commands.toml --thread 2
says "^ideotype: run: there is no option --thread; did you mean --threads?$"
expect 2 "$ideotype" status results --jsno
says "status: there is no option --jsno; did you mean --json?"
expect 2 "$ideotype" check campaigns/commands.toml --xyz=3
says "check: there is no option --xyz; see ideotype check --help"
expect 2 "$ideotype" check campaigns/commands.toml more
says "check: unexpected argument 'more'; see ideotype check --help"
expect 2 "$ideotype" run campaigns/commands.toml --wall-time soon
says "'soon' is not a duration; write for example 90, 90s, 30m, 2h, 1h30m or 01:30:00"
expect 1 "$ideotype" check campaigns/missing.toml
says "missing.toml"

expect 0 "$ideotype" check campaigns/commands.toml
says "LAI 3.44"
says "^advice    the stand is uniform; "
says "^next: ideotype run campaigns/commands.toml$"
says "^leaves    absorb light; assimilation is not computed$"
says "^growth    none: plants are those of the crop file on all days, with leaves as at silking$"
says "^search    ga, generations of 6 plants, at most 12 plants$"
says "Ames  *42 N 93.6 W  *0807  *1  *64.2 deg  *0.2 %  *+1.24 h  *UTC-5  *06:19  *13:20  *20:20"
sed -e 's/^start = .*/start = 01:00:00/' -e 's/^end = .*/end = 05:00:00/' \
    campaigns/commands.toml >campaigns/dark.toml
for command in check run evaluate; do
    expect 3 "$ideotype" $command campaigns/dark.toml
    says "dark.toml:10:9: day .* no light .* from 06:19 to 20:20); give"
done
sed 's/^utc_offset = .*/utc_offset = -4/' campaigns/commands.toml \
    >campaigns/clock.toml
expect 0 "$ideotype" check campaigns/clock.toml
says "warning: campaigns/clock.toml:7:14: site.utc_offset is -4 h"
# Several cases are printed as ranges, and a warning names the stands with too
# many leaves.
sed -e 's/^\[spacing\]/[[spacing]]\nrow = 0.2\nplant = 0.1524\n[[spacing]]/' \
    campaigns/commands.toml >campaigns/dense.toml
expect 0 "$ideotype" check campaigns/dense.toml
says "^campaign  commands, 2 cases"
says "period 0.6 .. 2.286 x 0.4572 m, LAI 3.44 .. 13.10, "
says "warning: campaigns/dense.toml:14:7: spacing.row is 0.2 m (with 0.1524 m between plants the baseline has a leaf area index of 13.10, and fields hardly ever have more than 8); check both distances"
expect 0 "$ideotype" run campaigns/dense.toml --case 0 --out dense
says "warning: campaigns/dense.toml:14:7: spacing.row is 0.2 m"
says "; this plant has a leaf area index of 1[0-9.]*, and fields hardly ever have more than 8; limit .constraints. lai, or maximise carbon_balance"
expect 0 "$ideotype" status dense
says "(re-evaluated), gain .*, 0 failed; this plant has a leaf area index of 1"
expect 0 "$ideotype" check campaigns/commands.toml --set field.variation.length=0.05
! grep -q "the stand is uniform" out.log || fail "the stand is variable: $(cat out.log)"
expect 0 "$ideotype" check campaigns/commands.toml --set seed=3
says "^next: ideotype run campaigns/commands.toml --set seed=3$"
says "^ *128  *[0-9:]* *$"
# The source of photosynthesis is printed, and the use of default values causes
# a warning.
sed '/^\[photosynthesis\]/,/^\]/d' campaigns/crops/maize.toml >campaigns/crops/bare.toml
bare=(campaigns/commands.toml --set objective.maximise=carbon_balance
    --set plant.baseline=crops/bare.toml)
for command in check run; do
    expect 0 "$ideotype" $command "${bare[@]}" --set replicates=2 --out bare
    [ "$(grep -c 'warning: .*crops/bare.toml:.* the crop "b73" has no .photosynthesis.' out.log)" = 1 ] ||
        fail "not one warning: $(cat out.log)"
done
expect 0 "$ideotype" check "${bare[@]}"
says "^leaves    hyperbola, amax 50 (default), 30 deg C on clear days$"
expect 0 "$ideotype" check "${bare[@]}" --set photosynthesis.amax=40
says "^leaves    hyperbola (default), amax 40 (--set photosynthesis.amax=40), 30 deg C on clear days$"
! grep -q "has no .photosynthesis." out.log || fail "stated leaves are warned of: $(cat out.log)"
expect 0 "$ideotype" check campaigns/commands.toml --set objective.maximise=carbon_balance
says "^leaves    hyperbola, amax 63.9294, rate_2000 52 (maize.toml), 30 deg C on clear days$"
hybrid=(--set plant.baseline=crops/maize_hybrid.toml --set plant.bounds=traits --set plant.stage=1.75)
expect 0 "$ideotype" check campaigns/commands.toml "${hybrid[@]}"
says "on all days, with leaves as at development stage 1.75 (0.7 of the capacity at silking)$"
# The first generation of `auto` is smaller than the others or, with constraints,
# larger. The log counts the same plants as `check`.
auto=(--set search.optimizer=auto --set search.population=8 --set stop.generations=5)
expect 0 "$ideotype" check campaigns/commands.toml "${auto[@]}"
says "^search    auto, generations of 8 plants (the first of 5), at most 40 plants$"
auto+=(--set "constraints.lai=[0, 100]")
expect 0 "$ideotype" check campaigns/commands.toml "${auto[@]}"
says "^search    auto, generations of 8 plants (the first of 24), at most 40 plants$"
says "^cost      40 evaluations of "
expect 0 "$ideotype" run campaigns/commands.toml "${auto[@]}" --out auto
says "  generation 0, 24 of 40 plants, "
says "  generation 2, 40 of 40 plants, "
says "reached stop.generations; "
says "finished (reached stop.generations), 40 of 40 plants in 3 generations, "
expect 0 "$ideotype" check campaigns/commands.toml --cases
says "^ *0  ames_0807_762x152_all_r1  *[0-9]*$"
expect 0 "$ideotype" check campaigns/commands.toml --count
says "^1$"
expect 0 "$ideotype" check campaigns/commands.toml --left
[ "$(cat out.log)" = "0	0" ] || fail "a case to begin is left: $(cat out.log)"
expect 2 "$ideotype" check campaigns/commands.toml --left --count

{
    cat campaigns/commands.toml
    printf '[constraints]\nlai = [100, 200]\n'
} >campaigns/dense.toml
expect 0 "$ideotype" check campaigns/dense.toml
says "the baseline violates .constraints."

# The baseline must be within the bounds only for a search.
sed -e '/^bounds = /d' \
    -e 's/^baseline = .*/&\nbounds = { length = [1.05, 1.1] }/' \
    campaigns/commands.toml >campaigns/narrow.toml
expect 0 "$ideotype" evaluate campaigns/narrow.toml
expect 0 "$ideotype" check campaigns/narrow.toml
says "warning: campaigns/crops/maize.toml:.*leaf.length of leaf 1 .*outside the table's bounds 1.05 .. 1.1 m"
says "narrow.toml:.*write in .plant.bounds.:"
says "^length = .*, 1.1]$"
for command in run sensitivity; do
    expect 3 "$ideotype" $command campaigns/narrow.toml
    says "leaf.length of leaf 1 .*outside the table's bounds 1.05 .. 1.1 m"
done

sed 's/plants = 3/plnats = 3/' campaigns/commands.toml >campaigns/typo.toml
expect 3 "$ideotype" check campaigns/typo.toml
says "typo.toml:18:1"
says "plants"
expect 3 mpirun -n 3 "$ideotype" run campaigns/typo.toml
says "typo.toml:18:1"

expect 0 "$ideotype" evaluate campaigns/commands.toml
says "incident"
says "^--all also prints .*hours"
[ "$(wc -l <out.log)" -lt 40 ] || fail "more than a screen: $(cat out.log)"
# The objective is listed once, and quantities of the method are separate from
# the others.
[ "$(grep -c " absorbed_par  " out.log)" -eq 1 ] || fail "not one objective"
for word in balance_error capped paths; do
    sed '1,/^method/d' out.log | grep -q "^  $word " || fail "$word is no method"
    ! sed '/^method/,$d' out.log | grep -q "$word" || fail "$word twice"
done
expect 0 "$ideotype" evaluate campaigns/commands.toml --all
says "^  leaf10 "
expect 0 "$ideotype" evaluate campaigns/commands.toml --json
says '"leaf_by_layer"'
expect 2 "$ideotype" evaluate campaigns/commands.toml --case 1

expect 0 "$ideotype" run campaigns/commands.toml
says "finished (reached stop.generations), 12 of 12 plants in 2 generations, .*, gain .* %, LAI .* (baseline 3.44), 12 evaluations in 0:0[0-9], 0 failed$"
told=$(grep -o "12 of 12 plants in 2 generations, best .*" out.log)
# Lines of a log file begin with the time (UTC), and number generations as in
# the history.
says "^20[0-9-]*T[0-9:]*Z  ames.*  generation 1, 12 of 12 plants, "
says "best .* MJ m-2 day-1 (not re-evaluated)$"
says "one seed: ± is half of a 95 % confidence interval of light noise"
says "^next: ideotype report results/commands -o results/commands/report$"
# On a terminal one line is overwritten repeatedly; it must not wrap.
for columns in 60 80 100 200; do
    expect 0 script -qec "stty cols $columns; '$ideotype' run \
        campaigns/commands.toml --out terminal$columns" /dev/null
    tr '\r' '\n' <out.log | sed 's/\x1b\[K//' | grep "time left " >live ||
        fail "no live line: $(cat out.log)"
    grep -q " of 12 plants" live || fail "no plants: $(cat live)"
    [ "$(wc -L <live)" -lt "$columns" ] ||
        fail "a live line is wider than $columns: $(cat live)"
done
history=$(history_of results commands)
expect 0 "$ideotype" status "$history"
says "12 of 12 plants in 2 generations, best .* MJ m-2 day-1 (re-evaluated)"
says "finished (reached stop.generations), $told$"
says "^one seed: ± is half of a 95 % confidence interval of light noise"
expect 0 "$ideotype" check campaigns/commands.toml --left
[ ! -s out.log ] || fail "a finished case is not left"
expect 0 "$ideotype" check campaigns/commands.toml --left --out elsewhere
says "^0"
for slot in 0 3 5; do
    expect 0 "$ideotype" evaluate "$history" --generation 1 --slot $slot
    says "agrees bit for bit"
done
expect 0 "$ideotype" evaluate "$history" --best
says "agrees bit for bit"
expect 2 "$ideotype" evaluate "$history" --generation 2 --slot 0
expect 2 "$ideotype" evaluate "$history"
says "--best"

expect 0 "$ideotype" export "$history" --best --to plant.obj
[ "$(grep -c '^g leaf' plant.obj)" -eq 10 ] || fail "not one group per leaf"
expect 0 "$ideotype" export "$history" --generation 0 --slot 0 --field \
    --to field.obj
[ "$(grep -c '^g plant.*leaf' field.obj)" -eq 90 ] || fail "not nine plants"
# Read as a mesh, the exported field has the leaf area of the baseline and its
# stalks.
expect 0 "$ideotype" light field.obj --period 2.286 0.4572 \
    --sun 60 180 --tolerance 0.05
says "^lai  *3.4[34]"
says "^stalk  "
# Plants at the edge of an isolated plot are cut, so that plants differ in their
# numbers of faces.
sed -e 's/"commands"/"cut"/' -e '/^\[field\]/a boundary = "isolated"\nborder_rows = 1' \
    campaigns/commands.toml >campaigns/cut.toml
expect 0 "$ideotype" run campaigns/cut.toml
expect 0 "$ideotype" export "$(history_of results cut)" --generation 0 --slot 0 \
    --field --to cut.obj
[ "$(grep -c '^g plant005_leaf' cut.obj)" -eq 10 ] || fail "no middle plant"
[ -z "$(grep '^g ' cut.obj | sort | uniq -d)" ] ||
    fail "a group of a cut plot is in two pieces"
expect 0 "$ideotype" export "$history" --best --to plant.csv
[ "$(wc -l <plant.csv)" -eq 11 ] || fail "not ten leaves"
expect 0 "$ideotype" export "$history" --generations --to all.csv
[ "$(wc -l <all.csv)" -eq 13 ] || fail "not one line for each row and its head"
head -1 all.csv | tr , '\n' >heads
! grep -q '[^A-Za-z0-9_]' heads || fail "odd letters in $(cat heads)"
# Exported measures of the plant are not traits, and no trait is exported as a
# measure.
head -1 plant.csv | tr , '\n' | grep -vE '^(leaf|insertion_height_m|roll_deg|twist_deg)$' |
    sed 's/^/leaf07_/' | sort >expected
grep '^leaf07' heads | grep -v azimuth_deviation | sort | cmp - expected ||
    fail "not the heads of --best"
for name in origin absorbed_par_MJ_per_m2_per_day stalk_fraction paths lai_m2_per_m2 \
    absorbed_by_source_beam_standard_error_MJ_per_m2_per_day balance_error; do
    grep -qx $name heads || fail "no $name in $(cat heads)"
done
grep -q 'absorbed_by_hour\|absorbed_by_leaf' heads && fail "profiles are no scalars"
awk -F, 'NF != '"$(wc -l <heads)"' { exit 1 }' all.csv || fail "uneven lines"
expect 0 "$ideotype" export "$history" --best --to bred.toml
for shape in plant field; do
    [ $shape = plant ] && whole=() || whole=(--field)
    expect 0 "$ideotype" export "$history" --best "${whole[@]}" --to $shape.vtp
    grep -q 'absorbed_par \[MJ m-2 day-1\]' $shape.vtp || fail "no light"
done
grep -q "repeats every 2.286000 m in x and 0.457200 m in y" field.obj ||
    fail "the field file lacks its period"
expect 2 "$ideotype" export "$history" --best --paths 1 --to dark.vtp
expect 4 "$ideotype" export "$history" --best --to plant.obj
# Output is refused if its path is a symbolic link, even if the target does not
# exist.
for ending in csv toml obj vtp; do
    ln -s elsewhere.txt "link.$ending"
    expect 4 "$ideotype" export "$history" --best --to "link.$ending"
    says "link.$ending: this is a symbolic link"
done
ln -s elsewhere.txt links.csv
expect 4 "$ideotype" export "$history" --generations --to links.csv
says "links.csv: this is a symbolic link"
[ -L links.csv ] && [ ! -e elsewhere.txt ] || fail "a link was followed"
expect 2 "$ideotype" export "$history" --best --to plant.doc

# Resuming a finished case repeats its summary and evaluates nothing.
expect 0 "$ideotype" run campaigns/commands.toml --resume
says "$history: finished before (reached stop.generations), $told$"
[ "$(grep -vc "^next: \|^one seed: " out.log)" -eq 1 ] || fail "not one line a case: $(cat out.log)"

# The largest permitted number of cases is checked in little memory, because
# cases are made one at a time; all cases together would need ten times as much.
write_campaign many 12 3
{
    printf 'replicates = 1000\n'
    sed 's/^\[spacing\]/[[spacing]]/' campaigns/many.toml
    printf '[[spacing]]\nrow = 0.5\nplant = 0.%s\n' $(seq 101 199)
} >campaigns/all.toml
expect 0 "$ideotype" check campaigns/all.toml --count
says "^100000$"
limited=(bash -c 'ulimit -d 200000; exec "$@"' -)
if "${limited[@]}" "$ideotype" check campaigns/many.toml >/dev/null 2>&1; then
    expect 0 "${limited[@]}" "$ideotype" check campaigns/all.toml
    says "^campaign  many, 100000 cases "
else
    echo "THIS BUILD NEEDS MORE MEMORY FOR A SINGLE CASE: NOT TESTED" >&2
fi

# A time limit of this session stops the run in an orderly way.
write_campaign limited 12 400
expect 5 "$ideotype" run campaigns/limited.toml --wall-time 1s
says "stopped before the end"
