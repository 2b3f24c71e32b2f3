#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws plants in their field, at eye height and from above.

draw_field.py --to FILE.png [--spacing ROW PLANT] [TITLE=]PLANT...

A PLANT is a plant or crop file (its baseline is drawn), a history (its best
plant is drawn) or a campaign (its field is drawn with all components). Plants
have the within-line variation of fields (FIELD_PLANTS in shared.py); leaves
that were measured one by one keep their angles. The colour of a leaf is its
absorbed PAR per area, face by face, on a clear 7 August at 42 deg north, in
rows along the meridian, ROW and PLANT metres apart.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import matplotlib
import numpy as np
from PIL import Image
from plant_shapes import drawn, field_of
from shared import FIELD_PLANTS, Numbers, best, campaign_of, guard

from ideotype import Mesh, Stand, mesh
from ideotype.common.labels import unit_label
from ideotype.figures.field import (
    Field,
    add_key,
    face_colors,
    shade_faces,
    show,
    view_at_eye_height,
    view_from_above,
)
from ideotype.figures.style import RC, new_figure

IN_MIDRIBS = {"insertion_angle", "curvature", "azimuth", "roll", "twist"}
"""Numbers of the variation that are left out if leaves were measured one by
one."""
SIZE = (7, 12)
"""The number of rows, and of plants in each row."""


@dataclass(frozen=True)
class Drawn:
    """A field, and the light absorbed by each of its leaf faces [MJ m-2
    day-1]."""

    field: Mesh
    light: list[float | None]
    rows: tuple[float, ...]  # Positions of rows relative to the middle [m].
    length: float  # Length of the rows [m].


def of_campaign(path: Path, folder: Path) -> tuple[Mesh, Numbers, float]:
    """Returns the field of a campaign, enlarged twofold in width and length,
    the distances between successive rows, and the length of rows [m]."""
    tables = campaign_of(path)
    field, spacing = tables["field"], tables["spacing"][0]
    pattern = np.array(field.get("row_pattern", [1.0]))
    own = field["rows"]
    for component in tables.get("component", []):
        rows = component.get("rows")
        if rows:
            component["rows"] = [*rows, *(row + own for row in rows)]
        else:
            component["mixed"] *= 4
        if "plants" in component:
            component["plants"] *= 2
    plant = spacing.get("plant") or 1 / (spacing["density"] * spacing["row"])
    field |= {"rows": 2 * own, "plants": 2 * field["plants"]}
    tables |= {
        "light": {"paths": 16, "randomisations": 4},
        "objective": {},
        "search": {"optimizer": "ga", "population": 2, "elites": 0},
        "stop": {"generations": 1},
        "final": {"candidates": 1, "paths": 16, "randomisations": 2},
    }
    steps = np.resize(pattern / pattern.mean(), 2 * own) * spacing["row"]
    return drawn(tables, folder), steps, plant * field["plants"]


def of_plant(
    plant: Path, row: float, step: float, folder: Path
) -> tuple[Mesh, Numbers, float]:
    if plant.suffix == ".h5":
        bred = Stand.from_history(plant, same_isa=False)
        crop = folder / "bred.toml"
        crop.write_text(bred.crop_file(best(plant)))
    else:
        crop = plant.resolve()
    varied: dict[str, Any] = FIELD_PLANTS
    if "midrib" in crop.read_text():
        kept = FIELD_PLANTS.keys() - IN_MIDRIBS
        varied = {name: FIELD_PLANTS[name] for name in sorted(kept)}
    field = field_of("drawn", crop, varied, folder, SIZE, (row, step))
    return field, np.full(SIZE[0], row), SIZE[1] * step


def grown(plant: Path, row: float, step: float) -> Drawn:
    with TemporaryDirectory() as name:
        is_campaign = (
            plant.suffix == ".toml" and "[[site]]" in plant.read_text()
        )
        field, steps, length = (
            of_campaign(plant, Path(name))
            if is_campaign
            else of_plant(plant, row, step, Path(name))
        )
    surfaces = mesh(field.vertices, field.faces, groups=field.groups)
    found = surfaces.evaluate(
        period=(steps.sum(), length), site=(42, -93.6, -5),
        day="2025-08-07", paths=1 << 19, by_face=True,
    )  # fmt: skip
    light = [
        float(value) if "leaf" in group else None
        for value, group in zip(found.absorbed_by_face.values, field.groups)
    ]
    places = np.cumsum([0, *steps[:-1]])
    middle = (places[0] + places[-1]) / 2
    return Drawn(field, light, tuple(places - middle), length)


def in_view(drawn: Drawn, colors: Numbers) -> Field:
    """Returns the field, shaded and centred on the middle of its rows."""
    corners = drawn.field.corners
    middle = corners[..., 0].min() + corners[..., 0].max()
    corners = corners - [middle / 2, 0, 0]
    return Field(
        corners, shade_faces(colors, corners), drawn.rows, drawn.length
    )


def main() -> None:
    parser = argparse.ArgumentParser(usage=(__doc__ or "").split("\n")[2])
    parser.add_argument("--to", type=Path, required=True)
    parser.add_argument(
        "--spacing", type=float, nargs=2, default=(0.762, 0.1524)
    )
    parser.add_argument("plants", nargs="+")
    options = parser.parse_args()
    row, step = options.spacing
    shown = {}
    for plant in options.plants:
        title, _, path = plant.rpartition("=")
        shown[title or Path(path).stem] = grown(Path(path), row, step)
    lights = [
        x for each in shown.values() for x in each.light if x is not None
    ]
    # The scale excludes the brightest 2 % of faces, which would make all
    # others dark.
    brightest = float(np.quantile(lights, 0.98))

    figure = new_figure(4.3 * len(shown), 6.4)
    grid = figure.subplots(2, len(shown), squeeze=False)
    for column, (title, each) in zip(grid.T, shown.items()):
        colors = face_colors(each.field, each.light, brightest)
        field = in_view(each, colors)
        show(column[0], view_at_eye_height(field))
        show(column[1], view_from_above(field))
        column[0].set_title(title)
    unit = unit_label("MJ m-2 day-1")
    add_key(
        figure, list(grid.ravel()), brightest,
        f"PAR that leaves absorb on a clear day [{unit} of leaf]",
    )  # fmt: skip
    figure.savefig(options.to, dpi=130)
    with Image.open(options.to) as image:
        small = image.convert("RGB").quantize(256, dither=Image.Dither.NONE)
    small.save(options.to, optimize=True)


if __name__ == "__main__":
    with matplotlib.rc_context(RC):
        guard(main)
