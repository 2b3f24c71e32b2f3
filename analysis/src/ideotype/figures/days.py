# SPDX-License-Identifier: Apache-2.0
"""Draws the objective and other quantities by day of a season."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from matplotlib.figure import Figure

from ..history.case import Case
from ..history.estimate import NORMAL, Estimate
from . import style
from .profiles import PLANTS, Course, draw_courses, list_names, make_course
from .season import DAY

_BY_DAY = {
    "absorbed_par": "absorbed_by_day",
    "gross_assimilation": "assimilation_by_day",
    "transpiration": "transpiration_by_day",
}
"""Objectives with a quantity that is the objective by day."""

_GROSS, _GROSS_BY_DAY = "gross_assimilation", "assimilation_by_day"
_LOWERED = {
    "net_assimilation": "day respiration",
    "carbon_balance": "respiration and leaf construction cost",
}
"""Objectives that are gross assimilation less losses, and the losses."""


def draw_days(case: Case) -> Figure:
    """Draws quantities by day of a season with the differences between best
    and baseline. The first panel shows the objective or, if it is not known by
    day, the most similar quantity.

    Carbon losses are not known by day: each day is assigned those of the mean
    day.

    Raises HistoryError if no quantity is known by day."""
    names = list_names(case, "day", "day")
    goal = case.best.row.goals[0].name
    objective_by_day = _BY_DAY.get(goal, "")
    computed = _lowered(case, goal) if _GROSS_BY_DAY in names else None
    nearest = _GROSS_BY_DAY if goal in _LOWERED else objective_by_day
    names.sort(key=lambda name: name != nearest)
    courses = [_course(case, name) for name in names]
    if computed:
        courses.insert(0, computed)
    figure = draw_courses(courses)
    is_objective = computed is not None or objective_by_day == names[0]
    ahead = _count_days_ahead(case, courses[0], is_objective)
    style.set_answer(figure, f"{ahead}{_how(case)}")
    return figure


def _course(case: Case, name: str) -> Course:
    found = make_course(case, name)
    return replace(found, title=_GROSS) if name == _GROSS_BY_DAY else found


def _lowered(case: Case, goal: str) -> Course | None:
    """Returns an objective that equals gross assimilation minus losses.
    Returns None for growing plants, with losses that change with leaf area."""
    losses = _losses(case)
    if (
        goal not in _LOWERED
        or losses is None
        or DAY in case.best.row.quantities
    ):
        return None
    gross = make_course(case, _GROSS_BY_DAY).plants
    return Course(
        goal,
        {who: gross[who].lowered(loss) for who, loss in zip(PLANTS, losses)},
    )


def _losses(case: Case) -> tuple[float, ...] | None:
    """Returns gross assimilation minus the objective on a mean day, of
    baseline and best."""
    if _GROSS not in case.best.row.quantities:
        return None
    plants = [getattr(case, who) for who in PLANTS]
    return tuple(
        plant.estimate(_GROSS).mean - plant.objective.mean for plant in plants
    )


def _count_days_ahead(case: Case, course: Course, is_objective: bool) -> str:
    was, now = course.plants["baseline"], course.plants["best"]
    sign = case.best.row.goals[0].sign if is_objective else 1
    count = int(np.count_nonzero(sign * (now.values - was.values) > 0))
    verb = "is ahead in" if is_objective else "has more"
    return (
        f"The best plant {verb} {style.words(course.title)} on {count} of "
        f"{len(now.values)} days."
    )


def _how(case: Case) -> str:
    """Divides the difference in carbon into gross assimilation and losses.
    Losses follow from leaf area, which is exact, so that the error of the
    difference in gross assimilation is the paired error of the objective."""
    goal = case.best.row.goals[0]
    if goal.name not in _LOWERED or (losses := _losses(case)) is None:
        return ""
    less = losses[0] - losses[1]
    gain = case.best_pair.difference
    gross = gain.mean - less
    reach = NORMAL * gain.standard_error
    interval = Estimate(gross, gain.standard_error).interval_text()
    unit = style.unit_label(gain.unit)
    text = (
        f" On a mean day its gross assimilation differs by {_signed(interval)} {unit}; "
        f"its losses by {_LOWERED[goal.name]} are {abs(less):.2g} {unit} "
        f"{'lower' if less > 0 else 'higher'}"
    )
    if gain.mean - reach > 0 and less > 0 and gross + reach < 0:
        return (
            text + ". The gain comes from lower losses, not from more "
            "assimilation."
        )
    if gain.mean - reach > 0 and less < 0:
        return text + ". The gain comes from more assimilation."
    return text + "."


def _signed(text: str) -> str:
    if text.startswith("-"):
        return text.replace("-", "\N{MINUS SIGN}", 1)
    return f"+{text}"
