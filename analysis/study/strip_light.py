#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares light in strips of maize and soybean with reports of fields.

strip_light.py [--table FILE.csv] [--rough]

Compares the light in strips that abstracts report with that of this program,
by sign and size; nothing is fitted. Maize is crops/maize.toml. Soybean at a
stage is crops/soybean.toml with as many of its leaves as the stage has; all
lengths are multiplied by the factor that makes its stem as high as the sum of
internodes (DSSAT, as in that file). Days are clear, of Chengdu. The table
marks assumptions where a report is silent: "rows" for distances between rows,
"stage" for the stage. ± is half of a 95 % interval over randomisations.
--table compares light that was measured by row instead;
measured/strips/README.md describes its form. --rough is for tests.
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Sequence
from datetime import date, time
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pandas as pd
import tomli_w
from estimates import Estimate, plus_minus, print_table
from shared import CAMPAIGNS, MAIZE, guard, parser_of

from ideotype import Stand

SOYBEAN = CAMPAIGNS / "crops" / "soybean.toml"
#: Properties of soybean at stages: trifoliate nodes, stem height [m], and days
#: on which it reaches the stage between maize that was sown two months
#: earlier.
STAGES = {
    "V2": (2, 0.134, date(2017, 6, 25)),
    "V5": (5, 0.308, date(2017, 7, 5)),
    "R1": (9, 0.553, date(2017, 7, 25)),
}
SITE = {
    "name": "chengdu",
    "latitude": 30.7,
    "longitude": 104.0,
    "utc_offset": 7,
}


def soybean_at(stage: str, folder: Path) -> Path:
    """Writes a crop file of soybean at a stage, and returns its path."""
    nodes, height, _ = STAGES[stage]
    crop = tomllib.loads(SOYBEAN.read_text())
    crop["leaf"] = crop["leaf"][:nodes]
    factor = height / sum(leaf["internode"] for leaf in crop["leaf"])
    for leaf in crop["leaf"]:
        for key in ("length", "width", "internode", "petiole_length"):
            leaf[key] *= factor
    crop["blade"]["rachis_length"] *= factor
    for key in ("base_diameter", "top_diameter"):
        crop["stalk"][key] *= factor
    crop["petiole"]["diameter"] *= factor
    crop["name"] = f"soybean_{stage}"
    del crop["trait"]
    path = folder / f"{stage}.toml"
    path.write_text(tomli_w.dumps(crop))
    return path


class Strips:
    """Stands of maize with soybean in some rows."""

    def __init__(self, folder: Path, rough: bool) -> None:
        self._folder = folder
        accuracy = {"randomisations": 32}
        self._points = 512
        if rough:
            accuracy = {"paths": 2048, "randomisations": 4}
            self._points = 32
        self._light = {"light": accuracy}

    def stand(
        self,
        pattern: Sequence[float],
        plant: float,
        *,
        crop: Path = MAIZE,
        soybean: Sequence[int] = (),
        stage: str = "R1",
        direction: float = 0,
    ) -> Stand:
        """Returns rows at the given distances [m]. Plants of maize are `plant`
        apart [m]; some rows are soybean, with plants 0.10 m apart."""
        length = 0.6  # Approximate length of the cell along the rows [m].
        tables: dict[str, Any] = {
            "name": "strip",
            "seed": 1,
            "site": [SITE],
            "day": [
                {"date": STAGES[stage][2], "start": time(7), "end": time(19)}
            ],
            "spacing": [
                {
                    "row": float(np.mean(pattern)),
                    "plant": plant,
                    "row_direction": direction,
                }
            ],
            "field": {
                "rows": len(pattern),
                "plants": round(length / plant),
                "row_pattern": list(pattern),
                "variation": {"azimuth": 20, "insertion_angle": 10},
            },
            "plant": {"baseline": str(crop)},
            "objective": {"maximise": "absorbed_par"},
            **self._light,
        }
        if soybean:
            tables["component"] = [
                {
                    "name": "soybean",
                    "crop": str(soybean_at(stage, self._folder)),
                    "rows": list(soybean),
                    "plants": round(length / 0.1),
                    "jitter": 180,
                }
            ]
        return Stand(tables)

    def at(self, stand: Stand, height: float, position: float) -> Estimate:
        """Returns the fraction of the day's light at a height and at a
        distance from a row [m]."""
        found = stand.light_at(
            stand.baseline, height, position, points=self._points
        ).isel(sensor=0)
        part = found.incident / found.incident.sum()
        error = float(
            np.sqrt(((part * found.fraction_standard_error) ** 2).sum())
        )
        return float((part * found.fraction).sum()), error

    def by_row(self, stand: Stand) -> list[Estimate]:
        """Returns the light absorbed by the leaves of each row, per length of
        row."""
        found = stand.evaluate(stand.baseline, final=True).isel(plant=0)
        width = found.row_width
        means = found.absorbed_light_by_row * width
        errors = found.absorbed_light_by_row_standard_error * width
        return list(
            zip(means.values.tolist(), errors.values.tolist(), strict=True)
        )


def total(rows: Sequence[Estimate]) -> Estimate:
    """Returns the sum over rows, with errors treated as independent."""
    return sum(x for x, _ in rows), math.hypot(*(e for _, e in rows))


