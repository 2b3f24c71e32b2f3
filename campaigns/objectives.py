#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What evolves for light, for assimilation, and for the carbon balance of a season.

objectives.py FOLDER [--only OBJECTIVE...] [--figure FILE.png] [--generations N]
              [--seeds N]

Breeds crops/maize.toml by CMA-ES for five objectives at two spacings (where leaf area is
fixed, angles and azimuths alone), evaluates the best plant of each seed again beside the
baseline and plants/elite.toml, with the same random numbers, and prints gains, leaf area
and insertion angles. ± of gains is the standard error over seeds, or of the evaluations
where that is larger. Cases that are in FOLDER already are not bred again; interrupted
ones go on. The figure shows insertion angles.
IDEOTYPE_EXECUTABLE names the program, else it is that on PATH.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path
from statistics import fmean

import pandas as pd
from shared import (
    HERE,
    MAIZE,
    Estimate,
    breed,
    gain,
    guard,
    leaves,
    light_of_baselines,
    mean_over_seeds,
    stand_of,
)  # fmt: skip

from ideotype.analysis.style import new_figure

DAY, SEASON = HERE / "ames.toml", HERE / "bondville.toml"
CARBON = "objective.maximise=carbon_balance"
PLANT_AREA = 0.3991
"""Leaf area of the baseline [m2]."""


@dataclass(frozen=True)
class Objective:
    title: str
    campaign: Path
    settings: tuple[str, ...]


@dataclass(frozen=True)
class Spacing:
    name: str
    row: float
    plant: float

    def table(self) -> str:
        return (
            f'[{{name = "{self.name}", row = {self.row}, '
            f"plant = {self.plant}, row_direction = 90}}]"
        )


OBJECTIVES = {
    "par": Objective("absorbed PAR, clear day", DAY, ()),
    "net": Objective(
        "net assimilation, clear day",
        DAY,
        ("objective.maximise=net_assimilation",),
    ),
    "carbon": Objective("carbon balance, season", SEASON, (CARBON,)),
    "area": Objective(
        "the same, fixed leaf area",
        SEASON,
        (
            CARBON,
            'traits=[{name = "turns", free = ["insertion_angle", "azimuth"]}]',
        ),
    ),
    "nitrogen": Objective(
        "the same, fixed nitrogen",
        SEASON,
        (CARBON, "photosynthesis.profile=nitrogen"),
    ),
}
SPACINGS = (
    Spacing("30x6", 0.762, 0.1524),
    Spacing("15x3", 0.381, 0.0762),
)


@dataclass(frozen=True)
class Result:
    """Of one objective at one spacing; gains in % with their errors."""

    over_baseline: Estimate
    over_elite: Estimate
    by_seed: list[float]
    lai: list[float]
    angles: list[list[float]]  # of each seed, the lowest leaf first [deg]


def settings(name: str, spacing: Spacing) -> list[str]:
    return [f"spacing={spacing.table()}", *OBJECTIVES[name].settings]


def compare(name: str, spacing: Spacing, histories: list[Path]) -> Result:
    stands = [
        stand_of(path, OBJECTIVES[name].campaign, settings(name, spacing))
        for path in (MAIZE, HERE / "plants" / "elite.toml", *histories)
    ]
    baseline, elite, *best = light_of_baselines(stands).tolist()
    unbred, _, *bred = [leaves(stand, stand.baseline) for stand in stands]
    per_area = PLANT_AREA / size(unbred) / spacing.row / spacing.plant
    return Result(
        over_baseline=mean_over_seeds([gain(baseline, x) for x in best]),
        over_elite=mean_over_seeds([gain(elite, x) for x in best]),
        by_seed=[100 * (fmean(x) / fmean(baseline) - 1) for x in best],
        lai=[per_area * size(plant) for plant in bred],
        angles=[list(plant["insertion_angle"]) for plant in bred],
    )


def size(plant: pd.DataFrame) -> float:
    """Proportional to the leaf area, since all blades have the same outline."""
    return float((plant["length"] * plant["width"]).sum())


def print_table(results: dict[tuple[str, str], Result]) -> None:
    print(
        "| bred for | inches | over baseline [%] | by seed | over elite [%] "
        "| LAI | insertion angle of leaves 7 to 10 [deg] | of leaves 1 to 4 |"
    )
    print("|---|---|---|---|---|---|---|---|")
    for (name, spacing), each in results.items():
        top = ", ".join(f"{fmean(x[6:]):.0f}" for x in each.angles)
        low = ", ".join(f"{fmean(x[:4]):.0f}" for x in each.angles)
        print(
            f"| {OBJECTIVES[name].title} | {spacing} "
            f"| {each.over_baseline[0]:.2f} ± {each.over_baseline[1]:.2f} "
            f"| {', '.join(f'{x:.2f}' for x in each.by_seed)} "
            f"| {each.over_elite[0]:.2f} ± {each.over_elite[1]:.2f} "
            f"| {min(each.lai):.1f} to {max(each.lai):.1f} | {top} | {low} |"
        )


def draw(results: dict[tuple[str, str], Result], path: Path) -> None:
    maize = stand_of(MAIZE, DAY)
    own = list(leaves(maize, maize.baseline)["insertion_angle"])
    ranks = range(1, len(own) + 1)
    figure = new_figure(10, 3.2 * len(SPACINGS))
    axes = figure.subplots(
        len(SPACINGS), len(OBJECTIVES), sharex=True, sharey=True, squeeze=False
    )
    for (name, spacing), each in results.items():
        row = [x.name for x in SPACINGS].index(spacing)
        axis = axes[row][list(OBJECTIVES).index(name)]
        axis.plot(own, ranks, color="#999999", label="baseline")
        for angles in each.angles:
            axis.plot(angles, ranks, marker="o", color="#4E9A3A", alpha=0.7)
        axis.set_title(
            f"{OBJECTIVES[name].title}\n{spacing} inches", fontsize=8
        )
    for row in axes:
        row[0].set_ylabel("leaf, from the lowest")
    for axis in axes[-1]:
        axis.set_xlabel("insertion angle [deg]")
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument(
        "--only", nargs="+", choices=OBJECTIVES, metavar="OBJECTIVE"
    )
    parser.add_argument("--figure", type=Path)
    parser.add_argument("--generations", type=int, default=200)
    parser.add_argument("--seeds", type=int, default=3)
    options = parser.parse_args()
    search = [
        "search.optimizer=cma_es",
        f"stop.generations={options.generations}",
        f"replicates={options.seeds}",
    ]
    results = {}
    for spacing in SPACINGS:
        for name in options.only or OBJECTIVES:
            print(
                f"breeding for {name} at {spacing.name}",
                file=sys.stderr,
                flush=True,
            )
            histories = breed(
                OBJECTIVES[name].campaign,
                f"{name}_{spacing.name}",
                [*settings(name, spacing), *search],
                options.folder,
            )
            results[name, spacing.name] = compare(name, spacing, histories)
    print_table(results)
    if options.figure:
        draw(results, options.figure)


if __name__ == "__main__":
    guard(main)
