#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws plants from the side and from above, at one scale.

draw_plants.py --to FILE.png [TITLE=]PLANT...

A PLANT is a plant or crop file (its baseline is drawn) or a history (its best
plant is drawn). The view from the side is 30 deg off the row.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from shared import ANYWHERE, best, guard

from ideotype import Mesh, Stand
from ideotype.figures.style import new_figure

COLORS = {"leaf": "#4E9A3A", "sheath": "#A3B57E", "stalk": "#A98F62"}
TURN = np.deg2rad(30)
LIGHT = np.array([-0.3, 0.6, 0.74])
"""The direction of the light, of length 1: right, up and towards the
viewer."""


def shape_of(plant: Path) -> Mesh:
    if plant.suffix == ".h5":
        return Stand.from_history(plant, same_isa=False).mesh(best(plant))
    stand = Stand({**ANYWHERE, "plant": {"baseline": str(plant.resolve())}})
    return stand.mesh(stand.baseline)


def draw(axes: Axes, mesh: Mesh, is_side: bool, turn: float = TURN) -> None:
    x, y, z = mesh.vertices.T
    if is_side:
        c, s = np.cos(turn), np.sin(turn)
        x, y, z = c * x + s * y, z, s * x - c * y
    corners = [np.array([x, y, z]).T[list(face)] for face in mesh.faces]
    normals = np.array([np.cross(c[1] - c[0], c[2] - c[0]) for c in corners])
    cosine = np.abs(normals @ LIGHT) / np.linalg.norm(normals, axis=1)
    shade = 0.55 + 0.45 * cosine
    kinds = [group.split("_")[0].rstrip("0123456789") for group in mesh.groups]
    colors = (
        np.array([to_rgb(COLORS[kind]) for kind in kinds]) * shade[:, None]
    )
    # Faces closer to the viewer are drawn over those behind.
    order = np.argsort([c[:, 2].mean() for c in corners])
    axes.add_collection(
        PolyCollection(
            [corners[i][:, :2] for i in order],
            facecolors=colors[order],
            edgecolors="face",
            linewidths=0.3,
        )
    )
    axes.set_aspect("equal")
    axes.grid(visible=False)


def main() -> None:
    parser = argparse.ArgumentParser(usage=(__doc__ or "").split("\n")[2])
    parser.add_argument("--to", type=Path, required=True)
    parser.add_argument("plants", nargs="+")
    options = parser.parse_args()
    shown = {}
    for plant in options.plants:
        title, _, path = plant.rpartition("=")
        shown[title or Path(path).stem] = shape_of(Path(path))

    every = np.vstack([mesh.vertices for mesh in shown.values()])
    reach = 1.05 * np.hypot(every[:, 0], every[:, 1]).max()
    top = 1.05 * every[:, 2].max()
    width = 1.9 * len(shown) + 0.6
    figure = new_figure(width, 1.72 * (1 + top / reach / 2) + 0.9)
    grid = figure.subplots(
        2, len(shown), sharex=True, sharey="row", squeeze=False,
        height_ratios=(top, 2 * reach),
    )  # fmt: skip
    for (side, above), (title, mesh) in zip(grid.T, shown.items()):
        draw(side, mesh, is_side=True)
        draw(above, mesh, is_side=False)
        side.set_title(title, fontsize=9)
        above.set_xlabel("across the row [m]")
    grid[0, 0].set(ylim=(0, top), ylabel="height [m]")
    grid[1, 0].set(
        xlim=(-reach, reach), ylim=(-reach, reach), ylabel="along the row [m]"
    )
    figure.savefig(options.to, dpi=150, pil_kwargs={"optimize": True})


if __name__ == "__main__":
    guard(main)
