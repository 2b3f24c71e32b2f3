#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Optimise plants: run a campaign, and read its results.
#
# Each generation of plants is evaluated, and the next is derived from the best.
# The history contains every plant, and `report` draws it. The gain has a
# confidence interval; a single seed says little about other searches. This
# example uses `run`, `summary` and `export`.
set -euo pipefail

ideotype run campaigns/ames_quick.toml --set stop.generations=12 \
    --set final.paths=4096 --threads 2
ideotype summary results/ames_quick
ideotype export results/ames_quick/*.h5 --generations --to all.csv
python3 - <<'PYTHON'
import pandas as pd

rows = pd.read_csv("all.csv")
light = next(x for x in rows.columns if x.startswith("absorbed_par_MJ"))
table = rows.groupby("generation")[light].agg(["mean", "max"])
table.index.name = "generation"
table.columns = ["population mean [absorbed PAR, MJ m-2 day-1]", "best"]
table.to_csv("09_campaign.csv")
PYTHON
