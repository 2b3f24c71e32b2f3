#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What erect leaves do to canopy assimilation, by plant density.

erect_leaves.py [--under CAMPAIGN] [--densities N...]

Gives the leaves of crops/maize.toml other insertion angles or bends and prints how
much more CO2 the canopy assimilates (gross, a clear day of CAMPAIGN) at some
densities in rows of 0.762 m, in %, with standard errors of paired differences. Field
experiments beside it: Wang and others 1995 (doi:10.1007/BF02913002) tied leaves up at
silking; Winter and Ohlrogge 1973 (Agronomy Journal 65, 395-397) raised upper leaves
from about 45 deg to 10 or 15 deg from the vertical.
IDEOTYPE_EXECUTABLE names the program, else it is that on PATH.
"""

from __future__ import annotations

import argparse
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import fmean, stdev

from what_pays import ideotype, leaves, with_values

HERE = Path(__file__).parent
ROW = 0.762
DENSITIES = (3.0, 5.0, 7.0, 9.0, 12.0, 16.0)
UPPER = 5
"""Leaves above the ear, which is at leaf 6 of 10: 6 to 10."""

Change = dict[str, list[float | None]]
ALL_45: Change = {"insertion_angle": [45.0] * 10}
#: name: the plant that is changed, and what it becomes
VARIANTS: dict[str, tuple[Change, Change]] = {
    "all leaves at 15 deg instead of their own": (
        {},
        {"insertion_angle": [15.0] * 10},
    ),
    "all leaves at 15 deg and straight instead of their own": (
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


def changed(text: str, own: list[dict[str, float]], change: Change) -> str:
    for trait, values in change.items():
        text = with_values(
            text,
            trait,
            [
                leaf[trait] if value is None else value
                for leaf, value in zip(own, values, strict=True)
            ],
        )
    return text


def gains(under: Path, density: float) -> list[tuple[float, float]]:
    """Of each variant, with its standard error [%]."""
    baseline = HERE / "crops" / "maize.toml"
    own, text = leaves(baseline), baseline.read_text()
    with tempfile.TemporaryDirectory() as folder:
        plants = []
        for i, pair in enumerate(VARIANTS.values()):
            for name, change in zip(("before", "after"), pair, strict=True):
                plants.append(Path(folder) / f"{name}{i}.toml")
                plants[-1].write_text(changed(text, own, change))
        spacing = f"[{{row = {ROW}, plant = {1 / density / ROW:.6f}, row_direction = 90}}]"
        found = json.loads(
            ideotype(
                "evaluate", *plants, "--under", under, "--json",
                "--set", f"spacing={spacing}",
                "--set", "objective.maximise=gross_assimilation",
            )
        )  # fmt: skip
    values = [case[0] for case in found["by_randomisation"]]
    return [
        gain(before, after)
        for before, after in zip(values[::2], values[1::2], strict=True)
    ]


def leaf_area() -> float:
    """Of the baseline [m2 per plant]."""
    report = json.loads(ideotype("evaluate", HERE / "ames.toml", "--json"))
    return float(report["lai"]) * ROW * 0.1524


def gain(before: list[float], after: list[float]) -> tuple[float, float]:
    differences = [b - a for a, b in zip(before, after, strict=True)]
    scale = 100 / fmean(before)
    error = stdev(differences) / math.sqrt(len(differences))
    return scale * fmean(differences), scale * error


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--under", type=Path, default=HERE / "ames.toml")
    parser.add_argument(
        "--densities", nargs="+", type=float, default=DENSITIES
    )
    options = parser.parse_args()
    rows = [gains(options.under, density) for density in options.densities]
    area = leaf_area()
    titles = " | ".join(
        f"{density:g} m-2, LAI {area * density:.1f}"
        for density in options.densities
    )
    print(f"| gross assimilation [%] | {titles} |")
    print("|---|" + "---|" * len(options.densities))
    for name, each in zip(VARIANTS, zip(*rows, strict=True), strict=True):
        cells = " | ".join(
            f"{mean:+.1f} ± {error:.1f}" for mean, error in each
        )
        print(f"| {name} | {cells} |")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(error.stderr.strip())
