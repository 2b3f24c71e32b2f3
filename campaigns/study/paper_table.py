#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The table of arXiv:2512.06064 under three objectives: how much can breeding gain, and
which search finds it?

paper_table.py FOLDER [--figure FILE.png] [--objective NAME...] [--condition NAME...]
               [--evaluations N] [--seeds N] [--other-seeds N] [--rough]

Breeds crops/maize.toml with four sets of traits, at five latitudes and at six spacings
(bounds "paper", the others as in the first condition: all traits, 42 deg north, rows of
30 inches, plants 6 inches apart) for absorbed PAR and net assimilation of a clear day,
and for the carbon balance of a season, by random search, the genetic algorithm and CMA-ES
with as many evaluations each. Evaluates the best plants again, all with the same random
numbers, and prints gains over the baseline [%] with standard errors, leaf area, and the
gain per leaf area. The first condition has more seeds than the others. The season is that
of Bondville, Illinois, 40 deg north in the place of 42, and moved to the other latitudes
(climates.moved_season); its field repeats after 8 plants instead of 16. Searches that are
in FOLDER already are not repeated; interrupted ones go on. --rough is for tests.
IDEOTYPE_EXECUTABLE names the program, else it is that on PATH.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from climates import CLEAR_DAY, bondville, moved_season, season, site
from shared import (
    MAIZE,
    ROUGH,
    TITLES,
    Estimate,
    Numbers,
    best,
    breed_tables,
    estimate,
    gain,
    guard,
    mean_over_seeds,
    parser_of_searches,
    print_table,
)  # fmt: skip

from ideotype import Stand
from ideotype.analysis.style import new_figure, series

INCH = 0.0254
AMES = 42.0


@dataclass(frozen=True)
class Condition:
    name: str
    title: str
    latitude: float = AMES
    row: float = 30
    plant: float = 6
    """[inches]"""
    free: tuple[str, ...] = ("insertion_angle", "azimuth", "width", "length")


FIRST = Condition("all", "all traits, 42° N, 30 x 6 inches")
CONDITIONS = (
    FIRST,
    Condition("azimuth", "azimuths", free=("azimuth",)),
    Condition(
        "angles", "angles and azimuths", free=("insertion_angle", "azimuth")
    ),
    Condition(
        "widths",
        "the same and widths",
        free=("insertion_angle", "azimuth", "width"),
    ),
    *(
        Condition(f"{latitude:g}".replace(".", "p"), f"{latitude}° N", latitude)
        for latitude in (7.0, 39.35, 46.8, 56.2)
    ),
    *(
        Condition(f"{row}x{plant}", f"{row} x {plant}", row=row, plant=plant)
        for row, plant in ((15, 3), (15, 6), (20, 3), (20, 6), (30, 3))
    ),
)  # fmt: skip
UNITS = {
    "absorbed_par": "MJ m-2 day-1",
    "net_assimilation": "mol m-2 day-1",
    "carbon_balance": "mol m-2 day-1",
}
#: title, and plants of a generation
SEARCHES = {
    "random": ("random search", 100),
    "ga": ("genetic algorithm", 100),
    "cma_es": ("CMA-ES", 20),
}


@dataclass(frozen=True)
class Found:
    """Under one condition and objective."""

    baseline: Estimate
    gains: dict[str, list[Estimate]]
    """Of each search and seed [%]."""
    lai: float
    """Of the best plant of all."""
    gain_per_leaf_area: Estimate
    """Of the same plant [%]."""


def campaign(
    where: Condition, objective: str, folder: Path, is_rough: bool
) -> dict[str, Any]:
    """Without a search."""
    tables: dict[str, Any] = {
        "name": f"{objective}_{where.name}",
        "spacing": [
            {
                "name": "stand",
                "row": round(where.row * INCH, 4),
                "plant": round(where.plant * INCH, 4),
            }
        ],
        "traits": [{"name": "free", "free": list(where.free)}],
        "plant": {"baseline": str(MAIZE), "bounds": "paper"},
        "objective": {"maximise": objective},
        "field": {"rows": 2 if objective == "carbon_balance" else 4},
        "final": {"candidates": 3},
    }
    if objective != "carbon_balance":
        here, light = site(where.latitude), {"day": [CLEAR_DAY]}
    elif where.latitude == AMES:
        here, light = bondville()["site"][0], {"climate": [season()]}
    else:
        moved = moved_season(where.latitude, folder)
        here = site(where.latitude)
        light = {"climate": [{**season(), "file": str(moved)}]}
    return {**tables, "site": [here], **light, **(ROUGH if is_rough else {})}


