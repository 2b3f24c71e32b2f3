#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Does the canopy behave as maize does in the field?

validation.py [--rough] [--figure FILE.png]

Evaluates the baseline of crops/maize.toml in stands like those of field experiments, on
the clear day of ames.toml, around its noon, and in the season of bondville.toml, and
prints each figure beside the published one (published.py): extinction coefficients and
fractions of PAR, what erect leaves do, light-use efficiency, and canopy assimilation. What
disagrees comes first; two standard errors are granted, and where a source tells one figure
without an error, 10 %. Then come what would change it, and extinction coefficients k
against row spacing and leaf area index. ± are standard errors. --rough is for tests.

k is of the light that reaches the soil, as in the field: -ln(transmitted / incident) / leaf
area index. `extinction_coefficient` of the program is of what plants absorb.
"""

from __future__ import annotations

import argparse
import math
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import erect_leaves
import numpy as np
from fields import (
    DAY,
    SEASON,
    Field,
    Measured,
    dry_matter,
    measure_all,
    noon_rate,
    ratio,
    scaled,
)  # fmt: skip
from published import PUBLISHED, Published, apsim_k, ceres_k
from shared import (
    PLANT_AREA,
    ROUGH,
    Estimate,
    Settings,
    guard,
    print_table,
    sign_change,
)  # fmt: skip

from ideotype.analysis.style import new_figure

ROWS = (0.20, 0.38, 0.50, 0.76, 1.0)
DENSITY = 7.5
ROW = 0.762
AREAS = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
AZIMUTHS = ("across", "along", "random")
LIGHTS = ("day", "noon")
LEAVES_ALONE = ("plant.organs=[]",)

USUAL = Field(ROW, DENSITY)
DENSE = Field(ROW, 6 / PLANT_AREA)
JULY = replace(DENSE, hours="whole", date="2025-07-10")
JULY_NOON = replace(JULY, hours="noon")
#: what is compared, by the keys of PUBLISHED where it is one figure of one field
FIELDS = {
    **{f"k {row}": Field(row, DENSITY) for row in (0.2, 0.5, 1.0)},
    "k ceres": USUAL,
    "k crops": USUAL,
    "k dense": replace(DENSE, hours="noon"),
    "fapar": Field(ROW, 5 / PLANT_AREA),
    **{
        f"fipar {density}": Field(0.52, density, hours="noon")
        for density in (4.5, 6.2, 7.3)
    },
    "rows 1.0": Field(1.0, DENSITY, hours="noon"),
    "rows 0.35": Field(0.35, DENSITY, hours="noon"),
    "eight, 0.7": Field(0.7, 8, hours="noon"),
    "eight, 0.35": Field(0.35, 8, hours="noon"),
    "noon": replace(USUAL, hours="noon"),
    "season": replace(USUAL, campaign=SEASON),
    "july": JULY,
    "july noon": JULY_NOON,
}
#: what would change it
CHANGES: dict[str, dict[str, Any]] = {
    "as it is": {},
    "rows from north to south": {"direction": 0},
    "leaves without other organs": {"more": LEAVES_ALONE},
    "leaves half as curved": {"curvature": 0.5},
    "straight leaves": {"curvature": 0},
    "straight leaves without other organs": {
        "curvature": 0,
        "more": LEAVES_ALONE,
    },
    "capacity alike at all depths": {"more": ("photosynthesis.profile=none",)},
    "the same, 75 umol m-2 s-1 in place of 50": {
        "more": ("photosynthesis.profile=none", "photosynthesis.amax=75")
    },
}


def of_fields(found: dict[str, Measured]) -> dict[str, Estimate]:
    """Ours, by the keys of PUBLISHED: of light and assimilation."""
    day, season = found["k ceres"], found["season"]
    parts = ("k", "fipar", "fapar")
    ours = {
        name: x[name.split()[0]]
        for name, x in found.items()
        if name.split()[0] in parts
    }
    ours |= {
        "transmitted": found["k dense"]["transmitted"],
        "trend": ratio(found["k 1.0"]["k"], found["k 0.2"]["k"]),
        "wide rows": ratio(found["rows 1.0"]["k"], found["rows 0.35"]["k"]),
        "narrow rows": ratio(
            found["eight, 0.7"]["k"], found["eight, 0.35"]["k"]
        ),
        "reflected": found["noon"]["reflected_fraction"],
        "efficiency": day["light_use_efficiency"],
        "clouds": ratio(
            season["light_use_efficiency"], day["light_use_efficiency"]
        ),
        "midday": noon_rate(found["july noon"]),
        "largest day": scaled(found["july"]["gross_assimilation"], 12.011),
        "one day": scaled(day["gross_assimilation"], 44.01),
    }
    return ours | {
        name: dry_matter(season)
        for name in PUBLISHED
        if name.startswith("dry matter")
    }


def of_erect_leaves(accuracy: Settings) -> dict[str, Estimate]:
    """The same, of what erect leaves do to gross assimilation [%]."""
    upper, all_15, tied_up = list(erect_leaves.VARIANTS)[2:]
    densities = (3.0, 5.0, 7.0, 9.0)
    wanted = [*((x, ROW) for x in (*densities, 16.0)), (9.0, 0.5), (9.0, 1.5)]
    wanted.append((5.93, 0.508))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        gains = pool.map(
            lambda at: erect_leaves.gains(DAY, *at, accuracy), wanted
        )
        found = {
            at: dict(zip(erect_leaves.VARIANTS, each, strict=True))
            for at, each in zip(wanted, gains, strict=True)
        }
    tops = [(x, found[x, ROW][upper]) for x in densities]
    pairs = list(pairwise(tops))
    crossing = [pair for pair in pairs if pair[0][1][0] < 0 <= pair[1][1][0]]
    change = sign_change(*(crossing or pairs)[0])
    return {
        "sign": scaled(change, PLANT_AREA),
        "tied up 9": found[9.0, ROW][tied_up],
        "tied up 16": found[16.0, ROW][tied_up],
        "erect 0.5": found[9.0, 0.5][upper],
        "erect 1.5": found[9.0, 1.5][upper],
        "lg2": found[5.93, 0.508][all_15],
    }


def verdict(ours: Estimate, told: Published) -> str:
    mean, error = ours
    if mean + 2 * error < told.low:
        return "lower"
    return "higher" if mean - 2 * error > told.high else "as published"


def shown(x: Estimate) -> str:
    """To the second digit of its error, at most the fourth after the point."""
    mean, error = x
    places = 1 - math.floor(math.log10(error)) if error else 4
    places = max(0, min(4, places))
    return f"{mean:.{places}f} ± {error:.{places}f}"


def print_comparison(ours: dict[str, Estimate]) -> None:
    rows = []
    for name, told in PUBLISHED.items():
        cells = [told.what, shown(ours[name]), told.told]
        cells += [verdict(ours[name], told), told.differs, told.source]
        rows.append(cells)
    rows.sort(key=lambda cells: cells[3] == "as published")
    titles = ["figure", "ours", "published", "ours is", "what differs"]
    print_table([*titles, "source"], rows)


def changed(name: str) -> list[Field]:
    return [
        replace(field, **CHANGES[name])
        for field in (USUAL, replace(USUAL, hours="noon"), DENSE, JULY_NOON)
    ]


def print_changes(found: dict[Field, Measured]) -> None:
    rows = []
    for name in CHANGES:
        day, noon, dense, july = (found[field] for field in changed(name))
        cells = [day["k"], noon["k"], dense["k"], day["light_use_efficiency"]]
        rows.append([name, *map(shown, [*cells, noon_rate(july)])])
    titles = [f"k, {x}, {DENSITY:g} plants m-2" for x in LIGHTS]
    titles += ["k, day, leaf area index 6", "light-use efficiency [g C MJ-1]"]
    titles.append("July noon, leaf area index 6 [umol m-2 s-1]")
    print()
    print_table(["what would change it", *titles], rows)


def by_row(rows: Sequence[float]) -> list[Field]:
    return [
        Field(row, DENSITY, azimuths, hours=hours)
        for row in rows
        for hours in LIGHTS
        for azimuths in AZIMUTHS
    ]


def by_area(areas: Sequence[float]) -> list[Field]:
    return [
        Field(ROW, area / PLANT_AREA, hours=hours)
        for area in areas
        for hours in LIGHTS
    ]


def print_rows(found: dict[Field, Measured], rows: Sequence[float]) -> None:
    titles = [f"k, {hours}, {x}" for hours in LIGHTS for x in AZIMUTHS]
    cells = []
    for row in rows:
        values = [found[field]["k"] for field in by_row([row])]
        values.append(found[Field(row, DENSITY)]["fapar"])
        models = [apsim_k(row), ceres_k(row, DENSITY)]
        cells.append(
            [
                f"{row:.2f}",
                *map(shown, values),
                *(f"{x:.2f}" for x in models),
            ]
        )
    first = f"rows [m], {DENSITY:g} plants m-2; leaves"
    print()
    print_table(
        [first, *titles, "fAPAR, day, random", "APSIM", "CERES"], cells
    )


def print_areas(found: dict[Field, Measured], areas: Sequence[float]) -> None:
    cells = []
    for area in areas:
        day, noon = (found[field] for field in by_area([area]))
        values = [day[x] for x in ("fapar", "extinction_coefficient", "k")]
        values += [noon[x] for x in ("fipar", "k")]
        density = area / PLANT_AREA
        cells.append([f"{area:g}", f"{density:.1f}", *map(shown, values)])
        cells[-1].append(f"{ceres_k(ROW, density):.2f}")
    titles = [f"leaf area index, rows of {ROW} m", "plants m-2", "fAPAR, day"]
    titles += ["k of absorbed light, day", "k, day", "fIPAR, noon", "k, noon"]
    print()
    print_table([*titles, "CERES"], cells)


def plot(
    axis: Any,
    found: dict[Field, Measured],
    x: Sequence[float],
    of: list[Field],
) -> None:
    azimuths, hours = of[0].azimuths, of[0].hours
    axis.errorbar(
        x,
        [found[field]["k"][0] for field in of],
        [found[field]["k"][1] for field in of],
        color=f"C{AZIMUTHS.index(azimuths)}",
        linestyle="-" if hours == "day" else "--",
        marker="o",
        label=f"leaves {azimuths}, {hours}",
    )


def draw(found: dict[Field, Measured], path: Path) -> None:
    figure = new_figure(9, 4)
    figure.suptitle("Does light fade in the canopy as it does in the field?")
    left, right = figure.subplots(1, 2, sharey=True)
    series = len(AZIMUTHS) * len(LIGHTS)
    for first in range(series):
        plot(left, found, ROWS, by_row(ROWS)[first::series])
    fine = np.linspace(min(ROWS), max(ROWS), 50)
    ceres = [ceres_k(x, DENSITY) for x in fine]
    left.plot(fine, [apsim_k(x) for x in fine], ":k", label="APSIM")
    left.plot(fine, ceres, "-.k", label="CERES-Maize")
    left.set_xlabel(f"distance of rows [m], {DENSITY:g} plants m-2")
    left.set_ylabel("extinction coefficient k")
    for first in range(len(LIGHTS)):
        plot(right, found, AREAS, by_area(AREAS)[first :: len(LIGHTS)])
    ceres = [ceres_k(ROW, x / PLANT_AREA) for x in AREAS]
    right.plot(AREAS, ceres, "-.k", label="CERES-Maize")
    right.axhline(apsim_k(ROW), color="k", linestyle=":", label="APSIM")
    crops = PUBLISHED["k crops"]
    right.axhspan(crops.low, crops.high, color="#D0D0D0", label="Kukal 2020")
    right.plot([6], [0.47], "kD", label="Ma 2014")
    right.set_xlabel(f"leaf area index, rows of {ROW} m")
    for axis in (left, right):
        axis.set_ylim(0, 1)
        axis.legend(fontsize=7, ncols=2, loc="lower right")
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--rough", action="store_true")
    parser.add_argument("--figure", type=Path)
    options = parser.parse_args()
    accuracy = (
        [f"final.{key}={value}" for key, value in ROUGH["final"].items()]
        if options.rough
        else []
    )
    wanted = [*FIELDS.values(), *by_row(ROWS), *by_area(AREAS)]
    for name in CHANGES:
        wanted += changed(name)
    found = measure_all(wanted, accuracy)
    ours = of_fields({name: found[field] for name, field in FIELDS.items()})
    print_comparison(ours | of_erect_leaves(accuracy))
    print_changes(found)
    print_rows(found, ROWS)
    print_areas(found, AREAS)
    if options.figure:
        draw(found, options.figure)


if __name__ == "__main__":
    guard(main)
