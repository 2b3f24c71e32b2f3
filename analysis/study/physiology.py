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

from estimates import plus_minus, print_table
from shared import (
    ROUGH,
    breed_tables,
    campaign_of,
    guard,
    parser_of_searches,
)  # fmt: skip

from ideotype import open_history
from ideotype.history.indices import indices_of

#: The ranges of parameters, with their sources or E for an estimate: the
#: phyllochron is one standard deviation between datasets of the Corn Belt
#: (13 to 18 %, doi:10.3389/fpls.2022.872738); kernels and their filling are
#: those of crops/maize_hybrid.toml.
PARAMETERS: dict[str, tuple[tuple[float, float], str]] = {
    "photosynthesis.vmax": ((30, 48), "E"),
    "photosynthesis.alpha": ((0.057, 0.077), "E"),
    "photosynthesis.rd": ((0.4, 1.2), "E"),
    "plant.baseline.growth.ear_maintenance": ((0.005, 0.015), "E"),
    "plant.baseline.stalk.maintenance": ((0.010, 0.020), "E"),
    "plant.baseline.growth.interval": ((38, 50), "source"),
    "plant.baseline.growth.root_share": ((0.10, 0.20), "source"),
    "plant.baseline.grain.kernels": ((385, 600), "source"),
    "plant.baseline.grain.filling_rate": ((5.4, 8.5), "source"),
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
                {"key": key, "range": list(limits)}
                for key, (limits, _) in PARAMETERS.items()
            ],
        },
        **{"light": {"tolerance": 0.03}, **(ROUGH if options.rough else {})},
    )
    [history] = breed_tables(tables, options.folder, "sensitivity")
    with open_history(history) as opened:
        every = indices_of(opened)
    found = [every[name] for name in OBJECTIVES]
    rows = []
    for k, factor in enumerate(found[0].factors):
        text = "breedable"
        if factor in PARAMETERS:
            (low, high), kind = PARAMETERS[factor]
            text = f"{low:g} to {high:g}" + (" (E)" if kind == "E" else "")
        totals = [
            (float(x.index["total"][k]), float(x.standard_error["total"][k]))
            for x in found
        ]
        rows.append([factor, text, *(plus_minus(x, 2) for x in totals)])
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
