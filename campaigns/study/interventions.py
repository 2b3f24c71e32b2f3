#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Changes one trait of a plant at a time, with and without its other organs.

interventions.py FOLDER [--fields N] [--generations N] [--seeds N] [--rough]

Gives each trait that quickstart.toml breeds other values, half way to its
bounds and at them, while all other traits stay those of the baseline. Prints
the change of the season's carbon and of the PAR that leaves absorb, with
stalk, sheaths, peduncle, tassel and ear and with leaves alone
(`plant.organs = []`), and the light that other organs and dead leaves take;
then the same of height in the hybrid that grows in 2011 at Bondville. Breeds
quickstart.toml in FOLDER and prints the gains of the best plants of its
searches in the same four ways: with and without other organs, with their own
height and with that of the baseline. All plants stand in the same N fields
with the same random numbers. ± is half of a 95 % interval.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd
from climates import growth
from estimates import Estimate, gain, interval_of, print_table, told
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

STEPS = (-1.0, -0.5, 0.5, 1.0)
"""The parts of the way from the baseline to the lower (-) or upper bound."""
LEAVES_ALONE = "leaves alone"
WAYS: dict[str, dict[str, Any]] = {
    "all organs": {},
    LEAVES_ALONE: {"plant.organs": []},
}
#: Two objectives, so that both are known in each randomisation.
MEASURED = {
    "objective.maximise": ["carbon_balance", "absorbed_par"],
    "search.optimizer": "nsga2",
}


@dataclass(frozen=True)
class Evaluated:
    """Plants in the same fields."""

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


def gains(values: Numbers) -> list[Estimate]:
    """Returns the gains of all plants over the first one [%]."""
    first, *others = values.tolist()
    return [gain(first, other) for other in others]


def named(trait: str, unit: str, value: float) -> str:
    name = trait.removesuffix("_profile").replace("_", " ")
    if unit == "1":
        return f"{name} x {value:g}"
    return f"{name} {value:+g} {unit}"


def changes(stand: Stand, only: str = "") -> Iterator[tuple[str, Numbers]]:
    """Yields plants that differ from the baseline in one bred trait, any or
    `only` this one. A trait of single leaves has opposite changes in
    successive leaves: equal ones would only turn the plant."""
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


def print_changes(stands: dict[str, Stand], only: str = "") -> None:
    """Prints the effect of each trait alone, or of `only` this one."""
    names, plants = zip(*changes(stands[LEAVES_ALONE], only), strict=True)
    found = {}
    for way, stand in stands.items():
        say(f"traits, {way}")
        found[way] = evaluate(stand, [stand.baseline, *plants])
    columns = [
        [told(x, 2, "+") for x in gains(values)]
        for each in (
            [x.carbon for x in found.values()],
            [x.par for x in found.values()],
        )
        for values in each
    ]
    light = [f"{x:.2f}" for x in next(iter(found.values())).others]
    titles = [
        f"{quantity}, {way} [%]"
        for quantity in ("season's carbon", "PAR of leaves")
        for way in found
    ]
    titles += ["light of other organs and dead leaves [% of incident]"]
    rows = zip(names, *columns, light[1:], strict=True)
    print_table(
        ["the baseline with", *titles],
        [["no change", *[""] * len(columns), light[0]], *rows],
    )


def with_own_height(stand: Stand, plant: Numbers) -> Numbers:
    """Returns the plant with the height of the baseline."""
    is_height = (stand.genes.trait == "height").to_numpy()
    return np.where(is_height, stand.baseline, plant)


def print_best(stands: dict[str, Stand], plants: Sequence[Numbers]) -> None:
    """Prints the gains of bred plants with and without other organs."""
    columns = {}
    for way, stand in stands.items():
        say(f"bred plants, {way}")
        equally_high = [with_own_height(stand, plant) for plant in plants]
        found = evaluate(stand, [stand.baseline, *plants, *equally_high])
        both = gains(found.carbon)
        columns[way] = both[: len(plants)]
        columns[f"{way}, height of the baseline"] = both[len(plants) :]
    genes = stands[LEAVES_ALONE].genes
    heights = [plant[genes.trait == "height"][0] for plant in plants]
    rows = [
        [str(seed), f"x {height:.2f}", *(told(x, 1, "+") for x in row)]
        for seed, (height, row) in enumerate(
            zip(heights, zip(*columns.values(), strict=True), strict=True), 1
        )
    ]
    print_table(["seed", "height", *(f"{x} [%]" for x in columns)], rows)
    print("\nMeans over the searches:")
    for name, values in columns.items():
        print(f"{name}: {interval_of(values)}")


def tables_of(options: argparse.Namespace) -> dict[str, Any]:
    """Returns the quickstart, with as many fields and searches as asked for."""
    tables = campaign_of("quickstart", replicates=options.seeds)
    tables["stop"]["generations"] = options.generations
    if options.rough:
        tables |= {"light": ROUGH["light"], "final": dict(ROUGH["final"])}
    return tables


def stands_of(tables: dict[str, Any], fields: int) -> dict[str, Stand]:
    """Returns the stand of a campaign with all organs and with leaves alone,
    in which plants are evaluated in so many fields."""
    return {
        way: Stand(
            tables,
            settings={**MEASURED, "final.randomisations": fields, **settings},
        )
        for way, settings in WAYS.items()
    }


def main() -> None:
    parser = parser_of_searches(__doc__, fields=192, generations=20, seeds=3)
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
