# SPDX-License-Identifier: Apache-2.0
"""Draws the objective over all generations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from ..common.labels import describe_span
from ..errors import NotCompiled
from ..history.case import Case
from ..history.file import HistoryError
from ..history.state import Generations
from ..history.trend import (
    LEAST,
    MATTERS,
    PART_THAT_MATTERS,
    End,
    FurtherGain,
    further_gain,
    searches_differ,
    verdict,
)
from . import style
from .style import axis_label, half_width, set_answer

_WITHOUT_LEARNING = ("random", "sobol")
"""Optimisers that sample plants independently of earlier plants."""


@dataclass(frozen=True)
class Verdict:
    """Whether searches have converged, with the reason in words."""

    end: End
    reason: str
    left: float | None = None
    """What as many further evaluations of `auto` gain at most, in 90 % of
    searches [% of the baseline, or of the last populations if the baseline is
    near zero]; None if no bound is known."""

    def __str__(self) -> str:
        return f"{self.end.value.capitalize()}: {self.reason}."


def draw_convergence(case: Case) -> Figure:
    """Draws the first objective by generation, numbered from 0 as in the file,
    with the baseline and the re-evaluated best plant. A single seed is shown
    by its best plant with the standard error, and by the mean and spread of
    its population; several seeds are shown by their means, with the range over
    seeds as a band."""
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
    set_answer(figure, str(judge_convergence(case, runs)))
    return figure


def judge_convergence(case: Case, runs: Sequence[Generations]) -> Verdict:
    """Judges whether the searches of a case have converged, from the expected
    gain of as many further generations."""
    optimizer = case.resolved.get("search", {}).get("optimizer", "")
    if optimizer in _WITHOUT_LEARNING:
        return Verdict(
            End.UNKNOWN,
            "this search samples plants without learning, so that its "
            "populations have no trend",
        )
    if len(case.histories[0].objectives) > 1:
        return Verdict(
            End.UNKNOWN,
            "one of several objectives does not show it; the hypervolume of the "
            "Pareto front shows progress in all of them",
        )
    scale = _scale(case, runs)
    sign = case.histories[0].objectives[0].sign
    further = further_gain([run.mean.values for run in runs], sign)
    if further is None or not scale > 0:
        return Verdict(
            End.UNKNOWN,
            f"{_count(runs)} generations are too few; at least "
            f"{2 * LEAST - 1} are needed",
        )
    low, mean, high = (
        100 * x / scale for x in (further.low, further.mean, further.high)
    )
    gains = [pair.gain for pair in case.pairs if pair.is_final]
    gain = abs(float(np.mean([x.mean for x in gains]))) if gains else 0.0
    matters = max(MATTERS, PART_THAT_MATTERS * gain)
    end = verdict(FurtherGain(mean, low, high), matters)
    try:
        left = _most_gain_left(runs, sign) if optimizer == "auto" else None
    except NotCompiled as reason:
        return Verdict(End.UNKNOWN, str(reason))
    if left is not None:
        left *= 100 / scale
        evaluations = describe_span([int(x.evaluations.sum()) for x in runs])
        if left < matters:
            end = End.YES
        elif end is End.YES:
            end = End.UNKNOWN
    again = (
        f"as many further evaluations ({evaluations}) gain at most "
        f"{left:.1f} % more, in 90 % of searches"
        if left is not None
        else f"by the trend of the population mean, as many further generations "
        f"({_count(runs)}) would gain {_range(low, high)} % more (95 % "
        "confidence interval)"
    )
    if end is End.NO:
        return Verdict(end, again, left)
    if optimizer == "auto" and left is None:
        return Verdict(
            End.UNKNOWN,
            "after so few evaluations the further gain of this optimiser has "
            f"no tested bound; {again}",
        )
    if searches_differ(gains, matters):
        least, most = (f(x.mean for x in gains) for f in (min, max))
        return Verdict(
            End.UNKNOWN,
            f"the searches gained {least:.1f} to {most:.1f} %, which differ by "
            f"more than their errors; {again}",
            left,
        )
    if end is End.UNKNOWN:
        return Verdict(end, again, left)
    return Verdict(
        end,
        f"{again}; less than {matters:.1f} % counts as converged. A better "
        "plant elsewhere in the design space is not excluded",
        left,
    )


def _most_gain_left(runs: Sequence[Generations], sign: int) -> float | None:
    """Returns the mean over searches by `auto` of the bounds of what as many
    further evaluations gain, as stop.gain_left uses them; none if one is
    unknown.

    Raises NotCompiled if the installation lacks the compiled module, without
    which figures are drawn all the same."""
    from ..common.compiled import _core

    bounds = [
        _core.most_gain_left(
            run.evaluations.tolist(), run.mean.values.tolist(), sign > 0
        )
        for run in runs
    ]
    return None if None in bounds else float(np.mean(bounds))


def _scale(case: Case, runs: Sequence[Generations]) -> float:
    """Returns the absolute objective of the baseline, or that of the last
    populations while the baseline is unknown or within three standard errors
    of zero."""
    if case.pairs and not case.baseline.objective.is_near_zero:
        return abs(case.baseline.objective.mean)
    return abs(float(np.mean([run.mean.values[-1] for run in runs])))


def _count(runs: Sequence[Generations]) -> str:
    return describe_span([len(run) for run in runs])


def _range(low: float, high: float) -> str:
    text = f"{low:.1f} to {high:.1f}"
    return text.replace("-0.0", "0.0").replace("-", "\N{MINUS SIGN}")


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
        label="best of its generation (not re-evaluated)",
    )
    mean, spread = run.mean.values, run.spread.values
    axes.plot(number, mean, color=style.MEAN, label="mean")
    _fill(
        axes, mean - spread, mean + spread, style.MEAN,
        "standard deviation about the mean",
    )  # fmt: skip


def _draw_seeds(axes: Axes, runs: list[Generations]) -> None:
    for quantity, color, label in (
        ("best", style.BEST, "best of its generation (not re-evaluated)"),
        ("mean", style.MEAN, "mean of the population"),
    ):
        # The table has NaN for generations that a seed has not reached.
        table = pandas.DataFrame(
            [[*getattr(run, quantity).values] for run in runs]
        )
        axes.plot(
            range(table.shape[1]),
            table.mean(),
            color=color,
            marker="o" if quantity == "best" else None,
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
            color=style.ACCENT,
            marker="D",
            linestyle="none",
            label="best plant, re-evaluated",
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
