#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures transpiration of maize: CO2, leaf area, parts of the model, cost.

water.py [--only PART] [--rough]

Prints, for maize with photosynthesis by Collatz in the weather of Bondville:

co2      the response to 550 umol mol-1 of CO2 in a hot week of 2011, with the air of the canopy
         and without, and that of the field (Hussain et al. 2013, doi:10.1111/gcb.12155; Leakey et
         al. 2006);
area     transpiration against leaf area index (Suyker and Verma 2008: linear up to 3 to 4, then
         flat);
parts    the effect of each part of the model;
seasons  the growing seasons of 2011 and of the drought of 2012;
cost     processor time relative to that without water, in pairs;
error    the change of a season's numbers if one source of error is made smaller.

--rough is for tests.
"""

from __future__ import annotations

import argparse
import math
import statistics
import time
from datetime import date
from typing import Any

import numpy as np
from climates import growing_season, season
from estimates import plus_minus, print_table
from shared import campaign_of, guard

from ideotype import Stand

FIGURES = (
    "transpiration",
    "canopy_conductance",
    "leaf_warming",
    "net_assimilation",
    "water_use_efficiency",
)
WEEK = {"from": date(2011, 7, 21), "to": date(2011, 7, 28)}
PARTS: dict[str, dict[str, Any]] = {
    "all": {},
    "air above the canopy": {"canopy_air": False},
    "leaves as warm as the air": {"leaf_temperature": False},
    "stomata of Ball and Berry": {"stomata": "ball_berry"},
    "no fall of wind": {"wind_attenuation": 0.0},
}


def week(
    paths: int, density: float = 8.6, co2: float = 390, **water: Any
) -> Stand:
    """Returns a campaign of the hot week of bondville.toml, with [water]."""
    return Stand(
        campaign_of(
            "bondville",
            climate=[{**season(), **WEEK, "co2": co2}],
            spacing=[{"row": 0.762, "density": density}],
            photosynthesis={"model": "collatz"},
            objective={"maximise": "net_assimilation"},
            light={"paths": paths},
            water=water,
        )
    )


def grown(year: int, has_water: bool, seed: int = 1, **light: Any) -> Stand:
    """Returns the stand of growing_season.toml in a year, with keys of
    [light]."""
    water = {"water": {}} if has_water else {}
    return Stand(growing_season(year, light=light, seed=seed, **water))


def numbers(stand: Stand, names: tuple[str, ...] = FIGURES) -> list[float]:
    found = stand.evaluate(stand.baseline, names)
    return [float(found[name][0]) for name in names]


def print_co2(paths: int) -> None:
    rows = []
    for name, water in list(PARTS.items())[:2]:
        now, rich = (
            numbers(week(paths, co2=co2, **water)) for co2 in (372, 550)
        )
        change = [100 * (b / a - 1) for a, b in zip(now, rich, strict=True)]
        rows.append(
            [
                name,
                f"{change[0]:+.1f}",
                f"{change[1]:+.1f}",
                f"{rich[2] - now[2]:+.2f}",
                f"{change[3]:+.1f}",
            ]
        )
    rows.append(["field", "-7 to -11", "-34", "+0.5 to +0.6", "0"])
    print_table(
        ["550 over 372 umol mol-1", "E [%]", "gs [%]", "T [K]", "A [%]"], rows
    )


def print_area(paths: int) -> None:
    rows = []
    for density in (1.0, 2.0, 4.0, 6.0, 8.6, 12.0):
        stand = week(paths, density)
        lai = numbers(stand, ("lai",))[0]
        found = numbers(stand)
        rows.append(
            [
                f"{lai:.2f}",
                f"{found[0]:.2f}",
                f"{found[2]:+.2f}",
                f"{found[4]:.2f}",
            ]
        )
    print_table(
        ["leaf area index", "E [mm/d]", "T - Ta [K]", "[g C/kg]"], rows
    )


def print_parts(paths: int) -> None:
    rows = [
        [name, *(f"{x:.3f}" for x in numbers(week(paths, **water)))]
        for name, water in PARTS.items()
    ]
    print_table(["part", *FIGURES], rows)


def print_seasons(paths: int) -> None:
    names = (
        "water_use",
        "carbon_balance",
        "water_use_efficiency",
        "leaf_warming",
        "hot_hours",
    )
    rows = [
        [
            str(year),
            *(
                f"{x:.3f}"
                for x in numbers(grown(year, True, paths=paths), names)
            ),
        ]
        for year in (2011, 2012)
    ]
    print_table(["season", *names], rows)


def print_cost(paths: int, pairs: int) -> None:
    """Prints the ratio of processor times with and without water; and this
    ratio times that of the squared relative errors of carbon, which is the
    ratio at equal errors. Each pair has another seed."""
    rows = []
    for name, keys in (
        ("the tolerance of a campaign", {}),
        (f"{paths} paths", {"paths": paths}),
        ("the tolerance of a campaign, four fields", {"fields": 4}),
    ):
        ratios, variances = [], []
        for seed in range(1, pairs + 1):
            used = []
            for has_water in (False, True):
                stand = grown(2011, has_water, seed, **keys)
                start = time.process_time()
                found = stand.evaluate(stand.baseline, ["carbon_balance"])
                used.append(time.process_time() - start)
                error = float(found["carbon_balance_standard_error"][0])
                variances.append(
                    (error / float(found["carbon_balance"][0])) ** 2
                )
            ratios.append(used[1] / used[0])
        more = statistics.fmean(variances[1::2]) / statistics.fmean(
            variances[::2]
        )
        middle = statistics.median(ratios)
        rows.append(
            [
                name,
                f"{middle:.2f} ({min(ratios):.2f} to {max(ratios):.2f})",
                f"{middle * more:.2f}",
            ]
        )
    print_table(["light", f"time, {pairs} pairs", "at an equal error"], rows)


def print_error(paths: int, seeds: int) -> None:
    """Prints the change and the scatter of a season's transpiration and carbon
    if one source of error is reduced."""
    origins: dict[str, tuple[int, dict[str, Any]]] = {
        "as it is": (paths, {}),
        "ten times the paths of near infrared": (paths, {"band": "nir"}),
        "four times the drawn points": (paths // 4, {"randomisations": 64}),
        "four times the paths": (4 * paths, {}),
        "four times the stages": (paths, {"stages": 40}),
    }
    names = ("water_use", "carbon_balance")
    usual = np.empty(0)
    rows: list[list[str]] = []
    for name, (of_each, light) in origins.items():
        found = np.array(
            [
                numbers(grown(2011, True, seed, paths=of_each, **light), names)
                for seed in range(1, seeds + 1)
            ]
        )
        usual = usual if rows else found
        row = [name]
        for i in range(len(names)):
            change = 100 * (found[:, i] / usual[:, i] - 1)
            scatter = 100 * found[:, i].std(ddof=1) / found[:, i].mean()
            error = change.std(ddof=1) / math.sqrt(seeds)
            row += [
                plus_minus((change.mean(), error), 2, "+"),
                f"{scatter:.2f}",
            ]
        rows.append(row)
    titles = (
        f"{x} {y} [%]"
        for x in ("water", "carbon")
        for y in ("change", "scatter")
    )
    print_table([f"{seeds} seeds", *titles], rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--only", choices=("co2", "area", "parts", "seasons", "cost", "error")
    )
    parser.add_argument("--rough", action="store_true")
    options = parser.parse_args()
    paths = 256 if options.rough else 4096
    parts = {
        "co2": lambda: print_co2(paths),
        "area": lambda: print_area(paths),
        "parts": lambda: print_parts(paths),
        "seasons": lambda: print_seasons(paths),
        "cost": lambda: print_cost(paths, 1 if options.rough else 10),
        "error": lambda: print_error(paths, 2 if options.rough else 8),
    }
    for name, show in parts.items():
        if options.only in (None, name):
            show()
            print()


if __name__ == "__main__":
    guard(main)
