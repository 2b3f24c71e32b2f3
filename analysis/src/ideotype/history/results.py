# SPDX-License-Identifier: Apache-2.0
"""Tabulates the results of a study, one line for each case."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .case import Case
from .file import HistoryError
from .history import History
from .interval import Interval, interval

if TYPE_CHECKING:
    import pandas

_COORDINATES = (
    *("campaign", "site", "latitude", "longitude", "day", "row_spacing"),
    *("plant_spacing", "trait_set"),
)
_UNITS = {
    "latitude": "deg",
    "longitude": "deg",
    "row_spacing": "m",
    "plant_spacing": "m",
    "density": "m-2",
    "gain_percent": "%",
    "gain_percent_low": "%",
    "gain_percent_high": "%",
    "lowest_gain_percent": "%",
    "highest_gain_percent": "%",
    "gain_per_leaf_area_percent": "%",
    "gain_per_leaf_area_percent_low": "%",
    "gain_per_leaf_area_percent_high": "%",
    "baseline_lai": "m2 m-2",
    "best_lai": "m2 m-2",
}


def results_of(
    cases: Sequence[Case], further: Mapping[str, Mapping[str, Any]] = {}
) -> pandas.DataFrame:
    """Returns a table with one line for each case: its site, day, spacing and
    trait set, the baseline, the best plant, the gain with the ends of its 95 %
    confidence interval, the leaf area index and the number of searches.
    Unknown numbers are NaN. `further` maps the name of a case to additional
    columns. Units are in .attrs["units"]."""
    # pandas is imported here, because its import is slow.
    import pandas

    lines = [_line(case) | dict(further.get(case.name, {})) for case in cases]
    table = pandas.DataFrame(lines)
    units = {name: unit for name, unit in _UNITS.items() if name in table}
    table.attrs["units"] = units
    return table


def _line(case: Case) -> dict[str, Any]:
    has = case.attributes
    line: dict[str, Any] = {"case": case.name}
    line |= {name: has.get(name) for name in _COORDINATES}
    row, plant = (
        float(has.get(f"{x}_spacing", "nan")) for x in ("row", "plant")
    )
    line["density"] = 1 / (row * plant) if row * plant > 0 else math.nan
    goal = case.histories[0].objectives[0]
    line |= {"objective": goal.name, "unit": goal.unit}
    for name, take in _NUMBERS.items():
        line |= _columns(name, _known(case, take))
    gains = [pair.gain.mean for pair in case.pairs]
    line["lowest_gain_percent"] = min(gains, default=math.nan)
    line["highest_gain_percent"] = max(gains, default=math.nan)
    for who in ("baseline", "best"):
        lai = _known(
            case,
            lambda case, who=who: interval(
                [getattr(case, who).estimate("lai")]
            ),
        )
        line[f"{who}_lai"] = lai.mean if lai else math.nan
    line["searches"] = len(case.histories)
    line["evaluations"] = sum(map(count_evaluations, case.histories))
    line["is_final"] = case.is_final
    line["best_history"] = str(case.best_history.path) if case.pairs else ""
    return line


def count_evaluations(history: History) -> int:
    """Returns the number of evaluations in the committed generations of a
    search."""
    return int(history.generations().evaluations.sum())


_NUMBERS: dict[str, Callable[[Case], Interval]] = {
    "baseline": lambda case: interval([case.baseline.objective]),
    "best": lambda case: interval([case.best.objective]),
    "gain": Case.gain,
    "gain_percent": Case.relative_gain,
    "gain_per_leaf_area_percent": Case.gain_per_leaf_area,
}


def _known(case: Case, take: Callable[..., Interval]) -> Interval | None:
    try:
        return take(case)
    except HistoryError:
        return None


def _columns(name: str, number: Interval | None) -> dict[str, float]:
    return {
        name: number.mean if number else math.nan,
        f"{name}_low": number.low if number else math.nan,
        f"{name}_high": number.high if number else math.nan,
    }
