# SPDX-License-Identifier: Apache-2.0
"""Which way figures from above are turned."""

from __future__ import annotations

import shutil
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_layout import seal
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ideotype._geometry import Mesh
from ideotype.analysis.case import Case
from ideotype.analysis.plan import draw_plan, draw_roses
from ideotype.analysis.shape import draw_azimuths
from ideotype.analysis.stand import places, row_direction
from ideotype.analysis.study import open_study

SQUARE = Mesh(
    np.array([[0, 0, 1], [1, 0, 1], [1, 0.5, 1], [0, 0.5, 1.0]]),
    ((0, 1, 2, 3),),
    ("leaf01",),
)


def copy_with(history: Path, folder: Path, campaign: str) -> Path:
    """A copy of another campaign."""
    copy = folder / "copy.h5"
    shutil.copy(history, copy)
    with h5py.File(copy, "r+") as file:
        file["campaign/resolved"][...] = campaign.encode()
        seal(file)
    return copy


def turned(history: Path, folder: Path, direction: float) -> Path:
    """A copy whose rows run that way."""
    text = f'[[spacing]]\nname = "30x6"\nrow_direction = {direction}'
    return copy_with(history, folder, text)


def figures(case: Case) -> list[Figure]:
    return [
        draw_azimuths(case),
        draw_roses(case),
        draw_plan(case, SQUARE, SQUARE),
    ]


def norths(figure: Figure) -> list[tuple[float, float]]:
    return [
        text.get_position()
        for axes in figure.axes
        for text in axes.texts
        if text.get_gid() == "north" and text.get_text() == "N"
    ]


@pytest.mark.parametrize("direction", [0.0, 30.0, 90.0])
def test_north_lies_against_the_turn_of_the_rows(
    finished: Path, tmp_path: Path, direction: float
) -> None:
    path = turned(finished, tmp_path, direction)
    with open_study(path) as study:
        (case,) = study.cases()
        assert row_direction(case) == direction
        drawn = figures(case)
    for figure in drawn:
        ((x, y),) = norths(figure)
        # clockwise from the row, which is the top of the figure
        bearing = np.rad2deg(np.arctan2(x, y))
        assert bearing == pytest.approx(-direction)


def test_a_compass_tells_the_row_and_the_turn_without_north(
    finished: Path,
) -> None:
    with open_study(finished) as study:
        (case,) = study.cases()
        assert row_direction(case) is None
        drawn = figures(case)
    for figure in drawn:
        assert not norths(figure)
        said = {t.get_text() for axes in figure.axes for t in axes.texts}
        assert {"row, 0°", "azimuths\nclockwise"} <= said


def test_a_stand_goes_on_and_a_plot_alone_ends(
    finished: Path, tmp_path: Path
) -> None:
    with open_study(finished) as study:
        around = places(study.cases()[0], 2)
    expected = {
        (0.762 * i, 0.1524 * j) for i in (-1, 0, 1) for j in range(-2, 3)
    }
    assert not around[0].any()
    assert {tuple(place) for place in around} == expected
    alone = '[field]\nboundary = "isolated"\nrows = 1\nplants = 3'
    with open_study(copy_with(finished, tmp_path, alone)) as study:
        around = places(study.cases()[0], 2)
    assert {tuple(place) for place in around} == {
        (0.0, 0.1524 * j) for j in (-1, 0, 1)
    }


def test_the_plan_has_no_seams(finished: Path) -> None:
    """Two faces of one leaf that meet in a slanting edge."""
    corners = [[0, 0, 1], [1, 0, 1], [1, 0.7, 1], [0, 0.5, 1], [0.4, 0, 1]]
    corners += [[0.6, 0.62, 1.0]]
    faces = ((0, 4, 5, 3), (4, 1, 2, 5))
    leaf = Mesh(np.array(corners, dtype=float), faces, ("leaf01", "leaf01"))
    with open_study(finished) as study:
        case = study.cases()[0]
        case.attributes = {}
        figure = draw_plan(case, leaf, leaf)
    axes = figure.axes[0]
    for line in axes.lines:
        line.set_visible(False)
    axes.grid(visible=False)
    figure.set_dpi(200)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())[..., :3].astype(int)
    edge = np.array([[0.4, 0.0], [0.6, 0.62]])
    along = np.linspace(0.1, 0.9, 60)[:, None]
    points = edge[0] + along * (edge[1] - edge[0])

    def at(points: np.ndarray) -> np.ndarray:
        x, y = np.floor(axes.transData.transform(points)).astype(int).T
        return pixels[len(pixels) - 1 - y, x]

    shown, (color,) = at(points), at(np.array([[0.2, 0.25]]))
    assert np.ptp(color) > 20
    assert np.abs(shown - color).max() <= 2
