#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the gain of each search, by evaluations and by time.

searches.py FOLDER [--figure FILE.png] [--evaluations N] [--seeds N]
            [--only SEARCH...] [--campaign FILE]

Runs a campaign (ames.toml by default) with each search and takes the best
plant of the generation that reaches each number of evaluations (the best of
all until then for a search that does not learn). Re-evaluates these plants and
the baseline with many paths. Prints the gain over the baseline in %, the mean
of the seeds with its 95 % interval, and the seconds of all evaluations until
then. Finished cases in FOLDER are not repeated. IDEOTYPE_EXECUTABLE names the
program; without it, the one on PATH is used.
"""

from __future__ import annotations

import argparse
import math
from dataclasses import dataclass
from pathlib import Path
from statistics import fmean, stdev

import numpy as np
from estimates import half_interval, plus_minus, print_table
from shared import (
    CAMPAIGNS,
    Numbers,
    breed,
    gains_over_baseline,
    guard,
    parser_of,
    say,
)

from ideotype import Stand, open_history
from ideotype.figures.style import new_figure, series

#: Searches by name: keys of [search], and the number of candidates per
#: generation.
SEARCHES: dict[str, tuple[tuple[str, ...], int]] = {
    "random": (("search.optimizer=random",), 100),
    "sobol": (("search.optimizer=sobol",), 100),
    "ga": (("search.optimizer=ga",), 100),
    "cma_es": (("search.optimizer=cma_es",), 15),
    "cma_es_40": (("search.optimizer=cma_es",), 40),
    "auto": (("search.optimizer=auto",), 37),
}
RANDOM = 2
"""The origin of a plant that has no parents."""
CHECKPOINTS = (
    100,
    250,
    500,
    1000,
    1500,
    2000,
    2500,
    3000,
    4000,
    6000,
    10000,
    20000,
)


@dataclass(frozen=True)
class Point:
    """The results of a search after a number of evaluations."""

    evaluations: int
    gains: list[float]  # The gain of each seed [%].
    errors: list[float]  # The paired standard error of each gain [%].
    seconds: float  # The processor time, a mean over the seeds.

    @property
    def gain(self) -> float:
        return fmean(self.gains)

    @property
    def error(self) -> float:
        if len(self.gains) == 1:
            return self.errors[0]
        return stdev(self.gains) / math.sqrt(len(self.gains))


def run(name: str, options: argparse.Namespace) -> list[Path]:
    keys, population = SEARCHES[name]
    say(f"searching by {name}")
    every = [
        f"search.population={population}",
        f"stop.generations={math.ceil(options.evaluations / population)}",
        f"replicates={options.seeds}",
        "final.candidates=2",
        *keys,
    ]
    return breed(options.campaign, name, every, options.folder)


def best_until(
    history: Path, checkpoints: list[int]
) -> list[tuple[Numbers, float]]:
    """Returns for each checkpoint the best plant and the processor time of all
    evaluations until then [s]. For searches that learn, the best plant is that
    of the last generation; for others, that of all generations."""
    found: list[tuple[Numbers, float]] = []
    highest, plant = -math.inf, np.empty(0)
    done, seconds = 0, 0.0
    with open_history(history) as opened:
        for generation in range(len(opened.generations())):
            rows = opened.evaluations(generation)
            done += len(rows)
            seconds += float(np.sum(rows.seconds))
            best = rows.ranking(1)[0]
            value = rows.goals[0].sign * rows.objectives[best, 0]
            learns = rows.origin[-1] != RANDOM
            if learns or value > highest:
                highest, plant = value, rows.genome[best]
            while (
                len(found) < len(checkpoints)
                and done >= checkpoints[len(found)]
            ):
                found.append((plant, seconds))
    return found


def evaluate_again(
    histories: list[Path], stand: Stand, checkpoints: list[int]
) -> list[Point]:
    """Re-evaluates the best plants of one search with common random
    numbers."""
    chosen = [best_until(path, checkpoints) for path in histories]
    count = min(map(len, chosen))
    plants = [plant for points in chosen for plant, _ in points[:count]]
    every = gains_over_baseline(stand, plants)
    points = []
    for k, evaluations in enumerate(checkpoints[:count]):
        gains, errors = zip(*every[k::count])
        seconds = fmean(points_of[k][1] for points_of in chosen)
        points.append(Point(evaluations, list(gains), list(errors), seconds))
    return points


def tell(found: dict[str, list[Point]]) -> None:
    titles = ["search", "evaluations", "gain [%]", "by seed"]
    rows = [
        [
            name,
            f"{each.evaluations:,}",
            plus_minus((each.gain, each.error), 2),
            ", ".join(plus_minus(x, 2) for x in zip(each.gains, each.errors)),
            f"{each.seconds:.1f}",
        ]
        for name, points in found.items()
        for each in points
    ]
    print_table([*titles, "core-seconds"], rows)


def draw(found: dict[str, list[Point]], path: Path) -> None:
    figure = new_figure(9, 3.6)
    axes = figure.subplots(1, 2, sharey=True)
    for i, (name, points) in enumerate(found.items()):
        color, marker = series(i)
        for axis, xs in (
            (axes[0], [p.evaluations for p in points]),
            (axes[1], [p.seconds for p in points]),
        ):
            axis.errorbar(
                xs,
                [p.gain for p in points],
                [half_interval(p.error) for p in points],
                color=color,
                marker=marker,
                label=name,
            )
    axes[0].set_xlabel("evaluations")
    axes[1].set_xlabel("core-seconds of evaluations")
    axes[0].set_ylabel("gain over the baseline [%]")
    for axis in axes:
        axis.set_xscale("log")
    axes[0].legend(fontsize=7)
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--figure", type=Path)
    parser.add_argument("--evaluations", type=int, default=20000)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument(
        "--only", nargs="+", choices=SEARCHES, metavar="SEARCH"
    )
    parser.add_argument(
        "--campaign", type=Path, default=CAMPAIGNS / "ames.toml"
    )
    options = parser.parse_args()
    stand = Stand.from_campaign(options.campaign)
    checkpoints = [x for x in CHECKPOINTS if x <= options.evaluations]
    found = {
        name: evaluate_again(run(name, options), stand, checkpoints)
        for name in options.only or SEARCHES
    }
    tell(found)
    if options.figure:
        draw(found, options.figure)


if __name__ == "__main__":
    guard(main)
