# SPDX-License-Identifier: Apache-2.0
"""The data of Pareto fronts for the page: a chart for choosing plants, and
the numbers of each plant."""

from __future__ import annotations

import math
from typing import Any

from ..common.labels import unit_label, words
from ..figures.style import axis_label, short
from ..history.case import Case
from ..history.estimate import NORMAL, Estimate, relative_gain
from ..history.pair import Pair
from ..history.rows import Evaluation, join
from .tables import UNKNOWN

_BOOKKEEPING = ("balance_error", "paths", "capped")
"""Scalar quantities that describe the evaluation and not the plant."""


def make_front_scene(case: Case) -> dict[str, Any]:
    """Returns the front of a case with several objectives, for front.js. Its
    members are the plants after the baseline."""
    first = case.fronts[0][1]
    names = _quantities(first.baseline)
    return {
        "text": describe_front(case),
        "first": _first(case),
        "seeds": len(case.histories),
        "axes": [
            {
                "name": words(objective.name),
                "label": axis_label(objective.name, objective.unit),
                "sense": objective.sense,
            }
            for objective in first.members.goals
        ],
        "baseline": _objectives(first.baseline),
        "others": [
            [short(x) for x in row]
            for history, _ in case.fronts
            for row in history.latest().done.objectives
        ],
        "quantities": [
            _titled(name, first.baseline.estimate(name)) for name in names
        ],
        "members": [
            {
                "title": case.member_title(seed, i),
                "seed": seed,
                "is_kept": bool(front.is_kept[i]),
                "objectives": _objectives(front.one(i)),
                "numbers": _numbers(front.pair(i), names),
                "scenarios": _scenarios(front.pair(i)),
            }
            for seed, (_, front) in enumerate(case.fronts)
            for i in range(len(front.members))
        ],
    }


def _first(case: Case) -> int:
    """Returns the member that is shown first: the best member in the first
    objective, as in the rest of the page."""
    members = join([front.members for _, front in case.fronts])
    return int(members.ranking(1)[0])


def describe_front(case: Case) -> str:
    """States how many members of the fronts of all seeds are not dominated
    after re-evaluation."""
    fronts = [front for _, front in case.fronts]
    count = sum(len(front.members) for front in fronts)
    if not all(front.is_final for front in fronts):
        return (
            f"Provisional: not all of the {count} plants are re-evaluated. Noise "
            "makes a Pareto front look better than it is."
        )
    kept = sum(int(front.is_kept.sum()) for front in fronts)
    text = f"After re-evaluation {kept} of {count} plants remain in the Pareto front"
    text += " of their seed" * (len(fronts) > 1)
    if kept == count:
        return f"{text}."
    return (
        f"{text}; {count - kept} {'is' if count - kept == 1 else 'are'} "
        "dominated: another plant is at least as good in all objectives and "
        "better in one."
    )


def _quantities(plant: Evaluation) -> list[str]:
    """Returns objectives, then all other quantities of a plant that are single
    numbers."""
    objectives = [objective.name for objective in plant.row.goals]
    others = plant.row.quantities.values()
    return objectives + [
        each.name
        for each in others
        if each.axis is None and each.name not in (*objectives, *_BOOKKEEPING)
    ]


def _titled(name: str, of: Estimate) -> str:
    unit = "" if of.unit == "1" else f" [{unit_label(of.unit)}]"
    return f"{words(name)}{unit}"


def _objectives(plant: Evaluation) -> list[list[float]]:
    """Returns each objective with half of its 95 % interval."""
    found = (plant.estimate(objective.name) for objective in plant.row.goals)
    return [[short(x.mean), short(NORMAL * x.standard_error)] for x in found]


def _numbers(pair: Pair, names: list[str]) -> list[list[str]]:
    """Returns for each quantity the numbers of the baseline and the plant, and
    the increase of the plant over the baseline [%]."""
    return [
        [
            _text(pair.baseline.estimate(name)),
            _text(pair.best.estimate(name)),
            _gain(pair.gain_in(name)),
        ]
        for name in names
    ]


def _scenarios(pair: Pair) -> list[dict[str, Any]]:
    """Returns baseline, plant and gain in each scenario that an objective is
    taken over."""
    return [
        {
            "title": _titled(quantity.name, Estimate(0, 0, quantity.unit)),
            "rows": [
                [
                    str(label),
                    _text(was),
                    _text(now),
                    _gain(relative_gain(now, was)),
                ]
                for label, was, now in zip(
                    pair.best.profile(quantity.name).labels,
                    pair.baseline.profile(quantity.name).estimates(),
                    pair.best.profile(quantity.name).estimates(),
                )
            ],
        }
        for quantity in pair.best.row.with_axis("scenario")
    ]


def _text(of: Estimate) -> str:
    return _signed(of.interval_text())


def _gain(gain: Estimate) -> str:
    """Returns a gain as "+1.50 ± 0.06"."""
    if not math.isfinite(gain.mean):
        return UNKNOWN
    plus = "+" if gain.mean > 0 else ""
    is_exact = gain.standard_error == 0
    text = f"{gain.mean:.2f}" if is_exact else gain.interval_text()
    return _signed(plus + text)


def _signed(text: str) -> str:
    return text.replace("-", "\N{MINUS SIGN}").replace("± ", "±\u00a0")
