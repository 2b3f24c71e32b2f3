#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the canopy with maize in the field.

validation.py [--rough] [--figure FILE.png]

Evaluates the hybrid of crops/maize_hybrid.toml, whose plants differ and fail
as field plants do, in stands like those of field experiments, on the clear day
of ames.toml, around its noon, and in the season of bondville.toml, and prints
each figure beside the published one (published.py): extinction coefficients
and fractions of PAR or of all sunlight as the source has them, light-use
efficiency, canopy assimilation, and what erect leaves do to crops/maize.toml.
Figures that disagree come first; two standard errors are granted, and where a
source tells one figure without an error, 10 %. Then come what each measured
input changes, alone and together, what would change the hybrid, and extinction
coefficients k against row spacing and leaf area index. ± is half of a
95 % interval.
--rough is for tests. Plants do not grow here; growth_maps.py compares growing
seasons.

k follows from the light that reaches the soil, as in the field:
-ln(transmitted / incident) / leaf area index. `extinction_coefficient` of the
program follows from what plants absorb.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from statistics import fmean
from tempfile import TemporaryDirectory
from typing import Any

import erect_leaves
import numpy as np
from compared_fields import (
    CHANGES,
    DENSITY,
    FIELDS,
    LEAF_AREAS,
    LIGHTS,
    OF_SUNLIGHT,
    PLANES,
    ROW,
    ROWS,
    STEPS,
    by_area,
    by_row,
    changed,
    density_of,
)  # fmt: skip
from estimates import Estimate, half_interval, print_table, ratio, told
from fields import (
    DAY,
    Field,
    Measured,
    dry_matter,
    measure_all,
    noon_rate,
    of_sunlight,
    scaled,
)  # fmt: skip
from plant_shapes import THIRDS, field_of, shape_of
from published import PUBLISHED, Published, apsim_k, ceres_k
from shared import (
    FIELD_PLANTS,
    HYBRID,
    ROUGH,
    Settings,
    guard,
    parser_of,
)  # fmt: skip

from ideotype.figures.style import new_figure


def of_fields(
    found: dict[str, Measured], infrared: dict[str, Measured]
) -> dict[str, Estimate]:
    """Returns the figures of this program, by the keys of PUBLISHED for light
    and assimilation."""
    found = found | {
        name: found[name] | of_sunlight(found[name], each)
        for name, each in infrared.items()
    }
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
    """Returns the change of gross assimilation when leaves are tied up [%], as
    a mean over densities."""
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        found = [
            gains[-1]
            for gains in pool.map(
                lambda density: erect_leaves.gains(
                    DAY, density, ROW, accuracy
                ),
                (4.5, 6.0, 7.5, 9.0, 10.5),
            )
        ]
    means, errors = zip(*found, strict=True)
    return {"tied up": (fmean(means), math.hypot(*errors) / len(errors))}


def of_shapes() -> dict[str, Estimate]:
    """Returns how leaves of the hybrid are inclined in a field of 16 plants
    [deg]."""
    with TemporaryDirectory() as folder:
        shape = shape_of(
            field_of("hybrid", HYBRID, FIELD_PLANTS, Path(folder))
        )
    parts = ("all", *(f"{third} third" for third in THIRDS))
    return {
        f"inclination {part}": (float(mean), 0.0)
        for part, mean in zip(parts, shape.inclination, strict=True)
    }


def verdict(ours: Estimate, published: Published) -> str:
    mean, error = ours
    if mean + 2 * error < published.low:
        return "lower"
    return "higher" if mean - 2 * error > published.high else "as published"


def shown(x: Estimate) -> str:
    """Prints a figure to the second digit of its standard error, with at most
    four decimals."""
    error = x[1]
    places = 1 - math.floor(math.log10(error)) if error else 4
    return told(x, max(0, min(4, places)))


def print_comparison(ours: dict[str, Estimate]) -> None:
    rows = []
    for name, each in PUBLISHED.items():
        cells = [each.what, shown(ours[name]), each.told]
        cells += [verdict(ours[name], each), each.differs, each.source]
        rows.append(cells)
    rows.sort(key=lambda cells: cells[3] == "as published")
    apart = sum(cells[3] != "as published" for cells in rows)
    print(f"{apart} of {len(rows)} figures disagree\n")
    titles = ["figure", "ours", "published", "ours is", "what differs"]
    print_table([*titles, "source"], rows)


