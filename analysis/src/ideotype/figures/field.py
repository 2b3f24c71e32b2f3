# SPDX-License-Identifier: Apache-2.0
"""Draws plants in their field, as seen at eye height and from above."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize, to_rgb
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..history.case import Case
from ..history.file import HistoryError
from ..history.layout import leaf_light
from ..mesh.geometry import Mesh, shaded
from . import style

EYE = 1.6
"""The height of the eyes above the soil [m]."""

_ROWS, _PLANTS = 7, 8
_LENGTH = 1.3
"""The length of rows [m], which is shorter if rows would need more than twice
the usual number of plants."""
_STEPS_BACK = 2.5
"""The distance from the first plants of the rows to the eyes [m]."""
_WIDTH = 700
"""The width of a painted field [pixels]."""
_IN_VIEW = 1.9
"""The height of the tallest plants that are seen whole at this distance
[m]."""
_NEAREST = 0.25
"""The distance from the eyes below which nothing is drawn [m]."""
_LIGHT = np.array([-0.35, -0.45, 0.82])
"""The direction, of length 1, towards the light that shades leaves."""
_SKY = LinearSegmentedColormap.from_list("sky", ["#F4F7FA", "#9CC3E6"])
_SOIL = LinearSegmentedColormap.from_list("soil", ["#8F7459", "#C9B79C"])


@dataclass(frozen=True)
class Field:
    """Plants that stand in rows along y."""

    corners: NDArray[np.float64]
    """The corners of faces [faces, 4, 3] in metres; triangles repeat a
    corner."""
    colors: NDArray[np.float64]
    """The colours of faces [faces, 3]."""
    rows: tuple[float, ...]
    """The places of the rows across the field [m]."""
    length: float
    """The length of the rows [m]."""


def plant_field(
    mesh: Mesh,
    colors: NDArray[np.float64],
    row: float,
    plant: float,
    jitter: float,
    size: tuple[int, int],
) -> Field:
    """Returns a field with the given numbers of rows and plants per row, each
    plant turned at random by up to `jitter` [deg]; `colors` are the colours of
    the mesh's faces."""
    x, y, z = mesh.corners.transpose(2, 0, 1)
    rows = tuple(row * (i - (size[0] - 1) / 2) for i in range(size[0]))
    places = [(at, plant * j) for at in rows for j in range(size[1])]
    turns = np.random.default_rng(1).uniform(-1, 1, len(places)) * jitter
    copies = []
    for (across, along), turn in zip(places, np.deg2rad(turns)):
        c, s = np.cos(turn), np.sin(turn)
        moved = (c * x + s * y + across, c * y - s * x + along, z)
        copies.append(np.stack(moved, axis=-1))
    corners = np.concatenate(copies)
    every = np.tile(colors, (len(places), 1))
    return Field(
        corners, shade_faces(every, corners), rows, plant * (size[1] - 1)
    )


