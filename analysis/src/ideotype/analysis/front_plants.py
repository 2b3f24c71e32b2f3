# SPDX-License-Identifier: Apache-2.0
"""Draws the plants along a front, side by side."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from numpy.typing import NDArray

from .._geometry import Mesh, shaded
from . import style
from .case import Case
from .estimate import Estimate
from .file import HistoryError
from .rows import Evaluation

_MOST = 5
_TURN = np.deg2rad(30)
_LIGHT = np.array([-0.3, 0.6, 0.74])
"""The direction of the light, of length 1: right, up and towards the
viewer."""


def draw_front_plants(
    case: Case, baseline: Mesh, members: Sequence[Mesh]
) -> Figure:
    """Draws the baseline and up to five plants of the front, at equal steps in
    the order of the first objective, from the side at one scale, with all
    objectives and their standard errors. Plants have the numbers that they
    have everywhere.

    Raises HistoryError if there is no front."""
    plants = [
        (front.one(i), case.member_title(seed, i), bool(front.is_kept[i]))
        for seed, (_, front) in enumerate(case.fronts)
        for i in range(len(front.members))
    ]
    kept = [
        (plant, mesh, name)
        for (plant, name, keeps), mesh in zip(plants, members)
        if keeps
    ]
    if not kept:
        raise HistoryError("no front is evaluated yet")
    kept.sort(key=lambda each: each[0].objective.mean)
    steps = np.linspace(0, len(kept) - 1, min(len(kept), _MOST))
    shown = [(case.baseline, baseline, "baseline")]
    shown += [kept[i] for i in dict.fromkeys(steps.round().astype(int))]
    columns = min(len(shown), 3)
    rows = -(-len(shown) // columns)
    every = np.vstack([mesh.vertices for _, mesh, _ in shown])
    top = 1.03 * every[:, 2].max()
    reach = 1.03 * max(
        np.abs(_side(mesh.vertices)[:, 0]).max() for _, mesh, _ in shown
    )
    size = 1.9 * columns
    objectives = case.best.row.goals
    words = 0.25 + 0.16 * len(objectives)
    height = size / columns * top / (2 * reach) + words
    figure = style.new_figure(size, 0.5 + rows * height)
    panels = figure.subplots(rows, columns, squeeze=False)
    for axes, (plant, mesh, name) in zip(chain(*panels), shown):
        _draw(axes, mesh)
        axes.set(xlim=(-reach, reach), ylim=(0, top))
        told = "\n".join(_objectives(plant))
        axes.set_title(f"{name}\n{told}", fontsize=8)
    for axes in chain(*panels):
        axes.set_axis_off()
    of = (
        style.axis_label(objective.name, objective.unit)
        for objective in objectives
    )
    figure.suptitle("\n".join([case.name, *of]), fontsize=10)
    return figure


def _objectives(plant: Evaluation) -> list[str]:
    return [
        _text(plant.estimate(objective.name)) for objective in plant.row.goals
    ]


def _text(of: Estimate) -> str:
    if of.standard_error == 0:
        return f"{of.mean:.3g}"
    return of.number().replace("+-", "±").replace(" ± unknown", "")


def _side(points: NDArray) -> NDArray[np.float64]:
    """Returns points [..., 3] as right, up and towards the viewer, who looks
    30 deg past the row."""
    x, y, z = np.moveaxis(points, -1, 0)
    c, s = np.cos(_TURN), np.sin(_TURN)
    return np.stack([c * x + s * y, z, s * x - c * y], axis=-1)


def _draw(axes: Axes, mesh: Mesh) -> None:
    corners = _side(mesh.corners)
    colors = np.array(
        [
            to_rgb("#4E9A3A" if g.startswith("leaf") else style.organ_color(g))
            for g in mesh.groups
        ]
    )
    order = np.argsort(corners[..., 2].mean(axis=1))
    axes.add_collection(
        PolyCollection(
            list(corners[order, :, :2]),
            facecolors=shaded(colors, corners, _LIGHT, 0.6)[order],
            edgecolors="face",
            linewidths=0.3,
            rasterized=True,
        )
    )
    axes.set_aspect("equal")
