#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares maize in soil that dries with measured fields, and asks what drought
and shade cost.

drought.py [--measured FOLDER] [--years FOLDER] [--seeds N] [--only PART ...]

Parts:

* gainesville: shoots, grain and kernels of the trial UFGA8201 of 1982, rain-fed
  (treatment 2) and irrigated (treatment 4), with its weather, soil and irrigation.
  --measured is a folder with the files ufga1982_soil.csv, ufga1982_irrigation.csv
  and ufga1982_growth.csv and ufga1982_harvest.csv, made from
  github.com/DSSAT/dssat-csm-data, ac780c7; the project does not contain them.
* years: water of the soil and evapotranspiration by month in several years.
  --years is a folder with champaign_1995_2023_may_sep.csv.gz, made from
  cmi_weather_data of the R package BioCro (b8ed268); the project does not contain
  it.
* rules: both rules of kernels, in both treatments.
* shade: grain lost over light lost, in shade from silking to maturity.
* cost: CPU time of an evaluation with soil over that without, in pairs.

Nothing is fitted to the measured values."""

from __future__ import annotations

import argparse
import csv
import gzip
import math
import time
from collections.abc import Iterator
from datetime import date
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pandas as pd
from climates import growing_season
from estimates import estimate, plus_minus, print_table, ratio
from measured_seasons import SEASONS, crop_of, in_season
from shared import HYBRID_1980S, guard

from ideotype import Stand

GAINESVILLE = SEASONS[0]
TREATMENTS = {"rain-fed": "2", "irrigated": "4"}
#: Kernels and filling of the hybrid of the trial, McCurdy 84aa, in CERES-Maize
#: (G2 and G3 of DSSAT).
CERES = {"kernel_rule": "ceres", "kernels": 924, "filling_rate": 8.17}


def rows_of(folder: Path, name: str) -> list[dict[str, str]]:
    """Returns the rows of a table of the trial."""
    with (folder / f"ufga1982_{name}.csv").open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def soil_of(folder: Path) -> dict[str, Any]:
    """Returns [soil] of the trial. Roots reach the layers whose factor of root
    growth is above 0.03. The evaporable water is equation 73 of FAO-56 for a
    layer of 0.10 m."""
    layers, top = [], 0.0
    for row in rows_of(folder, "soil"):
        bottom = float(row["depth_to_cm"]) / 100
        if float(row["root_growth"]) >= 0.03:
            layers.append(
                (
                    bottom - top,
                    float(row["field_capacity"]),
                    float(row["wilting_point"]),
                )
            )
        top = bottom
    depths, field, wilting = np.array(layers).T
    upper = layers[0]
    return {
        "field_capacity": float(np.average(field, weights=depths)),
        "wilting_point": float(np.average(wilting, weights=depths)),
        "root_depth": float(depths.sum()),
        "total_evaporable": 1000 * (upper[1] - upper[2] / 2) * 0.10,
        "readily_evaporable": 2.0,
        "curve_number": 60,
    }


def irrigation_of(folder: Path, treatment: str) -> dict[str, Any]:
    """Returns [irrigation] of a treatment."""
    rows = [
        x for x in rows_of(folder, "irrigation") if x["treatment"] == treatment
    ]
    return {
        "dates": [date.fromisoformat(x["date"]) for x in rows],
        "amounts": [float(x["mm"]) for x in rows],
    }


def gainesville(
    folder: Path, work: Path, treatment: str, **grain: Any
) -> Stand:
    """Returns the stand of a treatment. The dew point of each day is its
    smallest temperature (FAO-56, equation 48)."""
    tables = growing_season(
        light={"tolerance": 0.01}, photosynthesis={"model": "collatz"}
    )
    crop = crop_of({"plant": {"baseline": str(HYBRID_1980S)}})
    tables["plant"] = {
        "baseline": {**crop, "grain": {**crop["grain"], **grain}}
    }
    tables = in_season(tables, GAINESVILLE, work)
    tables["climate"][0] |= {"humidity": ["rh", "1"], "rain": ["rain", "mm"]}
    return Stand(
        tables
        | {
            "objective": {"maximise": "grain_yield"},
            "water": {},
            "soil": soil_of(folder),
            "irrigation": irrigation_of(folder, treatment),
        }
    )


def figures(stand: Stand, seeds: int) -> list[Any]:
    """Returns evaluations of the baseline with several seeds."""
    return [
        stand.evaluate(stand.baseline, seed=seed).isel(plant=0)
        for seed in range(1, seeds + 1)
    ]


def over(found: list[Any], name: str, **at: Any) -> tuple[float, float]:
    """Returns the mean of a quantity over seeds, with its error."""
    return estimate([float(x[name].sel(at) if at else x[name]) for x in found])


def compare(folder: Path, seeds: int) -> None:
    """Prints both treatments beside what was measured."""
    found = {}
    with TemporaryDirectory() as work:
        for name, treatment in TREATMENTS.items():
            found[name] = figures(
                gainesville(folder, Path(work), treatment), seeds
            )
    measured = {x["treatment"]: x for x in rows_of(folder, "harvest")}
    growth = rows_of(folder, "growth")
    rows = []
    for name, treatment in TREATMENTS.items():
        own = [
            x
            for x in growth
            if x["treatment"] == treatment
            and x["date"] in ("1982-04-26", "1982-05-11", "1982-06-07")
        ]
        rows += [
            [
                f"{name}: shoot on {x['date']} [t ha-1]",
                f"{float(x['biomass_kg_ha']) / 1000:.2f}",
                plus_minus(
                    over(found[name], "shoot_by_day", day=x["date"]), 2
                ),
            ]
            for x in own
        ]
        harvest = measured[treatment]
        last = str(found[name][0].day.values[-1])
        largest = estimate(
            [float(x["lai_by_stage"].max()) for x in found[name]]
        )
        rows += [
            [
                f"{name}: shoot at harvest [t ha-1]",
                f"{float(harvest['biomass_kg_ha']) / 1000:.2f}",
                plus_minus(over(found[name], "shoot_by_day", day=last), 2),
            ],
            [
                f"{name}: largest leaf area index",
                harvest["lai_max"],
                plus_minus(largest, 2),
            ],
            [
                f"{name}: kernels [m-2]",
                harvest["kernels_m2"],
                plus_minus(over(found[name], "kernels"), 0),
            ],
            [
                f"{name}: grain, dry [t ha-1]",
                f"{float(harvest['grain_dry_kg_ha']) / 1000:.2f}",
                plus_minus(over(found[name], "grain_yield"), 2),
            ],
        ]
        for water in (
            "rain", "irrigation", "water_use", "soil_evaporation", "drainage",
            "runoff",
        ):  # fmt: skip
            rows.append(
                [
                    f"{name}: {water.replace('_', ' ')} [mm]",
                    "",
                    plus_minus(over(found[name], water), 0),
                ]
            )
        rows.append(
            [
                f"{name}: transpiration prevented [%]",
                "",
                plus_minus(
                    tuple(100 * x for x in over(found[name], "water_stress")),
                    1,
                ),
            ]
        )
    shares = {
        "grain": ("grain_yield", "grain_dry_kg_ha"),
        "kernels": ("kernels", "kernels_m2"),
    }
    for name, (ours, theirs) in shares.items():
        rows.append(
            [
                f"{name}, rain-fed over irrigated",
                f"{float(measured['2'][theirs]) / float(measured['4'][theirs]):.2f}",
                plus_minus(
                    ratio(
                        over(found["rain-fed"], ours),
                        over(found["irrigated"], ours),
                    ),
                    2,
                ),
            ]
        )
    print_table(["Gainesville 1982", "measured", "computed"], rows)


def compare_rules(folder: Path, seeds: int) -> None:
    """Prints kernels and grain by both rules."""
    rows = []
    with TemporaryDirectory() as work:
        for rule, grain in {"andrade": {}, "ceres": CERES}.items():
            found = {
                name: figures(
                    gainesville(folder, Path(work), treatment, **grain), seeds
                )
                for name, treatment in TREATMENTS.items()
            }
            for quantity, digits in (("kernels", 0), ("grain_yield", 2)):
                values = [over(found[x], quantity) for x in TREATMENTS]
                rows.append(
                    [
                        f"{quantity} by {rule}",
                        *(plus_minus(x, digits) for x in values),
                        plus_minus(ratio(*values), 2),
                    ]
                )
    print_table(["", *TREATMENTS, "ratio"], rows)


def champaign(
    folder: Path, year: int, work: Path, **tables: Any
) -> dict[str, Any]:
    """Returns the campaign of a year at Champaign with its rain."""
    path = work / f"champaign_{year}.csv"
    if not path.exists():
        name = "champaign_1995_2023_may_sep.csv.gz"
        with gzip.open(folder / name, "rt", encoding="utf-8") as file:
            lines = file.read().splitlines()
        path.write_text(
            "\n".join(
                [lines[0], *(x for x in lines if x.startswith(str(year)))]
            )
            + "\n"
        )
    campaign = growing_season(light={"tolerance": 0.01})
    campaign["climate"] = [
        {
            "name": str(year),
            "file": str(path),
            "from": date(year, 5, 1),
            "to": date(year, 9, 29),
            "emergence": date(year, 5, 15),
            "time": ["time"],
            "stamp": "middle",
            "global": ["ppfd_umol", "umol/m2/s"],
            "temperature": ["temp_c", "C"],
            "humidity": ["rh", "1"],
            "wind": ["wind_m_s", "m/s"],
            "rain": ["rain_mm", "mm"],
        }
    ]
    return campaign | {
        "objective": {"maximise": "grain_yield"},
        "water": {},
        "soil": {"texture": "silty_clay_loam", "root_depth": 1.35},
        **tables,
    }


def compare_years(folder: Path, years: list[int]) -> None:
    """Prints water and grain of several years, and evapotranspiration by
    month."""
    rows, months = [], []
    with TemporaryDirectory() as work:
        for year in years:
            stand = Stand(champaign(folder, year, Path(work)))
            found = figures(stand, 2)
            rows.append(
                [
                    str(year),
                    *(
                        plus_minus(over(found, name), digits)
                        for name, digits in (
                            ("rain", 0), ("water_use", 0),
                            ("soil_evaporation", 0), ("drainage", 0),
                            ("soil_water", 0), ("water_stress", 3),
                            ("kernels", 0), ("grain_yield", 2),
                        )
                    ),
                ]
            )  # fmt: skip
            days = stand.season(stand.baseline).set_index("date")
            both = days["transpiration"] + days["evaporation"]
            by_month = both.groupby(both.index.month).mean()
            months.append(
                [
                    str(year),
                    *(
                        f"{by_month.get(m, math.nan):.1f}"
                        for m in range(5, 10)
                    ),
                    f"{days['soil_water'].min():.0f}",
                    str(days["soil_water"].idxmin().date()),
                ]
            )
    print_table(
        [
            "year", "rain [mm]", "transpiration [mm]", "evaporation [mm]",
            "drainage [mm]", "soil water [mm]", "stress", "kernels [m-2]",
            "grain [t ha-1]",
        ],
        rows,
    )  # fmt: skip
    print()
    print_table(
        [
            "evapotranspiration [mm day-1]", "May", "June", "July", "August",
            "September", "least soil water [mm]", "on",
        ],
        months,
    )  # fmt: skip


def shaded(work: Path, share: float) -> dict[str, Any]:
    """Returns the season of Bondville 2011 with a part of the light taken
    away by cloth from 10 days after silking on (R2 to R6)."""
    campaign = growing_season(light={"tolerance": 0.01})
    climate = campaign["climate"][0]
    table = pd.read_csv(
        Path(__file__).parents[2] / "campaigns" / climate["file"], dtype=str
    )
    late = table["time"] >= "2011-07-27"
    ppfd = table["ppfd_umol"].astype(float)
    table["ppfd_umol"] = ppfd.where(~late, ppfd * (1 - share))
    path = work / f"shade_{share:.2f}.csv"
    table.to_csv(path, index=False)
    climate["file"] = str(path)
    return campaign | {"objective": {"maximise": "grain_yield"}}


def compare_shade(seeds: int) -> None:
    """Prints grain lost in shade."""
    with TemporaryDirectory() as work:
        full = figures(Stand(shaded(Path(work), 0)), seeds)
        rows = []
        for share in (0.15, 0.30, 0.50):
            found = figures(Stand(shaded(Path(work), share)), seeds)
            lost = [
                100 * (1 - float(x.grain_yield) / float(y.grain_yield))
                for x, y in zip(found, full, strict=True)
            ]
            # g of grain per MJ of PAR above the canopy.
            per_light = [
                100
                * (float(y.grain_yield) - float(x.grain_yield))
                / (float(y.incident - x.incident) * len(x.day))
                for x, y in zip(found, full, strict=True)
            ]
            rows.append(
                [
                    f"{100 * share:.0f}",
                    plus_minus(estimate(lost), 1),
                    plus_minus(estimate(per_light), 2),
                ]
            )
    print_table(
        ["shade [%]", "grain lost [%]", "grain per PAR lost [g MJ-1]"], rows
    )


def compare_cost(folder: Path, pairs: int) -> None:
    """Prints the CPU time of evaluations with soil over that without, in a dry
    year."""
    with TemporaryDirectory() as work:
        dry = champaign(folder, 2012, Path(work))
        wet = {k: v for k, v in dry.items() if k != "soil"}
        stands = [
            Stand(x | {"objective": {"maximise": "carbon_balance"}})
            for x in (dry, wet)
        ]

        def seconds(stand: Stand, seed: int) -> float:
            began = time.process_time()
            stand.evaluate_one(stand.baseline, seed=seed)
            return time.process_time() - began

        for stand in stands:
            seconds(stand, 0)
        shares = [
            seconds(stands[0], seed) / seconds(stands[1], seed)
            for seed in range(1, pairs + 1)
        ]
    print(
        f"cost with soil over without: {np.median(shares):.3f}, "
        f"{min(shares):.3f} to {max(shares):.3f} of {pairs} pairs"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--measured", type=Path)
    parser.add_argument("--years", type=Path)
    parser.add_argument("--seeds", type=int, default=4)
    parser.add_argument("--only", nargs="*")
    options = parser.parse_args()

    def parts() -> Iterator[tuple[str, Any]]:
        if options.measured:
            yield (
                "gainesville",
                lambda: compare(options.measured, options.seeds),
            )
            yield (
                "rules",
                lambda: compare_rules(options.measured, options.seeds),
            )
        if options.years:
            yield (
                "years",
                lambda: compare_years(
                    options.years, [2011, 2012, 2005, 1999, 2014, 2023]
                ),
            )
            yield "cost", lambda: compare_cost(options.years, 9)
        yield "shade", lambda: compare_shade(options.seeds)

    for name, run in parts():
        if not options.only or name in options.only:
            print(f"\n## {name}\n")
            run()


if __name__ == "__main__":
    guard(main)
