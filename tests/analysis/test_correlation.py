# SPDX-License-Identifier: Apache-2.0
"""Correlations tell which traits go together."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from made_numbers import LEAVES

from ideotype.analysis.correlation import columns_of, draw_correlation
from ideotype.analysis.study import open_study


def test_azimuths_enter_as_cosine_and_sine(finished: Path) -> None:
    with open_study(finished) as study:
        (case,) = study.cases()
        rows = case.histories[0].evaluations().done
        columns = columns_of(case)
    assert columns.shape == (len(rows), LEAVES * 5)
    azimuth = np.deg2rad(rows["leaf01_azimuth"].values)
    length = rows["leaf01_length"].values
    for column, expected in (
        ((3, "cos"), np.cos(azimuth)),
        ((3, "sin"), np.sin(azimuth)),
        ((0, ""), length),
    ):
        off = columns[column].to_numpy() - (expected - expected.mean())
        assert off == pytest.approx(0, abs=1e-12)


def test_every_row_of_the_correlation_has_its_leaf(sweep: Path) -> None:
    with open_study(sweep) as study:
        case = study.cases()[0]
        columns = columns_of(case)
        figure = draw_correlation(case)
    figure.draw_without_rendering()
    axes = figure.axes[0]
    for axis in (axes.xaxis, axes.yaxis):
        shown = [t.label1.get_text() for t in axis.get_minor_ticks()]
        assert len(shown) == columns.shape[1] > 40
        assert shown == [str(n) for n in range(1, LEAVES + 1)] * 5
        kinds = [t.label1.get_text() for t in axis.get_major_ticks()]
        assert kinds == [
            *("length", "width", "insertion angle"),
            *("cos azimuth", "sin azimuth"),
        ]


def test_differences_between_seeds_do_not_correlate(sweep: Path) -> None:
    with open_study(sweep) as study:
        case = study.cases()[0]
        counts = [len(h.evaluations().done) for h in case.histories]
        columns = columns_of(case)
    assert len(counts) > 1
    seed = np.repeat(np.arange(len(counts)), counts)
    assert np.abs(columns.groupby(seed).mean()).max(None) < 1e-12
