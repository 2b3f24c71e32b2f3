# SPDX-License-Identifier: Apache-2.0
"""Draws plants from the side and from above."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

from ..mesh.geometry import Mesh, shaded
from . import style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_TURN = np.deg2rad(30)
_LIGHT = np.array([-0.3, 0.6, 0.74])
"""The direction of the light, of length 1: right, up and towards the
viewer."""


def draw_side(axes: Axes, mesh: Mesh) -> None:
    """Draws a plant from the side, in a view 30 deg off the row."""
    _draw(axes, mesh, _side(mesh.corners))


def draw_above(axes: Axes, mesh: Mesh) -> None:
    """Draws a plant from above with the row upwards."""
    _draw(axes, mesh, mesh.corners)


def side_limits(meshes: Sequence[Mesh]) -> tuple[float, float, float]:
    """Returns left, right and top of plants from the side [m], with a
    margin."""
    across = np.concatenate([_side(mesh.vertices)[:, 0] for mesh in meshes])
    top = max(float(mesh.vertices[:, 2].max()) for mesh in meshes)
    reach = 1.03 * float(np.abs(across).max())
    return -reach, reach, 1.03 * top


def draw_plants(plants: Mapping[str, Mesh]) -> Figure:
    """Draws plants with their names from the side and from above, at one
    scale."""
    meshes = [*plants.values()]
    left, right, top = side_limits(meshes)
    every = np.vstack([mesh.vertices[:, :2] for mesh in meshes])
    reach = 1.05 * float(np.linalg.norm(every, axis=1).max())
    width = 1.9
    figure = style.new_figure(
        width * len(plants) + 0.6, width * (1 + top / (right - left)) + 0.9
    )
    grid = figure.subplots(
        2, len(plants), sharey="row", squeeze=False,
        height_ratios=(top / (right - left), 1),
    )  # fmt: skip
    for (side, above), (name, mesh) in zip(grid.T, plants.items()):
        draw_side(side, mesh)
        draw_above(above, mesh)
        side.set_title(name)
        side.set(xlim=(left, right), ylim=(0, top))
        above.set(xlim=(-reach, reach), ylim=(-reach, reach))
        above.set_xlabel("across the row [m]")
    grid[0, 0].set_ylabel("height [m]")
    grid[1, 0].set_ylabel("along the row [m]")
    return figure


def _side(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Returns points [..., 3] as right, up and towards the viewer."""
    x, y, z = np.moveaxis(points, -1, 0)
    c, s = np.cos(_TURN), np.sin(_TURN)
    return np.stack([c * x + s * y, z, s * x - c * y], axis=-1)


def _draw(axes: Axes, mesh: Mesh, corners: NDArray[np.float64]) -> None:
    """Draws faces with the given corners [faces, 4, 3]: right, up, towards the
    viewer."""
    colors = np.array(
        [to_rgb(_color(*each)) for each in zip(mesh.groups, mesh.ranks)]
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
    axes.grid(visible=False)


def _color(group: str, rank: int) -> str:
    if "dead" in group:
        return "#B08D57"
    return "#4E9A3A" if rank else style.organ_color(group)
