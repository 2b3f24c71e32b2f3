#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plants in their field, at eye height and from above, in the colours of light.

draw_field.py --to FILE.png [--spacing ROW PLANT] [TITLE=]PLANT...

Each PLANT is a plant or crop file, of which its baseline is drawn, or a history, of
which the best plant is. Plants differ as those of fields do (FIELD_PLANTS in shared.py); leaves
that were measured one by one keep their angles. Leaves have the colour of the PAR that they
absorb per area on a clear 7 August at 42 deg north, by face, in rows along the meridian,
ROW and PLANT metres apart.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import matplotlib
import numpy as np
from PIL import Image
from plant_shapes import field_of
from shared import FIELD_PLANTS, Numbers, best, guard

from ideotype import Stand, mesh
from ideotype._geometry import Mesh
from ideotype.analysis.field import (
    Field,
    add_key,
    at_eye_height,
    face_colors,
    from_above,
    lit,
    show,
)
from ideotype.analysis.style import RC, new_figure, unit_label

IN_MIDRIBS = {"insertion_angle", "curvature", "azimuth", "roll", "twist"}
"""What does not vary of plants whose leaves were each measured."""
SIZE = (7, 12)
"""Rows, and plants of each."""


def grown(
    plant: Path, row: float, step: float
) -> tuple[Mesh, list[float | None]]:
    """The field of a plant, and the light on each of its faces that is of a
    leaf [MJ m-2 day-1]."""
    with TemporaryDirectory() as name:
        folder = Path(name)
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
    surfaces = mesh(field.vertices, field.faces, groups=field.groups)
    found = surfaces.evaluate(
        period=(SIZE[0] * row, SIZE[1] * step), site=(42, -93.6, -5),
        day="2025-08-07", paths=1 << 19, by_face=True,
    )  # fmt: skip
    light = [
        float(value) if "leaf" in group else None
        for value, group in zip(found.absorbed_by_face.values, field.groups)
    ]
    return field, light


def in_view(field: Mesh, colors: Numbers, row: float, step: float) -> Field:
    """The field about the middle of its rows, shaded."""
    corners = field.corners
    middle = corners[..., 0].min() + corners[..., 0].max()
    corners = corners - [middle / 2, 0, 0]
    rows = tuple(row * (i - (SIZE[0] - 1) / 2) for i in range(SIZE[0]))
    return Field(corners, lit(colors, corners), rows, step * (SIZE[1] - 1))


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
    told = [x for _, light in shown.values() for x in light if x is not None]
    # The few brightest faces would leave the others dark.
    brightest = float(np.quantile(told, 0.98))

    figure = new_figure(4.3 * len(shown), 6.4)
    grid = figure.subplots(2, len(shown), squeeze=False)
    for column, (title, (shape, light)) in zip(grid.T, shown.items()):
        colors = face_colors(shape, light, brightest)
        field = in_view(shape, colors, row, step)
        show(column[0], at_eye_height(field))
        show(column[1], from_above(field))
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
