# SPDX-License-Identifier: Apache-2.0
"""The tables of objectives that are taken over several scenarios."""

from __future__ import annotations

from collections.abc import Sequence

from ..figures.style import axis_label
from ..history.case import Case
from ..history.estimate import Estimate, relative_gain
from ..history.interval import over_searches
from ..history.pair import Pair
from .blocks import Table
from .tables import bracket_intervals, format_bare


def tabulate_scenarios(cases: Sequence[Case]) -> list[Table]:
    """Returns tables of each objective in every scenario over which it is
    taken."""
    rows_by_title: dict[str, list[list[str]]] = {}
    better: dict[str, int] = {}
    for case in cases:
        if not case.pairs:
            continue
        signs = {
            f"{goal.name}_by_scenario": goal.sign
            for goal in case.best.row.goals
        }
        for objective in case.best.row.with_axis("scenario"):
            if objective.name not in signs:
                continue  # a part of the margin
            sign = signs[objective.name]
            title = axis_label(objective.name, objective.unit)
            rows = rows_by_title.setdefault(title, [])
            was, now = (
                plant.profile(objective.name)
                for plant in (case.baseline, case.best)
            )
            gains = zip(
                *(_compute_gains(pair, objective.name) for pair in case.pairs)
            )
            for label, *plants, gain in zip(
                was.labels, was.estimates(), now.estimates(), gains
            ):
                cells = [
                    x.interval_text().replace(" ", "\u00a0") for x in plants
                ]
                mean = over_searches(gain)
                better[title] = better.get(title, 0) + (sign * mean.mean > 0)
                cells.append(format_bare(mean))
                rows.append([f"{case.name}: {label}", *cells])
    return [
        Table(
            ("case: scenario", "baseline", "best", "gain [%]"),
            rows,
            f"{title[0].upper()}{title[1:]}. The best plant is better than the "
            f"baseline in {better[title]} of {len(rows)} scenarios. Gains are "
            f"means over searches{bracket_intervals(cases)}; their errors treat "
            "baseline and best as independent.",
        )
        for title, rows in rows_by_title.items()
    ]


def _compute_gains(pair: Pair, name: str) -> list[Estimate]:
    was, now = (
        plant.profile(name).estimates() for plant in (pair.baseline, pair.best)
    )
    return [*map(relative_gain, now, was)]
