#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds the leaf nitrogen that a season's carbon needs.

nitrogen.py FOLDER [--evaluations N] [--seeds N] [--rough]

The leaves of a stand share a fixed nitrogen, so that more leaf area dilutes it
(photosynthesis.profile "nitrogen"). For each of several amounts, optimises
crops/maize.toml for the carbon balance of the season measured at Bondville,
Illinois. Traits are those that a breeder can select (bounds "breedable"), and
stands have within-line variation. Evaluates each plant, and the baseline, with
its amount of nitrogen and common random numbers, and prints their carbon, the
gain over the baseline with the usual amount, and the amount from which on
optimised plants have the carbon of that baseline. ± is half of a 95 %
interval.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from climates import bondville, season
from estimates import (
    Estimate,
    estimate,
    gain,
    mean_over_seeds,
    plus_minus,
    print_table,
    sign_change,
)
from shared import (
    BREEDABLE,
    ROUGH,
    Numbers,
    best_plants,
    guard,
    light,
    parser_of_searches,
    say,
)

from ideotype import Stand

#: Leaf nitrogen per ground area [g m-2].
AMOUNTS = (1.5, 2.5, 3.5, 4.5, 6.0)
USUAL = 4.5
"""The default of the program."""


@dataclass(frozen=True)
class Level:
    """The plants optimised with an amount of nitrogen."""

    amount: float
    baseline: Numbers
    """The carbon balance of the baseline, by randomisation."""
    bred: list[Numbers]
    """That of the best plant of each seed."""
    lai: float
    """The mean leaf area index of the best plants."""


def campaign(amount: float, options: argparse.Namespace) -> dict[str, Any]:
    return {
        **BREEDABLE,
        "name": f"nitrogen_{amount:g}".replace(".", "p"),
        "replicates": options.seeds,
        "site": bondville()["site"],
        "climate": [season()],
        "photosynthesis": {"profile": "nitrogen", "nitrogen": amount},
        "objective": {"maximise": "carbon_balance"},
        "stop": {"evaluations": options.evaluations},
        **(ROUGH if options.rough else {}),
    }


def find(amount: float, options: argparse.Namespace) -> Level:
    say(f"optimising with {amount:g} g m-2")
    tables = campaign(amount, options)
    plants = best_plants(tables, options.folder)
    stand = Stand(tables)
    baseline, *bred = light(stand, np.array([stand.baseline, *plants]))
    index = stand.evaluate(np.array(plants), ["lai"], final=True)["lai"]
    return Level(amount, baseline, bred, float(np.mean(index.values)))


def over_seeds(values: list[Numbers]) -> Estimate:
    return mean_over_seeds([estimate(each.tolist()) for each in values])


def main() -> None:
    parser = parser_of_searches(__doc__, evaluations=600, seeds=2)
    options = parser.parse_args()
    levels = [find(amount, options) for amount in AMOUNTS]
    (usual,) = (each.baseline for each in levels if each.amount == USUAL)
    gains = {
        each.amount: mean_over_seeds(
            [gain(usual.tolist(), bred.tolist()) for bred in each.bred]
        )
        for each in levels
    }
    rows = []
    for before, level in zip([None, *levels], levels):
        more = ""
        if before is not None:
            step = level.amount - before.amount
            more = plus_minus(
                over_seeds(
                    [
                        (after - first) / step
                        for first, after in zip(before.bred, level.bred)
                    ]
                ),
                3,
                "+",
            )
        rows.append(
            [
                f"{level.amount:g}",
                plus_minus(estimate(level.baseline.tolist()), 3),
                plus_minus(over_seeds(level.bred), 3),
                plus_minus(gains[level.amount], 1, "+"),
                more,
                f"{level.lai:.2f}",
            ]
        )
    print_table(
        ["leaf nitrogen [g m-2]", "carbon balance of the baseline "
         "[mol m-2 day-1]", "of the best plants",
         f"over the baseline with {USUAL:g} g m-2 [%]",
         "of one more g of nitrogen", "leaf area index"],
        rows,
    )  # fmt: skip
    for low, high in pairwise(gains.items()):
        if low[1][0] < 0 <= high[1][0]:
            where, error = sign_change(low, high)
            print(
                f"\nOptimised plants have the carbon of the baseline with "
                f"{USUAL:g} g m-2 from {plus_minus((where, error), 2)} g m-2 on "
                "(linear interpolation)."
            )


if __name__ == "__main__":
    guard(main)
