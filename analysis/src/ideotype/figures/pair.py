# SPDX-License-Identifier: Apache-2.0
"""Draws the baseline and the best plant next to each other."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..common.labels import unit_label
from ..history.case import Case
from ..mesh.geometry import Mesh
from . import style
from .plants import draw_side, side_limits
from .trait_changes import describe_changes


def draw_pair(case: Case, baseline: Mesh, best: Mesh) -> Figure:
    """Draws the baseline and the best plant from the side at one scale, with
    their objectives."""
    left, right, top = side_limits([baseline, best])
    width = style.WIDTH / 2 - 0.3
    height = width * top / (right - left)
    figure = style.new_figure(style.WIDTH, height + 1.0)
    panels = figure.subplots(1, 2, sharey=True)
    for axes, who, mesh in zip(
        panels, ("baseline", "best"), (baseline, best), strict=True
    ):
        draw_plant(axes, mesh, (left, right, top))
        objective = getattr(case, who).objective
        unit = "" if objective.unit == "1" else unit_label(objective.unit)
        name = {"best": "best plant"}.get(who, who)
        axes.set_title(f"{name}\n{objective.interval_text()}\n{unit}".rstrip())
    panels[0].set_ylabel("height [m]")
    traits = [
        trait
        for kind in ("leaf", "profile", "plant")
        for trait in case.genes.bred(kind)
    ]
    style.set_answer(figure, describe_changes(case, traits))
    return figure


def draw_plant(
    axes: Axes, mesh: Mesh, limits: tuple[float, float, float]
) -> None:
    """Draws a plant from the side above its ground. `limits` are left, right
    and top [m]."""
    left, right, top = limits
    draw_side(axes, mesh)
    axes.set(xlim=(left, right), ylim=(0, top), xticks=[])
    axes.spines["left"].set_visible(False)
    axes.grid(visible=True, axis="y")
    axes.tick_params(axis="y", length=0)
