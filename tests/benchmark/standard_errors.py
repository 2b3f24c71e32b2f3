#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the standard errors that evaluations report with the errors that
they make: the baseline is evaluated with many seeds in fields without turns,
in sparse stands, with leaves that are nearly white, over a season, and as it
grows and transpires, in one or four variable stands.

Prints for each set-up and quantity the spread over seeds, the root mean square
of the reported errors and its ratio to the spread, the median, smallest and
largest reported error, and the part of seeds whose error exceeds what a t
distribution with one degree of freedom less than there are randomisations or
fields exceeds with a probability of 5, 1 and 0.1 %. With one field of plants
that differ, the spread contains how fields differ and the reported errors do
not.
"""

from __future__ import annotations

import argparse
import tomllib
from pathlib import Path

import numpy as np
from scipy.stats import t as student

import ideotype

CAMPAIGNS = Path(__file__).resolve().parents[2] / "campaigns"
RANDOMISATIONS = 16
LIGHT = ("absorbed_par",)
CARBON = ("absorbed_par", "net_assimilation", "carbon_balance")
WATER = ("transpiration", "water_use_efficiency", "sensible_heat")
WHITE = ["optics.leaf_reflectance=0.499", "optics.leaf_transmittance=0.499"]


def apart(row: float, plant: float) -> list[str]:
    where = f'name = "apart", row = {row}, plant = {plant}'
    return [f"spacing=[{{{where}, row_direction = 90}}]"]


def growing(fields: int) -> list[str]:
    return ["objective.over=[]", "water={}", f"light.fields={fields}"]


ALIKE = ["field.jitter=0"]
CARBON_BALANCE = 'objective.maximise="carbon_balance"'
# The set-ups by name: campaign, settings, tolerance and quantities.
SETUPS = {
    "30 x 6 inches": ("ames_quick", ALIKE, 0.01, LIGHT),
    "2 x 2 m": ("ames_quick", [*ALIKE, *apart(2, 2)], 0.01, LIGHT),
    "4 x 4 m": ("ames_quick", [*ALIKE, *apart(4, 4)], 0.01, LIGHT),
    "10 x 10 m": ("ames_quick", [*ALIKE, *apart(10, 10)], 0.01, LIGHT),
    "R + T = 0.998": ("ames_quick", [*ALIKE, *WHITE], 0.01, LIGHT),
    "day": ("ames_quick", [*ALIKE, CARBON_BALANCE], 0.008, CARBON),
    "season": ("bondville", [*ALIKE, CARBON_BALANCE], 0.008, CARBON),
    "water": ("growing_season", growing(1), None, (*CARBON, *WATER)),
    "water in 4 fields": (
        "growing_season",
        growing(4),
        None,
        (*CARBON, *WATER),
    ),
}


def table_of(name: str, seeds: int) -> list[str]:
    campaign, settings, tolerance, quantities = SETUPS[name]
    stand = ideotype.Stand.from_campaign(
        CAMPAIGNS / f"{campaign}.toml", settings=settings
    )
    reports = [
        stand.evaluate(stand.baseline, tolerance=tolerance, seed=seed)
        for seed in range(1, seeds + 1)
    ]
    fields = tomllib.loads(stand.campaign)["light"].get("fields", 1)
    repetitions = fields if fields > 1 else RANDOMISATIONS
    capped = np.mean([float(each["capped"][0]) for each in reports])
    lines = []
    for quantity in quantities:
        x = np.array([float(each[quantity][0]) for each in reports])
        error = f"{quantity}_standard_error"
        reported = np.array([float(each[error][0]) for each in reports])
        spread, mean, scale = x.std(ddof=1), x.mean(), abs(x.mean())
        rms = np.sqrt(np.mean(reported**2))
        deviation = np.abs(x - mean) / reported
        beyond = " ".join(
            f"{np.mean(deviation > student.isf(p / 2, repetitions - 1)):.3f}"
            for p in (0.05, 0.01, 0.001)
        )
        lines.append(
            f"| {name} | {quantity} | {100 * spread / scale:.2f} "
            f"| {100 * rms / scale:.2f} | {rms / spread:.2f} "
            f"± {1.96 * np.sqrt(0.5 / seeds) * rms / spread:.2f} "
            f"| {100 * np.median(reported) / scale:.2f} "
            f"| {100 * reported.min() / scale:.2f} "
            f"| {100 * reported.max() / scale:.2f} | {beyond} | {capped:.2f} |"
        )
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=200)
    parser.add_argument("setups", nargs="*", choices=[*SETUPS, []])
    options = parser.parse_args()
    print(
        "| set-up | quantity | spread % | reported % | ratio | median % "
        "| least % | largest % | beyond t of 0.05 0.01 0.001 | capped |\n"
        + 10 * "|---"
        + "|"
    )
    for name in options.setups or SETUPS:
        print("\n".join(table_of(name, options.seeds)), flush=True)


if __name__ == "__main__":
    main()
