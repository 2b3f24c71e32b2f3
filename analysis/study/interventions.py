#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Changes one trait of a plant at a time, with and without its other organs.

interventions.py FOLDER [--fields N] [--evaluations N] [--seeds N] [--rough]

Moves each trait that quickstart.toml optimises halfway to its bounds and to
them, while all other traits stay those of the baseline. Prints the change of
the season's carbon and of absorbed PAR in each variant of
`ideotype.report.organ_split`, from all organs to leaves alone
(`plant.organs = []`); the difference between successive variants; and the
light intercepted by other organs and dead leaves. Prints the same for height
in the hybrid that grows in 2011 at Bondville. Runs quickstart.toml in FOLDER
and prints the gains of the best plants of its searches in each variant, with
their height and with that of the baseline. All plants stand in the same N
fields with common random numbers. ± is half of a 95 % interval of paired
differences.
"""

from __future__ import annotations

import argparse
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd
from climates import growth
from estimates import Estimate, interval_of, plus_minus, print_table
from shared import (
    BREEDABLE,
    ROUGH,
    Numbers,
    best_plants,
    campaign_of,
    guard,
    parser_of_searches,
    say,
)  # fmt: skip

import ideotype
from ideotype import Stand
from ideotype.history.estimate import Estimate as Figure
from ideotype.report.organ_split import (
    Split,
    Variant,
    make_variants,
    split_gain,
)

STEPS = (-1.0, -0.5, 0.5, 1.0)
"""The parts of the way from the baseline to the lower (-) or upper bound."""
#: Two objectives, so that the randomisations of both are available.
MEASURED = {
    "objective.maximise": ["carbon_balance", "absorbed_par"],
    "search.optimizer": "nsga2",
}


CARBON = "mol m-2 day-1"
Stands = list[tuple[Variant, Stand]]
"""The variants of a campaign, first with all organs, and their stands."""


@dataclass(frozen=True)
class Evaluated:
    """Plants evaluated in the same fields."""

    carbon: Numbers
    """The carbon balance [plants, randomisations]."""
    par: Numbers
    """The PAR that leaves absorb [plants, randomisations]."""
    others: Numbers
    """The light that other organs and dead leaves absorb [plants, % of
    incident]."""


def evaluate(stand: Stand, genomes: Sequence[Numbers]) -> Evaluated:
    found = stand.evaluate(np.array(genomes), ["stalk_fraction"], final=True)
    for message in found.message.values:
        if message:
            raise ideotype.Error(f"{stand.name}: {message}")
    carbon, par = found.objective_by_randomisation.to_numpy().swapaxes(0, 1)
    return Evaluated(carbon, par, 100 * found.stalk_fraction.to_numpy())


def splits(
    variants: Sequence[Variant], values: Sequence[Numbers], unit: str
) -> list[Split]:
    """Returns the split of the gain of each plant over the first one. `values`
    are the objective of all plants in each variant [plants,
    randomisations]."""
    return [
        split_gain(variants, [each[[0, k]] for each in values], unit)
        for k in range(1, len(values[0]))
    ]


def pair_of(figure: Figure) -> Estimate:
    return figure.mean, figure.standard_error


def titles_of(variants: Sequence[Variant], quantity: str) -> list[str]:
    """Returns the titles of the columns of cells()."""
    return [
        *(f"{quantity} {v.title} [%]" for v in variants),
        *(
            f"{quantity} by {v.removed} [points]"
            for v in variants
            if v.removed
        ),
    ]


def cells(found: Split) -> list[str]:
    """Returns the gain in each variant and the differences between successive
    variants."""
    unit = "" if found.unit == "%" else f" {found.unit.partition(' ')[0]}"
    return [
        plus_minus(pair_of(x), 2, "+") + unit
        for x in (*found.gains, *found.parts)
    ]


def named(trait: str, unit: str, value: float) -> str:
    name = trait.removesuffix("_profile").replace("_", " ")
    if unit == "1":
        return f"{name} x {value:g}"
    return f"{name} {value:+g} {unit}"


def changes(stand: Stand, only: str = "") -> Iterator[tuple[str, Numbers]]:
    """Yields plants that differ from the baseline in one free trait, only in
    the trait `only` if it is given. Changes of traits of single leaves
    alternate in sign between leaves, because equal changes of azimuth would
    only rotate the plant."""
    free = stand.genes[stand.free]
    for trait, genes in free.groupby("trait", sort=False):
        if only and trait != only:
            continue
        turns = np.where(genes.leaf % 2, 1, -1) if genes.leaf.any() else 1
        for step in STEPS:
            ends = np.where(step * turns < 0, genes.lower, genes.upper)
            values = genes.baseline + abs(step) * (ends - genes.baseline)
            plant = pd.Series(stand.baseline)
            plant[genes.index] = values
            name = named(str(trait), genes.unit.iloc[0], float(values.iloc[0]))
            if genes.leaf.any():
                name += ", leaves in turn"
            yield name, plant.to_numpy()


def print_changes(stands: Stands, only: str = "") -> None:
    """Prints the effect of each trait alone, or only that of `only`."""
    variants = [variant for variant, _ in stands]
    names, plants = zip(*changes(stands[0][1], only), strict=True)
    found = []
    for variant, stand in stands:
        say(f"traits, {variant.title}")
        found.append(evaluate(stand, [stand.baseline, *plants]))
    carbon = splits(variants, [each.carbon for each in found], CARBON)
    # Light does not depend on the carbon of other organs.
    ends = [variants[0], variants[-1]]
    par = splits(ends, [found[0].par, found[-1].par], "MJ m-2 day-1")
    light = [f"{x:.2f}" for x in found[0].others]
    titles = titles_of(variants, "season's carbon")
    titles += titles_of(ends, "PAR of leaves")
    rows = [
        [name, *cells(one), *cells(other), share]
        for name, one, other, share in zip(
            names, carbon, par, light[1:], strict=True
        )
    ]
    print_table(
        [
            "the baseline with",
            *titles,
            "light of other organs and dead leaves [% of incident]",
        ],
        [["no change", *[""] * len(titles), light[0]], *rows],
    )


def with_own_height(stand: Stand, plant: Numbers) -> Numbers:
    """Returns the plant with the height of the baseline."""
    is_height = (stand.genes.trait == "height").to_numpy()
    return np.where(is_height, stand.baseline, plant)


def print_best(stands: Stands, plants: Sequence[Numbers]) -> None:
    """Prints the gains of optimised plants in each variant."""
    variants = [variant for variant, _ in stands]
    values = []
    for variant, stand in stands:
        say(f"optimised plants, {variant.title}")
        equally_high = [with_own_height(stand, plant) for plant in plants]
        genomes = [stand.baseline, *plants, *equally_high]
        values.append(evaluate(stand, genomes).carbon)
    both = splits(variants, values, CARBON)
    columns: dict[str, list[Estimate]] = {}
    for height, found in (
        ("", both[: len(plants)]),
        (", height of the baseline", both[len(plants) :]),
    ):
        for k, variant in enumerate(variants):
            columns[f"gain {variant.title}{height} [%]"] = [
                pair_of(each.gains[k]) for each in found
            ]
        for k, variant in enumerate(variants[1:]):
            columns[f"by {variant.removed}{height} [points]"] = [
                pair_of(each.parts[k]) for each in found
            ]
    genes = stands[0][1].genes
    heights = [plant[genes.trait == "height"][0] for plant in plants]
    rows = [
        [str(seed), f"x {height:.2f}", *(plus_minus(x, 1, "+") for x in row)]
        for seed, (height, row) in enumerate(
            zip(heights, zip(*columns.values(), strict=True), strict=True), 1
        )
    ]
    print_table(["seed", "height", *columns], rows)
    print("\nMeans over the searches:")
    for name, gains in columns.items():
        print(f"{name.partition(' [')[0]}: {interval_of(gains)}")


def tables_of(options: argparse.Namespace) -> dict[str, Any]:
    """Returns the tables of the quickstart with the requested numbers of
    fields and searches."""
    tables = campaign_of("quickstart", replicates=options.seeds)
    tables["search"], tables["stop"] = {}, {"evaluations": options.evaluations}
    if options.rough:
        tables |= {"light": ROUGH["light"], "final": dict(ROUGH["final"])}
    return tables


def stands_of(tables: dict[str, Any], fields: int) -> Stands:
    """Returns the stand of each variant of a campaign, with the given number
    of fields."""
    settings = {**MEASURED, "final.randomisations": fields}
    resolved = tomllib.loads(Stand(tables, settings=settings).campaign)
    return [
        (each, Stand(resolved, settings=each.settings))
        for each in make_variants(resolved)
    ]


def main() -> None:
    parser = parser_of_searches(__doc__, fields=192, evaluations=480, seeds=3)
    options = parser.parse_args()
    tables = tables_of(options)
    stands = stands_of(tables, options.fields)
    print_changes(stands)
    print("\nThe hybrid, where plants grow:\n")
    growing = {**BREEDABLE, "name": "growing", **growth()}
    if options.rough:
        growing |= ROUGH
    print_changes(stands_of(growing, options.fields), "height")
    print("\nThe best plants of the searches:\n")
    print_best(stands, best_plants(tables, options.folder))


if __name__ == "__main__":
    guard(main)
