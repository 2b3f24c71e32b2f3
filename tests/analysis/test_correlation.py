# SPDX-License-Identifier: Apache-2.0
"""Which traits go together."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from made_numbers import LEAVES

from ideotype.analysis import open_history
from ideotype.analysis.correlation import (
    Column,
    centred,
    columns_of,
    draw_correlation,
    evaluated,
    rank_correlation,
)
from ideotype.analysis.study import open_study

PLANTS = 2000


def test_azimuths_enter_as_cosine_and_sine(finished: Path) -> None:
    with open_history(finished) as history:
        rows = history.evaluations().done
        columns, x = columns_of(history.genes, rows)
    assert len(columns) == x.shape[1] == LEAVES * 5
    at = columns.index(Column(3, "cos"))
    assert columns[at + 1] == Column(3, "sin")
    azimuth = np.deg2rad(rows["leaf01_azimuth"].values)
    assert x[:, at] == pytest.approx(np.cos(azimuth))
    assert x[:, at + 1] == pytest.approx(np.sin(azimuth))
    assert x[:, 0] == pytest.approx(rows["leaf01_length"].values)


def test_independent_columns_of_many_ties_are_not_correlated() -> None:
    draw = np.random.default_rng(1)
    x, z = draw.random((2, PLANTS, 2))
    x[z < 0.9] = 0.0
    # four standard errors of a correlation of independent columns
    assert abs(rank_correlation(x)[0, 1]) < 4 / np.sqrt(PLANTS)
    # by hand: ranks 1.5 1.5 3 4 and 1 2.5 2.5 4
    tied = rank_correlation(np.array([[0, 1], [0, 2], [5, 2], [7, 9]]))
    assert tied[0, 1] == pytest.approx(3.75 / 4.5)


def test_every_row_of_the_correlation_has_its_leaf(sweep: Path) -> None:
    with open_study(sweep) as study:
        case = study.cases()[0]
        columns, _ = columns_of(case.genes, evaluated(case)[0])
        figure = draw_correlation(case)
    figure.draw_without_rendering()
    axes = figure.axes[0]
    for axis in (axes.xaxis, axes.yaxis):
        shown = [t.label1.get_text() for t in axis.get_minor_ticks()]
        assert len(shown) == len(columns) > 40
        assert shown == [str(n) for n in range(1, LEAVES + 1)] * 5
        kinds = [t.label1.get_text() for t in axis.get_major_ticks()]
        assert kinds == [
            *("length", "width", "insertion angle"),
            *("cos azimuth", "sin azimuth"),
        ]


def test_differences_between_seeds_do_not_correlate() -> None:
    """Seeds with longer leaves absorb more, though within a seed longer
    leaves absorb less."""
    draw = np.random.default_rng(3)
    seed = np.repeat([0, 1, 2], 100)
    length = draw.normal(size=300)
    absorbed = -length + 0.1 * draw.normal(size=300)
    both = np.array([length + 10 * seed, absorbed + 30 * seed]).T
    assert rank_correlation(both)[0, 1] > 0.5
    assert rank_correlation(centred(both, seed))[0, 1] < -0.9
