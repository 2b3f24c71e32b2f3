# SPDX-License-Identifier: Apache-2.0
"""Draws figures of several objectives: the front and its hypervolume."""

from __future__ import annotations

from itertools import combinations, zip_longest
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from ..history.case import Case
from ..history.file import HistoryError
from ..history.rows import Rows
from . import style

_MARKERS = "os^vP"
"""The markers of seeds, as in front.js."""


def draw_front(case: Case) -> Figure:
    """Draws each pair of objectives: the fronts of all seeds with standard
    errors, the baseline, and the last generation as evaluated in the search,
    as far as it lies within the axes."""
    if not case.fronts:
        raise HistoryError("no front is evaluated yet")
    objectives = case.histories[0].objectives
    pairs = [*combinations(range(len(objectives)), 2)]
    columns = min(len(pairs), 2)
    rows = -(-len(pairs) // columns)
    space = " " if columns == 1 else "\n"
    figure = style.new_figure(style.WIDTH, 1.2 + rows * 4.2 / columns)
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes, pair in zip_longest(panels, pairs):
        if pair is None:
            axes.set_visible(False)
            continue
        up, across = pair
        _draw_pair(axes, case, [across, up])
        x, y = (
            f"{style.axis_label(objectives[k].name, objectives[k].unit)},{space}"
            f"{objectives[k].sense}d"
            for k in (across, up)
        )
        axes.set_xlabel(x)
        axes.set_ylabel(y)
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=1)
    style.set_answer(figure, _exchange(case))
    return figure


def _exchange(case: Case) -> str:
    """States the objectives at both ends of the best seed's front."""
    _, front = max(case.fronts, key=lambda each: int(each[1].is_kept.sum()))
    rows = front.members.take(front.is_kept)
    order = np.argsort(rows.objectives[:, 0])
    texts = []
    for k, goal in enumerate(case.histories[0].objectives[:2]):
        first, last = rows.objectives[order[[0, -1]], k]
        unit = "" if goal.unit == "1" else f" {style.unit_label(goal.unit)}"
        texts.append(
            f"{style.words(goal.name)} changes from {first:.3g} to {last:.3g}{unit}"
        )
    return (
        f"Along the Pareto front of {len(rows)} plants "
        f"{' while '.join(texts)}."
    )


def _draw_pair(axes: Axes, case: Case, shown: list[int]) -> None:
    for seed, (_, front) in enumerate(case.fronts):
        suffix = f" of seed {seed + 1}" if len(case.histories) > 1 else ""
        marker = _MARKERS[seed % len(_MARKERS)]
        for which, color, face, label in (
            (front.is_kept, style.BEST, style.BEST, "Pareto front"),
            (
                ~front.is_kept,
                style.ACCENT,
                "white",
                "dominated after re-evaluation",
            ),
        ):
            rows = front.members.take(which)
            if len(rows):
                style_of = {"color": color, "markerfacecolor": face}
                _draw_rows(
                    axes, rows, shown, marker, label + suffix, **style_of
                )
    baseline = case.fronts[0][1].baseline.row
    _draw_rows(axes, baseline, shown, "D", "baseline", color=style.BASELINE)
    axes.set(xlim=axes.get_xlim(), ylim=axes.get_ylim())
    others = np.concatenate(
        [history.latest().done.objectives for history, _ in case.fronts]
    )
    axes.plot(
        *others[:, shown].T, ".", color=style.QUIET, alpha=0.5, zorder=0,
        label="last generation, not re-evaluated",
    )  # fmt: skip


def _draw_rows(
    axes: Axes, rows: Rows, shown: list[int], marker: str, label: str,
    **colors: Any,
) -> None:  # fmt: skip
    x, y = rows.objectives[:, shown].T
    x_error, y_error = style.half_width(
        rows.objectives_standard_error[:, shown]
    ).T
    axes.errorbar(
        x, y, y_error, x_error, marker=marker, linestyle="none", elinewidth=1,
        label=label, **colors,
    )  # fmt: skip


def draw_hypervolume(case: Case) -> Figure:
    """Draws the hypervolume that the front dominates, by generation: a line
    for each seed, with its standard error as a band."""
    runs = [history.generations().hypervolume for history in case.histories]
    known = [
        (seed, run)
        for seed, run in enumerate(runs, start=1)
        if run is not None and len(run.values)
    ]
    if not known:
        raise HistoryError("the histories have no hypervolume")
    figure = style.new_figure(style.WIDTH, 3.6)
    axes = figure.add_subplot()
    for seed, run in known:
        color, _ = style.series(seed - 1)
        number: NDArray = np.arange(len(run.values))
        lower, upper = (
            run.values + sign * style.half_width(run.standard_error)
            for sign in (-1, 1)
        )
        axes.fill_between(
            number, lower, upper, color=color, alpha=0.2, linewidth=0
        )
        axes.plot(number, run.values, color=color, label=f"seed {seed}")
    axes.set_xlabel("generation")
    axes.set_ylabel(style.axis_label("hypervolume", known[0][1].unit))
    axes.xaxis.set_major_locator(MaxNLocator(8, integer=True))
    if len(runs) > 1:
        figure.legend(loc="outside lower center", ncols=3)
    run = known[0][1]
    half = len(run.values) // 2
    before, now = run.values[half], run.values[-1]
    style.set_answer(
        figure,
        f"In the second half of the generations the hypervolume grew by "
        f"{100 * (now - before) / max(abs(now), 1e-12):.2g} % of its final "
        "value.",
    )
    return figure
