#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares maize in soil that dries with measured fields, and asks what drought
and shade cost.

drought.py FOLDER [--measured FOLDER] [--years FOLDER] [--only PART] [--rough]

* gainesville: shoots, grain and kernels of the trial UFGA8201 of 1982, rain-fed
  (treatment 2) and irrigated (treatment 4), with its weather, soil and
  irrigation; both rules of kernels; and what would close the gap between
  computed and measured, one change at a time in both treatments. --measured is a
  folder with the tables ufga1982_soil.csv, ufga1982_irrigation.csv,
  ufga1982_growth.csv and ufga1982_harvest.csv, made from
  github.com/DSSAT/dssat-csm-data, ac780c7; the project does not contain them.
* ames: shoots and grain of Ames 1999 (IUAF9901, treatment 4), rain-fed in a silty
  clay loam, with dry matter of measured_seasons.py.
* years: water and grain of six years at Champaign, and evapotranspiration by
  month. --years is a folder with champaign_1995_2023_may_sep.csv.gz, made from
  cmi_weather_data of the R package BioCro (b8ed268); the project does not contain
  it.
* bred: plants that are optimised for grain in a wet and in a dry year, rain-fed
  and irrigated, and what each loses in the other conditions; needs --years.
* cost: CPU time of an evaluation with soil over that without, in pairs; needs
  --years.
* shade: grain lost over light lost, in shade from ten days after silking to
  maturity, and below modules.

