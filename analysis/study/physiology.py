#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the traits of a plant with parameters of physiology and growth.

physiology.py FOLDER [--samples N] [--rough]

Computes Sobol' indices of dry matter and grain of growing_season.toml, as means
over its years, for the traits that can be selected and for the parameters of
PARAMETERS, each over the range of its source. Shares depend on these ranges.
± is half of a 95 % interval by bootstrap over samples.
"""

from __future__ import annotations

from typing import NamedTuple

from estimates import plus_minus, print_table
from shared import ROUGH, campaign_of, guard, parser_of_searches, sensitivity


class Range(NamedTuple):
    """The range of a parameter, from a source or estimated (E)."""

    low: float
    high: float
    is_estimate: bool = False

    def __str__(self) -> str:
        mark = " (E)" if self.is_estimate else ""
        return f"{self.low:g} to {self.high:g}{mark}"


#: The range of the phyllochron is one standard deviation between datasets of
#: the Corn Belt (13 to 18 %, doi:10.3389/fpls.2022.872738); those of kernels
#: and their filling are from crops/maize_hybrid.toml.
PARAMETERS: dict[str, Range] = {
    "photosynthesis.vmax": Range(30, 48, is_estimate=True),
    "photosynthesis.alpha": Range(0.057, 0.077, is_estimate=True),
    "photosynthesis.rd": Range(0.4, 1.2, is_estimate=True),
    "plant.baseline.growth.ear_maintenance": Range(
        0.005, 0.015, is_estimate=True
    ),
    "plant.baseline.stalk.maintenance": Range(0.010, 0.020, is_estimate=True),
    "plant.baseline.growth.interval": Range(38, 50),
    "plant.baseline.growth.root_share": Range(0.10, 0.20),
    "plant.baseline.grain.kernels": Range(385, 600),
    "plant.baseline.grain.filling_rate": Range(5.4, 8.5),
}
OBJECTIVES = ("dry_matter", "grain_yield")


def main() -> None:
    parser = parser_of_searches(__doc__, samples=64)
    options = parser.parse_args()
    tables = campaign_of(
        "growing_season",
        name="physiology",
        objective={"maximise": list(OBJECTIVES), "over": ["climate"]},
        sensitivity={
            "samples": options.samples,
            "keys": [
                {"key": key, "range": [limits.low, limits.high]}
                for key, limits in PARAMETERS.items()
            ],
        },
        **{"light": {"tolerance": 0.03}, **(ROUGH if options.rough else {})},
    )
    every = sensitivity(tables, options.folder)
    found = [every[name] for name in OBJECTIVES]
    rows = []
    for k, factor in enumerate(found[0].factors):
        totals = [
            (float(x.index["total"][k]), float(x.standard_error["total"][k]))
            for x in found
        ]
        of = str(PARAMETERS.get(factor, "breedable"))
        rows.append([factor, of, *(plus_minus(x, 2) for x in totals)])
    print_table(
        ["total Sobol' index", "range", "dry matter", "grain yield"], rows
    )
    for name, each in zip(OBJECTIVES, found, strict=True):
        print(
            f"\n{name.replace('_', ' ').capitalize()}: mean {each.mean:.1f}, "
            f"standard deviation {each.standard_deviation:.1f} {each.unit}, of "
            f"the noise of a row {each.noise:.1f}."
        )


if __name__ == "__main__":
    guard(main)
