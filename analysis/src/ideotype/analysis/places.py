# SPDX-License-Identifier: Apache-2.0
"""Cases against each other by latitude and by spacing."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from . import style
from .case import Case
from .comparison import intervals_of, known_cases
from .file import HistoryError
from .interval import Interval
from .style import label_light


def draw_latitudes(cases: Sequence[Case]) -> Figure:
    """Absorbed PAR and gain against latitude, a line for each combination of
    the other axes, and points for combinations at a latitude that no line
    shows. Raises HistoryError unless there are two latitudes."""

    def latitude(case: Case) -> float:
        return float(case.attributes["latitude"])

    return _draw_against(cases, latitude, "site", "latitude [°N]")


def draw_spacings(cases: Sequence[Case]) -> Figure:
    """The same against plants per area, a line for each distance of rows."""

    def density(case: Case) -> float:
        return 1 / (
            float(case.attributes["row_spacing"])
            * float(case.attributes["plant_spacing"])
        )

    return _draw_against(cases, density, "spacing", "plant density [m⁻²]")


def _draw_against(
    cases: Sequence[Case],
    position: Callable[[Case], float],
    axis: str,
    label: str,
) -> Figure:
    def places(members: Sequence[Case]) -> set[float]:
        return {round(position(case), 6) for case in members}

    what = label.split(" [")[0]
    known = [c for c in known_cases(cases) if not c.is_over(axis)]
    try:
        if len(places(known)) < 2:
            raise HistoryError(f"all cases have the same {what}")
    except (KeyError, ZeroDivisionError) as error:
        raise HistoryError(f"the histories do not say their {what}") from error
    lines, points = _split(known, axis, lambda group: len(places(group)) > 1)
    shown = places([case for line in lines.values() for case in line])
    points = {
        name: members
        for name, members in points.items()
        if not places(members) <= shown
    }
    for members in lines.values():
        members.sort(key=position)
    figure = style.new_figure(style.WIDTH, 4.2)
    left, right = figure.subplots(1, 2)
    for i, (name, members) in enumerate((lines | points).items()):
        look = _Look(*style.series(i), is_joined=name in lines)
        x = [position(case) for case in members]
        for who in ("baseline", "best"):
            means = [case.mean(who) for case in members]
            _draw_line(left, x, means, look, f"{name}, {who}")
        gains = [case.relative_gain() for case in members]
        _draw_line(right, x, gains, look, name)
    objective = known[0].best.row.goals[0]
    label_light(left, "y", objective.name, objective.unit)
    right.set_ylabel("gain over the baseline [%]")
    for axes in (left, right):
        axes.set_xlabel(label)
    handles, labels = left.get_legend_handles_labels()
    figure.legend(
        handles, labels, loc="outside lower center", ncols=2, fontsize=8
    )
    style.say(figure, intervals_of(known))
    return figure


def _split(
    cases: Sequence[Case], axis: str, varies: Callable[[Sequence[Case]], bool]
) -> tuple[dict[str, list[Case]], dict[str, list[Case]]]:
    """Cases by their place on the other axes: those that vary along this
    one, and the others."""
    groups: dict[str, list[Case]] = {}
    for case in cases:
        groups.setdefault(_elsewhere(case, axis), []).append(case)
    lines: dict[str, list[Case]] = {}
    for name, members in groups.items():
        if varies(members):
            lines |= (
                _rows(name, members) if axis == "spacing" else {name: members}
            )
    return lines, {k: v for k, v in groups.items() if not varies(v)}


def _elsewhere(case: Case, axis: str) -> str:
    """The case's place on all axes but that of the comparison."""
    names = ("site", "day", "spacing", "trait_set")
    words = [
        str(case.attributes[name])
        for name in names
        if name != axis and name in case.attributes
    ]
    campaign, _, _ = case.name.rpartition(": ")
    return ": ".join(filter(None, [campaign, " ".join(words)]))


def _rows(name: str, members: Sequence[Case]) -> dict[str, list[Case]]:
    """A line for each distance of rows, unless plants of a row are always as
    far apart."""

    def rows(case: Case) -> float:
        return float(case.attributes["row_spacing"])

    lines: dict[str, list[Case]] = {}
    for case in sorted(members, key=rows):
        lines.setdefault(f"{name}, rows {rows(case):.4g} m", []).append(case)
    return lines if len(lines) < len(members) else {name: [*members]}


@dataclass(frozen=True)
class _Look:
    color: str
    marker: str
    is_joined: bool


def _draw_line(
    axes: Axes, x: Sequence[float], y: Sequence[Interval], look: _Look,
    label: str,
) -> None:  # fmt: skip
    is_baseline = label.endswith(", baseline")
    joined = "--" if is_baseline else "-"
    axes.errorbar(
        x,
        [each.mean for each in y],
        np.nan_to_num([each.half_width for each in y]),
        color=look.color,
        marker=look.marker,
        markersize=4.5,
        fillstyle="none" if is_baseline else "full",
        linestyle=joined if look.is_joined else "none",
        label=label,
    )
