#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds the plant density from which an erect top pays.

erect_tops.py FOLDER [--figure FILE.png] [--light LIGHT...] [--limit LIMIT...]
              [--densities N...] [--latitudes N...] [--evaluations N]
              [--seeds N] [--rough]

Optimises crops/maize.toml twice for each plant density, latitude, light and
limit of leaf area: with insertion angles of the four highest leaves below
25 deg, and above 45 deg. All other traits that a breeder can select are free
(bounds "breedable", but insertion angles up to 50 deg above those of the
baseline, without which no top is flat); stands have within-line variation.
Re-evaluates the best plant of both with common random numbers and prints the
additional carbon of the erect top [%], with its 95 % interval, and the density
from which it pays. Where the carbon of the flat top is not above zero by three
standard errors, the difference is printed instead [mol m-2 day-1]. Where the
sign changes between two densities, both have more seeds. The figure is the
map.

The light is a clear day (7 August), the season measured at Bondville, Illinois
(40 deg north only), or an overcast day with a quarter of the light outside of
the atmosphere, all of it diffuse. The limit is the cost of building and
maintaining leaves ("carbon"), nitrogen of the stand that more leaves dilute
("nitrogen"), or the leaf area of the baseline ("area").
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from pathlib import Path
from typing import Any

import numpy as np
from climates import CLEAR_DAY, bondville, overcast_day, season, site
from estimates import (
    Estimate,
    difference,
    gain,
    half_interval,
    has_percent,
    mean_over_seeds,
    plus_minus,
    print_table,
    sign_change,
)
from shared import (
    MAIZE,
    PLANT_AREA,
    ROUGH,
    SEVERAL_FIELDS,
    SMALL_FIELD,
    Numbers,
    best,
    breed_tables,
    breedable_but,
    guard,
    light,
    parser_of_searches,
    say,
)  # fmt: skip

from ideotype import Stand
from ideotype.figures.style import new_figure

ROW = 0.762
DENSITIES = (4.0, 7.0, 12.0, 20.0)
LATITUDES = (7.0, 42.0, 56.2)
BONDVILLE = 40.05
LIGHTS = ("clear", "season", "overcast")
LIMITS = ("carbon", "nitrogen", "area")
TOPS = {"erect": [0.0, 25.0], "flat": [45.0, 90.0]}
TOP_LEAVES = 4
#: Range of insertion angles relative to the baseline [deg]. Measured lines
#: differ by only 10 deg, which does not permit a flat top.
ANGLES = (-10.0, 50.0)


@dataclass(frozen=True, order=True)
class Condition:
    light: str
    limit: str
    latitude: float
    density: float

    @property
    def name(self) -> str:
        return (
            f"{self.light}_{self.limit}_{self.latitude:g}_{self.density:g}"
        ).replace(".", "p")


@dataclass(frozen=True)
class Gains:
    """The gain of the erect top over the flat top, for each seed."""

    differences: list[Estimate]
    """In mol m-2 day-1."""
    percents: list[Estimate]
    """Empty if the carbon of a flat top is not above zero."""

    @property
    def is_positive(self) -> bool:
        return mean_over_seeds(self.differences)[0] > 0

    def text(self) -> str:
        if self.percents:
            return plus_minus(mean_over_seeds(self.percents), sign="+")
        return f"{plus_minus(mean_over_seeds(self.differences), 3, '+')} mol"


def campaign(where: Condition, folder: Path, is_rough: bool) -> dict[str, Any]:
    """Returns the tables of a condition; the shape of the top is still to be
    set."""
    tables: dict[str, Any] = {
        "name": where.name,
        "site": bondville()["site"]
        if where.light == "season"
        else [site(where.latitude)],
        "spacing": [
            {
                "name": "stand",
                "row": ROW,
                "plant": round(1 / where.density / ROW, 6),
            }
        ],
        "field": SMALL_FIELD,
        **breedable_but(MAIZE, insertion_angle_profile=ANGLES),
        "objective": {"maximise": "carbon_balance"},
        "light": {"tolerance": 0.012, **SEVERAL_FIELDS},
        "final": {"candidates": 2, "paths": 4096, "randomisations": 64},
    }
    if where.light == "clear":
        tables["day"] = [CLEAR_DAY]
    elif where.light == "season":
        tables["climate"] = [season()]
    else:
        tables["climate"] = [overcast_day(where.latitude, folder)]
        tables["light"]["sky"] = "overcast"
    if where.limit == "nitrogen":
        tables["photosynthesis"] = {"profile": "nitrogen"}
    if where.limit == "area":
        tables["constraints"] = {
            "lai": [0.0, round(PLANT_AREA * where.density, 4)]
        }
    return {**tables, **ROUGH} if is_rough else tables


def bred(
    tables: dict[str, Any], top: str, seed: int, evaluations: int, folder: Path
) -> Numbers:
    """Returns the genome of the best plant with the given shape of the top."""
    angles = {"range": TOPS[top], "highest": TOP_LEAVES}
    constraints = tables.get("constraints", {})
    shaped = {
        **tables,
        "name": f"{tables['name']}_{top}_s{seed}",
        "seed": seed,
        "constraints": {**constraints, "insertion_angle": angles},
        "stop": {"evaluations": evaluations},
    }
    return best(breed_tables(shaped, folder)[0])


