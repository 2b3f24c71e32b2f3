# SPDX-License-Identifier: Apache-2.0
"""Draws the optimised traits of the fittest plants."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..history.case import Case
from ..history.file import HistoryError
from ..history.genes import Kind, curve
from . import style
from .numbers import RANGE
from .trait_changes import describe_changes

COUNT = 10
"""The number of plants that are shown."""

_ACROSS = 2
"""The number of panels in a row."""

_BASELINE_MARKER: dict[str, Any] = {
    "marker": "D",
    "markersize": 5.5,
    "markerfacecolor": "none",
    "color": style.BASELINE,
    "linestyle": "none",
    "label": "baseline",
}
_BEST_MARKER = _BASELINE_MARKER | {
    "marker": "^",
    "markersize": 6.5,
    "color": style.BEST,
    "label": "best of each seed",
}
_MISSING: dict[Kind, str] = {
    "leaf": "no trait of single leaves",
    "plant": "no trait of the whole plant",
    "profile": "no profile over leaf position",
}


def draw_traits(case: Case) -> Figure:
    """Draws each optimised trait by leaf rank: the fittest plants, their mean and
    standard deviation, the baseline, and the bounds."""
    traits = _bred(case, "leaf")
    leaves = case.genes.leaves[case.genes.columns(traits[0])]
    figure, panels = _panels(traits, 1.6 + 0.28 * len(leaves))
    for axes, trait in zip(panels, traits):
        _draw_trait(axes, case, trait, leaves)
        axes.set_yticks(leaves)
        axes.set_ylim(leaves.min() - 0.6, leaves.max() + 0.6)
    for axes in panels[::_ACROSS]:
        axes.set_ylabel("leaf rank (1 = lowest)")
    style.set_answer(figure, describe_changes(case, traits))
    return finish(figure, panels[0])


def draw_profiles(case: Case) -> Figure:
    """Draws each optimised trait that is a smooth curve over leaf position: the
    points of the profile as in draw_traits(), and the curves of the fittest
    plants and of the baseline."""
    traits = _bred(case, "profile")
    figure, panels = _panels(traits, 4.4)
    along = np.linspace(0, 1, 101)
    for axes, trait in zip(panels, traits):
        columns = case.genes.columns(trait)
        _draw_trait(axes, case, trait, np.linspace(0, 1, len(columns)))
        for values, color in _colored(case.top(COUNT).genome[:, columns]):
            axes.plot(curve(values, along), along, color=color, lw=0.9)
        if case.pairs:
            values = curve(case.baseline.row.genome[0, columns], along)
            axes.plot(values, along, "--", color=style.BASELINE, lw=0.9)
        axes.set_yticks([0, 0.5, 1], ["lowest", "middle", "highest"])
    for axes in panels[::_ACROSS]:
        axes.set_ylabel("leaf position")
    style.set_answer(figure, describe_changes(case, traits))
    return finish(figure, panels[0])


def draw_plant_traits(case: Case) -> Figure:
    """Draws each optimised trait of the whole plant, as in draw_traits()."""
    traits = _bred(case, "plant")
    figure = style.new_figure(style.WIDTH, 1.2 + 0.8 * len(traits))
    panels = figure.subplots(len(traits), 1, squeeze=False)[:, 0]
    for axes, trait in zip(panels, traits):
        _draw_trait(axes, case, trait, np.zeros(1))
        axes.set_yticks([])
    style.set_answer(figure, describe_changes(case, traits))
    return finish(figure, panels[0])


def _bred(case: Case, kind: Kind) -> list[str]:
    traits = case.genes.bred(kind)
    if not traits:
        raise HistoryError(f"{_MISSING[kind]} is optimised")
    return traits


def _panels(traits: list[str], height: float) -> tuple[Figure, list[Axes]]:
    """Returns a figure with a panel of the given height [inches] for each
    trait."""
    across = min(len(traits), _ACROSS)
    down = -(-len(traits) // across)
    figure = style.new_figure(style.WIDTH, 0.6 + height * down)
    grid = figure.subplots(down, across, sharey=True, squeeze=False).ravel()
    for axes in grid[len(traits) :]:
        axes.set_axis_off()
    return figure, list(grid[: len(traits)])


def finish(figure: Figure, first: Axes) -> Figure:
    """Adds the legend."""
    handles, labels = first.get_legend_handles_labels()
    shown = dict(zip(labels, handles))
    figure.legend(
        shown.values(), shown.keys(),
        loc="outside lower center", ncols=2,
    )  # fmt: skip
    return figure


def draw_plants(
    axes: Axes,
    case: Case,
    numbers: Callable[[NDArray], NDArray],
    place: NDArray,
    size: float | None = None,
) -> None:
    """Draws the fittest plants, the baseline, and for several seeds the best
    plant of each seed, which shows whether seeds agree: numbers(genomes),
    [plants, places], against the places."""
    for values, color in _colored(numbers(case.top(COUNT).genome)):
        axes.plot(
            values, place, "o", color=color, markersize=size, alpha=0.8,
            label="single plant (darker: fitter)",
        )  # fmt: skip
    if case.pairs:
        (values,) = numbers(case.baseline.row.genome)
        axes.plot(values, place, **_BASELINE_MARKER)
    if len(case.pairs) > 1:
        for pair in case.pairs:
            (values,) = numbers(pair.best.row.genome)
            axes.plot(values, place, **_BEST_MARKER)


def _colored(values: NDArray) -> list[tuple[NDArray, NDArray]]:
    """Returns the numbers and the colour of each plant, the fittest last."""
    return [*zip(values, style.ranked_colors(len(values)))][::-1]


def _draw_trait(axes: Axes, case: Case, trait: str, place: NDArray) -> None:
    """Draws a trait's genes, each gene at its place on the vertical axis."""
    genes = case.genes
    columns = genes.columns(trait)
    is_circular = bool(genes.is_circular[columns].all())
    step = place[1] - place[0] if len(place) > 1 else 1.0
    lower, width = genes.lower[columns], (genes.upper - genes.lower)[columns]
    axes.barh(
        place, width, left=lower, height=0.8 * step, color="#F0F0F0",
        label="bounds", gid=RANGE,
    )  # fmt: skip
    draw_plants(axes, case, lambda genomes: genomes[:, columns], place, 3)
    if not genes.is_choice(columns[0]):
        shown = case.top(COUNT).genome[:, columns]
        _draw_mean(axes, shown, place - 0.28 * step, is_circular)
    # The axis limits include the bounds, and deviations that extend beyond
    # them.
    left, right = axes.dataLim.intervalx
    margin = 0.04 * (right - left)
    axes.set_xlim(left - margin, right + margin)
    if is_circular:
        axes.set_xticks(np.linspace(left, right, 5))
    if genes.values and (labels := genes.values[columns[0]]):
        axes.set_xticks(range(len(labels)), labels)
    axes.set_xlabel(genes.label(trait))


