# SPDX-License-Identifier: Apache-2.0
"""Draws gains as maps over two axes, such as latitude and density."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from ..history.case import Case
from ..history.coordinates import short_names
from ..history.estimate import Estimate, relative_gain
from ..history.file import HistoryError
from ..history.interval import Interval, over_searches
from . import style
from .comparison import select_known
from .places import AXES, describe_place

_Place = tuple[float, float]
_Cells = dict[_Place, Interval]


def draw_gain_map(cases: Sequence[Case]) -> Figure:
    """Draws the gain over the baseline [%], a map for each combination of the
    other axes.

    Raises HistoryError unless cases differ in two numbers."""
    known = select_known(cases)
    labels, groups = _maps(known)
    maps: dict[str, _Cells] = {
        name: {at: case.relative_gain() for at, case in members.items()}
        for name, members in groups.items()
    }
    figure = _draw(maps, labels, "gain over the baseline [%]")
    largest = max(known, key=lambda case: case.relative_gain().mean)
    style.set_answer(
        figure,
        f"Largest in {short_names(known)[largest.name]}: "
        f"{largest.relative_gain().number()} %.",
    )
    return figure


def draw_set_map(cases: Sequence[Case], sets: tuple[str, str]) -> Figure:
    """Draws the gain of the best plant of one trait set over the best plant of
    a second trait set [%], with the line of no difference; the error assumes
    that both plants are independent.

    Raises HistoryError unless the cases of both trait sets differ in two
    numbers."""
    first, second = sets
    known = select_known(cases)
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
    better = [x for cells in maps.values() for x in cells.values()]
    clearly = sum(x.low > 0 for x in better)
    style.set_answer(
        figure,
        f"Significantly (95 % confidence interval above 0) in {clearly} of "
        f"{len(better)} places.",
    )
    return figure


def find_sets(cases: Sequence[Case]) -> tuple[str, str] | None:
    """Returns the trait sets of cases, if there are exactly two sets."""
    names = dict.fromkeys(
        str(case.attributes.get("trait_set", "")) for case in cases
    )
    first, *others = names or [""]
    return (first, others[0]) if len(others) == 1 else None


def _over(case: Case, other: Case) -> Interval:
    """Returns the increase of the objective of the best plants, or the
    decrease of a minimised objective."""
    mine, theirs = (
        over_searches(
            [pair.best.objective for pair in each.pairs], each.gains()
        )
        for each in (case, other)
    )
    # Half widths are passed as standard errors, so that the result is also a
    # half width.
    ratio = relative_gain(
        *(Estimate(x.mean, x.below, x.unit) for x in (mine, theirs))
    )
    sign = case.best.row.goals[0].sign
    half_width, seeds = ratio.standard_error, min(mine.seeds, theirs.seeds)
    return Interval(sign * ratio.mean, half_width, half_width, "%", seeds)


def _maps(
    known: Sequence[Case],
) -> tuple[tuple[str, str], dict[str, dict[_Place, Case]]]:
    """Returns labels of the two axes, and cases by their place on these axes,
    for each combination of all other axes."""
    for i, (axis, label, place) in enumerate(AXES):
        for other, other_label, other_place in AXES[i + 1 :]:
            shown = [
                case
                for case in known
                if not case.is_over(axis) and not case.is_over(other)
            ]
            groups: dict[str, dict[_Place, Case]] = {}
            try:
                for case in shown:
                    at = place(case), other_place(case)
                    name = describe_place(case, axis, other)
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
    columns = 1
    rows = len(maps)
    tallest = max(len({at[1] for at in cells}) for cells in maps.values())
    figure = style.new_figure(style.WIDTH, 0.8 + rows * (0.9 + 0.42 * tallest))
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    largest = max(
        abs(x.mean) for cells in maps.values() for x in cells.values()
    )
    norm = Normalize(-largest, largest)
    for axes in panels[len(maps) :]:
        axes.set_visible(False)
    image = None
    for axes, (name, cells) in zip(panels, maps.items()):
        across, up = (sorted({at[k] for at in cells}) for k in (0, 1))
        table = np.full((len(up), len(across)), np.nan)
        for (x, y), gain in cells.items():
            i, j = up.index(y), across.index(x)
            table[i, j] = gain.mean
            _write(axes, j, i, gain, norm)
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
    figure.colorbar(
        image, ax=list(panels), location="bottom", aspect=40, label=title
    )
    return figure


def _write(
    axes: Axes, x: int, y: int, gain: Interval, norm: Normalize
) -> None:
    dark = abs(float(norm(gain.mean)) - 0.5) > 0.33
    plus = "+" if gain.mean > 0 else ""
    number, _, rest = gain.number().partition(" ")
    text = f"{plus}{number}\n{rest.replace('± ', '±')}"
    axes.text(
        x, y, text.replace("-", "\N{MINUS SIGN}"),
        ha="center", va="center", fontsize=8,
        color="white" if dark else "black",
    )  # fmt: skip
