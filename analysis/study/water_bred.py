#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Optimises maize with exchange of water, with and without a limit of water.

water_bred.py FOLDER [--only KIND] [--evaluations N] [--seeds N] [--rough]

Optimises maize for the carbon of a growing season at Bondville, of the mild year 2011 and of the
drought of 2012, and for the net assimilation of a hot week in strips with soybean and below rows
of modules. Prints gains over the baseline, with 95 % intervals that include differences between
searches, and the transpiration of the best plants; then the loss of a plant that was optimised in
the other year.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

from climates import (
    PRECISE_FINAL,
    PRECISE_LIGHT,
    bondville,
    growing_season,
    season,
)
from estimates import interval_of, print_table
from shared import (
    ROUGH,
    SEVERAL_FIELDS,
    best,
    breed_tables,
    campaign_of,
    gain_in,
    guard,
    parser_of_searches,
    say,
)  # fmt: skip
from water import WEEK

from ideotype import Stand
from ideotype.history import Case, open_history

SEASON_LIMIT = 300.0
"""The highest transpiration of plants in a growing season [mm]."""
WEEK_SHARE = 0.9
"""The highest transpiration of plants in a week, relative to the
baseline's."""


def whole_season(year: int) -> dict[str, Any]:
    """Returns the tables of growing_season.toml for one year."""
    return growing_season(
        year,
        light=PRECISE_LIGHT,
        final={"candidates": 3, **PRECISE_FINAL, "randomisations": 16},
    )


def hot_week(campaign: str) -> dict[str, Any]:
    """Returns the tables of a campaign, moved to the hot week of
    bondville.toml."""
    found = campaign_of(
        campaign,
        site=bondville()["site"],
        climate=[{**season(), **WEEK}],
        photosynthesis={"model": "collatz"},
        light={**PRECISE_LIGHT, **SEVERAL_FIELDS},
        final={"candidates": 2, **PRECISE_FINAL},
    )
    del found["day"]
    found["plant"]["bounds"] = "breedable"
    return found


KINDS = {
    "2011": partial(whole_season, 2011),
    "2012": partial(whole_season, 2012),
    "strip": partial(hot_week, "strip"),
    "panels": partial(hot_week, "agrivoltaic"),
}


def tables_of(kind: str, options: Any) -> dict[str, Any]:
    found = KINDS[kind]() | {
        "name": f"water_{kind}",
        "water": {},
        "replicates": options.seeds,
        "stop": {"evaluations": options.evaluations},
    }
    return {**found, **(ROUGH if options.rough else {})}


def limit_of(kind: str, stand: Stand) -> float:
    """Returns the water limit for a kind of campaign [mm]."""
    if "emergence" in KINDS[kind]()["climate"][0]:
        return SEASON_LIMIT
    found = stand.evaluate(stand.baseline, ["water_use"], final=True)
    return round(WEEK_SHARE * float(found.water_use[0]), 2)


def row_of(name: str, limit: float, case: Case) -> list[str]:
    return [
        name,
        f"{limit:g}" if limit else "none",
        case.relative_gain().number(),
        *(
            case.number(who, quantity).number().removesuffix(" ± 0.00")
            for quantity in ("water_use", "water_use_efficiency", "lai")
            for who in ("baseline", "best")
        ),
    ]


def print_other_year(
    stands: dict[str, Stand], plants: dict[str, list[Path]]
) -> None:
    """Prints the carbon of plants optimised in one year relative to that of
    plants optimised in the other year."""
    for year, other in (("2011", "2012"), ("2012", "2011")):
        gains = [
            gain_in(stands[year], best(b), best(a))
            for a, b in zip(plants[year], plants[other], strict=True)
        ]
        print(
            f"\nIn {year}, bred there over bred in {other}: "
            + interval_of(gains)
        )


def main() -> None:
    parser = parser_of_searches(__doc__, evaluations=72, seeds=2)
    parser.add_argument("--only", choices=KINDS)
    options = parser.parse_args()
    rows: list[list[str]] = []
    stands: dict[str, Stand] = {}
    plants: dict[str, list[Path]] = {}
    for kind in [options.only] if options.only else KINDS:
        tables = tables_of(kind, options)
        stands[kind] = Stand(tables)
        for limit in (0.0, limit_of(kind, stands[kind])):
            say(f"{kind}, limit {limit:g} mm")
            one = {**tables, "water": {"limit": limit}}
            one["name"] += "_limited" if limit else ""
            paths = breed_tables(one, options.folder)
            plants.setdefault(kind, paths)
            case = Case(one["name"], [open_history(path) for path in paths])
            rows.append(row_of(kind, limit, case))
    print_table(
        [
            "field", "limit [mm]", "gain of carbon [%]", "water, baseline [mm]",
            "best", "carbon per water, baseline [g/kg]", "best",
            "leaf area index, baseline", "best",
        ],
        rows,
    )  # fmt: skip
    if {"2011", "2012"} <= set(plants):
        print_other_year(stands, plants)


if __name__ == "__main__":
    guard(main)
