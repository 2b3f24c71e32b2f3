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
    finals,
    guard,
    objectives,
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
    seen = finals(stand, np.array([stand.baseline, *plants]), ["lai"])
    baseline, *bred = objectives(seen)
    return Level(amount, baseline, bred, float(seen["lai"][1:].mean()))


def over_seeds(values: list[Numbers]) -> Estimate:
    return mean_over_seeds([estimate(each.tolist()) for each in values])


def of_one_more(less: Level, more: Level) -> str:
    """Formats what one more gram of nitrogen adds to the best plants."""
    step = more.amount - less.amount
    pairs = zip(less.bred, more.bred, strict=True)
    return plus_minus(over_seeds([(y - x) / step for x, y in pairs]), 3, "+")


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
    more = ["", *(of_one_more(*pair) for pair in pairwise(levels))]
    print_table(
        ["leaf nitrogen [g m-2]", "carbon balance of the baseline "
         "[mol m-2 day-1]", "of the best plants",
         f"over the baseline with {USUAL:g} g m-2 [%]",
         "of one more g of nitrogen", "leaf area index"],
        [
            [
                f"{level.amount:g}",
                plus_minus(estimate(level.baseline.tolist()), 3),
                plus_minus(over_seeds(level.bred), 3),
                plus_minus(gains[level.amount], 1, "+"),
                cell,
                f"{level.lai:.2f}",
            ]
            for level, cell in zip(levels, more, strict=True)
        ],
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
