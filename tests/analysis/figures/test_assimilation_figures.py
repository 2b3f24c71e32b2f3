# SPDX-License-Identifier: Apache-2.0
"""Figures of assimilation, of sunlit leaves and of a season contain the right
numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from drawn import bars, horizontal_bars, labels
from made_history import MadeHistory
from made_kinds import Measured
from made_numbers import ERROR, HOURS, LAI, LEAVES, final_absorbed

from ideotype.figures.days import draw_days
from ideotype.figures.profiles import draw_hours, draw_leaves, draw_sunlit
from ideotype.figures.shares import draw_assimilation
from ideotype.history import HistoryError, open_study
from ideotype.history.case import Case
from ideotype.history.estimate import NORMAL

DAYS = [f"2011-07-{day}" for day in range(28, 32)] + ["2011-08-01"]
"""The days from a Thursday to a Monday."""
PARTS = {
    "sunlit_lai_by_hour": (
        Measured("m2 m-2", "hour"),
        np.linspace(0.0, 0.2, len(HOURS)),
    ),
    "assimilation_by_hour": (
        Measured("umol m-2 s-1", "hour"),
        np.linspace(1.0, 4.0, len(HOURS)),
    ),
    "assimilation_by_leaf": (
        Measured("mol m-2 day-1", "leaf"),
        np.linspace(0.01, 0.02, LEAVES),
    ),
    "net_assimilation_by_leaf": (
        Measured("mol m-2 day-1", "leaf"),
        np.linspace(0.002, 0.012, LEAVES),
    ),
    "absorbed_by_day": (
        Measured("MJ m-2 day-1", "day"),
        np.array([1.0, 0.5, 1.5, 1.2, 0.8]),
    ),
}


@pytest.fixture(scope="module")
def case(tmp_path_factory: pytest.TempPathFactory) -> Case:
    path = tmp_path_factory.mktemp("season") / "case.h5"
    made = MadeHistory(path, extra=PARTS, labels={"day": DAYS})
    made.evolve(1)
    made.finish()
    made.close()
    with open_study(path) as study:
        (found,) = study.cases()
        found.remember()
        yield found


def test_assimilation_is_drawn_by_hour_and_leaf(case: Case) -> None:
    figure = draw_assimilation(case)
    hours, leaves = figure.axes
    best, error = bars(hours, "best")
    parts = PARTS["assimilation_by_hour"][1]
    assert best == pytest.approx(final_absorbed(2) * parts)
    assert error == pytest.approx(NORMAL * ERROR / 4 * parts)
    shown = [horizontal_bars(leaves, i)[0] for i in range(4)]
    for drawn, (total, kind) in zip(
        shown, [(t, k) for t in (0, 2) for k in ("", "net_")], strict=True
    ):
        part = PARTS[f"{kind}assimilation_by_leaf"][1]
        assert drawn == pytest.approx(final_absorbed(total) * part)
    assert leaves.get_xlim()[0] <= 0
    assert {
        *("baseline, gross", "best, net", "leaf rank (1 = lowest)"),
        *("gross assimilation\n[µmol m⁻² s⁻¹ of ground]", "best"),
        "assimilation [mol m⁻² day⁻¹ of ground]",
    } <= labels(figure)
    # Sunlit leaf area is drawn only in a separate figure.
    assert len(draw_leaves(case).axes) == 1
    assert len(draw_hours(case).axes) == 2


def test_sunlit_leaves_are_a_part_of_all(case: Case) -> None:
    figure = draw_sunlit(case)
    best, error = bars(figure.axes[0], "best")
    part = 100 / LAI * PARTS["sunlit_lai_by_hour"][1]
    assert best == pytest.approx(final_absorbed(2) * part)
    assert error == pytest.approx(NORMAL * ERROR / 4 * part)
    assert "sunlit fraction of leaf area [%]" in labels(figure)


def test_a_season_is_drawn_by_day(case: Case) -> None:
    figure = draw_days(case)
    upper, lower = figure.axes
    parts = PARTS["absorbed_by_day"][1]
    best, error = bars(upper, "best")
    assert best == pytest.approx(final_absorbed(2) * parts)
    assert error == pytest.approx(NORMAL * ERROR / 4 * parts)
    change, _ = bars(lower, "_")
    gain = final_absorbed(2) - final_absorbed(0)
    assert change == pytest.approx(gain * parts)
    days = [label.get_text() for label in lower.get_xticklabels()]
    # Four ticks would fit on the axis.
    assert days == ["28 Jul", "30 Jul", "1 Aug"]
    assert "absorbed PAR\n[MJ m⁻² day⁻¹ of ground]" in labels(figure)


def test_figures_name_the_missing_data_of_older_histories(
    finished: Path,
) -> None:
    with open_study(finished) as study:
        (old,) = study.cases()
        for draw, message in (
            (draw_assimilation, "no assimilation by leaf or hour"),
            (draw_sunlit, "no sunlit_lai_by_hour"),
            (draw_days, "no quantities by day"),
        ):
            with pytest.raises(HistoryError, match=message):
                draw(old)
