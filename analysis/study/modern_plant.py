#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the hybrid of today against measured inclinations and coefficients k.

modern_plant.py [--rough] [--only inclination|extinction]

Prints the inclination of leaf surfaces by thirds of the plant for
crops/maize_hybrid.toml and plants/maize_hybrid_1980s.toml in FIELDS fields,
next to that of 11 plants of Iowa (measured/README.md). Then prints k of a
clear day, around its noon and of the season of bondville.toml, with plants at
exact positions, with those of modern planters and with those of surveys of
1987 to 1996 (fields.py). Both hybrids have the leaf area index of the hybrid
of the 1980s at 7.5 plants m-2; the hybrid of today also stands at 7.5 plants
m-2. ± is half of a 95 % interval, over fields or over the 11 plants. Nothing
here is fitted. --rough is for tests.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from estimates import Estimate, estimate, plus_minus, print_table
from fields import AREAS, SEASON, Field, measure_all
from plant_shapes import IOWA, THIRDS, field_of, measured, shape_of
from scipy.stats import t
from shared import (
    FIELD_PLANTS,
    HYBRID,
    HYBRID_1980S,
    ROUGH,
    guard,
    parser_of,
    run_parts,
)  # fmt: skip

ROW, DENSITY, FIELDS = 0.762, 7.5, 8
FORMER = "hybrid of the 1980s"
CROPS = {FORMER: HYBRID_1980S, "hybrid": HYBRID}
#: The standard deviation of positions along the row [m], for the variations of
#: fields.py.
POSITIONS = {
    "exact positions": "0",
    "field": "0.035",
    "positions of surveys": "0.075",
}


def wide(values: list[float]) -> Estimate:
    """Returns the mean of a few values. Its standard error is scaled so that
    the normal 95 % interval equals Student's interval."""
    mean, error = estimate(values)
    return mean, error * float(t.ppf(0.975, len(values) - 1)) / 1.96


def inclination(options: argparse.Namespace) -> None:
    rows = []
    with TemporaryDirectory() as folder:
        for name, crop in CROPS.items():
            drawn = [
                shape_of(
                    field_of(
                        f"{name} {seed}",
                        crop,
                        FIELD_PLANTS,
                        Path(folder),
                        (4, 4) if options.rough else (10, 10),
                        seed=seed,
                    )
                ).inclination
                for seed in range(2 if options.rough else FIELDS)
            ]
            rows.append((name, np.array(drawn)))
    rows.append((IOWA, measured()[1]["inclination"]))
    print_table(
        ["inclination of leaf surfaces [deg]", "all", *THIRDS],
        [
            [
                name,
                *(plus_minus(wide(x[~np.isnan(x)].tolist())) for x in each.T),
            ]
            for name, each in rows
        ],
    )


def extinction(options: argparse.Namespace) -> None:
    randomisations = 64
    accuracy = [f"final.randomisations={randomisations}"]
    if options.rough:
        accuracy = [f"final.{key}={x}" for key, x in ROUGH["final"].items()]
    alike = DENSITY * AREAS[FORMER] / AREAS["hybrid"]
    stands = {
        f"{FORMER}, {DENSITY:g} plants m-2": Field(ROW, DENSITY, FORMER),
        f"hybrid, {alike:.2g} plants m-2": Field(ROW, alike),
        f"hybrid, {DENSITY:g} plants m-2": Field(ROW, DENSITY),
    }
    lights = {
        "day": lambda field: field,
        "noon": lambda field: replace(field, hours="noon"),
        "season": lambda field: replace(field, campaign=SEASON),
    }
    fields = {
        (stand, position, light): change(replace(field, variation=position))
        for stand, field in stands.items()
        for position in POSITIONS
        for light, change in lights.items()
    }
    found = measure_all(fields.values(), accuracy)
    rows = []
    for stand in stands:
        for position, deviation in POSITIONS.items():
            each = [found[fields[stand, position, light]] for light in lights]
            cells = [plus_minus(x["k"], 3) for x in each]
            rows.append([stand, deviation, f"{each[0]['lai'][0]:.2f}", *cells])
    print_table(
        [
            "",
            "positions, standard deviation [m]",
            "leaf area index",
            *(f"k, {light}" for light in lights),
        ],
        rows,
    )


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("--rough", action="store_true")
    run_parts(parser, {"inclination": inclination, "extinction": extinction})


if __name__ == "__main__":
    guard(main)
