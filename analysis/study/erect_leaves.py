#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares canopy assimilation of erect and flat leaves, by plant density.

erect_leaves.py [--under CAMPAIGN] [--densities N...]

Gives the leaves of crops/maize.toml other insertion angles or bends and prints
the additional CO2 uptake of the canopy (gross, a clear day of CAMPAIGN) at
some densities in rows of 0.762 m, in %, with 95 % intervals of paired
differences. Field experiments for comparison: Wang and others 1995
(doi:10.1007/BF02913002) tied leaves up at silking; Winter and Ohlrogge 1973
(Agronomy Journal 65, 395-397) raised upper leaves from about 45 deg to 10 or
15 deg from the vertical.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from estimates import Estimate, gain, plus_minus, print_table
from shared import (
    CAMPAIGNS,
    MAIZE,
    PLANT_AREA,
    Numbers,
    Settings,
    guard,
    leaves,
    light,
    parser_of,
    stand_of,
    with_trait,
)  # fmt: skip

from ideotype import Stand

ROW = 0.762
DENSITIES = (3.0, 5.0, 7.0, 9.0, 12.0, 16.0)
UPPER = 5
"""The number of leaves above the ear, which is at leaf 6 of 10: leaves 6 to
10."""

Change = dict[str, list[float | None]]
ALL_45: Change = {"insertion_angle": [45.0] * 10}
#: Variants by name: the plant before and after the change.
VARIANTS: dict[str, tuple[Change, Change]] = {
    "all leaves at 15 deg instead of as they are": (
        {},
        {"insertion_angle": [15.0] * 10},
    ),
    "all leaves at 15 deg and straight instead of as they are": (
        {},
        {"insertion_angle": [15.0] * 10, "curvature": [0.0] * 10},
    ),
    "upper 5 leaves at 12 deg instead of 45": (
        {"insertion_angle": [None] * 5 + [45.0] * UPPER},
        {"insertion_angle": [None] * 5 + [12.0] * UPPER},
    ),
    "all leaves at 15 deg instead of 45": (
        ALL_45,
        {"insertion_angle": [15.0] * 10},
    ),
    "all leaves tied up, 10 deg and straight, instead of 45 deg": (
        ALL_45,
        {"insertion_angle": [10.0] * 10, "curvature": [0.0] * 10},
    ),
}


def changed(stand: Stand, change: Change) -> Numbers:
    genome: Numbers = stand.baseline
    own = leaves(stand, genome)
    for trait, values in change.items():
        new = [
            old if value is None else value
            for old, value in zip(own[trait], values, strict=True)
        ]
        genome = with_trait(stand, genome, trait, new)
    return genome


def gains(
    under: Path, density: float, row: float = ROW, settings: Settings = ()
) -> list[Estimate]:
    """Returns the gain of each variant [%] at a density [m-2], in rows at the
    given distance [m]."""
    spacing = (
        f"{{row = {row}, plant = {1 / density / row:.6f}, row_direction = 90}}"
    )
    stand = stand_of(
        MAIZE,
        under,
        [
            f"spacing=[{spacing}]",
            "objective.maximise=gross_assimilation",
            *settings,
        ],
    )
    genomes = [
        changed(stand, change) for pair in VARIANTS.values() for change in pair
    ]
    values = light(stand, np.array(genomes)).tolist()
    return list(map(gain, values[::2], values[1::2]))


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("--under", type=Path, default=CAMPAIGNS / "ames.toml")
    parser.add_argument(
        "--densities", nargs="+", type=float, default=DENSITIES
    )
    options = parser.parse_args()
    columns = [gains(options.under, density) for density in options.densities]
    titles = [
        f"{density:g} m-2, LAI {PLANT_AREA * density:.1f}"
        for density in options.densities
    ]
    rows = [
        [name, *(plus_minus(x, sign="+") for x in each)]
        for name, each in zip(
            VARIANTS, zip(*columns, strict=True), strict=True
        )
    ]
    print_table(["gross assimilation [%]", *titles], rows)


if __name__ == "__main__":
    guard(main)
