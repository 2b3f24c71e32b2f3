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
from shared import (
    ROUGH,
    campaign_of,
    guard,
    parser_of_searches,
    sensitivity,
    words_of,
)


class Parameter(NamedTuple):
    """A parameter with its range, from a source or estimated (E)."""

    words: str
    low: float
    high: float
    unit: str
    is_estimate: bool = False

    def range(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        mark = " (E)" if self.is_estimate else ""
        return f"{self.low:g} to {self.high:g}{unit}{mark}"


#: By key. The range of the phyllochron is one standard deviation between
#: datasets of the Corn Belt (13 to 18 %, doi:10.3389/fpls.2022.872738); those
#: of kernels and their filling are from crops/maize_hybrid.toml.
PARAMETERS = {
    "photosynthesis.vmax": Parameter(
        "capacity", 30, 48, "µmol m-2 s-1", is_estimate=True
    ),
    "photosynthesis.alpha": Parameter(
        "quantum yield", 0.057, 0.077, "", is_estimate=True
    ),
    "photosynthesis.rd": Parameter(
        "respiration of leaves", 0.4, 1.2, "µmol m-2 s-1", is_estimate=True
    ),
    "plant.baseline.growth.ear_maintenance": Parameter(
        "maintenance of ears", 0.005, 0.015, "d-1", is_estimate=True
    ),
    "plant.baseline.stalk.maintenance": Parameter(
        "maintenance of stalks", 0.010, 0.020, "d-1", is_estimate=True
    ),
    "plant.baseline.growth.interval": Parameter("phyllochron", 38, 50, "°C d"),
    "plant.baseline.growth.root_share": Parameter(
        "share of roots", 0.10, 0.20, ""
    ),
    "plant.baseline.grain.kernels": Parameter(
        "kernels per plant", 385, 600, ""
    ),
    "plant.baseline.grain.filling_rate": Parameter(
        "filling rate", 5.4, 8.5, "mg d-1"
    ),
}
OBJECTIVES = ("dry_matter", "grain_yield")


def main() -> None:
    parser = parser_of_searches(__doc__, samples=192)
    options = parser.parse_args()
    tables = campaign_of(
        "growing_season",
        name="physiology",
        objective={"maximise": list(OBJECTIVES), "over": ["climate"]},
        sensitivity={
            "samples": options.samples,
            "keys": [
                {"key": key, "range": [each.low, each.high]}
                for key, each in PARAMETERS.items()
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
        known = PARAMETERS.get(factor)
        rows.append(
            [
                f"{known.words} (`{factor}`)" if known else words_of(factor),
                known.range() if known else "breedable",
                *(plus_minus(x, 2) for x in totals),
            ]
        )
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
