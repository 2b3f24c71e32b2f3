#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plants in their field, at eye height and from above, in the colours of light.

draw_field.py --to FILE.png [--spacing ROW PLANT] [TITLE=]PLANT...

Each PLANT is a plant or crop file, of which its baseline is drawn, or a history, of
which the best plant is. Leaves have the colour of the PAR that they absorb per area on
a clear 7 August at 42 deg north, by face, in rows along the meridian, ROW and PLANT
metres apart.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import matplotlib
import numpy as np
from draw_plants import shape_of
from PIL import Image
from shared import guard

from ideotype import mesh
from ideotype._geometry import Mesh
from ideotype.analysis.field import (
    add_key,
    at_eye_height,
    face_colors,
    from_above,
    plant_field,
    show,
)
from ideotype.analysis.style import RC, new_figure, unit_label

SIZE = (7, 12)
"""Rows, and plants of each."""
JITTER = 10
"""By which plants are turned at random [deg]."""


def light_of(plant: Mesh, row: float, step: float) -> list[float | None]:
    """Of each face of a leaf [MJ m-2 day-1]."""
    surfaces = mesh(plant.vertices, plant.faces, groups=plant.groups)
    found = surfaces.evaluate(
        period=(row, step), site=(42, -93.6, -5), day="2025-08-07",
        paths=1 << 18, by_face=True,
    )  # fmt: skip
    return [
        float(value) if group.startswith("leaf") else None
        for value, group in zip(found.absorbed_by_face.values, plant.groups)
    ]


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
        shape = shape_of(Path(path))
        shown[title or Path(path).stem] = shape, light_of(shape, row, step)
    told = [x for _, light in shown.values() for x in light if x is not None]
    # The few brightest faces would leave the others dark.
    brightest = float(np.quantile(told, 0.98))

    figure = new_figure(4.3 * len(shown), 6.4)
    grid = figure.subplots(2, len(shown), squeeze=False)
    for column, (title, (shape, light)) in zip(grid.T, shown.items()):
        colors = face_colors(shape, light, brightest)
        field = plant_field(shape, colors, row, step, JITTER, SIZE)
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
