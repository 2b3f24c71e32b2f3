"""The fitness of all generations."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike, NDArray

from . import style
from .estimate import DAILY_ENERGY, MWH_PER_ACRE_PER_MJ_PER_M2
from .file import HistoryError
from .history import History
from .pair import Pair


def draw_convergence(history: History) -> Figure:
    """Best of each generation with its standard error, mean with the spread
    of the population, the baseline, and the best evaluated anew."""
    generations = history.generations()
    if not len(generations):
        raise HistoryError("no generation is complete yet")
    figure = style.new_figure(6.4, 4.2)
    axes = figure.add_subplot()
    number = range(len(generations))
    axes.errorbar(
        number,
        generations.best.values,
        generations.best.standard_error,
        color=style.BEST,
        marker="o",
        markersize=3,
        elinewidth=1,
        label="best of its generation ± standard error",
    )
    mean, spread = generations.mean.values, generations.spread.values
    axes.plot(number, mean, color=style.MEAN, label="mean")
    axes.fill_between(
        number,
        mean - spread,
        mean + spread,
        color=style.MEAN,
        alpha=0.2,
        linewidth=0,
        label="mean ± standard deviation",
    )
    pair = history.comparison()
    has_final = pair is not None and pair.is_final
    if pair is not None:
        _draw_pair(axes, pair, len(generations))
    objective = history.evaluations(0).objectives
    axes.set_ylabel(style.axis_label(objective.names[0], objective.units[0]))
    axes.set_xlabel("generation")
    _set_ticks(axes, len(generations), has_final)
    axes.set_title(str(history.attributes.get("case", history.path.stem)))
    axes.legend(loc="best", fontsize=8)
    if objective.units[0] == DAILY_ENERGY:
        _add_acre_axis(axes)
    return figure


def _draw_pair(axes: Axes, pair: Pair, end: int) -> None:
    baseline = pair.baseline.objective
    axes.axhline(
        baseline.mean,
        color=style.BASELINE,
        linestyle="--",
        label="baseline ± standard error",
    )
    axes.axhspan(
        baseline.mean - baseline.standard_error,
        baseline.mean + baseline.standard_error,
        color=style.BASELINE,
        alpha=0.15,
        linewidth=0,
    )
    if pair.is_final:
        best = pair.best.objective
        axes.errorbar(
            [end],
            [best.mean],
            [best.standard_error],
            color=style.ANEW,
            marker="D",
            linestyle="none",
            label="best plant, evaluated anew ± standard error",
        )


def _set_ticks(axes: Axes, count: int, has_final: bool) -> None:
    """Whole generations, and "anew" after them for the final evaluation."""
    ticks = MaxNLocator(8, integer=True).tick_values(0, max(count - 1, 1))
    room = 0.07 * count if has_final else 0
    shown = [int(t) for t in ticks if 0 <= t <= min(count - 1, count - room)]
    labels = [str(t) for t in shown]
    if has_final:
        shown.append(count)
        labels.append("anew")
    axes.set_xticks(shown, labels)


def _add_acre_axis(axes: Axes) -> None:
    factor = MWH_PER_ACRE_PER_MJ_PER_M2

    def to_acre(energy: ArrayLike) -> NDArray:
        return np.asarray(energy) * factor

    def from_acre(energy: ArrayLike) -> NDArray:
        return np.asarray(energy) / factor

    right = axes.secondary_yaxis("right", functions=(to_acre, from_acre))
    right.spines["right"].set_visible(True)
    right.set_ylabel(f"[{style.unit_label('MWh acre-1 day-1')}]")
