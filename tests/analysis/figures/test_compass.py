# SPDX-License-Identifier: Apache-2.0
"""Figures from above show their orientation."""

from __future__ import annotations

import shutil
from itertools import combinations
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_layout import seal
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ideotype.figures.azimuths import draw_azimuths
from ideotype.history.layout import places, row_direction
from ideotype.history.study import open_study


def copy_with(history: Path, folder: Path, campaign: str) -> Path:
    """Copies a history and gives the copy another campaign."""
    copy = folder / "copy.h5"
    shutil.copy(history, copy)
    with h5py.File(copy, "r+") as file:
        file["campaign/resolved"][...] = campaign.encode()
        seal(file)
    return copy


def turned(history: Path, folder: Path, direction: float) -> Path:
    """Copies a history and changes the direction of its rows."""
    text = f'[[spacing]]\nname = "30x6"\nrow_direction = {direction}'
    return copy_with(history, folder, text)


def norths(figure: Figure) -> list[tuple[float, float]]:
    return [
        text.get_position()
        for axes in figure.axes
        for text in axes.texts
        if text.get_gid() == "north" and text.get_text() == "N"
    ]


@pytest.mark.parametrize("direction", [0.0, 20.0, 90.0, 180.0])
def test_labels_of_the_compass_do_not_overlap(
    finished: Path, tmp_path: Path, direction: float
) -> None:
    with open_study(turned(finished, tmp_path, direction)) as study:
        figure = draw_azimuths(study.cases()[0])
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    # The compass is the narrow panel that contains the letter N.
    (axes,) = (a for a in figure.axes if any(t.get_gid() for t in a.texts))
    boxes = [t.get_window_extent() for t in axes.texts if t.get_text()]
    assert len(boxes) == 3
    for one, other in combinations(boxes, 2):
        assert not one.overlaps(other)


@pytest.mark.parametrize("direction", [0.0, 30.0, 90.0])
def test_north_lies_against_the_turn_of_the_rows(
    finished: Path, tmp_path: Path, direction: float
) -> None:
    path = turned(finished, tmp_path, direction)
    with open_study(path) as study:
        (case,) = study.cases()
        assert row_direction(case) == direction
        ((x, y),) = norths(draw_azimuths(case))
    # Angles count clockwise from the row, which points to the top of the
    # figure.
    assert np.rad2deg(np.arctan2(x, y)) == pytest.approx(-direction)


def test_a_compass_without_north_shows_row_and_azimuth(
    finished: Path,
) -> None:
    with open_study(finished) as study:
        (case,) = study.cases()
        assert row_direction(case) is None
        figure = draw_azimuths(case)
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