def bred_pairs(
    tables: dict[str, Any], folder: Path, evaluations: int, seeds: int
) -> list[list[Numbers]]:
    """Returns the best plants with a flat and with an erect top, for each
    seed."""
    return [
        [
            bred(tables, top, seed, evaluations, folder)
            for top in ("flat", "erect")
        ]
        for seed in range(1, seeds + 1)
    ]


def gains(pairs: Sequence[Sequence[Sequence[float]]]) -> Gains:
    """Compares flat and erect tops by their randomisations, for each seed."""
    return Gains(
        [difference(*pair) for pair in pairs],
        [gain(*pair) for pair in pairs]
        if all(has_percent(flat) for flat, _ in pairs)
        else [],
    )


def gains_of(
    tables: dict[str, Any], folder: Path, evaluations: int, seeds: int
) -> Gains:
    stand = Stand(tables)
    pairs = bred_pairs(tables, folder, evaluations, seeds)
    return gains([light(stand, np.array(pair)).tolist() for pair in pairs])


def sign_changes(
    results: dict[Condition, Gains],
) -> Iterator[tuple[Condition, Condition]]:
    """Yields successive densities between which the gain changes its sign."""
    for one, other in pairwise(sorted(results)):
        alike = (one.light, one.limit, one.latitude) == (
            other.light,
            other.limit,
            other.latitude,
        )
        if alike and results[one].is_positive != results[other].is_positive:
            yield one, other


def line(
    results: dict[Condition, Gains], one: Condition, other: Condition
) -> Estimate:
    """Returns the density [m-2] at which the difference is zero, interpolated
    linearly over the logarithm of density."""
    low, high = (
        (math.log(x.density), mean_over_seeds(results[x].differences))
        for x in (one, other)
    )
    at, error = sign_change(low, high)
    return math.exp(at), math.exp(at) * error


def tell(results: dict[Condition, Gains], densities: Sequence[float]) -> None:
    lines = {
        (one.light, one.limit, one.latitude): line(results, one, other)
        for one, other in sign_changes(results)
    }
    rows = []
    for key in sorted({(x.light, x.limit, x.latitude) for x in results}):
        cells = [results[Condition(*key, x)].text() for x in densities]
        pays = f"{plus_minus(lines[key])} m-2" if key in lines else ""
        rows.append([key[0], key[1], f"{key[2]:g}", *cells, pays])
    titles = [f"{density:g} m-2" for density in densities]
    print_table(["light", "limit", "latitude", *titles, "pays from"], rows)


def draw(results: dict[Condition, Gains], path: Path) -> None:
    lights = list(dict.fromkeys(x.light for x in sorted(results)))
    limits = list(dict.fromkeys(x.limit for x in sorted(results)))
    figure = new_figure(4 * len(limits), 3 * len(lights))
    figure.suptitle("When does an erect top pay?")
    axes = figure.subplots(
        len(lights), len(limits), sharex=True, sharey=True, squeeze=False
    )
    for (row, of_light), (column, limit) in product(
        enumerate(lights), enumerate(limits)
    ):
        axis = axes[row][column]
        chosen = sorted(
            x
            for x, found in results.items()
            if (x.light, x.limit) == (of_light, limit) and found.percents
        )
        for latitude in sorted({x.latitude for x in chosen}):
            at = [x for x in chosen if x.latitude == latitude]
            found = [mean_over_seeds(results[x].percents) for x in at]
            axis.errorbar(
                [x.density for x in at],
                [mean for mean, _ in found],
                [half_interval(error) for _, error in found],
                marker="o",
                label=f"{latitude:g} deg north",
            )
        axis.axhline(0, color="#999999", linewidth=1)
        axis.set_xscale("log")
        axis.set_xticks(DENSITIES, [f"{x:g}" for x in DENSITIES])
        axis.minorticks_off()
        axis.set_title(f"{of_light}, limit: {limit}", fontsize=9)
        axis.legend(fontsize=7)
    for row_of_axes in axes:
        row_of_axes[0].set_ylabel("erect over flat top [%]")
    for axis in axes[-1]:
        axis.set_xlabel("plants m-2")
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = parser_of_searches(
        __doc__, has_figure=True, evaluations=600, seeds=3
    )
    parser.add_argument("--light", nargs="+", choices=LIGHTS, default=LIGHTS)
    parser.add_argument("--limit", nargs="+", choices=LIMITS, default=LIMITS)
    parser.add_argument(
        "--densities", nargs="+", type=float, default=DENSITIES
    )
    parser.add_argument(
        "--latitudes", nargs="+", type=float, default=LATITUDES
    )
    options = parser.parse_args()
    wanted = [
        Condition(of_light, limit, latitude, density)
        for of_light, limit in product(options.light, options.limit)
        for latitude in (
            [BONDVILLE] if of_light == "season" else options.latitudes
        )
        for density in options.densities
    ]

    def look(where: Condition, seeds: int) -> Gains:
        say(f"{where.name}: {seeds} seeds")
        tables = campaign(where, options.folder, options.rough)
        return gains_of(tables, options.folder, options.evaluations, seeds)

    results = {where: look(where, 1) for where in wanted}
    for where in sorted({x for pair in sign_changes(results) for x in pair}):
        results[where] = look(where, options.seeds)
    tell(results, options.densities)
    if options.figure:
        draw(results, options.figure)


if __name__ == "__main__":
    guard(main)