Nothing is fitted to the measured values."""

from __future__ import annotations

import argparse
import csv
import gzip
import math
import time
from collections.abc import Mapping
from datetime import date
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pandas as pd
from climates import growing_season
from estimates import estimate, plus_minus, print_table, ratio
from measured_seasons import SEASONS, crop_of, in_season
from shared import (
    HYBRID_1980S,
    ROUGH,
    best_plants,
    campaign_of,
    guard,
    parser_of_searches,
    run_parts,
)  # fmt: skip

from ideotype import Stand

GAINESVILLE, AMES = SEASONS
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
    """Returns [irrigation] of a treatment, if there is any."""
    rows = [
        x for x in rows_of(folder, "irrigation") if x["treatment"] == treatment
    ]
    if not rows:
        return {}
    return {
        "irrigation": {
            "dates": [date.fromisoformat(x["date"]) for x in rows],
            "amounts": [float(x["mm"]) for x in rows],
        }
    }


def gainesville(
    folder: Path,
    work: Path,
    treatment: str,
    *,
    grain: Mapping[str, Any] = {},
    soil: Mapping[str, Any] = {},
    width: float = 1,
) -> Stand:
    """Returns the stand of a treatment. The dew point of each day is its
    smallest temperature (FAO-56, equation 48)."""
    tables = growing_season(
        light={"tolerance": 0.01}, photosynthesis={"model": "collatz"}
    )
    crop = crop_of({"plant": {"baseline": str(HYBRID_1980S)}})
    tables["plant"] = {
        "baseline": {
            **scaled_leaves(crop, width),
            "grain": {**crop["grain"], **grain},
        }
    }
    tables = in_season(tables, GAINESVILLE, work)
    tables["climate"][0] |= {"humidity": ["rh", "1"], "rain": ["rain", "mm"]}
    return Stand(
        tables
        | {
            "objective": {"maximise": "grain_yield"},
            "water": {},
            "soil": {**soil_of(folder), **soil},
            **irrigation_of(folder, treatment),
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


def compare_ames(seeds: int) -> None:
    """Prints shoots and grain of Ames beside what was measured. The soil of the
    trial is not known; a silty clay loam is assumed."""
    tables = growing_season(
        light={"tolerance": 0.01}, photosynthesis={"model": "collatz"}
    )
    tables["plant"] = {"baseline": str(HYBRID_1980S)}
    with TemporaryDirectory() as work:
        tables = in_season(tables, AMES, Path(work))
        tables["climate"][0] |= {
            "humidity": ["rh", "1"],
            "rain": ["rain", "mm"],
        }
        tables |= {
            "objective": {"maximise": "grain_yield"},
            "water": {},
            "soil": {"texture": "silty_clay_loam"},
        }
        found = figures(Stand(tables), seeds)
    measured = {
        "1999-07-21": 4.822,
        "1999-08-13": 11.578,
        "1999-08-31": 16.093,
        str(found[0].day.values[-1]): AMES.measured["harvest"],
    }
    rows = [
        [
            f"shoot on {day} [t ha-1]",
            f"{value:.1f}",
            plus_minus(over(found, "shoot_by_day", day=day), 1),
        ]
        for day, value in measured.items()
    ]
    rows += [
        [
            "grain, dry [t ha-1]",
            "10.35",
            plus_minus(over(found, "grain_yield"), 2),
        ],
        ["kernels [m-2]", "", plus_minus(over(found, "kernels"), 0)],
        *(
            [
                f"{name.replace('_', ' ')} [mm]",
                "",
                plus_minus(over(found, name), 0),
            ]
            for name in ("rain", "water_use", "soil_evaporation", "drainage")
        ),
        [
            "transpiration prevented",
            "",
            plus_minus(over(found, "water_stress"), 3),
        ],
    ]
    print_table(["Ames 1999", "measured", "computed"], rows)


def scaled_leaves(crop: dict[str, Any], width: float) -> dict[str, Any]:
    """Returns a crop whose leaves are wider by a factor."""
    return {
        **crop,
        "leaf": [{**x, "width": x["width"] * width} for x in crop["leaf"]],
    }


def compare_changes(folder: Path, seeds: int) -> None:
    """Prints kernels and grain of both treatments with one change at a time.
    Leaves of the rain-fed field that are as small as measured change that
    treatment only."""
    measured = {x["treatment"]: x for x in rows_of(folder, "harvest")}
    smaller = float(measured["2"]["lai_max"]) / float(measured["4"]["lai_max"])
    changes: dict[str, dict[str, Any]] = {
        "as it is": {},
        "kernels by ceres": {"grain": CERES},
        "leaves of the rain-fed field as small as measured": {
            "width": smaller
        },
        "roots of 0.9 m": {"soil": {"root_depth": 0.9}},
        "roots of 0.6 m": {"soil": {"root_depth": 0.6}},
        "stress from a quarter of the water on": {
            "soil": {"depletion_fraction": 0.25}
        },
        "roots half as fast": {"soil": {"root_rate": 0.0011}},
        "all but the shallowest roots": {
            "grain": CERES,
            "width": smaller,
            "soil": {
                "root_depth": 0.9,
                "depletion_fraction": 0.25,
                "root_rate": 0.0011,
            },
        },
    }
    rows = []
    with TemporaryDirectory() as work:
        for name, change in changes.items():
            found = {}
            for treatment, number in TREATMENTS.items():
                width = change.get("width", 1) if number == "2" else 1
                found[treatment] = figures(
                    gainesville(
                        folder,
                        Path(work),
                        number,
                        grain=change.get("grain", {}),
                        soil=change.get("soil", {}),
                        width=width,
                    ),
                    seeds,
                )
            grain = [over(found[x], "grain_yield") for x in TREATMENTS]
            kernels = [over(found[x], "kernels") for x in TREATMENTS]
            rows.append(
                [
                    name,
                    *(plus_minus(x, 0) for x in kernels),
                    *(plus_minus(x, 1) for x in grain),
                    plus_minus(ratio(*grain), 2),
                ]
            )
    rows.append(
        [
            "measured",
            *(measured[x]["kernels_m2"] for x in ("2", "4")),
            *(
                f"{float(measured[x]['grain_dry_kg_ha']) / 1000:.1f}"
                for x in ("2", "4")
            ),
            f"{float(measured['2']['grain_dry_kg_ha']) / float(measured['4']['grain_dry_kg_ha']):.2f}",
        ]
    )
    print_table(
        [
            "changed", "kernels, rain-fed [m-2]", "irrigated",
            "grain, rain-fed [t ha-1]", "irrigated", "ratio of grain",
        ],
        rows,
    )  # fmt: skip


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


def below_modules(has_modules: bool) -> dict[str, Any]:
    """Returns the season of Bondville 2011 below the modules of
    agrivoltaic.toml, or without them, with twice the distance between rows of
    modules: modules cover a fifth of the ground."""
    modules = campaign_of("agrivoltaic")
    campaign = growing_season(
        light={"tolerance": 0.01},
        spacing=modules["spacing"],
        field={**modules["field"], "rows": 16, "plants": 2},
    )
    if has_modules:
        campaign["panel"] = [
            {**x, "pitch": 2 * x["pitch"]} for x in modules["panel"]
        ]
    return campaign | {
        "objective": {"maximise": "grain_yield"},
        "band": [{"name": "nir"}],
    }


def compare_modules(seeds: int) -> None:
    """Prints grain and light lost below modules."""
    found, full = (
        figures(Stand(below_modules(x)), seeds) for x in (True, False)
    )
    rows = [
        [
            name,
            plus_minus(
                estimate(
                    [
                        100 * (1 - float(x[name]) / float(y[name]))
                        for x, y in zip(found, full, strict=True)
                    ]
                ),
                1,
            ),
        ]
        for name in (
            "absorbed_par", "net_assimilation", "kernels", "grain_yield"
        )
    ]  # fmt: skip
    print_table(["below modules", "lost [%]"], rows)


CONDITIONS = {
    "wet": (2014, {}),
    "dry": (2012, {}),
    "dry, irrigated": (2012, {"irrigation": {"depletion": 0.5}}),
}


def compare_bred(options: argparse.Namespace) -> None:
    """Prints the grain of plants that were optimised in each condition, in all
    conditions."""
    stands, plants = {}, {}
    for name, (year, tables) in CONDITIONS.items():
        campaign = champaign(options.years, year, options.folder, **tables)
        campaign |= {
            "name": "bred_" + name.replace(", ", "_"),
            "replicates": options.seeds,
            "light": {"tolerance": 0.02},
            "final": {
                "candidates": 3,
                "paths": 1024,
                "randomisations": 16,
            },
            "stop": {"evaluations": options.evaluations},
        } | (ROUGH if options.rough else {})
        plants[name] = best_plants(campaign, options.folder)
        stands[name] = Stand(campaign)
    # The baseline with wider and narrower leaves shows what leaf area does.
    genes = stands["wet"].genes
    is_width = genes["name"].str.startswith("width_profile").to_numpy()
    for factor in (0.7, 0.85, 1, 1.15, 1.3):
        scaled = stands["wet"].baseline.copy()
        scaled[is_width] = factor
        plants[f"baseline, blades {factor} times as wide"] = [scaled]
    rows = []
    for bred, each in plants.items():
        row = [bred]
        for stand in stands.values():
            found = [
                stand.evaluate(
                    plant,
                    ["grain_yield", "water_use", "lai"],
                    final=True,
                    seed=seed,
                ).isel(plant=0)
                for plant in each
                for seed in range(1, 4)
            ]
            for quantity, digits in (
                ("grain_yield", 2), ("water_use", 0), ("lai", 2)
            ):  # fmt: skip
                row.append(plus_minus(over(found, quantity), digits))
        rows.append(row)
    print_table(
        [
            "optimised for",
            *(
                f"{quantity}, {name}"
                for name in CONDITIONS
                for quantity in (
                    "grain [t ha-1]", "transpiration [mm]", "leaf area index"
                )
            ),
        ],
        rows,
    )  # fmt: skip


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
    parser = parser_of_searches(__doc__, seeds=4, evaluations=640)
    parser.add_argument("--measured", type=Path)
    parser.add_argument("--years", type=Path)
    years = [2011, 2012, 2005, 1999, 2014, 2023]

    def gainesville_parts(options: argparse.Namespace) -> None:
        compare(options.measured, options.seeds)
        print()
        compare_changes(options.measured, options.seeds)

    def shade_parts(options: argparse.Namespace) -> None:
        compare_shade(options.seeds)
        print()
        compare_modules(options.seeds)

    run_parts(
        parser,
        {
            "gainesville": gainesville_parts,
            "ames": lambda x: compare_ames(x.seeds),
            "years": lambda x: compare_years(x.years, years),
            "bred": compare_bred,
            "cost": lambda x: compare_cost(x.years, 9),
            "shade": shade_parts,
        },
    )


if __name__ == "__main__":
    guard(main)
