#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A day in a field, hour by hour, on the command line.
#
# A campaign is a file that states a site, a day, a field and a plant. `check`
# reports its mistakes, `evaluate` computes the light that the plant absorbs, and
# --set changes any key. This example uses campaigns and `evaluate --json`.
set -euo pipefail

campaign=campaigns/ames_quick.toml
ideotype check "$campaign" | head -4
for direction in 0 90; do
    ideotype evaluate "$campaign" --set final.paths=4096 \
        --set "spacing=[{ row = 0.762, plant = 0.1524, row_direction = $direction }]" \
        --json >"05_day_$direction.json"
done
python3 - <<'PYTHON'
import csv
import json

days = [json.load(open(f"05_day_{d}.json")) for d in (0, 90)]
columns = [day["hours"] for day in days]
with open("05_day.csv", "w") as file:
    out = csv.writer(file)
    out.writerow(["local time [h]", "rows north-south [absorbed PAR, W m-2]", "rows east-west"])
    for hours in zip(*columns):
        light = (x["incident"] * x["leaf"]["mean"] for x in hours)
        out.writerow([hours[0]["hour"], *(f"{x:.2f}" for x in light)])
PYTHON
