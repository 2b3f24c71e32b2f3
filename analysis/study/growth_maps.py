#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares optimised plants with growth and without, and seasons with fields.

growth_maps.py FOLDER [--only PART] [--densities N...] [--evaluations N] [--seeds N]
               [--figure FILE.png] [--rough]

tops     The hybrid optimised twice for each plant density, with growth and without (the same days
         with plants as they stand at silking): with insertion angles of the four highest leaves
         below 25 deg, and above 45 deg, both with at most the leaf area of the hybrid at silking,
         in fields without gaps. Prints the additional carbon of the season by the erect top, and
         the leaf area index at silking at which it gains nothing.
best     The hybrid optimised for the carbon of the season with growth and without. Each plant is
         evaluated in both ways, with common random numbers.
season   Dry matter by organ in the measured seasons, of a hybrid of their time and of today's,
         and the effect of single parts of the carbon budget; ± is from evaluations with different
         random numbers. `ideotype validate` compares it by date.

The weather is that of Bondville in 2011. Finished searches in FOLDER are not repeated. ± is half
of a 95 % interval: of randomisations, or of seeds where those differ more. --figure draws `tops`.
--rough is for tests. IDEOTYPE_EXECUTABLE names the program; without it, the one on PATH is used.
"""

from __future__ import annotations

from argparse import Namespace as Options
from itertools import pairwise
from pathlib import Path
from statistics import fmean
from typing import Any

import numpy as np
from climates import PRECISE_FINAL, PRECISE_LIGHT
from erect_tops import ANGLES, ROW, TOP_LEAVES, bred_pairs
from estimates import (
    Estimate,
    gain,
    half_interval,
    interval_of,
    mean_over_seeds,
    plus_minus,
    print_table,
    sign_change,
)
from growing import of_full_canopy, tables
from measured_seasons import compare_dry_matter, compare_parts
from shared import (
    FIELD_PLANTS,
    HYBRID,
    HYBRID_1980S,
    ROUGH,
    SEVERAL_FIELDS,
    Numbers,
    best,
    breed_tables,
    breedable_but,
    gain_in,
    guard,
    light,
    parser_of_searches,
    run_parts,
    say,
)  # fmt: skip

from ideotype import Stand
from ideotype.figures.style import new_figure

DENSITIES = (3.0, 5.0, 8.0)
WAYS = ("growth", "full canopy")


def campaigns(options: Options, density: float) -> dict[str, dict[str, Any]]:
    """Returns the tables of a season with and without growth."""
    growing = tables(**PRECISE_LIGHT) | {
        "spacing": [{"row": ROW, "density": density}],
        "field": {"rows": 2, "plants": 2, "variation": FIELD_PLANTS},
        "plant": {"baseline": str(HYBRID), "bounds": "breedable"},
        "stop": {"evaluations": options.evaluations},
        "final": {"candidates": 1, **PRECISE_FINAL},
    }
    if options.rough:
        growing |= {**ROUGH, "light": {**ROUGH["light"], "stages": 4}}
    return dict(zip(WAYS, (growing, of_full_canopy(growing)), strict=True))


def comparing_stand(campaign: dict[str, Any]) -> Stand:
    """Returns a stand that compares the optimised plants of a campaign in
    several fields. A search has only one field, so that its result is adapted
    to the few plants of this field."""
    several = {**campaign["light"], **SEVERAL_FIELDS}
    return Stand({**campaign, "light": several})


def bred(
    campaign: dict[str, Any], name: str, seed: int, options: Options
) -> Numbers:
    """Returns the genome of the best plant of a search."""
    named = {**campaign, "name": f"{name}_s{seed}", "seed": seed}
    say(named["name"])
    return best(breed_tables(named, options.folder)[0])


def of_a_top(
    way: str, density: float, options: Options
) -> tuple[float, list[Estimate]]:
    """Returns the leaf area index at silking, and for each seed the gain of an
    erect over a flat top [%]."""
    # Missing plants would make the leaf area per plant differ from that of the
    # field.
    no_gaps = {"variation": {**FIELD_PLANTS, "missing": 0}}
    both = {
        name: {
            **tables,
            **breedable_but(HYBRID, insertion_angle_profile=ANGLES),
            "field": {**tables["field"], **no_gaps},
            "final": {**tables["final"], "candidates": 5},
        }
        for name, tables in campaigns(options, density).items()
    }
    alike = Stand({**both[WAYS[1]], "field": {"rows": 2, "plants": 2}})
    limit = float(alike.evaluate(alike.baseline, ["lai"]).lai[0])
    stand = comparing_stand(both[way])
    quantity = "lai_by_stage" if way == WAYS[0] else "lai"
    shaped = {
        **both[way],
        "name": f"tops_{density:g}_{way.split()[0]}".replace(".", "p"),
        "constraints": {"lai": [0.0, round(limit, 4)]},
    }
    say(shaped["name"])
    pairs = bred_pairs(
        shaped, options.folder, options.evaluations, options.seeds
    )
    areas = [
        float(stand.evaluate(plant, [quantity])[quantity].max())
        for pair in pairs
        for plant in pair
    ]
    return fmean(areas), [gain_in(stand, *pair) for pair in pairs]


def tops(options: Options) -> None:
    found: dict[str, list[tuple[float, Estimate]]] = {x: [] for x in WAYS}
    rows = []
    for density in options.densities:
        row = [f"{density:g}"]
        for way in WAYS:
            area, gains = of_a_top(way, density, options)
            found[way].append((area, mean_over_seeds(gains)))
            row += [f"{area:.2f}", interval_of(gains)]
        rows.append(row)
    titles = [
        f"{what} {way}"
        for way in WAYS
        for what in ("leaf area index,", "gain,")
    ]
    print_table(["plants m-2", *titles], rows)
    print()
    for way, points in found.items():
        crossings = [
            sign_change(*two)
            for two in pairwise(points)
            if two[0][1][0] < 0 <= two[1][1][0]
        ]
        for area, error in crossings:
            print(
                f"With {way} an erect top pays from a leaf area index of "
                f"{plus_minus((area, error), 2)} (95 %) on."
            )
        if not crossings:
            print(f"With {way} the gain does not change its sign here.")
    if options.figure:
        draw(found, options.figure)


def draw(found: dict[str, list[tuple[float, Estimate]]], path: Path) -> None:
    figure = new_figure(5, 3.4)
    axes = figure.subplots()
    for way, points in found.items():
        axes.errorbar(
            [area for area, _ in points],
            [mean for _, (mean, _) in points],
            [half_interval(error) for _, (_, error) in points],
            marker="o",
            capsize=3,
            label=way,
        )
    axes.axhline(0, color="0.6", lw=0.8)
    axes.set(
        xlabel="leaf area index at silking",
        ylabel="bred: erect over flat top [%]",
    )
    axes.legend()
    figure.savefig(path, dpi=150)


def shape(stand: Stand, genome: Numbers) -> list[str]:
    """Formats the leaf area, from lengths times widths [m2], and the angles of
    the four highest and of the other leaves [deg]."""
    each = stand.leaves(genome)
    cells = [f"{(each.length * each.width).sum():.3f}"]
    for trait in ("insertion_angle", "curvature"):
        values = each[trait].to_numpy()
        for part in (values[-TOP_LEAVES:], values[:-TOP_LEAVES]):
            cells += [f"{part.mean():.0f}"]
    return cells


def best_plants(options: Options) -> None:
    """Optimises with and without growth, and evaluates each plant under both
    conditions."""
    both = campaigns(options, 7.5)
    stands = {way: comparing_stand(x) for way, x in both.items()}
    plants = {
        way: [
            bred(both[way], f"best_{way.split()[0]}", seed, options)
            for seed in range(1, options.seeds + 1)
        ]
        for way in WAYS
    }
    first = stands[WAYS[0]]
    titles = ["plant", "length x width [m2]", "angle, top", "angle, others"]
    titles += ["bend, top", "bend, others"]
    rows = [["the hybrid", *shape(first, first.baseline)]]
    for way, genomes in plants.items():
        for seed, genome in enumerate(genomes, 1):
            rows.append(
                [f"bred with {way}, seed {seed}", *shape(first, genome)]
            )
    print_table(titles, rows)
    print()
    rows = []
    for way, stand in stands.items():
        own, other = (plants[x] for x in (way, *(x for x in WAYS if x != way)))
        found = light(stand, np.array([stand.baseline, *own, *other])).tolist()
        at = len(own) + 1
        pairs = list(zip(found[1:at], found[at:], strict=True))
        gains = [
            mean_over_seeds([gain(found[0], x) for x in values])
            for values in (found[1:at], found[at:])
        ]
        apart = [gain(theirs, ours) for ours, theirs in pairs]
        rows.append(
            [
                way,
                *(plus_minus(x, sign="+") for x in gains),
                interval_of(apart),
            ]
        )
    titles = ["evaluated with", "bred so: over the baseline [%]"]
    titles += ["bred otherwise [%]", "the first over the second"]
    print_table(titles, rows)


def seasons(options: Options) -> None:
    """Compares a hybrid of the period with measured seasons."""
    plants = {
        name: {
            **tables(paths=256 if options.rough else 4096),
            "plant": {"baseline": str(path)},
            "field": {"rows": 2, "plants": 2, "variation": FIELD_PLANTS},
        }
        for name, path in {
            "hybrid of the 1980s": HYBRID_1980S,
            "hybrid of today": HYBRID,
        }.items()
    }
    seeds = 2 if options.rough else 6
    print()
    compare_dry_matter(plants, seeds, options.folder)
    compare_parts(plants["hybrid of the 1980s"], seeds, options.folder)


PARTS = {"tops": tops, "best": best_plants, "season": seasons}


def main() -> None:
    parser = parser_of_searches(
        __doc__, has_figure=True, evaluations=300, seeds=2
    )
    parser.add_argument(
        "--densities", nargs="+", type=float, default=DENSITIES
    )
    run_parts(parser, PARTS)


if __name__ == "__main__":
    guard(main)
