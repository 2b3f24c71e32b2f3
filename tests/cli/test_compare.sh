#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Plants in the same light: values, paired differences, profiles; measured
# plants; what is told of wrong use.
. "$(dirname "$0")/common.sh"

write_campaign light 8 2
under=(--under campaigns/light.toml)
elite=campaigns/plants/elite.toml
b73=campaigns/crops/maize.toml

# $1 a file of CSV, $2 plant, $3 quantity, $4 leaf or "", $5 a column
entry() {
    awk -F, -v plant="$2" -v quantity="$3" -v leaf="$4" -v column="$5" '
        NR == 1 { for (i = 1; i <= NF; ++i) if ($i == column) at = i }
        $1 == plant && $3 == quantity && $5 == leaf { print $at; exit }' "$1"
}

# $1 what must hold of numbers
holds() {
    awk "BEGIN { exit !($1) }" || fail "not so: $1"
}

expect 0 "$ideotype" compare $b73 $elite "${under[@]}" --csv all.csv
says "^absorbed_par .MJ m-2 day-1. of each plant in each case"
says "^  elite .* +- .* +- .* (+[0-9.]* +- [0-9.]* %)$"
# Per cent of what is exact have no error.
says "^  elite  *[0-9.]*  *[0-9.]* (+[0-9.]* %)$"
says "^lai .m2 m-2.$"
! grep -E "0\.000000|[0-9]e-1[0-9]" out.log || fail "zeros have tails"
[ "$(head -1 all.csv)" = "plant,case,quantity,unit,leaf,layer_m,mean,standard_error,difference,difference_standard_error" ] ||
    fail "another head: $(head -1 all.csv)"
head -2 all.csv | tail -1 |
    grep -q '^b73,ames_0807_762x152_all,absorbed_par,MJ m-2 day-1,,,' ||
    fail "the objective does not come first"
[ "$(grep -c '^elite,.*,absorbed_by_leaf,' all.csv)" -eq 10 ] ||
    fail "not ten leaves"
awk -F, 'NF != 10 { exit 1 }' all.csv || fail "uneven lines"
# A difference is one of means; its error is less than that of two that do not
# share their random numbers.
for leaf in "" 9; do
    [ -z "$leaf" ] && what=absorbed_par || what=absorbed_by_leaf
    a=$(entry all.csv b73 $what "$leaf" mean)
    b=$(entry all.csv elite $what "$leaf" mean)
    by=$(entry all.csv elite $what "$leaf" difference)
    error_a=$(entry all.csv b73 $what "$leaf" standard_error)
    error_b=$(entry all.csv elite $what "$leaf" standard_error)
    error=$(entry all.csv elite $what "$leaf" difference_standard_error)
    holds "($b - $a - $by)^2 < 1e-24 && $by != 0"
    holds "$error > 0 && $error < 1.5 * sqrt($error_a^2 + $error_b^2)"
done
holds "$(entry all.csv elite lai "" difference_standard_error) == 0"
expect 4 "$ideotype" compare $b73 $elite "${under[@]}" --csv all.csv
says "all.csv: exists already and is not overwritten"

# The result is a function of plant, campaign and seed.
for_seed() { "$ideotype" compare $b73 $elite "${under[@]}" "${@:2}" --json >"$1"; }
for_seed own.json
for_seed seven.json --seed 7
for_seed nine.json --seed 9
for_seed set.json --set seed=9
cmp own.json seven.json || fail "the seed of the campaign is another"
cmp nine.json set.json || fail "--seed is not --set seed"
cmp -s own.json nine.json && fail "another seed changes nothing"
"$ideotype" evaluate campaigns/light.toml --set seed=9 --json >baseline.json
mean=$(sed -n '/"absorbed_par": {/,/}/s/.*"mean": \([0-9.]*\),*/\1/p' baseline.json)
[ -n "$mean" ] && grep -q "^ *$mean,*$" nine.json ||
    fail "evaluate and compare differ: $mean in $(cat nine.json)"
for name in objective unit seed plants cases mean standard_error difference \
    by_randomisation quantities profiles coordinates; do
    grep -q "\"$name\"" own.json || fail "no $name in $(cat own.json)"
done
for threads in 1 3; do
    for_seed threads.json --threads $threads
    cmp own.json threads.json || fail "$threads threads compare otherwise"
done
# More accurate, with as many paths as that takes.
"$ideotype" compare $b73 "${under[@]}" --tolerance 0.001 --csv exact.csv >/dev/null
holds "$(entry exact.csv b73 absorbed_par "" standard_error) < \
    .0015 * $(entry exact.csv b73 absorbed_par "" mean)"
holds "$(entry exact.csv b73 paths "" mean) > \
    4 * $(entry all.csv b73 paths "" mean)"
expect 2 "$ideotype" compare $b73 "${under[@]}" --tolerance 2
expect 0 "$ideotype" compare $b73 "${under[@]}"
says "^absorbed_par .MJ m-2 day-1. of each plant in each case$"
grep -q "difference" out.log && fail "a difference from nothing"

# Plants of one name are told apart; measured plants take what is not measured
# from the campaign's crop, or from the crop that they name.
cat >field.csv <<'CSV'
leaf,length_cm,width_cm,insertion_angle_from_horizontal_deg,curvature_deg,azimuth_from_row_clockwise_deg,insertion_height_cm
1,40,4.5,40,60,90,20
2,60,6.5,45,60,270,45
3,75,8,50,60,90,70
4,80,8.5,55,50,270,95
CSV
expect 0 "$ideotype" compare $b73 $b73 field.csv "${under[@]}" --csv three.csv
says "^  b73 (2) .* 0$"
says "^  field  "
[ "$(grep -c '^field,.*,absorbed_by_leaf,' three.csv)" -eq 4 ] ||
    fail "not four leaves"
{ echo "# crop: sorghum" && cat field.csv; } >whole.csv
expect 0 "$ideotype" compare field.csv whole.csv "${under[@]}" --csv crops.csv
# Sorghum has other organs than the campaign's maize.
holds "$(entry crops.csv whole stalk_fraction "" difference) != 0"
sed -i '3s/6.5/65/; 1s/azimuth_from_row_clockwise/azimut/' field.csv
expect 3 "$ideotype" compare field.csv "${under[@]}"
says "field.csv:1:75: there is no column 'azimut_deg'; did you mean 'azimuth_deg'?"
says "field.csv:3:6: width_cm is 65 (expected: 0.1 .. 50)"

# The objective is that of the components that weights tell.
beside=("${under[@]}" --set 'component=[{name="other",crop="crops/maize.toml",rows=[2]}]')
for weights in 1,1 1,0 0,1; do
    expect 0 "$ideotype" compare $b73 $elite "${beside[@]}" \
        --set "objective.weights=[$weights]" --csv "weights_$weights.csv"
done
weighed() {
    entry "weights_$1.csv" elite absorbed_par "" mean
}
holds "($(weighed 1,0) + $(weighed 0,1) - $(weighed 1,1))^2 < 1e-18"
holds "$(weighed 1,0) > 0 && $(weighed 0,1) > 0"

# Wrong use.
expect 2 "$ideotype" compare $b73
says "under"
expect 2 "$ideotype" compare $b73 "${under[@]}" --seed -1