def shade_faces(
    colors: NDArray[np.float64], corners: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Returns the colours of faces, darker for faces that look away from the
    light."""
    return shaded(colors, corners, _LIGHT, 0.72)


@dataclass(frozen=True)
class View:
    """Faces on a plane, of which later faces hide earlier faces."""

    outlines: NDArray[np.float64]
    """The corners of faces on the plane [faces, 4, 2]."""
    colors: NDArray[np.float64]
    limits: tuple[float, float, float, float]
    """The limits of the plane: left, right, bottom, top."""
    horizon: float = np.inf
    """The height on the plane below which there is soil."""


def view_at_eye_height(field: Field) -> View:
    """Returns the view of the field for eyes before its rows, farther away
    from tall plants."""
    back = _STEPS_BACK * max(1, field.corners[..., 2].max() / _IN_VIEW)
    eye = np.array([-0.27 * field.rows[-1] - 0.35, -back, EYE])
    middle = np.array([0.15, 0.6 * field.length, 0.62 * EYE])
    ahead = (middle - eye) / np.linalg.norm(middle - eye)
    right = np.cross(ahead, [0, 0, 1])
    right /= np.linalg.norm(right)
    up = np.cross(right, ahead)
    at = (field.corners - eye) @ np.array([right, up, ahead]).T
    seen = at[..., 2].min(axis=1) > _NEAREST
    at, colors = at[seen], field.colors[seen]
    order = np.argsort(-np.linalg.norm(at.mean(axis=1), axis=1))
    horizon = float(-ahead[2] / np.hypot(ahead[0], ahead[1]))
    return View(
        at[order, :, :2] / at[order, :, 2:], colors[order],
        (-0.69, 0.69, -0.46, 0.46), horizon,
    )  # fmt: skip


def view_from_above(field: Field) -> View:
    """Returns the view from above on the middle of the field; plants reach
    across the edges of the view."""
    order = np.argsort(field.corners[..., 2].mean(axis=1))
    middle = field.length / 2
    half = max(min(middle, field.rows[-1] / 1.5), 0.3)
    return View(
        field.corners[order, :, :2], field.colors[order],
        (-1.5 * half, 1.5 * half, middle - half, middle + half),
    )  # fmt: skip


def show(axes: Axes, view: View) -> None:
    """Shows a view as painted pixels, because thousands of faces would make a
    PDF too large."""
    left, right, bottom, top = view.limits
    axes.set_facecolor(_SOIL(0.3))
    ramp = np.linspace(0, 1, 128)[:, None]
    for shades, low, high in (
        (_SOIL, bottom, view.horizon),
        (_SKY, view.horizon, top),
    ):
        if view.horizon < top:
            axes.imshow(
                ramp, cmap=shades, extent=(left, right, low, high),
                origin="lower", aspect="auto", gid="painted",
            )  # fmt: skip
    axes.imshow(_painted(view), extent=view.limits, gid="painted")
    axes.set(xlim=(left, right), ylim=(bottom, top), xticks=[], yticks=[])
    axes.set_aspect("equal")
    axes.grid(visible=False)
    for side in axes.spines.values():
        side.set_visible(False)


def _painted(view: View) -> NDArray[np.uint8]:
    """Returns the pixels of a view [pixels, pixels, 4]; pixels without a face
    are transparent."""
    left, right, bottom, top = view.limits
    low, high = view.outlines.min(axis=1), view.outlines.max(axis=1)
    seen = (high > (left, bottom)).all(axis=1)
    seen &= (low < (right, top)).all(axis=1)
    height = _WIDTH * (top - bottom) / (right - left)
    figure = Figure(figsize=(_WIDTH / 100, height / 100), dpi=100)
    figure.patch.set_alpha(0)
    axes = figure.add_axes(
        (0, 0, 1, 1), xlim=(left, right), ylim=(bottom, top)
    )
    axes.set_axis_off()
    # Edges close the seams between the faces of a leaf.
    axes.add_collection(
        PolyCollection(
            view.outlines[seen], facecolors=view.colors[seen],
            edgecolors="face", linewidths=0.5,
        ),
        autolim=False,
    )  # fmt: skip
    return style.pixels(figure)


def face_colors(
    mesh: Mesh, values: Sequence[float | None], brightest: float
) -> NDArray[np.float64]:
    """Returns colours [faces, 3]: viridis of 0 to `brightest`, and for faces
    without a value the colour of their organ."""
    shades = colormaps["viridis"]
    return np.array(
        [
            to_rgb(style.organ_color(group))
            if value is None
            else shades(value / brightest)[:3]
            for group, value in zip(mesh.groups, values)
        ]
    )


def add_key(
    figure: Figure, panels: Sequence[Axes], brightest: float, label: str
) -> None:
    """Adds the scale of face_colors()."""
    scale = ScalarMappable(Normalize(0, brightest), colormaps["viridis"])
    figure.colorbar(
        scale, ax=panels, location="bottom", aspect=40, shrink=0.8, label=label
    )


def draw_stand(mesh: Mesh, resolved: dict[str, Any], case: str) -> Figure:
    """Draws a field of one plant at eye height and from above, its leaves
    green; the spacing is that of a case of a resolved campaign."""
    spacings = resolved["spacing"]
    spacing = next(
        (each for each in spacings if f"_{each['name']}_" in f"{case}_"),
        spacings[0],
    )
    row, plant = spacing["row"], spacing["plant"]
    colors = np.array(
        [
            to_rgb("#4E9A3A" if rank else style.organ_color(group))
            for group, rank in zip(mesh.groups, mesh.ranks)
        ]
    )
    size = (_ROWS, int(np.clip(_LENGTH / plant, _PLANTS, 2 * _PLANTS)))
    jitter = float(resolved.get("field", {}).get("jitter", 0))
    field = plant_field(mesh, colors, row, plant, jitter, size)
    figure = style.new_figure(5.8, 2.3)
    for axes, view in zip(
        figure.subplots(1, 2),
        (view_at_eye_height(field), view_from_above(field)),
    ):
        show(axes, view)
    return figure


def draw_field(case: Case, baseline: Mesh, best: Mesh) -> Figure:
    """Draws fields of baseline and best plant; the colour of a leaf shows its
    absorbed PAR per area of leaf.

    Raises HistoryError if the history lacks this light or the distances of
    plants."""
    if case.is_over("spacing"):
        raise HistoryError("each plant is evaluated at several spacings")
    try:
        row = float(case.attributes["row_spacing"])
        plant = float(case.attributes["plant_spacing"])
    except (KeyError, ValueError):
        raise HistoryError("the history has no spacing") from None
    pairs = ((case.baseline, baseline), (case.best, best))
    lights = [leaf_light(*pair, row * plant) for pair in pairs]
    known = [x for light in lights for x in light.values() if x is not None]
    if not known:
        raise HistoryError("the history does not distinguish leaves")
    brightest = max(known)
    field = case.resolved.get("field", {})
    size = (_ROWS, int(np.clip(_LENGTH / plant, _PLANTS, 2 * _PLANTS)))
    if case.is_isolated:
        size = (int(field.get("rows", 1)), int(field.get("plants", 1)))
        size = (min(size[0], _ROWS), min(size[1], 2 * _PLANTS))
    figure = style.new_figure(style.WIDTH, 4.6)
    grid = figure.subplots(2, 2)
    for column, (_, mesh), light, name in zip(
        grid.T, pairs, lights, ("baseline", "best")
    ):
        by_face = [light[group] for group in mesh.groups]
        colors = face_colors(mesh, by_face, brightest)
        jitter = float(field.get("jitter", 0))
        stand = plant_field(mesh, colors, row, plant, jitter, size)
        show(column[0], view_at_eye_height(stand))
        show(column[1], view_from_above(stand))
        column[0].set_title(name)
    unit = style.unit_label(case.best.profile("absorbed_by_leaf").unit)
    add_key(
        figure, list(grid.ravel()), brightest,
        f"absorbed PAR [{unit} of leaf]",
    )  # fmt: skip
    light_of_best = {k: x for k, x in lights[1].items() if x is not None}
    brightest_leaf = max(light_of_best, key=lambda group: light_of_best[group])
    style.set_answer(
        figure,
        f"Leaf {int(brightest_leaf.removeprefix('leaf'))} of {len(light_of_best)} of the best "
        f"plant absorbs most per leaf area, {light_of_best[brightest_leaf]:.3g} "
        f"{style.unit_label(case.best.profile('absorbed_by_leaf').unit)}.",
    )
    return figure
