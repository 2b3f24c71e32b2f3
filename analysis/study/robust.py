#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the cost of one plant for five sites.

robust.py FOLDER [--figure FILE.png] [--latitudes N...] [--evaluations N]
          [--seeds N] [--growing] [--rough]

Optimises crops/maize.toml for the carbon balance of a season at each latitude
of arXiv:2512.06064 alone, and one robust plant for the mean over all of them.
The season is that measured at Bondville, Illinois, under the sun of each
latitude (temperature and the transmission of the atmosphere are those of
Bondville). Traits are those that a breeder can select (bounds "breedable"),
and stands have within-line variation. Prints the carbon of each plant at each
latitude, relative to the plant optimised there [%]; ± is half of a 95 %
interval over common randomisations, or over seeds where that is larger.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from statistics import fmean
from typing import Any

import numpy as np
from climates import growth, moved_season, season, site
from estimates import (
    Estimate,
    gain,
    half_interval,
    mean_over_seeds,
    plus_minus,
    print_table,
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
)  # fmt: skip

from ideotype import Stand
from ideotype.figures.style import new_figure, series

ROBUST, BASELINE = "all of them", "baseline, not bred"
LATITUDES = (7.0, 39.35, 42.0, 46.8, 56.2)
Matrix = dict[str, list[Estimate]]
"""The carbon of each plant at each latitude [% of the plant bred there]."""


def place(
    latitude: float, folder: Path, climate: dict[str, Any]
) -> dict[str, Any]:
    """Returns a latitude as a [[site]] with its weather."""
    return {
        **site(latitude),
        "name": f"n{latitude:g}".replace(".", "p"),
        "weather": str(moved_season(latitude, folder, climate["file"])),
    }


def light_of(options: argparse.Namespace) -> dict[str, Any]:
    """Returns the season, and the growing plant if plants grow."""
    return growth() if options.growing else {"climate": [season()]}


def campaign(
    name: str, places: list[dict[str, Any]], options: argparse.Namespace
) -> dict[str, Any]:
    """Returns the tables of a search for the mean over these sites."""
    lit = light_of(options)
    # Each site has a separate weather file.
    lit["climate"][0].pop("file")
    return {
        **BREEDABLE,
        **lit,
        "name": name,
        "replicates": options.seeds,
        "site": places,
        "objective": {"maximise": "carbon_balance", "over": ["site"]},
        "stop": {"evaluations": options.evaluations},
        **(ROUGH if options.rough else {}),
    }


def bred(tables: dict[str, Any], folder: Path) -> list[Numbers]:
    """Returns the best plant of each seed."""
    say(f"optimising {tables['name']}")
    return best_plants(tables, folder)


def relative(stand: Stand, home: int, plants: list[Numbers]) -> list[Estimate]:
    """Returns the carbon of plants at this site [% of the plant optimised
    here]."""
    values = light(stand, np.array(plants)).tolist()
    changes = (gain(values[home], value) for value in values)
    return [(100 + mean, error) for mean, error in changes]


def matrix(options: argparse.Namespace) -> Matrix:
    (climate,) = light_of(options)["climate"]
    places = [
        place(latitude, options.folder, climate)
        for latitude in options.latitudes
    ]
    alone = [campaign(each["name"], [each], options) for each in places]
    over = campaign("robust", places, options)
    plants = [bred(tables, options.folder) for tables in (*alone, over)]
    columns = []
    for home, tables in enumerate(alone):
        stand = Stand(tables)
        by_seed = [
            relative(stand, home, [*of_seed, stand.baseline])
            for of_seed in zip(*plants, strict=True)
        ]
        columns.append(
            [mean_over_seeds(each) for each in zip(*by_seed, strict=True)]
        )
    names = [f"{latitude:g} deg north" for latitude in options.latitudes]
    rows = zip(*columns, strict=True)
    return {
        name: list(row)
        for name, row in zip([*names, ROBUST, BASELINE], rows, strict=True)
    }


def mean_of_row(row: Sequence[Estimate]) -> Estimate:
    """Returns the mean of a row. Its error is at most the mean of the errors,
    because the fields are the same at all latitudes."""
    return fmean(mean for mean, _ in row), fmean(error for _, error in row)


def draw(found: Matrix, latitudes: Sequence[float], path: Path) -> None:
    figure = new_figure(7.2, 4)
    axes = figure.subplots()
    for i, (name, row) in enumerate(found.items()):
        if name == BASELINE:
            continue
        color, marker = series(i)
        axes.errorbar(
            range(len(row)),
            [mean for mean, _ in row],
            [half_interval(error) for _, error in row],
            color="#000000" if name == ROBUST else color,
            linewidth=3 if name == ROBUST else 1.5,
            marker=marker,
            label=name,
        )
    axes.set_xticks(range(len(latitudes)), [f"{x:g}" for x in latitudes])
    axes.set_xlabel("grown at [deg north]")
    axes.set_ylabel("carbon balance\n[% of the plant bred there]")
    figure.suptitle("What does one plant for five sites cost?")
    figure.legend(title="bred for", loc="outside right upper", fontsize=8)
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = parser_of_searches(
        __doc__, has_figure=True, has_growth=True, evaluations=800, seeds=1
    )
    parser.add_argument(
        "--latitudes", nargs="+", type=float, default=LATITUDES
    )
    options = parser.parse_args()
    found = matrix(options)
    grown = [f"grown at {latitude:g} deg" for latitude in options.latitudes]
    rows = []
    for name, row in found.items():
        cells = (*row, mean_of_row(row))
        rows.append([name, *(plus_minus(x, 2) for x in cells)])
    print_table(["bred for", *grown, "mean"], rows)
    if options.figure:
        draw(found, options.latitudes, options.figure)


if __name__ == "__main__":
    guard(main)
