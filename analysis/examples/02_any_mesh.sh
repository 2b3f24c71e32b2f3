#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# An OBJ file of any plant model, on the command line.
#
# The command `light` computes the light of a sun that each surface absorbs. The
# lower the sun, the smaller the fraction of light on the soil, but gaps between
# rows let it pass along them. This example uses `light`, its JSON and a mesh
# that repeats periodically.
set -euo pipefail

plant=analysis/benchmark/meshes/maize.obj
echo "solar elevation [deg],across the rows [fraction of light on the soil],along the rows" >02_any_mesh.csv
for elevation in 10 20 30 45 60 75 90; do
    line=$elevation
    for azimuth in 90 180; do
        light=$(ideotype light "$plant" --period .76 .2 --paths 20000 \
            --sun "$elevation" "$azimuth" --json)
        line+=,$(python3 -c 'import json, sys
print(json.load(sys.stdin)["soil"]["mean"])' <<<"$light")
    done
    echo "$line" >>02_any_mesh.csv
done
cat 02_any_mesh.csv
