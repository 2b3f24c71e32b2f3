#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the cost of staying close to measured lines of maize.

feasible.py FOLDER [--evaluations N] [--rough]

Optimises the smooth traits of crops/maize.toml in rows of 30 inches with 6
inches between plants, under within-line variation, for absorbed PAR and net
assimilation of a clear day and for the carbon of a season. Plants may have any
distance from 281 inbred lines (lines/maize_panel.toml), or at most 3 standard
deviations, where a typical line has 2.6. Prints baseline, optimised plant,
gain and both distances. ± is half of a 95 % interval.
"""

from __future__ import annotations

import tomllib
from typing import Any

import numpy as np
from conditions import AT_SILKING
from estimates import gain, plus_minus, print_table
from fields import DAY, SEASON
from shared import (
    BREEDABLE,
    CAMPAIGNS,
    ROUGH,
    TITLES,
    best,
    breed_tables,
    finals,
    guard,
    objectives,
    parser_of_searches,
)  # fmt: skip

import ideotype
from ideotype import Stand

LINES = CAMPAIGNS / "lines" / "maize_panel.toml"
LIMITS = {"any": 0.0, "at most 3": 3.0}
QUANTITIES = ["distance_from_lines", "distance_from_line", "lai"]


def campaign(objective: str, limit: float) -> dict[str, Any]:
    """Returns the tables of a search with a limit on the distance from
    measured lines."""
    under = SEASON if objective == "carbon_balance" else DAY
    tables = tomllib.loads(under.read_text())
    kept = ("site", "day", "climate", "photosynthesis")
    name = f"{objective}_{'limited' if limit else 'free'}"
    found = {key: tables[key] for key in kept if key in tables}
    for each in found.get("climate", []):
        each["file"] = str(under.parent / each["file"])
    return {
        **found,
        **BREEDABLE,
        "name": name,
        "objective": {"maximise": objective},
        "feasibility": {"lines": str(LINES), "limit": limit},
    }


def main() -> None:
    parser = parser_of_searches(__doc__, evaluations=2400)
    options = parser.parse_args()
    rows = []
    for objective in AT_SILKING:
        for limit, distance in LIMITS.items():
            tables = campaign(objective, distance) | {
                "stop": {"evaluations": options.evaluations}
            }
            if options.rough:
                tables |= ROUGH
            (history,) = breed_tables(tables, options.folder)
            stand = Stand.from_history(history, same_isa=False)
            plants = np.array([stand.baseline, best(history)])
            found = finals(stand, plants, QUANTITIES)
            values = objectives(found)
            with ideotype.open_history(history) as opened:
                unit = opened.objectives[0].unit
            rows.append(
                [
                    f"{TITLES[objective]} [{unit}]",
                    limit,
                    *(f"{each.mean():.4g}" for each in values),
                    plus_minus(gain(*values.tolist()), 2, "+"),
                    *(
                        " -> ".join(f"{x:.2f}" for x in found[name].values)
                        for name in QUANTITIES
                    ),
                ]
            )
    titles = ["objective", "distance allowed", "baseline", "bred", "gain [%]"]
    titles += ["distance from lines", "distance from B73", "leaf area index"]
    print_table(titles, rows)


if __name__ == "__main__":
    guard(main)
