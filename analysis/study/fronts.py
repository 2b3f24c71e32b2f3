#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds the leaf area, or the water, that a season's carbon needs.

fronts.py FOLDER [--figure FILE.png] [--generations N] [--seeds N]
          [--growing | --water] [--rough]

Optimises crops/maize.toml by NSGA-II for a high carbon balance of the season
measured at Bondville, Illinois, and a low leaf area index; with --water for a
high carbon balance of July in the drought of 2012, where leaves exchange
water, and low transpiration. Traits are those that a breeder can select
(bounds "breedable"), and stands have within-line variation. Re-evaluates
members of the Pareto front of each seed with common random numbers and prints
some of those that no other dominates, the baseline, and the leaf area index or
transpiration beyond which more of it gains no carbon. ± is half of a 95 %
interval; that of a difference is over common randomisations.
"""

from __future__ import annotations

import argparse
import math
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
from climates import bondville, dry_month, growth, season
from draw_plants import draw as draw_plant
from estimates import estimate, gain, half_interval, plus_minus, print_table
from front_members import BALANCE, LEAVES, WATER, Found, Price
from matplotlib.axes import Axes
from shared import (
    BREEDABLE,
    ROUGH,
    Numbers,
    breed_tables,
    front_of,
    guard,
    parser_of_searches,
)  # fmt: skip

from ideotype import Stand
from ideotype.figures.style import BASELINE, BEST, QUIET, new_figure
from ideotype.history.front import non_dominated

SHOWN = 8
DRAWN = 5
"""The number of plants of the front in the figure."""
CARBON = 12.011
"""The molar mass of carbon [g mol-1]."""


def campaign(options: argparse.Namespace, price: Price) -> dict[str, Any]:
    lit = {"site": bondville()["site"], "climate": [season()]}
    if options.growing or options.water:
        lit = growth() if options.growing else dry_month()
    return {
        **BREEDABLE,
        "name": "front",
        "replicates": options.seeds,
        "objective": {
            "maximise": "carbon_balance",
            "minimise": price.quantity,
        },
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


def find(options: argparse.Namespace) -> Found:
    price = WATER if options.water else LEAVES
    tables = campaign(options, price)
    stand = Stand(tables)
    bred = [front_of(path) for path in breed_tables(tables, options.folder)]
    seed = np.repeat(np.arange(len(bred)), [len(plants) for plants in bred])
    genomes = np.vstack([*bred, stand.baseline])
    values = stand.evaluate(genomes, ["lai"], final=True)
    both = values.objective_by_randomisation.to_numpy()
    order = np.append(np.argsort(both[:-1, 1].mean(1)), len(seed))
    carbon, paid = both[order].swapaxes(0, 1)
    is_front = non_dominated(
        np.column_stack([carbon.mean(1), paid.mean(1)]), [1, -1]
    )
    is_front[-1] = False
    return Found(
        *(stand, price, genomes[order], values.lai.to_numpy()[order]),
        *(paid, carbon, is_front),
        seed=seed[order[:-1]],
    )


def angles(found: Found, plant: int) -> list[str]:
    """Formats the mean angles of the four highest and of the lowest four
    leaves [deg]."""
    crop = tomllib.loads(found.stand.crop_file(found.genomes[plant]))
    leaves = [leaf["insertion_angle"] for leaf in crop["leaf"]]
    return [f"{np.mean(x):.0f}" for x in (leaves[-4:], leaves[:4])]


def top(found: Found) -> tuple[float, float, float]:
    """Returns the resource that the highest carbon balance requires, with its
    95 % interval by bootstrap over randomisations."""
    bred = found.carbon[:-1]
    count = bred.shape[1]
    draws = np.random.default_rng(1).integers(count, size=(2000, count))
    highest = [int(bred[:, draw].mean(1).argmax()) for draw in draws]
    lower, upper = np.quantile(found.paid[highest], [0.025, 0.975])
    return float(found.paid[bred.mean(1).argmax()]), lower, upper


def tell(found: Found) -> None:
    chosen = found.shown(SHOWN)
    row = leaf_row if found.price == LEAVES else water_row
    rows = [["baseline", *row(found, len(found.lai) - 1, None)]]
    for number, plant in enumerate(chosen, 1):
        before = chosen[number - 2] if number > 1 else None
        rows.append([str(number), *row(found, plant, before)])
    titles = ["plant", found.price.title, *found.price.titles]
    titles += ["insertion angle of the upper 4 leaves [deg]", "of the lower 4"]
    print_table(titles, rows)
    carbon = found.carbon[:-1].mean(1)
    by_seed = [
        found.paid[np.where(found.seed == seed, carbon, 0).argmax()]
        for seed in np.unique(found.seed)
    ]
    print(
        f"\nThe carbon balance is highest at a {found.price.name} of "
        "{:.2f} ({:.2f} .. {:.2f});".format(*top(found)),
        f"by seed {', '.join(f'{x:.2f}' for x in by_seed)}.",
    )
    tell_ends(found)


def over_baseline(values: Numbers, plant: int) -> tuple[float, float]:
    """Returns the gain of a plant over the baseline and its error [%]."""
    return gain(values[-1].tolist(), values[plant].tolist())


def tell_ends(found: Found) -> None:
    """Prints the resource with which a plant on the front has the carbon of
    the baseline, and the carbon of the best plant."""
    carbon = found.carbon.mean(1)
    ends = {
        f"least {found.price.name} of those with no less carbon than it": [
            i for i in found.front if carbon[i] >= carbon[-1]
        ][:1],
        "most carbon": [int(carbon[:-1].argmax())],
    }
    print("\nOver the baseline (95 % intervals of randomisations):")
    for name, plants in ends.items():
        for plant in plants:
            paid, more = (
                plus_minus(over_baseline(values, plant), 1, "+")
                for values in (found.paid_by_randomisation, found.carbon)
            )
            print(
                f"the plant with the {name} has {paid} % of "
                f"{found.price.name} and {more} % of carbon."
            )


def leaf_row(found: Found, plant: int, before: int | None) -> list[str]:
    lai, carbon = found.lai[plant], found.carbon[plant]
    more = ""
    if before is not None:
        step = lai - found.lai[before]
        steps = (carbon - found.carbon[before]) / step
        more = plus_minus(estimate(steps.tolist()), 3, "+")
    return [
        f"{lai:.2f}",
        plus_minus(estimate(carbon.tolist()), 3),
        plus_minus(estimate((carbon / lai).tolist()), 3),
        more,
        *angles(found, plant),
    ]


def water_row(found: Found, plant: int, _: int | None) -> list[str]:
    water, carbon = found.paid_by_randomisation, found.carbon
    more = [
        plus_minus(over_baseline(each, plant), 1, "+")
        if plant < len(each) - 1
        else ""
        for each in (water, carbon)
    ]
    # The ratio of means; its error is that of linearised ratios (Cochran 1977,
    # chapter 6).
    ratio = carbon[plant].mean() / water[plant].mean()
    apart = (carbon[plant] - ratio * water[plant]) / water[plant].mean()
    per_water = CARBON * (ratio + apart)
    return [
        *(plus_minus(estimate(water[plant].tolist()), 2), more[0]),
        *(plus_minus(estimate(carbon[plant].tolist()), 3), more[1]),
        *(
            plus_minus(estimate(per_water.tolist()), 2),
            f"{found.lai[plant]:.2f}",
        ),
        *angles(found, plant),
    ]


def draw(found: Found, path: Path) -> None:
    baseline = len(found.lai) - 1
    shown = sorted(
        [*found.shown(DRAWN), baseline], key=lambda i: float(found.paid[i])
    )
    figure = new_figure(9, 6)
    figure.suptitle(found.price.question)
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
            found.paid[plants], means[plants],
            [half_interval(x) for x in errors[plants]],
            color=color, marker=marker, linestyle="none", label=name,
        )  # fmt: skip
    middle, lower, upper = top(found)
    axes.axvspan(lower, upper, color=QUIET, alpha=0.3, linewidth=0)
    axes.axvline(middle, color=QUIET, label="carbon is highest")
    axes.set_xlabel(found.price.title)
    axes.set_ylabel(BALANCE)
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
        axes.set_title(f"{name}{found.paid[plant]:.1f}", fontsize=9)


def main() -> None:
    parser = parser_of_searches(
        __doc__, has_figure=True, has_growth=True, generations=60, seeds=2
    )
    parser.add_argument(
        "--water",
        action="store_true",
        help="minimise transpiration instead of leaf area",
    )
    options = parser.parse_args()
    if options.growing and options.water:
        parser.error("--water is of plants that stand; leave --growing out")
    found = find(options)
    tell(found)
    if options.figure:
        draw(found, options.figure)


if __name__ == "__main__":
    guard(main)
