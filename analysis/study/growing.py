#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the stages, the cost and the effect of growth of a canopy.

growing.py [--figure FOLDER] [--rough]

Prints, for the hybrid of crops/maize_hybrid.toml and the weather of Bondville 2011:

* the error of the season's gross assimilation by number of stages;
* the cost of a growing season relative to the same days with a full canopy, at an
  equal error, in pairs;
* the effect of growth on the carbon;
* the additional carbon of the plant when its four highest leaves are erect (15 deg)
  instead of flat (50 deg), by leaf area index at silking, with growth and without.

No plant is optimised here; growth_maps.py does that, and compares with measured
seasons. --figure writes stages.png, plants.png and season.png. --rough is for tests.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from datetime import date
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from climates import growing_season
from draw_plants import draw
from estimates import plus_minus, print_table, sign_change
from shared import HYBRID, gain_in, guard

from ideotype import Crop, Stand
from ideotype.figures.style import new_figure

STAGES = (4, 6, 8, 10, 14, 20)
DENSITIES = (2.0, 3.0, 4.5, 6.0, 7.5, 10.0)
FULL = "emergence to maturity, full canopy"


def tables(**light: Any) -> dict[str, Any]:
    """The first year of growing_season.toml, in a uniform stand."""
    field = {"rows": 2, "plants": 2, "jitter": 0}
    return growing_season(field=field, light=light)


def of_full_canopy(growing: dict[str, Any]) -> dict[str, Any]:
    """Returns the same days with plants that remain as at silking."""
    stand = Stand(growing)
    days = stand.evaluate(stand.baseline, ["assimilation_by_day"]).day.values
    climate = dict(growing["climate"][0])
    del climate["emergence"]
    climate["from"], climate["to"] = map(
        date.fromisoformat, (str(days[0]), str(days[-1]))
    )
    return {**growing, "climate": [climate]}


def number(stand: Stand, *names: str) -> list[float]:
    found = stand.evaluate(stand.baseline, names)
    return [float(found[name][0]) for name in names]


def errors_of_stages(paths: int, stages: tuple[int, ...]) -> list[float]:
    """Returns the change of gross assimilation with fewer stages, compared
    with 40 stages [%]."""
    found = [
        number(
            Stand(tables(paths=paths, stages=n, dates=n)),
            "gross_assimilation",
        )[0]
        for n in (40, *stages)
    ]
    return [100 * (x / found[0] - 1) for x in found[1:]]


def cost(pairs: int) -> tuple[float, float]:
    """Returns the time of a growing season relative to that with a full canopy
    at equal errors: the mean over pairs and its standard error."""
    growing = tables(tolerance=0.008)
    stands = [Stand(growing), Stand(of_full_canopy(growing))]
    name = "gross_assimilation"
    squares = np.zeros((pairs, 2))
    seconds = np.zeros((pairs, 2))
    for pair in range(pairs):
        for i, stand in enumerate(stands):
            began = time.process_time()
            found = stand.evaluate(stand.baseline, [name], seed=pair + 1)
            seconds[pair, i] = time.process_time() - began
            error = found[f"{name}_standard_error"] / found[name]
            squares[pair, i] = float(error[0]) ** 2
    equal = squares.mean(axis=0)
    ratios = seconds[:, 0] / seconds[:, 1] * equal[0] / equal[1]
    return float(ratios.mean()), float(ratios.std(ddof=1) / np.sqrt(pairs))


def carbon(paths: int) -> list[tuple[str, float]]:
    """Returns the effect of growth on the carbon of a season."""
    growing = Stand(tables(paths=paths))
    full = Stand(of_full_canopy(tables(paths=paths)))
    names = ("gross_assimilation", "respiration", "carbon_after_silking")
    gross, lost, late = number(growing, *names)
    full_gross, full_lost = number(full, *names[:2])
    days = growing.evaluate(growing.baseline).day.size
    return [
        ("days", days),
        ("gross [mol m-2]", days * gross),
        (
            "full canopy: more carbon [%]",
            100 * ((full_gross - full_lost) / (gross - lost) - 1),
        ),
        ("after silking [%]", 100 * late / (gross - lost)),
    ]


