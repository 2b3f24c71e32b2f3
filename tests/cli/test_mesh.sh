#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the output and the errors of `light MESH`.
. "$(dirname "$0")/common.sh"

reference=$project/tests/data/reference

# $1 the expected exit code, $2 a pattern of the output, the rest the options.
light() {
    expect "$1" "$ideotype" light "${@:3}"
    says "$2"
}

maize=("$reference/maize1.obj" --period .76 .15)
light 0 '"mean": 0.92' "${maize[@]}" --sun 60 180 --json \
    --leaf-reflectance 0 --leaf-transmittance 0 --soil-albedo 0 --tolerance 2e-4
for key in incident leaf soil reflected groups plant000_leaf10 lai \
    ground_area_m2 paths seconds standard_error is_met; do
    grep -q "\"$key\"" out.log || fail "no $key in: $(cat out.log)"
done
light 0 "reflected" "${maize[@]}" --sky uniform
light 0 '"hours"' "${maize[@]}" --site 42 -93.6 -5 --date 2025-08-07 --json
for key in leaf_by_origin beam scattered leaf_by_face leaf_by_layer \
    sunlit_leaf_area; do
    grep -q "\"$key\"" out.log || fail "no $key in: $(cat out.log)"
done
light 0 "ground_area_m2  *1.026$" "$reference/maize1.obj" --field 3 3 .76 .15 \
    --jitter 10 --sun 40 90

plot=("$reference/maize1.obj" --boundary isolated --sun 40 90)
light 0 "may exceed 1" "${plot[@]}" --ground-area .114
light 0 '"entered"' "${plot[@]}" --ground-area .114 --json
light 2 "--ground-area" "${plot[@]}"

light 2 "--period X Y is missing" "$reference/maize1.obj" --sun 60 180
light 2 "the light is missing" "${maize[@]}"
light 2 "two light sources" "${maize[@]}" --sun 60 180 --sky uniform
light 2 "needs the position of the sun" "${maize[@]}" --sky clear
light 2 "not above the horizon" "${maize[@]}" --sun -1 180
light 2 "--sun: elevation is nan (not a finite number" "${maize[@]}" --sun nan 180
light 2 "--period: x is nan (not a finite number" "$reference/maize1.obj" \
    --period nan 1 --sun 60 180
light 2 "limit is 1e+04); give 0.0769 deg" "${maize[@]}" --sun 1e-9 180
light 2 "exceed 1" "${maize[@]}" --sun 60 180 --leaf-reflectance .9 \
    --leaf-transmittance .2
light 2 "YYYY-MM-DD" "${maize[@]}" --site 42 -93.6 -5 --date 7.8.2025
light 2 "2025-02-30" "${maize[@]}" --site 42 -93.6 -5 --date 2025-02-30
light 2 "excludes" "${maize[@]}" --sun 60 180 --paths 9 --tolerance .1
light 2 "unexpected argument" "${maize[@]}" campaign.toml --sun 60 180
light 2 "mesh is required" --period 1 1

light 2 "--stalk-reflectance and --stalk-transmittance exceed 1" "${maize[@]}" \
    --sun 60 180 --stalk-reflectance .9 --stalk-transmittance .2
light 0 "^    reflectance  *0.31$" "${maize[@]}" --sun 60 180 --tolerance .1
light 0 '"unit": "fraction of incident"' "${maize[@]}" --sun 60 180 --json \
    --tolerance .1
light 0 '"incident_unit": "W m-2"' "${maize[@]}" --site 42 -93.6 -5 \
    --date 2025-08-07 --tolerance .1 --json
[ "$(grep -c '"incident_unit": "J m-2 day-1"' out.log)" -eq 1 ] ||
    fail "not one unit of the day's light in: $(cat out.log)"

square=(--period 1 1 --sun 60 180 square.obj)
light 1 "cannot read square.obj; name an OBJ file" "${square[@]}"
mkfifo pipe.obj
for thing in "campaigns a folder" "pipe.obj a named pipe" "/dev/zero a device"; do
    read -r path what <<<"$thing"
    light 1 "cannot read $path ($what, no regular file); name an OBJ file" \
        --period 1 1 --sun 60 180 "$path"
done
printf 'v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n' >vertices
: >square.obj
light 3 "square.obj: there are no faces" "${square[@]}"
(cat vertices && echo f 1 2 9) >square.obj
light 3 "square.obj:5:1: a corner is vertex 9" "${square[@]}"
(echo v 0 nan 0 && cat vertices && echo f 1 2 3) >square.obj
light 3 "square.obj:1:5: 'nan'" "${square[@]}"
(cat vertices && echo v 1e9 0 0 && echo f 1 2 5) >square.obj
light 3 "square.obj:5:1: the coordinate 1e+09" "${square[@]}"
(cat vertices && printf 'g \xff\nf 1 2 3 4\nf 1 1 2\n') >square.obj
light 0 "1 faces without area" "${square[@]}" --json

printf 'v 0 0 -1\nv 1 0 1\nv 1 1 1\nf 1 2 3\n' >square.obj
light 0 "warning: .*reaches 1 m below the soil" "${square[@]}" --paths 1000

# The time for very many groups does not exceed the time for as many faces.
awk 'BEGIN { for (i = 0; i < 200000; ++i) {
    x = i % 447 / 447; y = int(i / 447) / 448
    printf "v %.5f %.5f 1\nv %.5f %.5f 1\nv %.5f %.5f 1\ng g%d\nf -3 -2 -1\n",
        x, y, x + .001, y, x, y + .001, i } }' >square.obj
timeout 40 "$ideotype" light "${square[@]}" --paths 1000 --json >out.log ||
    fail "200,000 groups took too long, or failed"
grep -q '"g199999"' out.log || fail "a group is missing"
