# SPDX-License-Identifier: Apache-2.0
"""Draws the best plant of each kind as a map."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..history.atlas import Atlas, AtlasAxis
from ..history.case import Case
from ..history.file import HistoryError
from ..history.interval import interval
from . import style


def draw_atlas(case: Case) -> Figure:
    """Draws the first objective of the leader of each cell of the first two
    axes; if there is a third axis, the best of its leaders.

    Raises HistoryError if no leader is evaluated yet."""
    atlas = case.best_history.atlas()
    if atlas is None:
        raise HistoryError("no leader of the atlas is re-evaluated yet")
    shown = np.array(atlas.on_two_axes())
    rows = 1 if len(atlas.axes) == 1 else atlas.axes[1].cells
    figure = style.new_figure(style.WIDTH, 2.6 + 0.3 * rows)
    axes = figure.add_subplot()
    (_draw_line if len(atlas.axes) == 1 else _draw_map)(axes, atlas, shown)
    if np.any(~atlas.is_confirmed[shown]):
        figure.legend(loc="outside upper center")
    style.set_answer(figure, _answer(atlas))
    return figure


def _draw_map(axes: Axes, atlas: Atlas, shown: np.ndarray) -> None:
    across, up = atlas.axes[:2]
    table = np.full((up.cells, across.cells), np.nan)
    x, y = atlas.cells[shown, :2].T
    table[y, x] = atlas.leaders.objectives[shown, 0]
    image = axes.imshow(table, cmap="viridis", origin="lower", aspect="auto")
    open_ = ~atlas.is_confirmed[shown]
    axes.plot(
        x[open_], y[open_], "x", color="white", markeredgecolor=style.ACCENT,
        markeredgewidth=2, label="not confirmed",
    )  # fmt: skip
    for which, axis in ((axes.xaxis, across), (axes.yaxis, up)):
        which.set_ticks(range(axis.cells), axis.spans())
    axes.tick_params("x", rotation=45)
    axes.set(xlabel=_label(across), ylabel=_label(up))
    axes.grid(visible=False)
    goal = atlas.leaders.goals[0]
    axes.figure.colorbar(
        image, ax=axes, location="bottom", aspect=40,
        label=style.axis_label(goal.name, goal.unit),
    )  # fmt: skip


def _draw_line(axes: Axes, atlas: Atlas, shown: np.ndarray) -> None:
    (axis,), goal = atlas.axes, atlas.leaders.goals[0]
    middles = (axis.edges[1:] + axis.edges[:-1])[atlas.cells[shown, 0]] / 2
    error = style.half_width(atlas.leaders.objectives_standard_error[shown, 0])
    values = atlas.leaders.objectives[shown, 0]
    for which, label, face in (
        (atlas.is_confirmed[shown], "confirmed", style.BEST),
        (~atlas.is_confirmed[shown], "not confirmed", "white"),
    ):
        axes.errorbar(
            middles[which], values[which], error[which], fmt="o", label=label,
            color=style.BEST, markerfacecolor=face,
        )  # fmt: skip
    axes.set(
        xlabel=_label(axis), ylabel=style.axis_label(goal.name, goal.unit)
    )


def _label(axis: AtlasAxis) -> str:
    return style.axis_label(axis.name, axis.unit)


def _answer(atlas: Atlas) -> str:
    goal, leaders = atlas.leaders.goals[0], atlas.leaders
    best = atlas.one(int(leaders.ranking(1)[0])).objective
    worth = goal.sign * leaders.objectives[:, 0]
    error = style.half_width(leaders.objectives_standard_error[:, 0])
    top = int(np.argmax(worth))
    near = int(np.sum(worth + np.hypot(error, error[top]) >= worth[top]))
    place = " and ".join(
        f"{style.words(axis.name)} of {axis.spans()[cell]}{_unit(axis.unit)}"
        for axis, cell in zip(atlas.axes, atlas.cells[top])
    )
    return (
        f"The best of {len(leaders)} kinds has {place}, and reaches "
        f"{interval([best]).number()}{_unit(goal.unit)}. {near - 1} others do "
        "not differ significantly from it. "
        f"{int(atlas.is_confirmed.sum())} leaders were confirmed by "
        "re-evaluation in the search."
    )


def _unit(unit: str) -> str:
    return "" if unit == "1" else f" {style.unit_label(unit)}"
