#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares optimising few numbers of the whole plant with some for each leaf.

parametrisation.py FOLDER [--evaluations N] [--seeds N] [--condition NAME...]
                   [--way NAME...] [--rough]

Optimises crops/maize.toml for net assimilation of a clear day as
paper_table.py does, by auto, under within-line variation. Lengths, widths and
insertion angles are free for each leaf, as smooth profiles, or as three
numbers that all leaves share (two factors, and degrees that are added), always
with the azimuth of each leaf. Two further ways spend half of the evaluations
on profiles or factors and the other half on free leaves around the best plant
of the first half. Re-evaluates the best plants with common random numbers and
prints gains over the baseline [%] by seed, and half of the widest 95 %
interval of one. Factors and profiles have the ranges of the profiles of
crops/maize.toml, 0.65 to 1.35 and -10 to 50 deg.
"""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w
from conditions import CONDITIONS, Condition, campaign
from estimates import Estimate, half_interval, print_table
from shared import (
    MAIZE,
    Numbers,
    best,
    breed_tables,
    gains_over_baseline,
    guard,
    parser_of_searches,
    say,
)  # fmt: skip

from ideotype import Stand

#: Traits of the whole plant. Their ranges are those of the profiles of
#: crops/maize.toml.
FACTORS: list[dict[str, Any]] = [
    {
        "name": "all_lengths",
        "per": "plant",
        "scales": ["leaf.length"],
        "unit": "1",
        "range": [0.65, 1.35],
        "bred": False,
    },
    {
        "name": "all_widths",
        "per": "plant",
        "scales": ["leaf.width"],
        "unit": "1",
        "range": [0.65, 1.35],
        "bred": False,
    },
    {
        "name": "all_insertion_angles",
        "per": "plant",
        "shifts": ["leaf.insertion_angle"],
        "unit": "deg",
        "range": [-10, 50],
        "bred": False,
    },
]
FREE = {
    "leaves": ["length", "width", "insertion_angle"],
    "profiles": ["length_profile", "width_profile", "insertion_angle_profile"],
    "factors": [each["name"] for each in FACTORS],
}
WAYS = {
    "leaves": "free leaves",
    "profiles": "profiles",
    "factors": "factors",
    "factors-leaves": "factors, then free leaves",
    "profiles-leaves": "profiles, then free leaves",
}
SIZES = ("length", "width", "insertion_angle", "azimuth")


def crop_with_factors(folder: Path) -> Path:
    crop = tomllib.loads(MAIZE.read_text(encoding="utf-8"))
    crop["trait"] += FACTORS
    path = folder / "maize.toml"
    path.write_text(tomli_w.dumps(crop), encoding="utf-8")
    return path


def plant_of(stand: Stand, genome: Numbers, folder: Path, name: str) -> Path:
    """Writes a crop file of a plant with leaves computed from factors and
    profiles, and returns its path."""
    path = folder / f"{name}.plant.toml"
    path.write_text(stand.crop_file(genome), encoding="utf-8")
    return path


def as_free_leaves(stand: Stand, plant: Path) -> Numbers:
    """Returns the genome of the plant in a file, for a campaign with this
    plant as its baseline."""
    values = tomllib.loads(plant.read_text(encoding="utf-8"))["leaf"]
    genome = np.array(stand.baseline)
    genes = stand.genes
    for index, (trait, leaf) in enumerate(
        zip(genes.trait, genes.leaf, strict=True)
    ):
        if trait in SIZES:
            genome[index] = np.clip(
                values[leaf - 1][trait],
                genes.lower.iloc[index],
                genes.upper.iloc[index],
            )
    return genome


def found(
    tables: dict[str, Any], way: str, seed: int, count: int, folder: Path
) -> Numbers:
    """Returns the genome of the best plant of the last stage. Free leaves
    start from the best plant of the preceding stage, within their own
    bounds."""
    stages = way.split("-")
    start: list[float] = []
    for number, stage in enumerate(stages):
        name = f"{tables['name']}_{way}{number}_s{seed}"
        evaluations = count // len(stages)
        run: dict[str, Any] = {
            **tables,
            "name": name,
            "seed": seed,
            "traits": [{"name": stage, "free": [*FREE[stage], "azimuth"]}],
            "search": {
                "optimizer": "auto",
                **({"start": start} if start else {}),
            },
            "stop": {
                "generations": evaluations // 10 + 1,
                "evaluations": evaluations,
            },
        }
        history = breed_tables(run, folder)[0]
        stand = Stand(run)
        genome = best(history)
        if number + 1 < len(stages):
            plant = plant_of(stand, genome, folder, name)
            start = as_free_leaves(stand, plant).tolist()
    return genome


def gains_of(
    where: Condition,
    ways: list[str],
    count: int,
    seeds: int,
    folder: Path,
    is_rough: bool,
) -> tuple[dict[str, list[Estimate]], float]:
    tables = campaign(
        where, "net_assimilation", folder, is_rough, crop_with_factors(folder)
    )
    keys = [(way, seed) for way in ways for seed in range(1, seeds + 1)]
    plants = []
    for way, seed in keys:
        say(f"{where.title}: {way}, seed {seed}")
        plants.append(found(tables, way, seed, count, folder))
    stand = Stand(tables)
    gains: dict[str, list[Estimate]] = {way: [] for way in ways}
    every = gains_over_baseline(stand, plants)
    for (way, _), each in zip(keys, every, strict=True):
        gains[way].append(each)
    return gains, max(error for each in gains.values() for _, error in each)


def main() -> None:
    parser = parser_of_searches(__doc__, evaluations=800, seeds=2)
    names = [x.name for x in CONDITIONS]
    parser.add_argument(
        "--condition", nargs="+", choices=names, default=["all", "15x3"]
    )
    parser.add_argument("--way", nargs="+", choices=WAYS, default=list(WAYS))
    options = parser.parse_args()
    rows = []
    for where in CONDITIONS:
        if where.name not in options.condition:
            continue
        gains, error = gains_of(
            where,
            options.way,
            options.evaluations,
            options.seeds,
            options.folder,
            options.rough,
        )
        cells = (
            ", ".join(f"{x:.1f}" for x, _ in each) for each in gains.values()
        )
        rows.append([where.title, *cells, f"{half_interval(error):.1f}"])
    print_table(
        ["gain [%]", *(WAYS[way] for way in options.way), "largest ±"],
        rows,
    )


if __name__ == "__main__":
    guard(main)
