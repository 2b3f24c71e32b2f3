#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests the claims of arXiv:2512.06064.

claims.py FOLDER --table PAPER_TABLE [--evaluations N] [--seeds N] [--rough]

Tests each claim in four set-ups: that of the paper (an isolated plot with
light from the sides, a bare stalk, absorbed PAR), and an endless stand under
absorbed PAR, net assimilation of a clear day, and the carbon balance of a
season. The plants of the stand are those that paper_table.py found by `auto`
in the folder PAPER_TABLE; those of the plot are optimised in FOLDER by the
genetic algorithm, as in the paper. Gains and losses are in % with 95 %
intervals, over seeds where there are several.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from conditions import CONDITIONS, FIRST, Condition, campaign
from estimates import (
    Estimate,
    difference,
    gain,
    has_percent,
    mean_over_seeds,
    plus_minus,
    print_table,
)
from paper_table import bred
from shared import (
    CAMPAIGNS,
    Numbers,
    gains_over_baseline,
    guard,
    leaves,
    light,
    parser_of_searches,
    say,
    with_trait,
)  # fmt: skip

from ideotype import Stand

UPPER = 4
PLACES = {x.name: x for x in CONDITIONS}
PLOT = "the paper's plot"
ELITE = CAMPAIGNS / "plants" / "elite.toml"
STANDS = {
    "stand, absorbed PAR": "absorbed_par",
    "stand, net assimilation": "net_assimilation",
    "stand, carbon balance of a season": "carbon_balance",
}


@dataclass(frozen=True)
class SetUp:
    title: str
    objective: str
    folder: Path
    evaluations: int
    seeds: int
    is_rough: bool
    is_plot: bool = False

    def tables(self, where: Condition) -> dict[str, Any]:
        found = campaign(where, self.objective, self.folder, self.is_rough)
        if not self.is_plot:
            return found
        plant = {**found["plant"], "organs": ["stalk"]}
        plot = {
            "rows": 6,
            "plants": 6,
            "boundary": "isolated",
            "border_rows": 1,
        }
        return {
            **found,
            "name": f"plot_{where.name}",
            "plant": plant,
            "field": plot,
            **({} if self.is_rough else {"light": {"tolerance": 0.02}}),
        }

    def best(self, where: Condition, seed: int) -> Numbers:
        """Returns the genome of the best plant of a search."""
        return bred(
            self.tables(where),
            "ga" if self.is_plot else "auto",
            seed,
            self.evaluations,
            self.folder,
        )


@cache
def stand(set_up: SetUp, where: Condition) -> Stand:
    return Stand(set_up.tables(where))


@cache
def best(set_up: SetUp, where: Condition) -> list[Numbers]:
    """Returns the best genome of each seed."""
    seeds = set_up.seeds if where == FIRST else 1
    return [set_up.best(where, seed) for seed in range(1, seeds + 1)]


def cell(values: list[Estimate]) -> str:
    return plus_minus(mean_over_seeds(values), sign="+")


def mol(values: list[Estimate]) -> str:
    return f"{plus_minus(mean_over_seeds(values), 3, '+')} mol"


def gain_with(name: str) -> Callable[[SetUp], str]:
    def look(set_up: SetUp) -> str:
        where = PLACES[name]
        plants = best(set_up, where)
        return cell(gains_over_baseline(stand(set_up, where), plants))

    return look


def over_elite(set_up: SetUp) -> str:
    tables = set_up.tables(FIRST)
    plant = {**tables["plant"], "baseline": str(ELITE)}
    other = Stand({**tables, "plant": plant})
    elite = light(other, other.baseline)[0].tolist()
    found = light(stand(set_up, FIRST), np.array(best(set_up, FIRST)))
    return cell([gain(elite, each) for each in found.tolist()])


def by_leaves(trait: str) -> Callable[[SetUp], str]:
    """Prints the mean of a trait over the lower and the upper leaves, for each
    seed."""

    def look(set_up: SetUp) -> str:
        here = stand(set_up, FIRST)
        own = leaves(here, here.baseline)[trait]
        pairs = []
        for genome in best(set_up, FIRST):
            values = leaves(here, genome)[trait]
            if trait == "width":
                values = 100 * values / own
            low, top = values.iloc[:UPPER].mean(), values.iloc[-UPPER:].mean()
            pairs.append(f"{low:.0f} / {top:.0f}")
        return ", ".join(pairs)

    return look


