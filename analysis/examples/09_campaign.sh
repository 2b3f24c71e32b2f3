#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Breed plants: run a campaign, and read what came out.
#
# Each generation of plants is evaluated and the next is bred from the best. The
# history has every plant; the page of `report` draws it. The gain has an error,
# and one seed tells little. This teaches `run`, `summary` and `export`.
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
table.columns = ["mean of plants", "best"]
table.to_csv("09_campaign.csv")
PYTHON
