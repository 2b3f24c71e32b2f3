# SPDX-License-Identifier: Apache-2.0
"""Figures show the objective on each day of a season."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
from drawn import bars, labels
from made_history import Extra, MadeHistory
from made_kinds import Measured
from made_layout import seal
from made_numbers import FINALISTS

from ideotype.figures.days import draw_days
from ideotype.figures.style import get_answer
from ideotype.history import open_study
from ideotype.history.case import Case

DAYS = [f"2011-07-{day}" for day in range(21, 26)]
SHARES = np.array([1.0, 0.5, 1.5, 1.2, 0.8])
RATE = Measured("mol m-2 day-1")
BY_DAY = Measured("mol m-2 day-1", "day")
LIGHT = Measured("MJ m-2 day-1", "day")


def give(
    rows: h5py.Group, slot: int, gross: float, loss: float, error: float
) -> None:
    """Sets the gross assimilation and the losses of a finalist, and
    randomisations with the standard error of the paired difference."""
    count = rows["objectives_by_randomisation"].shape[2]
    noise = np.resize([1.0, -1.0], count) * (error if slot else 0.0)
    rows["objectives_by_randomisation"][slot, 0] = (
        gross - loss + noise * np.sqrt(count - 1)
    )
    rows["objectives"][slot, 0] = gross - loss
    rows["gross_assimilation"][slot] = gross
    rows["assimilation_by_day"][slot] = gross * SHARES


def case_with(
    folder: Path,
    best: tuple[float, float],
    error: float = 0.002,
    objective: str = "carbon_balance",
    grows: bool = False,
) -> Case:
    """Returns a case in which the baseline assimilates 1.4 gross and loses
    0.5, and best plants have other values [mol m-2 day-1]."""
    extra: dict[str, Extra] = {
        "absorbed_by_day": (LIGHT, SHARES),
        "gross_assimilation": (RATE, 0.1),
        objective: (RATE, 0.08),
        "assimilation_by_day": (BY_DAY, 0.1 * SHARES),
    }
    if grows:
        stage = Measured("d", "stage", is_exact=True)
        extra["day_of_stage"] = (stage, np.array([1.0, 2.0]))
    path = folder / "case.h5"
    made = MadeHistory(
        path,
        extra=extra,
        labels={"day": DAYS, "stage": [100.0, 200.0]},
        objectives=((objective, "maximise"),),
    )
    made.evolve(1)
    made.finish()
    made.close()
    with h5py.File(path, "r+") as file:
        for slot in range(FINALISTS):
            numbers = best if slot else (1.4, 0.5)
            give(file["final"], slot, *numbers, error)
        seal(file)
    with open_study(path) as study:
        (case,) = study.cases()
        case.remember()
        return case


def test_daily_net_carbon_subtracts_the_losses_of_the_mean_day(
    tmp_path: Path,
) -> None:
    case = case_with(tmp_path, (1.38, 0.42))
    figure = draw_days(case)
    carbon, difference, gross, _, light, _ = figure.axes
    assert "net carbon balance\n[mol m⁻² day⁻¹]" in labels(figure)
    shown, _ = bars(carbon, "best")
    assert shown == pytest.approx(1.38 * SHARES - 0.42)
    assert shown.mean() == pytest.approx(case.best.objective.mean)
    by, _ = bars(difference, "_")
    assert by == pytest.approx(-0.02 * SHARES + 0.08)
    assert bars(gross, "best")[0] == pytest.approx(1.38 * SHARES)
    assert "gross assimilation\n[mol m⁻² day⁻¹]" in labels(figure)
    assert len(bars(light, "best")[0]) == len(DAYS)


def test_the_answer_names_a_gain_from_smaller_losses(tmp_path: Path) -> None:
    """The gain of the best plant is 0.06, though it assimilates 0.02 less."""
    assert get_answer(draw_days(case_with(tmp_path, (1.38, 0.42)))) == (
        "The best plant is ahead in net carbon balance on 5 of 5 days. On a "
        "mean day its gross assimilation differs by −0.0200 ± 0.0039 mol m⁻² "
        "day⁻¹; its losses by respiration and leaf construction cost are 0.08 "
        "mol m⁻² day⁻¹ lower. The gain comes from lower losses, not from more "
        "assimilation."
    )


@pytest.mark.parametrize(
    ("best", "error", "end"),
    [
        # The uncertainty of assimilation does not exclude that it increased.
        (
            (1.39, 0.42),
            0.02,
            " mol m⁻² day⁻¹ lower.",
        ),
        (
            (1.43, 0.47),
            0.002,
            " mol m⁻² day⁻¹ lower.",
        ),
        ((1.50, 0.52), 0.002, "The gain comes from more assimilation."),
        (
            (1.30, 0.45),
            0.002,
            " mol m⁻² day⁻¹ lower.",
        ),
    ],
)
def test_the_answer_names_only_significant_causes(
    tmp_path: Path, best: tuple[float, float], error: float, end: str
) -> None:
    text = get_answer(draw_days(case_with(tmp_path, best, error)))
    assert text.endswith(end)


def test_net_assimilation_subtracts_respiration_in_the_light(
    tmp_path: Path,
) -> None:
    case = case_with(tmp_path, (1.38, 0.42), objective="net_assimilation")
    assert "lower. The gain comes from lower losses" in get_answer(
        draw_days(case)
    )


def test_growing_plants_show_gross_assimilation(tmp_path: Path) -> None:
    """The losses of growing plants change daily with their leaf area, so that
    the figure shows gross assimilation."""
    case = case_with(tmp_path, (1.38, 0.42), grows=True)
    figure = draw_days(case)
    shown, _ = bars(figure.axes[0], "best")
    assert shown == pytest.approx(1.38 * SHARES)
    assert get_answer(figure).startswith(
        "The best plant has more gross assimilation on 0 of 5 days. On a mean "
        "day its gross assimilation differs by −0.0200"
    )
