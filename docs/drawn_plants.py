# SPDX-License-Identifier: Apache-2.0
"""Draws leaves, plants and fields for the manual."""

from __future__ import annotations

import copy
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from draw_plants import draw
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from shared import ANYWHERE

from ideotype import Mesh, Stand
from ideotype.figures.style import new_figure

DOCS = Path(__file__).resolve().parent

ROW, PLANT = 0.76, 0.15
"""Distances between rows and between plants in a row [m]."""
INK, MARK = "#333333", "#D55E00"

Change = Callable[[dict[str, Any]], None]


class Shapes:
    """Plants by crop file, as the program makes them."""

    def __init__(self) -> None:
        self._maize = tomllib.loads(
            (DOCS.parent / "campaigns/crops/maize.toml").read_text()
        )

    def mesh_crop(self, crop: dict[str, Any]) -> Mesh:
        """Returns the plant of a crop in metres."""
        # A campaign needs a trait, here one with a range that includes 1.
        crop = {key: crop[key] for key in crop if key != "bounds"}
        crop["trait"] = [
            {
                "name": "height", "per": "plant", "unit": "1",
                "scales": ["stalk.height"], "range": [0.5, 1.5],
            }
        ]  # fmt: skip
        stand = Stand({**ANYWHERE, "plant": {"baseline": crop}})
        return stand.mesh(stand.baseline)

    def maize(self, change: Change = lambda crop: None) -> Mesh:
        crop = copy.deepcopy(self._maize)
        change(crop)
        return self.mesh_crop(crop)

    def single_leaf(self, folding_angle: float = 10, **leaf: float) -> Mesh:
        """Returns a leaf of 70 cm on a short stalk, to the right."""
        crop = {
            "name": "leaf",
            "stalk": {"height": 0.5, "base_diameter": 0.02},
            "blade": {"folding_angle": folding_angle},
            "leaf": [
                {
                    "length": 0.7, "width": 0.085, "insertion_angle": 30,
                    "curvature": 60, "azimuth": 90, "insertion_height": 0.35,
                    **leaf,
                }
            ],
        }  # fmt: skip
        return self.mesh_crop(crop)


def turned(mesh: Mesh, angle: float) -> Mesh:
    """Turns a mesh clockwise, seen from above [deg]."""
    c, s = np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))
    x, y, z = mesh.vertices.T
    return Mesh(
        np.array([c * x + s * y, c * y - s * x, z]).T, mesh.faces, mesh.groups
    )


def bare(axes: Axes) -> None:
    axes.set_aspect("equal")
    axes.axis("off")


def show_side(axes: Axes, mesh: Mesh) -> None:
    """Shows a mesh from the south: right is across the rows."""
    draw(axes, mesh, is_side=True, turn=0.0)


def cell(shapes: Shapes) -> Figure:
    """Draws a field from above, and how it repeats."""
    figure = new_figure(5.2, 2.1)
    left, right = figure.subplots(1, 2, width_ratios=(4.2, 2.6))
    plant = shapes.maize()
    rng = np.random.default_rng(1)
    turns = rng.uniform(-10, 10, (2, 2))
    for axes, copies in ((left, range(-1, 2)), (right, range(1))):
        for i in copies:
            for j in copies:
                for row in range(2):
                    for slot in range(2):
                        mesh = turned(plant, turns[row, slot])
                        # Rows stand apart in x, plants in y.
                        shift = [
                            ((i * 2) + row) * ROW, ((j * 2) + slot) * 2 * PLANT, 0
                        ]  # fmt: skip
                        moved = Mesh(
                            mesh.vertices + shift, mesh.faces, mesh.groups
                        )
                        draw(axes, moved, is_side=False)
        axes.add_patch(
            Rectangle(
                (-ROW / 2, -PLANT), 2 * ROW, 4 * PLANT,
                fill=False, color=MARK, lw=1.6, zorder=5,
            )
        )  # fmt: skip
        bare(axes)
    # Copies are pale.
    for x, y, width, height in (
        (-3, -3, 9, 3 - PLANT), (-3, 3 * PLANT, 9, 3),
        (-3, -PLANT, 3 - ROW / 2, 4 * PLANT),
        (1.5 * ROW, -PLANT, 3, 4 * PLANT),
    ):  # fmt: skip
        left.add_patch(
            Rectangle((x, y), width, height, color="white", alpha=0.55, lw=0)
        )
    left.set(xlim=(-1.7, 2.5), ylim=(-0.85, 1.15))
    left.set_title('boundary = "periodic"')
    right.set(xlim=(-0.9, 1.7), ylim=(-0.85, 1.15))
    right.set_title('boundary = "isolated"')
    return figure


def traits(shapes: Shapes) -> Figure:
    """Draws the effect of each trait on the shape of maize."""

    def scale(key: str, factor: float) -> Change:
        def change(crop: dict[str, Any]) -> None:
            for leaf in crop["leaf"]:
                leaf[key] *= factor

        return change

    def put(key: str, values: Callable[[int], float]) -> Change:
        def change(crop: dict[str, Any]) -> None:
            for i, leaf in enumerate(crop["leaf"]):
                leaf[key] = values(i)

        return change

    def taller(crop: dict[str, Any]) -> None:
        scale("insertion_height", 1.2)(crop)
        crop["stalk"]["height"] *= 1.2

    def no_organs(crop: dict[str, Any]) -> None:
        for organ in crop["organ"]:
            organ["present"] = False

    shown: list[tuple[str, Change]] = [
        ("baseline", lambda crop: None),
        ("length × 0.7", scale("length", 0.7)),
        ("width × 1.4", scale("width", 1.4)),
        ("insertion_angle 60", put("insertion_angle", lambda i: 60)),
        ("curvature × 0.3", scale("curvature", 0.3)),
        ("height × 1.2", taller),
        ("azimuth 0, 180", put("azimuth", lambda i: 180.0 * (i % 2))),
        ("azimuth, a spiral", put("azimuth", lambda i: 137.5 * i % 360)),
        ("organs absent", no_organs),
    ]
    figure = new_figure(4.4, 9.4)
    grid = figure.subplots(
        6, 3, sharex=True, sharey="row", height_ratios=(2.5, 1.5) * 3
    )
    for i, (title, change) in enumerate(shown):
        mesh = shapes.maize(change)
        side, above = grid[i // 3 * 2 : i // 3 * 2 + 2, i % 3]
        draw(side, mesh, is_side=True)
        draw(above, mesh, is_side=False)
        side.set_title(title, fontsize=9)
        bare(side)
        bare(above)
        side.set(xlim=(-0.75, 0.75), ylim=(0, 2.5))
        above.set(ylim=(-0.75, 0.75))
    return figure
