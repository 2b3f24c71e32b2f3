# SPDX-License-Identifier: Apache-2.0
"""Draws the objective over all generations."""

from __future__ import annotations

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from ..case import Case
from ..reading.file import HistoryError
from ..reading.state import Generations
from . import style
from .style import answer, axis_label, half_width


def draw_convergence(case: Case) -> Figure:
    """Draws the first objective by generation, numbered from 0 as in the file,
    against the baseline, and the best plant evaluated again. For a single seed
    the figure has the best plant with its standard error, and the mean with
    the spread of the population; for several seeds it has means over seeds,
    with the range of seeds as a band."""
    runs = [history.generations() for history in case.histories]
    runs = [run for run in runs if len(run)]
    if not runs:
        raise HistoryError("no generation is complete yet")
    figure = style.new_figure(style.WIDTH, 4.4)
    axes = figure.add_subplot()
    if len(runs) == 1:
        _draw_seed(axes, runs[0])
    else:
        _draw_seeds(axes, runs)
    count = max(map(len, runs))
    if case.pairs:
        _draw_pairs(axes, case, count)
    objective = case.histories[0].objectives[0]
    axes.set_ylabel(axis_label(objective.name, objective.unit))
    axes.set_xlabel("generation")
    _set_ticks(axes, count, case.is_final)
    figure.legend(loc="outside lower center", ncols=1)
    answer(figure, _verdict(runs))
    return figure


def _verdict(runs: list[Generations]) -> str:
    """Tells whether the means of populations changed in the second half of the
    generations by more than their scatter about a line."""
    changing = 0
    for run in runs:
        values = run.mean.values[len(run) // 2 :]
        if len(values) < 4:
            return "The search is too short to tell."
        number = np.arange(len(values))
        line, squares, *_ = np.polyfit(number, values, 1, full=True)
        error = np.sqrt(squares.sum() / (len(values) - 2) / number.var())
        changing += abs(line[0]) > 2 * error / np.sqrt(len(values))
    of = (
        f"{changing} of {len(runs)} searches"
        if len(runs) > 1
        else "the search"
    )
    if changing:
        return (
            f"No: in the second half of its generations the mean plant of {of} "
            "still changed by more than its noise, so that more generations "
            "would probably gain more."
        )
    return (
        "Yes, as far as one can see: in the second half of the generations the "
        "mean plant no longer changed by more than its noise. A better plant "
        "elsewhere is not excluded."
    )


def _draw_seed(axes: Axes, run: Generations) -> None:
    number = range(len(run))
    axes.errorbar(
        number,
        run.best.values,
        half_width(run.best.standard_error),
        color=style.BEST,
        marker="o",
        markersize=3,
        elinewidth=1,
        label="best of its generation (not evaluated again)",
    )
    mean, spread = run.mean.values, run.spread.values
    axes.plot(number, mean, color=style.MEAN, label="mean")
    _fill(
        axes, mean - spread, mean + spread, style.MEAN,
        "standard deviation about the mean",
    )  # fmt: skip


def _draw_seeds(axes: Axes, runs: list[Generations]) -> None:
    for what, color, label in (
        ("best", style.BEST, "best of its generation (not evaluated again)"),
        ("mean", style.MEAN, "mean of the population"),
    ):
        # The table has NaN for generations that a seed has not reached.
        table = pandas.DataFrame(
            [[*getattr(run, what).values] for run in runs]
        )
        axes.plot(
            range(table.shape[1]),
            table.mean(),
            color=color,
            marker="o" if what == "best" else None,
            markersize=3,
            label=f"{label}, mean of seeds",
        )
        _fill(
            axes, table.min(), table.max(), color, f"{label}, range of seeds"
        )


def _fill(
    axes: Axes, lower: NDArray, upper: NDArray, color: str, label: str
) -> None:
    axes.fill_between(
        range(len(lower)), lower, upper,
        color=color, alpha=0.2, linewidth=0, label=label,
    )  # fmt: skip


def _draw_pairs(axes: Axes, case: Case, end: int) -> None:
    baseline = case.baseline.objective
    axes.axhline(
        baseline.mean,
        color=style.BASELINE,
        linestyle="--",
        label="baseline",
    )
    error = float(half_width(baseline.standard_error))
    axes.axhspan(
        baseline.mean - error,
        baseline.mean + error,
        color=style.BASELINE,
        alpha=0.15,
        linewidth=0,
    )
    again = [pair.best.objective for pair in case.pairs if pair.is_final]
    if again:
        axes.errorbar(
            [end] * len(again),
            [best.mean for best in again],
            half_width([best.standard_error for best in again]),
            color=style.ANEW,
            marker="D",
            linestyle="none",
            label="best plant, evaluated again",
        )


def _set_ticks(axes: Axes, count: int, has_final: bool) -> None:
    """Sets ticks at whole generations, and at "final" after them for the final
    evaluation."""
    ticks = MaxNLocator(8, integer=True).tick_values(0, max(count - 1, 1))
    room = 0.07 * count if has_final else 0
    shown = [int(t) for t in ticks if 0 <= t <= min(count - 1, count - room)]
    labels = [str(t) for t in shown]
    if has_final:
        shown.append(count)
        labels.append("final")
    axes.set_xticks(shown, labels)
