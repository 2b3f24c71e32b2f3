# SPDX-License-Identifier: Apache-2.0
"""Draws the angles of leaves for the manual."""

from __future__ import annotations

from typing import Any

import numpy as np
from draw_plants import draw
from drawn_plants import INK, MARK, Shapes, bare, show_side
from matplotlib.figure import Figure
from matplotlib.patches import Arc

from ideotype import Mesh
from ideotype.figures.style import new_figure


def azimuth(shapes: Shapes) -> Figure:
    """Draws azimuths seen from above, with a compass."""
    figure = new_figure(5.2, 2.9)
    left, right = figure.subplots(1, 2)
    directions = (0, 45, 90, 180, 270)

    def five(crop: dict[str, Any]) -> None:
        leaves = crop["leaf"][2:7]
        for leaf, direction in zip(leaves, directions):
            leaf["azimuth"] = direction
        crop["leaf"] = leaves
        del crop["organ"]

    plant = shapes.maize(five)
    draw(left, plant, is_side=False)
    for direction in directions:
        a = np.deg2rad(direction)
        left.annotate(
            f"{direction}°", (0.74 * np.sin(a) + 0.09, 0.74 * np.cos(a)),
            ha="center", va="center", color=MARK, fontsize=10,
        )  # fmt: skip
    left.plot([0, 0], [-0.85, 0.85], color=INK, lw=0.8, ls="--", zorder=0)
    left.text(0.02, -0.86, "the row", fontsize=8, color=INK, va="top")
    left.annotate(
        "", (0.40, 0.62), (0.10, 0.82), color=MARK,
        arrowprops={
            "arrowstyle": "->", "color": MARK, "connectionstyle": "arc3,rad=-0.25"
        },
    )  # fmt: skip
    left.set(xlim=(-0.95, 0.95), ylim=(-0.98, 0.95))
    left.set_title("azimuth of a leaf")
    bare(left)

    # The row runs from west to east: its direction is 90 deg clockwise from
    # north.
    right.plot([-0.8, 0.8], [0, 0], color=INK, lw=0.8, ls="--", zorder=0)
    for x in (-0.6, -0.2, 0.2, 0.6):
        right.plot(x, 0, "o", color="#4E9A3A", ms=9)
    right.annotate(
        "",
        (0, 0.85),
        (0, 0.12),
        arrowprops={"arrowstyle": "-|>", "color": INK},
    )
    right.text(0, 0.88, "north", ha="center", va="bottom", color=INK)
    right.add_patch(
        Arc((0, 0.0), 0.8, 0.8, theta1=0, theta2=90, color=MARK, lw=1.5)
    )
    right.text(0.36, 0.34, "row_direction\n90°", color=MARK, fontsize=9)
    right.annotate(
        "azimuth 0°", (0.84, 0), (0.84, -0.22), ha="center", color=MARK,
        fontsize=9, arrowprops={"arrowstyle": "-", "color": MARK},
    )  # fmt: skip
    right.text(
        0, -0.42, "azimuth 90°: south", color=MARK, ha="center", fontsize=9
    )
    right.annotate(
        "",
        (0, -0.36),
        (0, -0.06),
        arrowprops={"arrowstyle": "->", "color": MARK},
    )
    right.set(xlim=(-1.05, 1.15), ylim=(-0.98, 0.98))
    right.set_title("direction of a row")
    bare(right)
    return figure


def insertion_angle(shapes: Shapes) -> Figure:
    figure = new_figure(4.8, 2.1)
    grid = figure.subplots(1, 4, sharex=True, sharey=True)
    for axes, angle in zip(grid, (10, 30, 60, 90)):
        show_side(axes, shapes.single_leaf(insertion_angle=angle, curvature=0))
        axes.plot([0, 0], [0.35, 0.75], color=MARK, lw=0.8, ls="--")
        axes.add_patch(
            Arc((0, 0.35), 0.5, 0.5, theta1=90 - angle, theta2=90, color=MARK)
        )
        axes.set_title(f"{angle}°")
        bare(axes)
    grid[0].set(xlim=(-0.12, 0.78), ylim=(0, 1.1))
    return figure


def curvature(shapes: Shapes) -> Figure:
    figure = new_figure(4.8, 2.1)
    grid = figure.subplots(1, 4, sharex=True, sharey=True)
    for axes, bend in zip(grid, (0, 45, 90, 140)):
        show_side(axes, shapes.single_leaf(curvature=bend))
        axes.set_title(f"{bend}°")
        bare(axes)
    grid[0].set(xlim=(-0.12, 0.6), ylim=(0, 1.0))
    return figure


def folding(shapes: Shapes) -> Figure:
    """Draws a blade along the midrib of a level leaf: the V of the blade."""
    figure = new_figure(4.8, 1.2)
    grid = figure.subplots(1, 3, sharex=True, sharey=True)
    for axes, angle in zip(grid, (0, 10, 40)):
        mesh = shapes.single_leaf(
            angle, insertion_angle=90, curvature=0, azimuth=0
        )
        blade = [i for i, group in enumerate(mesh.groups) if group != "stalk"]
        blade_alone = Mesh(
            mesh.vertices,
            tuple(mesh.faces[i] for i in blade),
            tuple(mesh.groups[i] for i in blade),
        )
        show_side(axes, blade_alone)
        axes.plot([0, 0.06], [0.35, 0.35], color=MARK, lw=0.8, ls="--")
        if angle:
            axes.add_patch(
                Arc((0, 0.35), 0.08, 0.08, theta1=0, theta2=angle, color=MARK)
            )
        axes.set_title(f"{angle}°")
        bare(axes)
    grid[0].set(xlim=(-0.07, 0.07), ylim=(0.33, 0.40))
    return figure
