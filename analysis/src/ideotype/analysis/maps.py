# SPDX-License-Identifier: Apache-2.0
"""Maps over two numbers in which cases differ, such as latitude and plant
density."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .case import Case
from .comparison import intervals_of, known_cases
from .estimate import Estimate, relative_gain
from .file import HistoryError
from .interval import Interval

_Place = Callable[[Case], float]
_Cells = dict[tuple[float, float], Interval]


def _number(name: str) -> _Place:
    return lambda case: round(float(case.attributes[name]), 6)


def _density(case: Case) -> float:
    return float(
        f"{1 / (_number('row_spacing')(case) * _number('plant_spacing')(case)):.3g}"
    )


_AXES: tuple[tuple[str, str, _Place], ...] = (
    ("spacing", "plant density [m⁻²]", _density),
    ("site", "latitude [°N]", _number("latitude")),
    ("spacing", "distance of plants [m]", _number("plant_spacing")),
    ("spacing", "distance of rows [m]", _number("row_spacing")),
)
"""The axis of campaigns that each belongs to, its label, and where a case
is."""


def draw_gain_map(cases: Sequence[Case]) -> Figure:
    """The gain over the baseline [%], a map for each combination of the other
    axes.

    Raises HistoryError unless cases differ in two numbers."""
    known = known_cases(cases)
    labels, groups = _maps(known)
    maps: dict[str, _Cells] = {
        name: {at: case.relative_gain() for at, case in members.items()}
        for name, members in groups.items()
    }
    figure = _draw(maps, labels, "gain over the baseline [%]")
    style.say(figure, intervals_of(known))
    return figure


def draw_set_map(cases: Sequence[Case], sets: tuple[str, str]) -> Figure:
    """By how much the best plant of one of two trait sets is better than that
    of the other [%], with the line where both are equal; the error takes both
    as independent.

    Raises HistoryError unless cases of both differ in two numbers."""
    first, second = sets
    known = known_cases(cases)
    labels, groups = _maps(known)
    maps: dict[str, _Cells] = {}
    for name, members in groups.items():
        if not name.endswith(f" {first}"):
            continue
        place = name.removesuffix(f" {first}")
        others = groups.get(f"{place} {second}", {})
        shared = {at: case for at, case in members.items() if at in others}
        if shared:
            maps[place] = {
                at: _over(case, others[at]) for at, case in shared.items()
            }
    if not maps:
        raise HistoryError("no case has both sets")
    figure = _draw(maps, labels, f"{first} over {second} [%]", has_line=True)
    style.say(figure, intervals_of(known))
    return figure


def two_sets(cases: Sequence[Case]) -> tuple[str, str] | None:
    """The trait sets of cases, if there are just two."""
    names = dict.fromkeys(
        str(case.attributes.get("trait_set", "")) for case in cases
    )
    first, *others = names or [""]
    return (first, others[0]) if len(others) == 1 else None


def _over(case: Case, other: Case) -> Interval:
    """Of the best plants; of a minimised objective how much lower."""
    mine, theirs = case.mean("best"), other.mean("best")
    found = relative_gain(
        *(Estimate(x.mean, x.half_width, x.unit) for x in (mine, theirs))
    )
    sign = case.best.row.goals[0].sign
    seeds = min(mine.seeds, theirs.seeds)
    return Interval(sign * found.mean, found.standard_error, "%", seeds)


def _maps(
    known: Sequence[Case],
) -> tuple[tuple[str, str], dict[str, dict[tuple[float, float], Case]]]:
    """Labels of the two axes, and cases by their place on these, for each
    combination of all others."""
    for i, (axis, label, place) in enumerate(_AXES):
        for other, other_label, other_place in _AXES[i + 1 :]:
            shown = [
                case
                for case in known
                if not case.is_over(axis) and not case.is_over(other)
            ]
            groups: dict[str, dict[tuple[float, float], Case]] = {}
            try:
                for case in shown:
                    at = place(case), other_place(case)
                    name = _elsewhere(case, {axis, other})
                    members = groups.setdefault(name, {})
                    if at in members:
                        raise HistoryError("several cases are at one place")
                    members[at] = case
            except (KeyError, ZeroDivisionError, HistoryError):
                continue
            groups = {n: m for n, m in groups.items() if _is_area(m)}
            if groups:
                return (label, other_label), groups
    raise HistoryError(
        "cases do not differ in two of latitude, plant density, and distances "
        "of rows and plants"
    )


def _is_area(places: Mapping[tuple[float, float], Case]) -> bool:
    """At least two by two, more than half of which there is."""
    across, up = ({at[k] for at in places} for k in (0, 1))
    return min(len(across), len(up)) > 1 and 2 * len(places) > len(
        across
    ) * len(up)


def _elsewhere(case: Case, axes: set[str]) -> str:
    """The case's place on all other axes; the trait set comes last."""
    names = ("site", "day", "spacing", "trait_set")
    campaign, _, _ = case.name.rpartition(": ")
    words = [
        str(case.attributes.get(name, ""))
        for name in names
        if name not in axes
    ]
    return " ".join(filter(None, [campaign, *words]))


def _draw(
    maps: Mapping[str, _Cells],
    labels: tuple[str, str],
    title: str,
    has_line: bool = False,
) -> Figure:
    columns = min(len(maps), 2)
    rows = -(-len(maps) // columns)
    figure = style.new_figure(2.1 + 2.3 * columns, 0.9 + 2.7 * rows)
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    most = max(abs(x.mean) for cells in maps.values() for x in cells.values())
    norm = Normalize(-most, most)
    for axes in panels[len(maps) :]:
        axes.set_visible(False)
    image = None
    for axes, (name, cells) in zip(panels, maps.items()):
        across, up = (sorted({at[k] for at in cells}) for k in (0, 1))
        table = np.full((len(up), len(across)), np.nan)
        for (x, y), found in cells.items():
            i, j = up.index(y), across.index(x)
            table[i, j] = found.mean
            _write(axes, j, i, found, norm)
        image = axes.imshow(
            table, cmap="PuOr_r", norm=norm, origin="lower", aspect="auto"
        )
        if has_line:
            _draw_zero(axes, table)
        axes.set_xticks(range(len(across)), [f"{x:g}" for x in across])
        axes.set_yticks(range(len(up)), [f"{y:g}" for y in up])
        axes.set(xlabel=labels[0], ylabel=labels[1])
        axes.set_title(name, fontsize=9)
        axes.grid(visible=False)
    assert image is not None
    figure.colorbar(image, ax=list(panels), label=title)
    return figure


def _write(
    axes: Axes, x: int, y: int, found: Interval, norm: Normalize
) -> None:
    dark = abs(float(norm(found.mean)) - 0.5) > 0.33
    minus = "\N{MINUS SIGN}"
    axes.text(
        x, y, f"{found.mean:+.1f}\n±{found.half_width:.1f}".replace("-", minus),
        ha="center", va="center", fontsize=7,
        color="white" if dark else "black",
    )  # fmt: skip


def _draw_zero(axes: Axes, table: NDArray) -> None:
    """The line of no difference, between the middles of cells."""
    known = table[np.isfinite(table)]
    if known.min() < 0 < known.max():
        axes.contour(table, levels=[0.0], colors=style.BASELINE, linewidths=2)