def more(a: Estimate, b: Estimate) -> str:
    """Formats the excess of a over b [%]."""
    ratio = a[0] / b[0]
    error = ratio * math.hypot(a[1] / a[0], b[1] / b[0])
    return plus_minus((100 * ratio - 100, 100 * error), 0, "+")


def above_soybean(strips: Strips) -> list[list[str]]:
    """Compares the light above soybean between full-grown maize in strips of
    two rows and in alternate rows, at equal maize densities."""
    rows = []
    for stage, reported in (("V2", "+218"), ("V5", "+160"), ("R1", "+172")):
        height = STAGES[stage][1]
        # Soybean is 1.0 m from the more distant row of maize on each side.
        two = strips.stand((0.4, 1.6), 0.2, stage=stage)
        one = strips.stand((1.0, 1.0), 0.2, stage=stage)
        found = more(strips.at(two, height, 1.0), strips.at(one, height, 0.5))
        rows.append(
            [
                f"above soybean at {stage}, 2M2S over 1M1S (PMC6391028)",
                reported,
                found,
                "",
            ]
        )
    return rows


def of_maize(strips: Strips) -> list[str]:
    """Compares the light of maize in strips, before soybean has grown, with
    that of sole maize at equal densities."""
    strip = strips.stand((0.4, 1.6), 0.2, stage="V2")
    alone = strips.stand((0.7, 0.7), 0.2 / 0.7, stage="V2")
    in_strip = total(strips.by_row(strip))
    sole = total(strips.by_row(alone))
    land = 2.0 / 1.4  # The ratio of the areas of the two cells.
    scaled = (sole[0] * land, sole[1] * land)
    return [
        "all maize leaves, 2M2S over sole (PMC6391028: those at wide rows)",
        "+27, +20, +16",
        more(in_strip, scaled),
        "rows of sole",
    ]


def of_strips(strips: Strips) -> list[str]:
    """Compares the light of soybean in strips with that in alternate rows, at
    equal densities of both crops."""
    strip = strips.stand((0.4, 0.6, 0.4, 0.6), 0.2, soybean=(3, 4))
    alternate = strips.stand((0.5, 0.5), 0.2, soybean=(2,))
    a = total(strips.by_row(strip)[2:])
    b = total(strips.by_row(alternate)[1:])
    return [
        "soybean at R1, strips over alternate rows (pone.0169218)",
        "+35",
        more((a[0] / 2, a[1] / 2), b),
        "rows, stage",
    ]


def southernmost(strips: Strips) -> list[str]:
    """Compares the light of the southernmost of three soybean rows, which
    maize to its south shades, with that of the same rows without maize."""
    between = strips.stand(
        (0.4, 0.6, 0.3, 0.3, 0.6), 0.2, soybean=(3, 4, 5), direction=90
    )
    with TemporaryDirectory() as folder:
        bare = strips.stand(
            (0.3, 0.3, 1.6),
            0.1,
            crop=soybean_at("R1", Path(folder)),
            direction=90,
        )
        alone = strips.by_row(bare)
    shaded = strips.by_row(between)[2:]
    # Of the two outer rows, the southern one has less light.
    worst = int(np.argmin([shaded[0][0], shaded[2][0]])) * 2
    return [
        "southernmost row of soybean at R1, rows east to west, to maize "
        "(Li 2023: direct light)",
        "-52 to -57",
        more(shaded[worst], alone[worst]),
        "rows, stage",
    ]


def compare(path: Path) -> None:
    """Prints measured and computed light by row, and their agreement."""
    measured_light = pd.read_csv(path, comment="#")
    rows, pairs = [], []
    for campaign, part in measured_light.groupby("campaign", sort=False):
        stand = Stand.from_campaign(path.parent / str(campaign))
        found = stand.evaluate(stand.baseline, final=True).isel(plant=0)
        light = found.absorbed_light_by_row / found.incident
        error = found.absorbed_light_by_row_standard_error / found.incident
        for each in part.itertuples():
            i = int(each.row) - 1
            pairs.append((each.fraction, float(light[i])))
            rows.append(
                [
                    f"{campaign} {found.field_row.values[i]}",
                    f"{each.fraction:.3f}",
                    plus_minus((float(light[i]), float(error[i])), 3),
                ]
            )
    print_table(["row", "measured", "computed"], rows)
    measured, computed = np.array(pairs).T
    residual = float(((measured - computed) ** 2).sum())
    spread = float(((measured - measured.mean()) ** 2).sum())
    print(f"\nmean difference {np.mean(computed - measured):+.3f}", end="")
    print(
        f", R2 about the line 1:1 {1 - residual / spread:.2f}"
        if spread
        else ""
    )


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("--table", type=Path)
    parser.add_argument("--rough", action="store_true")
    options = parser.parse_args()
    if options.table:
        compare(options.table)
        return
    with TemporaryDirectory() as folder:
        strips = Strips(Path(folder), options.rough)
        rows = [
            *above_soybean(strips),
            of_maize(strips),
            of_strips(strips),
            southernmost(strips),
        ]
    print_table(
        ["light", "reported [%]", "here [%]", "not told by the report"], rows
    )


if __name__ == "__main__":
    guard(main)
