#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the value of single features of optimised plants.

what_pays.py --under CAMPAIGN HISTORY...

Prints the traits of the best plant of each history and their similarity. Then
undoes one feature at a time, evaluates all variants under the light of
CAMPAIGN, and prints the loss of the canopy, in % of the light that its leaves
absorb, with 95 % intervals. Histories should be the seeds of one case.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import combinations
from pathlib import Path
from statistics import correlation, fmean, stdev

import numpy as np
import pandas as pd
from estimates import Estimate, gain, mean_over_seeds, plus_minus, print_table
from shared import (
    MAIZE,
    guard,
    leaves,
    light,
    parser_of,
    stand_of,
    with_trait,
)  # fmt: skip

Values = list[float]


def mean_of(values: Values) -> Values:
    return [fmean(values)] * len(values)


#: Features that are undone: the trait, and a function of the old values and of
#: those of the baseline that returns the new values.
VARIANTS: dict[str, tuple[str, Callable[[Values, Values], Values]]] = {
    "azimuths of the baseline, all across the row": (
        "azimuth",
        lambda _, b: b,
    ),
    "all leaves along the row": (
        "azimuth",
        lambda _, b: [(azimuth + 90) % 360 for azimuth in b],
    ),
    "inclinations of the baseline": ("insertion_angle", lambda _, b: b),
    "the mean insertion_angle for all leaves": (
        "insertion_angle",
        lambda own, _: mean_of(own),
    ),
    "inclinations upside down": ("insertion_angle", lambda own, _: own[::-1]),
    "widths of the baseline": ("width", lambda _, b: b),
    "lengths of the baseline": ("length", lambda _, b: b),
}


def alike(trait: str, a: Values, b: Values) -> float:
    """Returns the similarity of two plants: 1 if equal, 0 if unrelated.
    Azimuths are compared as axes, without direction."""
    if trait != "azimuth":
        return correlation(a, b) if min(stdev(a), stdev(b)) > 0 else math.nan
    return fmean(
        math.cos(2 * math.radians(x - y)) for x, y in zip(a, b, strict=True)
    )


def print_traits(plants: list[pd.DataFrame]) -> None:
    """Prints a row per leaf, with a column for each plant."""
    form = {"length": "{:.2f}", "width": "{:.3f}", "insertion_angle": "{:.0f}"}
    names = [*form, "azimuth"]
    print("| leaf | length m | width m | insertion_angle deg | azimuth deg |")
    print("|---|---|---|---|---|")
    for rank in plants[0].index:
        cells = (
            ", ".join(
                form.get(name, "{:.0f}").format(plant[name][rank])
                for plant in plants
            )
            for name in names
        )
        print(f"| {rank} | {' | '.join(cells)} |")
    pairs = list(combinations(plants, 2))
    if pairs:
        cells = (
            "{:+.2f}".format(
                fmean(
                    alike(name, list(a[name]), list(b[name])) for a, b in pairs
                )
            )
            for name in names
        )
        print(f"| alike | {' | '.join(cells)} |")


def study(
    history: Path, baseline: pd.DataFrame, under: Path
) -> tuple[pd.DataFrame, list[Estimate]]:
    """Returns the best plant, and the loss of each variant with its standard
    error [%]."""
    stand = stand_of(history, under)
    best = leaves(stand, stand.baseline)
    genomes = [stand.baseline]
    for trait, change in VARIANTS.values():
        values = change(list(best[trait]), list(baseline[trait]))
        genomes.append(with_trait(stand, stand.baseline, trait, values))
    own, *changed = light(stand, np.array(genomes)).tolist()
    return best, [gain(own, each) for each in changed]


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument(
        "--under", type=Path, required=True, metavar="CAMPAIGN"
    )
    parser.add_argument("histories", nargs="+", type=Path, metavar="HISTORY")
    options = parser.parse_args()
    maize = stand_of(MAIZE, options.under)
    baseline = leaves(maize, maize.baseline)
    plants, seeds = zip(
        *(study(path, baseline, options.under) for path in options.histories),
        strict=True,
    )
    print_traits(list(plants))
    rows = [
        [
            name,
            plus_minus(mean_over_seeds(each), 2, "+"),
            ", ".join(plus_minus(x, 2, "+") for x in each),
        ]
        for name, each in zip(VARIANTS, zip(*seeds, strict=True), strict=True)
    ]
    print()
    print_table(["instead of what evolved", "light [%]", "by seed"], rows)


if __name__ == "__main__":
    guard(main)
