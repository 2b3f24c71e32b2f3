# SPDX-License-Identifier: Apache-2.0
"""Compares cases by where they are: latitude and spacing, as curves and as
maps over two of these."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from . import style
from .case import Case
from .comparison import intervals_of, known_cases
from .estimate import Estimate, relative_gain
from .file import HistoryError
from .interval import Interval
from .style import label_light

_Number = Callable[[Case], float]
_Place = tuple[float, float]
_Cells = dict[_Place, Interval]


def _number(name: str) -> _Number:
    return lambda case: round(float(case.attributes[name]), 6)


_latitude = _number("latitude")
_rows, _plants = _number("row_spacing"), _number("plant_spacing")


def _density(case: Case) -> float:
    return float(f"{1 / (_rows(case) * _plants(case)):.3g}")


_AXES: tuple[tuple[str, str, _Number], ...] = (
    ("spacing", "plant density [m⁻²]", _density),
    ("site", "latitude [°N]", _latitude),
    ("spacing", "distance of plants [m]", _plants),
    ("spacing", "distance of rows [m]", _rows),
)
"""The axis of campaigns to which each belongs, its label, and where a case
is."""


def _elsewhere(case: Case, *axes: str) -> str:
    """Returns the case's place on all other axes; the trait set comes last."""
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
    combination of the other axes, and points for combinations at a latitude
    that no line shows. Raises HistoryError unless there are two latitudes."""
    return _draw_against(cases, *_AXES[1])


def draw_spacings(cases: Sequence[Case]) -> Figure:
    """Draws absorbed PAR and gain against plants per area, a line for each
    distance of rows."""
    return _draw_against(cases, *_AXES[0])


def _draw_against(
    cases: Sequence[Case], axis: str, label: str, position: _Number
) -> Figure:
    def places(members: Sequence[Case]) -> set[float]:
        return {position(case) for case in members}

    what = label.split(" [")[0]
    known = [c for c in known_cases(cases) if not c.is_over(axis)]
    try:
        if len(places(known)) < 2:
            raise HistoryError(f"all cases have the same {what}")
    except (KeyError, ZeroDivisionError) as error:
        raise HistoryError(f"the histories do not say their {what}") from error
    groups: dict[str, list[Case]] = {}
    for case in known:
        groups.setdefault(_elsewhere(case, axis), []).append(case)
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
    figure = style.new_figure(style.WIDTH, 4.2)
    left, right = figure.subplots(1, 2)
    for i, (name, members) in enumerate((lines | points).items()):
        color, marker = style.series(i)
        look = {"color": color, "marker": marker}
        x = [position(case) for case in members]
        for who, dash in (("baseline", "--"), ("best", "-")):
            means = [case.mean(who) for case in members]
            look |= {
                "fillstyle": "none" if who == "baseline" else "full",
                "linestyle": dash if name in lines else "none",
            }
            _draw_line(left, x, means, look | {"label": f"{name}, {who}"})
        gains = [case.relative_gain() for case in members]
        _draw_line(right, x, gains, look | {"label": name})
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


def _by_rows(name: str, members: Sequence[Case]) -> dict[str, list[Case]]:
    """Returns cases by their lines: one for each distance of rows, unless
    plants of a row are always as far apart."""
    lines: dict[str, list[Case]] = {}
    for case in sorted(members, key=_rows):
        lines.setdefault(f"{name}, rows {_rows(case):.4g} m", []).append(case)
    return lines if len(lines) < len(members) else {name: [*members]}


def _draw_line(
    axes: Axes, x: Sequence[float], y: Sequence[Interval], look: Any
) -> None:
    errors = np.nan_to_num([each.half_width for each in y])
    axes.errorbar(x, [each.mean for each in y], errors, **look)


def draw_gain_map(cases: Sequence[Case]) -> Figure:
    """Draws the gain over the baseline [%], a map for each combination of the
    other axes.

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
    """Draws by how much the best plant of one of two trait sets is better than
    that of the other [%], with the line where both are equal; the error takes
    both as independent.

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
    """Returns the trait sets of cases, if there are just two."""
    names = dict.fromkeys(
        str(case.attributes.get("trait_set", "")) for case in cases
    )
    first, *others = names or [""]
    return (first, others[0]) if len(others) == 1 else None


def _over(case: Case, other: Case) -> Interval:
    """Returns how much more the best plants have; for a minimised objective
    how much less."""
    mine, theirs = case.mean("best"), other.mean("best")
    found = relative_gain(
        *(Estimate(x.mean, x.half_width, x.unit) for x in (mine, theirs))
    )
    sign = case.best.row.goals[0].sign
    seeds = min(mine.seeds, theirs.seeds)
    return Interval(sign * found.mean, found.standard_error, "%", seeds)


def _maps(
    known: Sequence[Case],
) -> tuple[tuple[str, str], dict[str, dict[_Place, Case]]]:
    """Returns labels of the two axes, and cases by their place on these, for
    each combination of all others."""
    for i, (axis, label, place) in enumerate(_AXES):
        for other, other_label, other_place in _AXES[i + 1 :]:
            shown = [
                case
                for case in known
                if not case.is_over(axis) and not case.is_over(other)
            ]
            groups: dict[str, dict[_Place, Case]] = {}
            try:
                for case in shown:
                    at = place(case), other_place(case)
                    name = _elsewhere(case, axis, other)
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


def _is_area(places: Mapping[_Place, Case]) -> bool:
    """Returns whether there are at least two by two places, more than half of
    which have a case."""
    across, up = ({at[k] for at in places} for k in (0, 1))
    return min(len(across), len(up)) > 1 and 2 * len(places) > len(
        across
    ) * len(up)


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
        # The line of no difference runs between the middles of cells.
        if has_line and np.nanmin(table) < 0 < np.nanmax(table):
            axes.contour(table, [0.0], colors=style.BASELINE, linewidths=2)
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
