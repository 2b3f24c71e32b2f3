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
from .tables import bare, held


def scenarios(cases: Sequence[Case]) -> list[Table]:
    """Returns tables of each objective in every scenario over which it is
    taken."""
    found: dict[str, list[list[str]]] = {}
    for case in cases:
        objectives = case.best.row.with_axis("scenario") if case.pairs else []
        for objective in objectives:
            rows = found.setdefault(
                axis_label(objective.name, objective.unit), []
            )
            was, now = (
                plant.profile(objective.name)
                for plant in (case.baseline, case.best)
            )
            gains = zip(
                *(
                    _gains_by_scenario(pair, objective.name)
                    for pair in case.pairs
                )
            )
            for label, *plants, gain in zip(
                was.labels, was.estimates(), now.estimates(), gains
            ):
                cells = [
                    x.interval_text().replace(" ", "\u00a0") for x in plants
                ]
                cells.append(bare(over_searches(gain)))
                rows.append([f"{case.name}: {label}", *cells])
    return [
        Table(
            ("case: scenario", "baseline", "best", "gain [%]"),
            rows,
            f"{title[0].upper()}{title[1:]}: gains are means of searches"
            f"{held(cases)}, and their errors take baseline and best as "
            "independent.",
        )
        for title, rows in found.items()
    ]


def _gains_by_scenario(pair: Pair, name: str) -> list[Estimate]:
    was, now = (
        plant.profile(name).estimates() for plant in (pair.baseline, pair.best)
    )
    return [*map(relative_gain, now, was)]
