#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures which traits matter for three objectives.

what_matters.py FOLDER [--figure FILE.png] [--only OBJECTIVE...] [--samples N]
                [--evaluations N] [--seeds N] [--draws N] [--rough]

Objectives are absorbed PAR and net assimilation on the clear day of ames.toml,
and the carbon balance of the season of bondville.toml. Traits are those that a
breeder can select (bounds "breedable"), and stands have within-line variation.
Prints

* Sobol' indices of the traits over their bounds (`ideotype sensitivity`), with
  95 % intervals;
* the shares of groups of traits of an optimised plant in its gain over the
  baseline. A share is the Shapley value: the mean contribution of a group over
  all orders in which the groups can be taken over from the optimised plant
  (Shapley 1953; Owen 2014, doi:10.1137/130936233);
* the cost of a mistake of 10 deg to the optimised plant. Angles below 0 deg
  are set to 0.

± is half of a 95 % interval over common randomisations, or over seeds where
that is larger.
"""

from __future__ import annotations

import argparse
import math
import tomllib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
from climates import growth, season
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
    CAMPAIGNS,
    ROUGH,
    TITLES,
    Numbers,
    best_plants,
    guard,
    light,
    parser_of_searches,
    say,
    sensitivity,
    words_of,
)  # fmt: skip

from ideotype import Stand
from ideotype.figures.style import new_figure, series
from ideotype.history.indices import Indices

DAY, SEASON = CAMPAIGNS / "ames.toml", CAMPAIGNS / "bondville.toml"
#: The objectives of breeding, and the campaign that provides the light of
#: each.
OBJECTIVES = {
    "absorbed_par": DAY,
    "net_assimilation": DAY,
    "carbon_balance": SEASON,
}
#: The groups of traits that are transferred together from an optimised plant.
GROUPS = {
    "sizes": ("length_profile", "width_profile"),
    "height": ("height",),
    "insertion angles": ("insertion_angle_profile",),
    "bends": ("curvature_profile",),
    "azimuths": ("azimuth_deviation", "leaf_plane"),
}
ANGLE, AZIMUTH = "insertion_angle", "azimuth_deviation"
#: Mistakes: the trait, the error of all its values [deg], and whether the
#: error of each leaf is random in sign.
MISTAKES = {
    "all insertion angles 10 deg larger": (ANGLE, 10.0, False),
    "all insertion angles 10 deg smaller": (ANGLE, -10.0, False),
    "each insertion angle 10 deg off": (ANGLE, 10.0, True),
    "each azimuth 10 deg off": (AZIMUTH, 10.0, True),
    "leaf plane turned by 10 deg": ("leaf_plane", 10.0, False),
}


@dataclass(frozen=True)
class Result:
    """The results for one objective: shares of the gain in percentage points,
    costs in %."""

    indices: Indices
    gain: Estimate
    shares: dict[str, Estimate]
    costs: dict[str, Estimate]


def campaign(
    objective: str, is_rough: bool, grows: bool = False
) -> dict[str, Any]:
    path = OBJECTIVES[objective]
    tables = tomllib.loads(path.read_text(encoding="utf-8"))
    lit = {"day": tables["day"]} if path == DAY else {"climate": [season()]}
    return {
        **BREEDABLE,
        "name": objective,
        "site": tables["site"],
        **lit,
        "objective": {"maximise": objective},
        **(growth() if grows and path == SEASON else {}),
        **(ROUGH if is_rough else {}),
    }


def is_of(stand: Stand, traits: Sequence[str]) -> np.ndarray:
    """Returns whether each gene belongs to one of these traits."""
    return stand.genes.trait.isin(traits).to_numpy()


def combined(
    stand: Stand, bred: Numbers
) -> Iterator[tuple[frozenset[str], Numbers]]:
    """Yields the baseline with all combinations of trait groups of an
    optimised plant; the first combination is empty."""
    for count in range(len(GROUPS) + 1):
        for names in combinations(GROUPS, count):
            traits = [trait for name in names for trait in GROUPS[name]]
            yield (
                frozenset(names),
                np.where(is_of(stand, traits), bred, stand.baseline),
            )


def shapley(values: dict[frozenset[str], Numbers], name: str) -> Numbers:
    """Returns the gain by one group for each randomisation, averaged over all
    orders of groups."""
    count = len(GROUPS)
    total = np.zeros_like(values[frozenset()])
    for names, value in values.items():
        if name not in names:
            k = len(names)
            weight = 1 / (count * math.comb(count - 1, k))
            total += weight * (values[names | {name}] - value)
    return total


def shares(stand: Stand, bred: Numbers) -> dict[str, Estimate]:
    """Returns the shares of the gain [percentage points]; the key "" stands
    for the total gain."""
    names, plants = zip(*combined(stand, bred), strict=True)
    if not np.array_equal(plants[-1], bred):
        raise SystemExit("a free trait belongs to no group")
    values = dict(zip(names, light(stand, np.array(plants)), strict=True))
    baseline = values[frozenset()]
    parts = {name: shapley(values, name) for name in GROUPS}
    parts[""] = values[frozenset(GROUPS)] - baseline
    return {
        name: gain(baseline.tolist(), (baseline + part).tolist())
        for name, part in parts.items()
    }


def mistaken(
    stand: Stand, plant: Numbers, mistake: str, draws: int
) -> Iterator[Numbers]:
    """Yields plants with the given mistake."""
    trait, degrees, is_random = MISTAKES[mistake]
    genes = is_of(stand, [trait])
    numbers = np.random.default_rng(1)
    for _ in range(draws if is_random else 1):
        signs = numbers.choice([-1, 1], len(plant)) if is_random else 1
        yield plant + degrees * signs * genes


def cost(stand: Stand, plant: Numbers, mistake: str, draws: int) -> Estimate:
    """Returns the cost of a mistake [% of the objective]."""
    plants = [plant, *mistaken(stand, plant, mistake, draws)]
    right, *wrong = light(stand, np.array(plants))
    mean, error = gain(right.tolist(), np.mean(wrong, 0).tolist())
    if len(wrong) > 1:
        spread = np.mean(wrong, 1).std(ddof=1) / math.sqrt(len(wrong))
        error = math.hypot(error, 100 * spread / right.mean())
    return mean, error


def indices(tables: dict[str, Any], samples: int, folder: Path) -> Indices:
    """Returns the sensitivity indices of the objective."""
    study = {
        **tables,
        "name": f"{tables['name']}_indices",
        "sensitivity": {"samples": samples},
    }
    return sensitivity(study, folder)[tables["name"]]


def bred(tables: dict[str, Any], options: argparse.Namespace) -> list[Numbers]:
    """Returns the best plant of each seed."""
    search = {
        **tables,
        "replicates": options.seeds,
        "stop": {"evaluations": options.evaluations},
    }
    return best_plants(search, options.folder)


def look(objective: str, options: argparse.Namespace) -> Result:
    tables = campaign(objective, options.rough, options.growing)
    say(f"sensitivity of {objective}")
    found = indices(tables, options.samples, options.folder)
    say(f"optimising for {objective}")
    plants = bred(tables, options)
    stand = Stand(tables)
    by_seed = [shares(stand, plant) for plant in plants]
    parts = {
        name: mean_over_seeds([each[name] for each in by_seed])
        for name in by_seed[0]
    }
    costs = {
        mistake: mean_over_seeds(
            [cost(stand, plant, mistake, options.draws) for plant in plants]
        )
        for mistake in MISTAKES
    }
    return Result(found, parts.pop(""), parts, costs)


def sobol(indices: Indices, which: str) -> dict[str, Estimate]:
    """Returns one of the indices for each trait."""
    numbers = (indices.index[which], indices.standard_error[which])
    return {
        words_of(trait): (float(mean), float(error))
        for trait, mean, error in zip(indices.factors, *numbers, strict=True)
    }


def interval(value: Estimate) -> str:
    """Formats a 95 % interval."""
    mean, half = value[0], half_interval(value[1])
    return f"{mean:.2f} ({mean - half:.2f} .. {mean + half:.2f})"


def signed(value: Estimate) -> str:
    return plus_minus(value, 2, "+")


def tell(
    title: str,
    columns: dict[str, dict[str, Estimate]],
    form: Callable[[Estimate], str] = signed,
) -> None:
    names = next(iter(columns.values()))
    rows = [
        [name, *(form(values[name]) for values in columns.values())]
        for name in names
    ]
    print_table([title, *columns], rows)


def print_tables(results: dict[str, Result]) -> None:
    found = {TITLES[name]: each for name, each in results.items()}
    tell(
        "Sobol' index",
        {
            f"{title}: {which}": sobol(each.indices, which)
            for title, each in found.items()
            for which in ("first", "total")
        },
        interval,
    )
    print()
    tell(
        "part of the gain over the baseline [%]",
        {x: {**each.shares, "all": each.gain} for x, each in found.items()},
    )
    print()
    tell(
        "change of the bred plant by a mistake [%]",
        {x: each.costs for x, each in found.items()},
    )


def draw(results: dict[str, Result], path: Path) -> None:
    """Draws bars with 95 % intervals."""
    figure = new_figure(11, 3.6)
    figure.suptitle("Which traits make the difference?")
    panels: dict[str, Callable[[Result], dict[str, Estimate]]] = {
        "total Sobol' index: share of the\nvariance of plants": (
            lambda each: sobol(each.indices, "total")
        ),
        "part of the gain over the baseline\n[percentage points]": (
            lambda each: each.shares
        ),
        "change by a mistake\n[% of the bred plant]": lambda each: each.costs,
    }
    height = 0.8 / len(results)
    axes = figure.subplots(1, len(panels))
    for axis, (label, values_of) in zip(axes, panels.items(), strict=True):
        for i, (name, each) in enumerate(results.items()):
            values = values_of(each)
            axis.barh(
                np.arange(len(values)) + i * height,
                [mean for mean, _ in values.values()],
                height,
                xerr=[half_interval(error) for _, error in values.values()],
                color=series(i)[0],
                label=TITLES[name],
                error_kw={"linewidth": 1},
            )
        axis.set_yticks(
            np.arange(len(values)) + 0.4 - height / 2,
            [name.replace(" 10 deg", "\n10 deg") for name in values],
            fontsize=8,
        )
        axis.invert_yaxis()
        axis.axvline(0, color="#999999", linewidth=1)
        axis.grid(visible=False, axis="y")
        axis.set_xlabel(label)
    figure.legend(
        *axes[0].get_legend_handles_labels(),
        loc="outside lower center",
        ncols=len(results),
        fontsize=8,
    )
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = parser_of_searches(
        __doc__,
        has_figure=True,
        has_growth=True,
        samples=256,
        evaluations=1200,
        seeds=2,
        draws=8,
    )
    parser.add_argument(
        "--only", nargs="+", choices=OBJECTIVES, metavar="OBJECTIVE"
    )
    options = parser.parse_args()
    results = {
        name: look(name, options) for name in options.only or OBJECTIVES
    }
    print_tables(results)
    if options.figure:
        draw(results, options.figure)


if __name__ == "__main__":
    guard(main)
