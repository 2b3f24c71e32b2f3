# SPDX-License-Identifier: Apache-2.0
"""Compares cases by place: latitude and spacing, as curves and as maps over
two axes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..history.case import Case
from ..history.file import HistoryError
from ..history.interval import Interval, bars
from . import style
from .comparison import select_known

_Number = Callable[[Case], float]


def _number(name: str) -> _Number:
    return lambda case: round(float(case.attributes[name]), 6)


_latitude = _number("latitude")
_rows, _plants = _number("row_spacing"), _number("plant_spacing")


def _density(case: Case) -> float:
    return float(f"{1 / (_rows(case) * _plants(case)):.3g}")


AXES: tuple[tuple[str, str, _Number], ...] = (
    ("spacing", "plant density [m⁻²]", _density),
    ("site", "latitude [°N]", _latitude),
    ("spacing", "plant distance in the row [m]", _plants),
    ("spacing", "row distance [m]", _rows),
)
"""The axes of figures: name of the axis of campaigns, label, and a function
that returns the place of a case."""


def describe_place(case: Case, *axes: str) -> str:
    """Returns the case's place on all axes except the given axes; the trait
    set comes last."""
    names = ("site", "day", "spacing", "trait_set")
    words = (
        case.attributes.get(name, "") for name in names if name not in axes
    )
    campaign, _, _ = case.name.rpartition(": ")
    return " ".join(
        filter(None, [f"{campaign}:"] * bool(campaign) + [*map(str, words)])
    )


def draw_latitudes(cases: Sequence[Case]) -> Figure:
    """Draws absorbed PAR and gain against latitude, a line for each
    combination of the other axes, and points for combinations without a line.
    Raises HistoryError unless there are two latitudes."""
    return _draw_against(cases, *AXES[1])


def draw_spacings(cases: Sequence[Case]) -> Figure:
    """Draws absorbed PAR and gain against plants per area, a line for each
    distance of rows."""
    return _draw_against(cases, *AXES[0])


def _draw_against(
    cases: Sequence[Case], axis: str, label: str, position: _Number
) -> Figure:
    quantity = label.split(" [")[0]
    known = [c for c in select_known(cases) if not c.is_over(axis)]
    try:
        if len({position(case) for case in known}) < 2:
            raise HistoryError(f"all cases have the same {quantity}")
    except (KeyError, ZeroDivisionError) as error:
        raise HistoryError(f"the histories have no {quantity}") from error
    lines, points = _lines(known, axis, position)
    figure = style.new_figure(
        style.WIDTH, 6.4 + 0.16 * (len(lines) + len(points))
    )
    upper, lower = figure.subplots(2, 1, sharex=True)
    in_order = _in_order(lines, axis)
    lines = in_order or lines
    colors = style.ordered(len(lines)) if in_order else []
    for i, (name, members) in enumerate((lines | points).items()):
        color, marker = style.series(i)
        if i < len(colors):
            color = colors[i]
        look = {"color": color, "marker": marker}
        x = [position(case) for case in members]
        for who, dash in (("baseline", "--"), ("best", "-")):
            means = [case.number(who) for case in members]
            look |= {
                "fillstyle": "none" if who == "baseline" else "full",
                "linestyle": dash if name in lines else "none",
            }
            _draw_line(upper, x, means, look | {"label": f"{name}, {who}"})
        gains = [case.relative_gain() for case in members]
        _draw_line(lower, x, gains, look | {"label": name})
    objective = known[0].best.row.goals[0]
    upper.set_ylabel(
        style.axis_label(objective.name, objective.unit).replace(" [", "\n[")
    )
    lower.set_ylabel("gain over the baseline [%]")
    lower.set_xlabel(label)
    handles, labels = lower.get_legend_handles_labels()
    many = len(labels) > 8
    figure.legend(
        handles, labels, loc="outside lower center", ncols=1 + many,
        fontsize=8 if many else 9,
    )  # fmt: skip
    upper.set_title("filled: best plant; open, dashed: baseline", fontsize=9)
    style.set_answer(figure, _tendency(known, position, label))
    return figure


def _lines(
    known: Sequence[Case], axis: str, position: _Number
) -> tuple[dict[str, list[Case]], dict[str, list[Case]]]:
    """Returns the cases that a line joins, by their common properties, and the
    cases at places without a line."""

    def places(members: Sequence[Case]) -> set[float]:
        return {position(case) for case in members}

    groups: dict[str, list[Case]] = {}
    for case in known:
        groups.setdefault(describe_place(case, axis), []).append(case)
    lines: dict[str, list[Case]] = {}
    for name, members in groups.items():
        members.sort(key=position)
        if len(places(members)) > 1:
            by_rows = axis == "spacing"
            lines |= _by_rows(name, members) if by_rows else {name: members}
    shown = {at for line in lines.values() for at in places(line)}
    points = {
        name: members
        for name, members in groups.items()
        if len(places(members)) == 1 and not places(members) <= shown
    }
    return lines, points


def _in_order(
    lines: Mapping[str, list[Case]], axis: str
) -> dict[str, list[Case]] | None:
    """Returns lines in the order of the number in which lines differ; None if
    lines differ in another property."""
    other = _density if axis == "site" else _latitude
    try:
        at = {name: other(members[0]) for name, members in lines.items()}
    except (KeyError, ZeroDivisionError):
        return None
    if len({*at.values()}) < len(at) or len(at) < 2:
        return None
    return {name: lines[name] for name in sorted(at, key=lambda x: at[x])}


def _tendency(known: Sequence[Case], position: _Number, label: str) -> str:
    """States the mean gains at both ends of an axis."""
    at = sorted({position(case) for case in known})
    _, _, unit = label.partition(" [")
    ends = []
    for place in (at[0], at[-1]):
        gains = [
            case.relative_gain().mean
            for case in known
            if position(case) == place
        ]
        ends.append(f"{np.mean(gains):.1f} % at {place:g} {unit.rstrip(']')}")
    return f"The mean gain changes from {ends[0]} to {ends[1]}."


def _by_rows(name: str, members: Sequence[Case]) -> dict[str, list[Case]]:
    """Returns cases by line: one line for each row distance, unless the
    distance within rows is constant."""
    lines: dict[str, list[Case]] = {}
    for case in sorted(members, key=_rows):
        lines.setdefault(f"{name}, rows {_rows(case):.4g} m", []).append(case)
    return lines if len(lines) < len(members) else {name: [*members]}


def _draw_line(
    axes: Axes, x: Sequence[float], y: Sequence[Interval], look: Any
) -> None:
    axes.errorbar(x, [each.mean for each in y], bars(y), **look)
