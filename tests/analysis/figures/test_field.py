# SPDX-License-Identifier: Apache-2.0
"""Plants are drawn in their field."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from made_history import MadeHistory
from made_numbers import LEAVES, final_absorbed, leaf_share
from matplotlib import colormaps
from matplotlib.figure import Figure

from ideotype import Mesh
from ideotype.figures.field import (
    EYE,
    View,
    draw_field,
    face_colors,
    plant_field,
    show,
    view_at_eye_height,
    view_from_above,
)
from ideotype.history import HistoryError, open_study
from ideotype.report.scene import build_plants

MAST = Mesh(
    np.array(
        [[-0.1, 0, 0], [0.1, 0, 0], [0.1, 0, 3], [-0.1, 0, 3], [0, 0.2, 1.0]]
    ),
    ((0, 1, 2, 3), (0, 1, 4)),
    ("stalk", "leaf01"),
    (0, 1),
)
"""A mast that is higher than the eyes, and a leaf."""


def test_plants_stand_in_rows_and_are_turned() -> None:
    colors = face_colors(MAST, [None, 2.0], 4.0)
    assert colors[1] == pytest.approx(colormaps["viridis"](0.5)[:3])
    field = plant_field(MAST, colors, 0.7, 0.2, 10.0, (3, 4))
    assert field.corners.shape == (3 * 4 * 2, 4, 3)
    assert field.rows == pytest.approx((-0.7, 0, 0.7))
    assert field.length == pytest.approx(0.6)
    masts = field.corners[::2]
    feet = masts[:, :2].mean(axis=1)
    assert feet[:, 0] == pytest.approx(np.repeat(field.rows, 4))
    assert feet[:, 1] == pytest.approx(np.tile([0, 0.2, 0.4, 0.6], 3))
    across = masts[:, 1] - masts[:, 0]
    turns = np.rad2deg(np.arctan2(across[:, 1], across[:, 0]))
    assert 0 < np.abs(turns).max() <= 10 and len(set(turns.round(6))) == 12
    # Each colour is a shade of the leaf colour.
    shades = field.colors[1::2] / colors[1]
    assert np.ptp(shades, axis=1) == pytest.approx(0)
    assert shades.min() >= 0.72 and shades.max() <= 1


def test_points_above_eye_height_are_above_the_horizon() -> None:
    colors = face_colors(MAST, [None, 1.0], 1.0)
    view = view_at_eye_height(plant_field(MAST, colors, 0.7, 0.2, 0.0, (3, 4)))
    assert view.limits[2] < view.horizon < view.limits[3]
    is_mast = [not np.allclose(quad[2], quad[3]) for quad in view.outlines]
    masts = view.outlines[is_mast]
    assert len(masts) == 12
    for quad in masts:
        foot, top = quad[1], quad[2]
        assert foot[1] < view.horizon < top[1]
        # The horizon crosses the mast approximately at eye height.
        part = (view.horizon - foot[1]) / (top[1] - foot[1])
        assert part == pytest.approx(EYE / 3, abs=0.1)
    # The nearest mast, which is the largest, is drawn last.
    heights = [quad[2, 1] - quad[1, 1] for quad in masts]
    assert heights[-1] == max(heights) > 1.2 * min(heights)


def test_from_above_higher_faces_hide_lower_ones() -> None:
    colors = face_colors(MAST, [None, 0.5], 1.0)
    field = plant_field(MAST, colors, 0.7, 0.4, 0.0, (3, 4))
    view = view_from_above(field)
    is_leaf = np.ptp(view.colors, axis=1) > 0.1
    # Leaves are below masts, which are grey.
    assert is_leaf[:12].all() and not is_leaf[12:].any()
    left, right, bottom, top = view.limits
    assert (left + right, bottom + top) == pytest.approx((0, field.length))


def test_a_view_is_painted_over_sky_and_soil() -> None:
    green = np.tile([0.0, 1.0, 0.0], (1, 1))
    square = np.array([[[0, 0], [2, 0], [2, 2], [0, 2]]], float)
    axes = Figure().add_subplot()
    show(axes, View(square, green, (-2.0, 2.0, -2.0, 2.0), 1.0))
    soil, sky, faces = axes.images
    assert soil.get_extent() == [-2, 2, -2, 1]
    assert sky.get_extent() == [-2, 2, 1, 2]
    painted = np.asarray(faces.get_array())
    # Pixel rows count from the top.
    height, width, _ = painted.shape
    green_part = painted[2 : height // 2 - 2, width // 2 + 2 : -2]
    assert np.all(green_part == (0, 255, 0, 255))
    assert not painted[height // 2 + 2 :, :, 3].any()
    assert not painted[:, : width // 2 - 2, 3].any()


def test_leaves_have_the_colour_of_their_light(sweep: Path) -> None:
    with open_study(sweep) as study:
        case = study.cases()[0]
        plants = build_plants(case)
        figure = draw_field(case, plants.baseline, plants.best)
    assert len(figure.axes) == 5
    assert [axes.get_title() for axes in figure.axes[:2]] == [
        "baseline",
        "best",
    ]
    key = figure.axes[-1]
    assert key.get_xlabel() == "absorbed PAR [MJ m⁻² day⁻¹ of leaf]"
    ground = 0.762 * 0.1524
    brightest = max(
        ground * leaf_share(n) * total / mesh.area(f"leaf{n:02}")
        for n in range(1, LEAVES + 1)
        for total, mesh in (
            (final_absorbed(0), plants.baseline),
            (case.best.objective.mean, plants.best),
        )
    )
    assert key.get_xlim() == pytest.approx((0, brightest))


def test_a_history_without_spacing_has_no_field_figure(tmp_path: Path) -> None:
    path = tmp_path / "case.h5"
    made = MadeHistory(path, attributes={"row_spacing": "unknown"})
    made.evolve(1)
    made.finish()
    made.close()
    with open_study(path) as study:
        (case,) = study.cases()
        with pytest.raises(HistoryError, match="has no spacing"):
            draw_field(case, MAST, MAST)
