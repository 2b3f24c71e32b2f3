#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares searches over numbers, integers and choices with enumeration.

mixed.py FOLDER [--evaluations N] [--seeds N] [--rough]

The plant (its height), its density (an integer), the row distance (one of three)
and the row pattern (equal or twin rows) are searched for the margin of an
irrigated hybrid in a made year at Ames (campaigns/maize_belt.toml; example
prices). All combinations are evaluated too, with five heights, and the best of
them again with independent random numbers. Prints the plants and managements
that searches find, the evaluations that they need, and their margins with the
random numbers of the enumeration."""

from __future__ import annotations

import argparse
import tomllib
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from estimates import plus_minus, print_table
from shared import (
    CAMPAIGNS,
    HYBRID,
    ROUGH,
    breed_tables,
    campaign_of,
    guard,
    parser_of_searches,
)

import ideotype
from ideotype import Stand

DENSITIES = tuple(range(4, 13))
ROWS = (0.38, 0.57, 0.762)
PATTERNS: tuple[tuple[float, ...], ...] = ((), (1, 3))
HEIGHTS = (0.7, 0.85, 1.0, 1.15, 1.3)
FINALISTS = 12
"""The number of combinations that are evaluated again."""


class Option(NamedTuple):
    """A plant and its management."""

    row: float
    density: float
    pattern: tuple[float, ...]
    height: float

    def __str__(self) -> str:
        rows = "twin rows" if self.pattern else "equal rows"
        return (
            f"{self.row:g} m, {rows}, {self.density:g} m-2, height "
            f"{self.height:.2f}"
        )


def campaign(options: argparse.Namespace, **tables: Any) -> dict[str, Any]:
    """Returns the campaign of one site and one year."""
    found = campaign_of("maize_belt")
    (site,) = [x for x in found["site"] if x["name"] == "ames"]
    site["weather"] = str(CAMPAIGNS / site["weather"])
    (year,) = found["climate"]
    del year["weights"], year["years"], found["search"]
    rough = dict(ROUGH) if options.rough else {}
    return {
        **found,
        "site": [site],
        "objective": {"maximise": "margin"},
        "plant": {
            "baseline": str(HYBRID),
            "bounds": {"height": [HEIGHTS[0], HEIGHTS[-1]]},
        },
        "traits": [{"name": "height", "free": ["height"]}],
        "spacing": [{"row": ROWS[-1], "density": 8.0}],
        "light": {"tolerance": 0.01, "fields": 4},
        **rough,
        **tables,
    }


def evaluate(
    options: argparse.Namespace,
    chosen: list[Option],
    seed: int,
    final: bool = False,
) -> list[tuple[float, float]]:
    """Returns the margin of each option with its standard error, with common
    random numbers."""
    found: dict[Option, tuple[float, float]] = {}
    for row, density, pattern in dict.fromkeys(x[:3] for x in chosen):
        of_field = [x for x in chosen if x[:3] == (row, density, pattern)]
        tables = campaign(options, spacing=[{"row": row, "density": density}])
        tables["field"] = {**tables["field"], "row_pattern": list(pattern)}
        stand = Stand(tables)
        heights = [[x.height] for x in of_field]
        values = stand.evaluate(heights, ["margin"], seed=seed, final=final)
        for option, mean, error in zip(
            of_field, values.margin.values, values.margin_standard_error.values
        ):
            found[option] = float(mean), float(error)
    return [found[x] for x in chosen]


def found_by(history: Path) -> tuple[Option, int]:
    """Returns the option that a search found, and its evaluations."""
    with ideotype.open_history(history) as opened:
        best, genes = opened.best(), opened.genes
        count = len(opened.evaluations().done)
    assert best is not None
    genome = best.row.genome[0]
    texts = [genes.text(i, x, ".17g") for i, x in enumerate(genome)]
    row, density, pattern = (
        tomllib.loads(f"value = {x}")["value"] for x in texts[-3:]
    )
    (height,) = genome[genes.columns("height")]
    return Option(row, density, tuple(pattern), float(height)), count


def main() -> None:
    parser = parser_of_searches(__doc__, seeds=5, evaluations=480)
    options = parser.parse_args()
    densities = DENSITIES[::4] if options.rough else DENSITIES
    every = [Option(*x) for x in product(ROWS, densities, PATTERNS, HEIGHTS)]
    margins = np.array(evaluate(options, every, 1))[:, 0]
    order = margins.argsort()[::-1][:FINALISTS]
    tables = campaign(options, name="mixed", replicates=options.seeds)
    tables["stop"] = {"evaluations": options.evaluations}
    tables["search"] = {
        "keys": [
            {"key": "spacing.row", "values": list(ROWS)},
            {
                "key": "spacing.density",
                "values": [float(x) for x in DENSITIES],
            },
            {
                "key": "field.row_pattern",
                "values": [list(x) for x in PATTERNS],
            },
        ],
    }
    searched = [found_by(x) for x in breed_tables(tables, options.folder)]
    finalists = [every[i] for i in order]
    again = evaluate(
        options, finalists + [x for x, _ in searched], 2, final=True
    )
    rows = [
        [f"enumeration, {rank}", f"{len(every)}", str(x), plus_minus(value, 0)]
        for rank, (x, value) in enumerate(zip(finalists, again), 1)
    ]
    rows += [
        [f"search {i}", f"{count}", str(x), plus_minus(value, 0)]
        for i, ((x, count), value) in enumerate(
            zip(searched, again[len(finalists) :]), 1
        )
    ]
    print_table(
        ["found by", "evaluations", "option", "margin per ha, re-evaluated"],
        rows,
    )


if __name__ == "__main__":
    guard(main)