def bred(
    tables: dict[str, Any], search: str, seed: int, count: int, folder: Path
) -> Numbers:
    """The genome of the best plant that this search finds."""
    population = min(SEARCHES[search][1], count)
    history = breed_tables(
        {
            **tables,
            "name": f"{tables['name']}_{search}_s{seed}",
            "seed": seed,
            "search": {"optimizer": search, "population": population},
            "stop": {"generations": count // population},
        },
        folder,
    )[0]
    return best(history)


def find(
    tables: dict[str, Any], folder: Path, count: int, seeds: int
) -> Found:
    """The best plants of a campaign by each search and seed."""
    keys = list(product(SEARCHES, range(1, seeds + 1)))
    plants = [bred(tables, *key, count, folder) for key in keys]
    stand = Stand(tables)
    seen = stand.evaluate(
        np.array([stand.baseline, *plants]), ["lai"], final=True
    )
    values = np.asarray(seen.objective_by_randomisation[:, 0])
    lai = np.asarray(seen.lai)
    baseline, *others = values.tolist()
    gains: dict[str, list[Estimate]] = {search: [] for search in SEARCHES}
    for (search, _), each in zip(keys, others, strict=True):
        gains[search].append(gain(baseline, each))
    first = int(values[1:].mean(1).argmax()) + 1
    return Found(
        baseline=estimate(baseline),
        gains=gains,
        lai=float(lai[first]),
        gain_per_leaf_area=gain(
            (values[0] / lai[0]).tolist(),
            (values[first] / lai[first]).tolist(),
        ),
    )


def told(values: list[Estimate]) -> str:
    mean, error = mean_over_seeds(values)
    return f"{mean:.1f} ± {error:.1f}"


def row(where: Condition, found: Found) -> list[str]:
    return [
        where.title,
        "{:.3f} ± {:.3f}".format(*found.baseline),
        *(told(found.gains[search]) for search in SEARCHES),
        f"{found.lai:.1f}",
        "{:+.1f} ± {:.1f}".format(*found.gain_per_leaf_area),
    ]


def tell(results: dict[tuple[str, Condition], Found]) -> None:
    searches = [title for title, _ in SEARCHES.values()]
    for objective in dict.fromkeys(name for name, _ in results):
        print(f"**{TITLES[objective]}**\n")
        titles = ["condition", f"baseline [{UNITS[objective]}]"]
        titles += [f"{search} [%]" for search in searches]
        titles += ["LAI of the best", "its gain per leaf area [%]"]
        print_table(
            titles,
            [
                row(where, found)
                for (name, where), found in results.items()
                if name == objective
            ],
        )
        print()
    print(f"Gain by seed [%], {FIRST.title}\n")
    by_seed = []
    for (objective, where), found in results.items():
        if where == FIRST:
            gains = (found.gains[search] for search in SEARCHES)
            cells = (", ".join(f"{x:.1f}" for x, _ in each) for each in gains)
            by_seed.append([TITLES[objective], *cells])
    print_table(["objective", *searches], by_seed)


def draw(results: dict[tuple[str, Condition], Found], path: Path) -> None:
    wheres = list(dict.fromkeys(where for _, where in results))
    names = list(dict.fromkeys(name for name, _ in results))
    figure = new_figure(4 * len(names), 0.5 + 0.4 * len(wheres))
    figure.suptitle("How much can breeding gain, and which search finds it?")
    axes = figure.subplots(1, len(names), sharey=True, squeeze=False)[0]
    for axis, objective in zip(axes, names, strict=True):
        for number, (search, (title, _)) in enumerate(SEARCHES.items()):
            color, marker = series(number)
            found = [
                mean_over_seeds(results[objective, where].gains[search])
                for where in wheres
            ]
            axis.errorbar(
                [mean for mean, _ in found],
                np.arange(len(wheres)) + 0.15 * (number - 1),
                xerr=[error for _, error in found],
                linestyle="",
                color=color,
                marker=marker,
                label=title,
            )
        axis.set_title(TITLES[objective], fontsize=9)
        axis.set_xlabel("gain over the baseline [%]")
        axis.set_xscale("symlog", linthresh=30)
        highest = axis.get_xlim()[1]
        ticks = [x for x in (0, 10, 20, 30, 50, 100, 300) if x < highest]
        axis.set_xticks(ticks, [f"{x}" for x in ticks])
        axis.minorticks_off()
    axes[0].set_yticks(range(len(wheres)), [x.title for x in wheres])
    axes[0].invert_yaxis()
    axes[0].legend(fontsize=7)
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = parser_of_searches(
        __doc__, evaluations=2500, seeds=3, other_seeds=1
    )
    parser.add_argument("--figure", type=Path)
    parser.add_argument("--objective", nargs="+", choices=UNITS, default=UNITS)
    parser.add_argument(
        "--condition", nargs="+", choices=[x.name for x in CONDITIONS]
    )
    options = parser.parse_args()
    wheres = [
        where
        for where in CONDITIONS
        if not options.condition or where.name in options.condition
    ]
    results = {}
    for objective, where in product(options.objective, wheres):
        print(f"{objective}: {where.title}", file=sys.stderr, flush=True)
        results[objective, where] = find(
            campaign(where, objective, options.folder, options.rough),
            options.folder,
            options.evaluations,
            options.seeds if where == FIRST else options.other_seeds,
        )
    tell(results)
    if options.figure:
        draw(results, options.figure)


if __name__ == "__main__":
    guard(main)
