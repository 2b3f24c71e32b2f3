# SPDX-License-Identifier: Apache-2.0
"""Draws the figure of a report for a paper: baseline and best plant, and the
gains."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..history.case import Case
from ..mesh.geometry import Mesh
from . import style
from .comparison import OVER_BASELINE, draw_gain_axes, measure_gains
from .pair import draw_plant
from .plants import side_limits

_WIDTH = 7.1
"""The width of two columns of a journal, 180 mm [inches]."""

_HEIGHT = 2.6
"""The least height of panels [inches]."""


def draw_paper_figure(
    known: Sequence[Case], plants: tuple[Mesh, Mesh] | None
) -> Figure:
    """Draws the baseline (a) and the best plant (b) from the side at one
    scale, and the gains of all cases (c); the gains alone without shapes."""
    height = max(_HEIGHT, 0.5 + measure_gains(known)) + 0.9
    figure = style.new_figure(_WIDTH if plants else style.WIDTH, height)
    if plants is None:
        axes = figure.add_subplot()
    else:
        grid = figure.add_gridspec(1, 3, width_ratios=(1, 1, 1.9))
        limits = side_limits(plants)
        first = figure.add_subplot(grid[0])
        second = figure.add_subplot(grid[1], sharey=first)
        for panel, letter, name, mesh in zip(
            (first, second), "ab", ("baseline", "best plant"), plants,
            strict=True,
        ):  # fmt: skip
            draw_plant(panel, mesh, limits)
            _name(panel, letter, name)
        first.set_ylabel("height [m]")
        second.tick_params(labelleft=False)
        axes = figure.add_subplot(grid[2])
        _name(axes, "c", "gain over the baseline")
    draw_gain_axes(axes, known)
    handles, labels = axes.get_legend_handles_labels()
    entries = dict(zip(labels, handles))
    mean = "mean" if any(len(case.pairs) > 1 for case in known) else "gain"
    entries = {
        f"{mean}, 95 % confidence interval"
        if label == OVER_BASELINE
        else label: handle
        for label, handle in entries.items()
    }
    figure.legend(
        entries.values(), entries.keys(), loc="outside lower right", fontsize=8
    )
    return figure


def _name(axes: Axes, letter: str, name: str) -> None:
    axes.set_title(rf"$\bf{{({letter})}}$ {name}", loc="left", fontsize=9)
