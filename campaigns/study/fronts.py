#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds the leaf area that a season's carbon needs.

fronts.py FOLDER [--figure FILE.png] [--generations N] [--seeds N]
          [--growing] [--rough]

Breeds crops/maize.toml by NSGA-II for a high carbon balance of the season
measured at Bondville, Illinois, and a low leaf area index. Traits are those
that a breeder can select (bounds "breedable"), and plants differ as those of
fields do. Evaluates members of the front of each seed again with the same
random numbers and prints some of those that no other dominates, the baseline,
and the leaf area index beyond which more leaves cost more carbon than they
gain. ± is the standard error; that of a difference is over randomisations that
both plants share.
"""

from __future__ import annotations

import argparse
import math
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from climates import bondville, growing_season, season
from draw_plants import draw as draw_plant
from matplotlib.axes import Axes
from shared import (
    BREEDABLE,
    ROUGH,
    Numbers,
    breed_tables,
    estimate,
    guard,
    parser_of_searches,
    print_table,
    told,
)  # fmt: skip

from ideotype import Error, Stand, open_history
from ideotype.analysis.figures.style import BASELINE, BEST, QUIET, new_figure
from ideotype.analysis.front import non_dominated

SHOWN = 8
DRAWN = 5
"""The number of plants of the front in the figure."""


@dataclass(frozen=True)
class Found:
    """Plants in the order of their leaf area index, with the baseline."""

    stand: Stand
    genomes: Numbers  # genomes [plants, genes], the baseline last
    lai: Numbers
    carbon: Numbers  # carbon balance of plants [plants, randomisations]
    is_front: np.ndarray  # whether no other plant dominates a plant
    seed: Numbers  # the seed that bred each plant but the baseline

    @property
    def front(self) -> list[int]:
        return [int(i) for i in np.flatnonzero(self.is_front)]

    @property
    def unit(self) -> str:
        known = self.stand.quantities.set_index("name")
        return str(known.unit["carbon_balance"])

    def shown(self, count: int) -> list[int]:
        """Returns members of the front at about equal steps of leaf area."""
        lai = self.lai[self.front]
        step = (lai[-1] - lai[0]) / max(count - 1, 1)
        number = np.round((lai - lai[0]) / max(step, 1e-9))
        off = np.abs(lai - lai[0] - number * step)
        return [
            self.front[int(np.where(number == each, off, np.inf).argmin())]
            for each in np.unique(number)
        ]


def campaign(options: argparse.Namespace) -> dict[str, Any]:
    lit = (
        growing_season()
        if options.growing
        else {"site": bondville()["site"], "climate": [season()]}
    )
    return {
        **BREEDABLE,
        "name": "front",
        "replicates": options.seeds,
        "objective": {"maximise": "carbon_balance", "minimise": "lai"},
        "search": {"optimizer": "nsga2", "population": 40},
        "stop": {"generations": options.generations},
        **lit,
        "final": {
            **BREEDABLE["final"],
            **lit.get("final", {}),
            "candidates": 20,
        },
        **(ROUGH if options.rough else {}),
    }


def members(history: Path) -> Numbers:
    """Returns genomes of the front [plants, genes]."""
    with open_history(history) as opened:
        front = opened.front()
    if front is None:
        raise Error(f"{history}: no plant is evaluated yet")
    return front.members.genome


def find(options: argparse.Namespace) -> Found:
    tables = campaign(options)
    stand = Stand(tables)
    bred = [members(path) for path in breed_tables(tables, options.folder)]
    seed = np.repeat(np.arange(len(bred)), [len(plants) for plants in bred])
    genomes = np.vstack([*bred, stand.baseline])
    values = stand.evaluate(genomes, ["lai"], final=True)
    lai = values.lai.to_numpy()
    carbon = values.objective_by_randomisation.sel(
        objective="carbon_balance"
    ).to_numpy()
    order = np.append(np.argsort(lai[:-1]), len(seed))
    is_front = non_dominated(
        np.column_stack([carbon.mean(1), lai])[order], [1, -1]
    )
    is_front[-1] = False
    return Found(
        *(stand, genomes[order], lai[order], carbon[order], is_front),
        seed=seed[order[:-1]],
    )


def angles(found: Found, plant: int) -> list[str]:
    """Prints the means of the upper four leaves and of the lower four leaves
    [deg]."""
    crop = tomllib.loads(found.stand.crop_file(found.genomes[plant]))
    leaves = [leaf["insertion_angle"] for leaf in crop["leaf"]]
    return [f"{np.mean(x):.0f}" for x in (leaves[-4:], leaves[:4])]


def top(found: Found) -> tuple[float, float, float]:
    """Returns the leaf area index of the highest carbon balance, and its 95 %
    interval by bootstrap over randomisations."""
    bred = found.carbon[:-1]
    count = bred.shape[1]
    draws = np.random.default_rng(1).integers(count, size=(2000, count))
    highest = [int(bred[:, draw].mean(1).argmax()) for draw in draws]
    lower, upper = np.quantile(found.lai[highest], [0.025, 0.975])
    return float(found.lai[bred.mean(1).argmax()]), lower, upper


def tell(found: Found) -> None:
    chosen = found.shown(SHOWN)
    rows = [["baseline", *row(found, len(found.lai) - 1, None)]]
    for number, plant in enumerate(chosen, 1):
        before = chosen[number - 2] if number > 1 else None
        rows.append([str(number), *row(found, plant, before)])
    titles = [
        "plant",
        "leaf area index",
        f"carbon balance [{found.unit}]",
        "per leaf area",
        "of one more unit of leaf area",
        "insertion angle of the upper 4 leaves [deg]",
        "of the lower 4",
    ]
    print_table(titles, rows)
    carbon = found.carbon[:-1].mean(1)
    by_seed = [
        found.lai[np.where(found.seed == seed, carbon, 0).argmax()]
        for seed in np.unique(found.seed)
    ]
    print(
        "\nThe carbon balance is highest at a leaf area index of "
        "{:.2f} ({:.2f} .. {:.2f});".format(*top(found)),
        f"by seed {', '.join(f'{x:.2f}' for x in by_seed)}.",
    )


def row(found: Found, plant: int, before: int | None) -> list[str]:
    lai, carbon = found.lai[plant], found.carbon[plant]
    more = ""
    if before is not None:
        step = lai - found.lai[before]
        steps = (carbon - found.carbon[before]) / step
        more = told(estimate(steps.tolist()), 3, "+")
    return [
        f"{lai:.2f}",
        told(estimate(carbon.tolist()), 3),
        told(estimate((carbon / lai).tolist()), 3),
        more,
        *angles(found, plant),
    ]


def draw(found: Found, path: Path) -> None:
    baseline = len(found.lai) - 1
    shown = sorted(
        [*found.shown(DRAWN), baseline], key=lambda i: float(found.lai[i])
    )
    figure = new_figure(9, 6)
    figure.suptitle("How much leaf area does a season's carbon need?")
    grid = figure.add_gridspec(2, len(shown), height_ratios=(1, 1.3))
    panels = [figure.add_subplot(grid[0, i]) for i in range(len(shown))]
    draw_plants(found, panels, shown)
    axes = figure.add_subplot(grid[1, :])
    means = found.carbon.mean(1)
    errors = found.carbon.std(1, ddof=1) / math.sqrt(found.carbon.shape[1])
    for name, plants, color, marker in (
        ("front", found.front, BEST, "o"),
        ("baseline", [baseline], BASELINE, "D"),
    ):
        axes.errorbar(
            found.lai[plants], means[plants], 1.96 * errors[plants],
            color=color, marker=marker, linestyle="none", label=name,
        )  # fmt: skip
    middle, lower, upper = top(found)
    axes.axvspan(lower, upper, color=QUIET, alpha=0.3, linewidth=0)
    axes.axvline(middle, color=QUIET, label="more leaves no longer pay")
    axes.set_xlabel("leaf area index")
    axes.set_ylabel(f"carbon balance [{found.unit}]")
    axes.legend(loc="lower right")
    figure.savefig(path, dpi=110)


def draw_plants(found: Found, panels: list[Axes], shown: list[int]) -> None:
    """Draws plants from the side, at one scale."""
    meshes = [found.stand.mesh(found.genomes[i]) for i in shown]
    every = np.vstack([mesh.vertices for mesh in meshes])
    reach = 1.05 * np.hypot(every[:, 0], every[:, 1]).max()
    for axes, mesh, plant in zip(panels, meshes, shown, strict=True):
        draw_plant(axes, mesh, is_side=True)
        axes.set(xlim=(-reach, reach), ylim=(0, 1.03 * every[:, 2].max()))
        axes.set_axis_off()
        name = "" if plant in found.front else "baseline, "
        axes.set_title(f"{name}{found.lai[plant]:.1f}", fontsize=9)


def main() -> None:
    parser = parser_of_searches(
        __doc__, has_figure=True, has_growth=True, generations=60, seeds=2
    )
    options = parser.parse_args()
    found = find(options)
    tell(found)
    if options.figure:
        draw(found, options.figure)


if __name__ == "__main__":
    guard(main)
