# SPDX-License-Identifier: Apache-2.0
"""Draws leaf area and carbon of growing plants over the season, and the plants
at each stage."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..history.case import Case
from ..history.file import HistoryError
from ..history.quantity import Profile
from ..history.rows import Evaluation
from ..mesh.geometry import Mesh
from . import style
from .plants import draw_side, side_limits

DAY = "day_of_stage"
_SHOWN = 8
"""The number of stages that are drawn."""
_LOOKS = (
    ("baseline", style.BASELINE, "D", "--"),
    ("best", style.BEST, "o", "-"),
)


def read_stages(case: Case) -> Profile:
    """Returns the day since emergence of each stage; labels are thermal time
    [deg C d].

    Raises HistoryError if plants do not grow."""
    case.need_pairs()
    if DAY not in case.best.row.quantities:
        raise HistoryError("the plants of the campaign do not grow")
    return case.best.profile(DAY)


def draw_leaf_area(case: Case) -> Figure:
    """Draws green and dead leaf area index of baseline and best over the days
    since emergence."""
    days = read_stages(case).values
    figure = style.new_figure(style.WIDTH, 3.6)
    axes = figure.add_subplot()
    maxima = {}
    for who, color, marker, dash in _LOOKS:
        plant: Evaluation = getattr(case, who)
        green = plant.profile("lai_by_stage")
        axes.plot(
            days, green.values, dash, marker=marker, color=color,
            label=f"{who}, green",
        )  # fmt: skip
        if "dead_area_index_by_stage" in plant.row.quantities:
            dead = plant.profile("dead_area_index_by_stage")
            axes.plot(
                days, dead.values, ":", marker=marker, fillstyle="none",
                color=color, label=f"{who}, dead",
            )  # fmt: skip
        maxima[who] = green.values.max(), days[int(green.values.argmax())]
    axes.set(xlabel="days since emergence", ylabel="leaf area index")
    axes.set_ylim(bottom=0)
    figure.legend(loc="outside lower center", ncols=2)
    (now, day), (was, _) = maxima["best"], maxima["baseline"]
    style.set_answer(
        figure,
        f"The maximum of the best plant is {now:.2f}, {day:.0f} days after "
        f"emergence; that of the baseline is {was:.2f}.",
    )
    return figure


def sum_weeks(
    days: NDArray[np.float64], rates: NDArray[np.float64], last: float
) -> NDArray[np.float64]:
    """Returns sums over the weeks since emergence of a rate per day, which is
    known on some days and interpolated linearly; the last week may be
    shorter."""
    fine = np.arange(int(np.ceil(last))) + 0.5
    daily = np.interp(fine, days, rates)
    return np.array(
        [daily[first : first + 7].sum() for first in range(0, len(daily), 7)]
    )


def draw_carbon(case: Case) -> Figure:
    """Draws the net carbon balance of each week, of baseline and best."""
    days = read_stages(case).values
    name = "carbon_balance_by_stage"
    if name not in case.best.row.quantities:
        raise HistoryError("the history has no carbon balance by stage")
    figure = style.new_figure(style.WIDTH, 3.6)
    axes = figure.add_subplot()
    sums = {}
    for who, color, marker, dash in _LOOKS:
        profile = getattr(case, who).profile(name)
        weeks = sum_weeks(days, profile.values, float(days.max()))
        axes.plot(
            np.arange(len(weeks)) + 1, weeks, dash, marker=marker, color=color,
            label=who,
        )  # fmt: skip
        sums[who] = weeks
    axes.axhline(0, color=style.QUIET, linewidth=1)
    unit = style.unit_label(profile.unit.replace(" day-1", ""))
    axes.set(
        xlabel="week since emergence", ylabel=f"net carbon balance [{unit}]"
    )
    figure.legend(loc="outside lower center", ncols=2)
    by = sums["best"] - sums["baseline"]
    week = int(np.argmax(by))
    style.set_answer(
        figure,
        f"The best plant is ahead in {np.count_nonzero(by > 0)} of {len(by)} "
        f"weeks; the largest lead is {by[week]:.3g} {unit} in week {week + 1}.",
    )
    return figure


def draw_stages(
    case: Case, plants: Sequence[tuple[str, Sequence[Mesh]]]
) -> Figure:
    """Draws baseline and best at each stage from the side, at one scale."""
    days = read_stages(case).values
    chosen = choose_stages(len(days))
    left, right, top = side_limits([m for _, each in plants for m in each])
    width = style.WIDTH / 4
    height = width * top / (right - left) + 0.3
    rows = len(plants) * -(-len(chosen) // 4)
    figure = style.new_figure(style.WIDTH, rows * height + 0.3)
    grid = figure.subplots(rows, 4, squeeze=False)
    panels: list[Axes] = list(grid.ravel())
    for axes in panels:
        axes.set_axis_off()
        axes.set(xlim=(left, right), ylim=(0, top))
    per_plant = len(panels) // len(plants)
    for p, (name, meshes) in enumerate(plants):
        for k, (stage, mesh) in enumerate(zip(chosen, meshes)):
            axes = panels[p * per_plant + k]
            draw_side(axes, mesh)
            axes.set_title(f"{name}, day {days[stage]:.0f}", fontsize=9)
    style.set_answer(
        figure,
        f"{len(chosen)} of the {len(days)} evaluated plant ages; dead organs are "
        "brown.",
    )
    return figure


def choose_stages(count: int) -> list[int]:
    """Returns the positions of the stages that are drawn."""
    if count <= _SHOWN:
        return [*range(count)]
    return [int(i) for i in np.linspace(0, count - 1, _SHOWN).round()]