def print_changes(
    title: str,
    changes: dict[str, dict[str, Any]],
    found: dict[Field, Measured],
    steps: bool,
) -> None:
    rows = []
    for name, change in changes.items():
        day, infrared, noon, dense, july = (
            found[field] for field in changed(change, steps)
        )
        cells = [
            day["k"],
            of_sunlight(day, infrared)["k"],
            noon["k"],
            dense["k"],
        ]
        cells += [day["fapar"], day["light_use_efficiency"], noon_rate(july)]
        rows.append([name, *map(shown, cells)])
    titles = ["k of PAR, day", "k of all sunlight, day", "k of PAR, noon"]
    titles += ["k of PAR, day, leaf area index 6", "fAPAR, day"]
    titles += ["light-use efficiency [g C MJ-1]"]
    titles.append("July noon, leaf area index 6 [umol m-2 s-1]")
    print()
    print_table([title, *titles], rows)


def print_rows(found: dict[Field, Measured], rows: Sequence[float]) -> None:
    titles = [f"k, {hours}, {x}" for hours in LIGHTS for x in PLANES]
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
    print_table([first, *titles, "fAPAR, day, field", "APSIM", "CERES"], cells)


def print_areas(found: dict[Field, Measured], areas: Sequence[float]) -> None:
    cells = []
    for area in areas:
        day, noon = (found[field] for field in by_area([area]))
        values = [day[x] for x in ("fapar", "extinction_coefficient", "k")]
        values += [noon[x] for x in ("fipar", "k")]
        density = density_of(area)
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
    planes, hours = of[0].variation, of[0].hours
    axis.errorbar(
        x,
        [found[field]["k"][0] for field in of],
        [half_interval(found[field]["k"][1]) for field in of],
        color=f"C{PLANES.index(planes)}",
        linestyle="-" if hours == "day" else "--",
        marker="o",
        label=f"{planes}, {hours}",
    )


def draw(found: dict[Field, Measured], path: Path) -> None:
    figure = new_figure(9, 4)
    figure.suptitle("Does light fade in the canopy as it does in the field?")
    left, right = figure.subplots(1, 2, sharey=True)
    series = len(PLANES) * len(LIGHTS)
    for first in range(series):
        plot(left, found, ROWS, by_row(ROWS)[first::series])
    fine = np.linspace(min(ROWS), max(ROWS), 50)
    ceres = [ceres_k(x, DENSITY) for x in fine]
    left.plot(
        fine, [apsim_k(x) for x in fine], ":k", label="APSIM, all sunlight"
    )
    left.plot(fine, ceres, "-.k", label="CERES-Maize")
    left.set_xlabel(f"distance of rows [m], {DENSITY:g} plants m-2")
    left.set_ylabel("extinction coefficient k")
    for first in range(len(LIGHTS)):
        plot(
            right, found, LEAF_AREAS, by_area(LEAF_AREAS)[first :: len(LIGHTS)]
        )
    ceres = [ceres_k(ROW, density_of(x)) for x in LEAF_AREAS]
    right.plot(LEAF_AREAS, ceres, "-.k", label="CERES-Maize")
    right.plot([6], [0.47], "kD", label="Ma 2014")
    right.set_xlabel(f"leaf area index, rows of {ROW} m")
    for axis in (left, right):
        axis.set_ylim(0, 1)
        axis.legend(fontsize=7, ncols=2, loc="lower right")
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("--rough", action="store_true")
    parser.add_argument("--figure", type=Path)
    options = parser.parse_args()
    accuracy = (
        [f"final.{key}={value}" for key, value in ROUGH["final"].items()]
        if options.rough
        else []
    )
    infrared = {
        name: replace(FIELDS[name], band="nir") for name in OF_SUNLIGHT
    }
    wanted = [*FIELDS.values(), *infrared.values(), *by_row(ROWS)]
    wanted += by_area(LEAF_AREAS)
    for steps, changes in ((True, STEPS), (False, CHANGES)):
        for change in changes.values():
            wanted += changed(change, steps)
    found = measure_all(wanted, accuracy)
    ours = of_fields(
        {name: found[field] for name, field in FIELDS.items()},
        {name: found[field] for name, field in infrared.items()},
    )
    print_comparison(ours | of_shapes() | of_erect_leaves(accuracy))
    print_changes("each measured input alone", STEPS, found, steps=True)
    print_changes("what would change the hybrid", CHANGES, found, steps=False)
    print_rows(found, ROWS)
    print_areas(found, LEAF_AREAS)
    if options.figure:
        draw(found, options.figure)


if __name__ == "__main__":
    guard(main)
