#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# An OBJ file of any plant model, on the command line.
#
# The verb `light` reads surfaces and tells where the light of a sun goes. The
# lower the sun, the less of its light comes to the soil, but a stand in rows is
# open along them. This teaches `light`, its JSON, and that a mesh repeats with
# a period.
set -euo pipefail

plant=analysis/benchmark/meshes/maize.obj
echo "elevation of the sun [deg],across the rows [light that comes to the soil],along the rows" >02_any_mesh.csv
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