def without(
    change: Callable[[Stand, Numbers], Numbers],
) -> Callable[[SetUp], str]:
    """Prints the loss of the best plants due to a change [%]."""

    def look(set_up: SetUp) -> str:
        here = stand(set_up, FIRST)
        losses = []
        for genome in best(set_up, FIRST):
            own, changed = light(
                here, np.array([genome, change(here, genome)])
            ).tolist()
            losses.append(gain(own, changed))
        return cell(losses)

    return look


def equal_angles(here: Stand, genome: Numbers) -> Numbers:
    angles = leaves(here, genome)["insertion_angle"]
    return with_trait(
        here, genome, "insertion_angle", [angles.mean()] * len(angles)
    )


def erect_tops(here: Stand, genome: Numbers) -> Numbers:
    """Returns the plant with its insertion angles reordered, so that the
    steepest leaves are at the top."""
    angles = leaves(here, genome)["insertion_angle"]
    return with_trait(
        here, genome, "insertion_angle", sorted(angles, reverse=True)
    )


def even_widths(here: Stand, genome: Numbers) -> Numbers:
    """Returns the plant with widths proportional to those of the baseline and
    with unchanged leaf area."""
    plant, own = leaves(here, genome), leaves(here, here.baseline)
    scale = (plant.length * plant.width).sum() / (
        plant.length * own.width
    ).sum()
    return with_trait(here, genome, "width", list(scale * own.width))


def distichous(here: Stand, genome: Numbers) -> Numbers:
    """Returns the plant with leaves in two ranks across the row, as in the
    baseline."""
    own = leaves(here, here.baseline)["azimuth"]
    return with_trait(here, genome, "azimuth", list(own))


def elsewhere(names: tuple[str, ...]) -> Callable[[SetUp], str]:
    """Prints the gain of the plant optimised at 42 deg north and 30 x 6
    inches, under other conditions, over the plant optimised there: in %, or in
    mol if the carbon of the latter is not above zero."""

    def look(set_up: SetUp) -> str:
        cells = []
        for name in names:
            where = PLACES[name]
            values = light(
                stand(set_up, where),
                np.array([*best(set_up, where), *best(set_up, FIRST)]),
            ).tolist()
            own, *others = values
            if has_percent(own):
                lost = cell([gain(own, each) for each in others])
            else:
                lost = mol([difference(own, each) for each in others])
            cells.append(f"{where.title}: {lost}")
        return "; ".join(cells)

    return look


CLAIMS: dict[str, Callable[[SetUp], str]] = {
    "Azimuths alone gain 5.6 %": gain_with("azimuth"),
    "Angles and azimuths gain 5.6 %": gain_with("angles"),
    "With widths 21.5 %": gain_with("widths"),
    "All traits gain 38.7 %": gain_with("all"),
    "More than hybrids that yield much: gain over an elite-like plant [%]": (
        over_elite
    ),
    "Upper leaves are steep: insertion angles of leaves 1 to 4 / 7 to 10, by "
    "seed [deg]": by_leaves("insertion_angle"),
    "The profile of angles pays: all at their mean angle [%]": without(
        equal_angles
    ),
    "and the steepest on top pays: the same angles in that order [%]": without(
        erect_tops
    ),
    "Upper leaves are narrow: widths of leaves 1 to 4 / 7 to 10, by seed "
    "[% of the baseline's]": by_leaves("width"),
    "and that pays: widths in proportion to the baseline's, same area [%]": (
        without(even_widths)
    ),
    "Azimuths that share out the directions pay: two ranks across the row "
    "[%]": without(distichous),
    "Gains hold at other latitudes: relative to a plant bred there [%]": (
        elsewhere(("7", "56p2"))
    ),
    "and at other densities [%]": elsewhere(("15x3", "15x6")),
}


def main() -> None:
    parser = parser_of_searches(__doc__, evaluations=2500, seeds=3)
    parser.add_argument("--table", type=Path, required=True)
    titles = [PLOT, *STANDS]
    parser.add_argument("--set-up", nargs="+", choices=titles, default=titles)
    options = parser.parse_args()
    searches = {
        "evaluations": options.evaluations,
        "seeds": options.seeds,
        "is_rough": options.rough,
    }
    table = options.table.resolve()
    plot = SetUp(
        title=PLOT,
        objective="absorbed_par",
        folder=options.folder,
        is_plot=True,
        **searches,
    )
    set_ups = [
        plot
        if title == PLOT
        else SetUp(title, STANDS[title], table, **searches)
        for title in options.set_up
    ]
    rows = []
    for claim, look in CLAIMS.items():
        say(claim)
        rows.append([claim, *(look(set_up) for set_up in set_ups)])
    print_table(["claim", *(x.title for x in set_ups)], rows)


if __name__ == "__main__":
    guard(main)
