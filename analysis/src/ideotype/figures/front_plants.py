# SPDX-License-Identifier: Apache-2.0
"""Draws the plants along a front, side by side."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

import numpy as np
from matplotlib.figure import Figure

from ..history.case import Case
from ..history.estimate import Estimate
from ..history.file import HistoryError
from ..history.rows import Evaluation
from ..mesh.geometry import Mesh
from . import style
from .plants import draw_side, side_limits

_MOST = 5


def draw_front_plants(
    case: Case, baseline: Mesh, members: Sequence[Mesh]
) -> Figure:
    """Draws the baseline and up to five plants of the front, at equal steps in
    the order of the first objective, from the side at one scale, with all
    objectives and their standard errors. Plants have their numbers of the
    whole report.

    Raises HistoryError if there is no front."""
    plants = [
        (front.one(i), case.member_title(seed, i), bool(front.is_kept[i]))
        for seed, (_, front) in enumerate(case.fronts)
        for i in range(len(front.members))
    ]
    kept = [
        (plant, mesh, name)
        for (plant, name, keeps), mesh in zip(plants, members)
        if keeps
    ]
    if not kept:
        raise HistoryError("no front is evaluated yet")
    kept.sort(key=lambda each: each[0].objective.mean)
    steps = np.linspace(0, len(kept) - 1, min(len(kept), _MOST))
    shown = [(case.baseline, baseline, "baseline")]
    shown += [kept[i] for i in dict.fromkeys(steps.round().astype(int))]
    columns = min(len(shown), 2)
    rows = -(-len(shown) // columns)
    left, reach, top = side_limits([mesh for _, mesh, _ in shown])
    size = style.WIDTH / 2 * columns
    objectives = case.best.row.goals
    words = 0.3 + 0.2 * len(objectives)
    height = size / columns * top / (2 * reach) + words
    figure = style.new_figure(size, 0.5 + rows * height)
    panels = figure.subplots(rows, columns, squeeze=False)
    for axes, (plant, mesh, name) in zip(chain(*panels), shown):
        draw_side(axes, mesh)
        axes.set(xlim=(left, reach), ylim=(0, top))
        text = "\n".join(_objectives(plant))
        axes.set_title(f"{name}\n{text}", fontsize=9)
    for axes in chain(*panels):
        axes.set_axis_off()
    style.set_answer(
        figure,
        "Numbers: "
        + ", ".join(
            style.axis_label(objective.name, objective.unit)
            for objective in objectives
        )
        + ".",
    )
    return figure


def _objectives(plant: Evaluation) -> list[str]:
    return [
        _text(plant.estimate(objective.name)) for objective in plant.row.goals
    ]


def _text(of: Estimate) -> str:
    return of.interval_text()