def erect_tops(
    paths: int, densities: tuple[float, ...]
) -> Iterator[list[Any]]:
    """Yields the gain of an erect over a flat top [%], with and without
    growth."""
    for density in densities:
        growing = tables(paths=paths)
        growing["field"] = {"rows": 2, "plants": 2}
        growing["spacing"] = [{"row": 0.762, "density": density}]
        growing["traits"] = [{"name": "angles", "free": ["insertion_angle"]}]
        row: list[Any] = [density]
        for each in (growing, of_full_canopy(growing)):
            stand = Stand(each)
            flat, erect = stand.baseline.copy(), stand.baseline.copy()
            genes = stand.genes
            top = (genes.trait == "insertion_angle") & (
                genes.leaf > genes.leaf.max() - 4
            )
            flat[top], erect[top] = 50, 15
            row += gain_in(stand, flat, erect)
            if len(row) == 3:
                lai = stand.evaluate(flat, ["lai_by_stage"]).lai_by_stage
                row.insert(1, float(lai.max()))
        yield row


def draw_figures(folder: Path, errors: dict[int, float]) -> None:
    figure = new_figure(5, 3)
    axes = figure.subplots()
    axes.plot(list(errors), list(errors.values()), "o-")
    axes.axhline(0, color="0.6", lw=0.8)
    axes.set(xlabel="stages", ylabel="error of the season's carbon [%]")
    figure.savefig(folder / "stages.png", dpi=150)

    crop = Crop.from_file(HYBRID)
    ages = (200, 350, 500, 650, 800, 960, 1500, 1800)
    figure = new_figure(12, 3.2)
    for axes, age in zip(figure.subplots(1, len(ages), sharey=True), ages):
        draw(axes, crop.mesh(age), is_side=True)
        axes.set(xlim=(-0.8, 0.8), ylim=(0, 2.9), xticks=[])
        axes.set_title(f"{age} °C d", fontsize=9)
    figure.savefig(folder / "plants.png", dpi=150)

    stand = Stand(tables())
    found = stand.evaluate(stand.baseline)
    figure = new_figure(9, 3)
    left, right = figure.subplots(1, 2)
    days = found.day_of_stage[0]
    left.plot(days, found.lai_by_stage[0], "o-", label="green")
    left.plot(days, found.dead_area_index_by_stage[0], "o-", label="dead")
    left.set(xlabel="days since emergence", ylabel="leaf area index")
    left.legend()
    weeks = found.assimilation_by_day[0].values
    weeks = weeks[: weeks.size // 7 * 7].reshape(-1, 7).sum(axis=1)
    right.bar(np.arange(weeks.size) + 1, 12.011 * weeks)
    right.set(
        xlabel="week", ylabel="gross assimilation [g C m$^{-2}$ week$^{-1}$]"
    )
    figure.savefig(folder / "season.png", dpi=150)


def main() -> None:
    parser = argparse.ArgumentParser(usage=(__doc__ or "").split("\n")[2])
    parser.add_argument("--figure", type=Path)
    parser.add_argument("--rough", action="store_true")
    options = parser.parse_args()
    rough = options.rough
    paths = 512 if rough else 65536
    stages = (4, 10) if rough else STAGES
    errors = dict(zip(stages, errors_of_stages(paths, stages)))
    print_table(
        ["stages", "error [%]"],
        [[str(n), f"{e:.2f}"] for n, e in errors.items()],
    )
    print(
        f"\ncost at equal error over {FULL}: "
        f"{plus_minus(cost(2 if rough else 24), 2)}\n"
    )
    for name, value in carbon(paths):
        print(f"{name:34} {value:10.4g}")
    densities = DENSITIES[-2:] if rough else DENSITIES
    rows = list(erect_tops(paths // 4, densities))
    print()
    print_table(
        ["plants m-2", "LAI", "growth [%]", "full canopy [%]"],
        [
            [
                *(f"{x:.2f}" for x in row[:2]),
                *(plus_minus((row[i], row[i + 1]), 2) for i in (2, 4)),
            ]
            for row in rows
        ],
    )
    for name, column in (("growth", 2), ("full canopy", 4)):
        points = [(row[1], (row[column], row[column + 1])) for row in rows]
        for low, high in pairwise(points):
            if low[1][0] < 0 < high[1][0]:
                at = plus_minus(sign_change(low, high), 2)
                print(f"{name}: pays from a leaf area index of {at} on")
    if options.figure:
        options.figure.mkdir(parents=True, exist_ok=True)
        draw_figures(options.figure, errors)


if __name__ == "__main__":
    guard(main)