def _draw_mean(
    axes: Axes, values: NDArray, y: NDArray, is_circular: bool
) -> None:
    """Draws mean and standard deviation of each gene."""
    if is_circular:
        mean, deviation = circular_mean_and_deviation(values)
        # A bar that passes 360 deg continues at 0 deg.
        left, right = mean - deviation, 360.0 - mean - deviation
        past, before = y[right < 0], y[left < 0]
        axes.hlines(past, 0.0, -right[right < 0], color=style.ACCENT)
        axes.hlines(before, 360.0 + left[left < 0], 360.0, color=style.ACCENT)
        reach = np.minimum(deviation, [mean, 360.0 - mean])
    else:
        mean = values.mean(0)
        deviation = values.std(0, ddof=1) if len(values) > 1 else 0 * mean
        reach = np.array([deviation, deviation])
    axes.errorbar(
        mean, y, xerr=reach, color=style.ACCENT, marker="|", linestyle="none",
        label="mean and standard deviation",
    )  # fmt: skip


def circular_mean_and_deviation(degrees: NDArray) -> tuple[NDArray, NDArray]:
    """Returns the circular mean, in [0, 360), and standard deviation, at most
    180, of each column [deg]."""
    # SciPy is imported at its use, because its import takes long.
    from scipy.stats import circmean, circstd

    deviation = circstd(degrees, high=360, axis=0)
    # The mean 360 deg becomes 0 deg.
    mean = circmean(degrees, high=360, axis=0) % 360
    return mean, np.minimum(deviation, 180.0)
