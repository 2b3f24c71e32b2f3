# SPDX-License-Identifier: Apache-2.0
"""What the fittest plants look like."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from numpy.typing import NDArray

from . import style
from .azimuths import azimuths
from .case import Case
from .circle import circular_deviation, circular_mean
from .compass import draw_compass
from .file import HistoryError
from .genes import Kind
from .profile_curve import curve
from .rows import Rows

COUNT = 10
"""How many plants are shown."""

_ACROSS = 4
"""Panels beside each other."""


def draw_traits(case: Case) -> Figure:
    """Each bred trait by leaf rank: the fittest plants, their mean and
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
    return _finish(figure, case, panels[0])


def draw_profiles(case: Case) -> Figure:
    """Each bred trait that is a smooth curve over leaf position: its points
    as in draw_traits(), and the curves of the fittest plants and of the
    baseline."""
    traits = _bred(case, "profile")
    figure, panels = _panels(traits, 4.4)
    top = case.top(COUNT)
    for axes, trait in zip(panels, traits):
        columns = case.genes.columns(trait)
        place = np.linspace(0, 1, len(columns))
        _draw_trait(axes, case, trait, place)
        along = np.linspace(0, 1, 101)
        for values, color in reversed(_colored(top, columns)):
            axes.plot(curve(values, along), along, color=color, lw=0.9)
        if case.pairs:
            values = case.baseline.row.genome[0, columns]
            axes.plot(
                curve(values, along), along, "--", color=style.BASELINE, lw=0.9
            )
        axes.set_yticks([0, 0.5, 1], ["lowest", "middle", "highest"])
    for axes in panels[::_ACROSS]:
        axes.set_ylabel("leaf position")
    return _finish(figure, case, panels[0])


def draw_plant_traits(case: Case) -> Figure:
    """Each bred trait of the whole plant, as in draw_traits()."""
    traits = _bred(case, "plant")
    figure = style.new_figure(style.WIDTH, 1.2 + 0.8 * len(traits))
    panels = figure.subplots(len(traits), 1, squeeze=False)[:, 0]
    for axes, trait in zip(panels, traits):
        _draw_trait(axes, case, trait, np.zeros(1))
        axes.set_yticks([])
    return _finish(figure, case, panels[0])


_WHAT: dict[Kind, str] = {
    "leaf": "no trait of single leaves",
    "plant": "no trait of the whole plant",
    "profile": "no profile over leaf position",
}


def _bred(case: Case, kind: Kind) -> list[str]:
    found = case.genes.bred(kind)
    if not found:
        raise HistoryError(f"{_WHAT[kind]} is bred")
    return found


def _panels(traits: list[str], height: float) -> tuple[Figure, list[Axes]]:
    """One for each trait, of this height [inches]."""
    across = min(len(traits), _ACROSS)
    down = -(-len(traits) // across)
    figure = style.new_figure(style.WIDTH, 0.6 + height * down)
    grid = figure.subplots(down, across, sharey=True, squeeze=False).ravel()
    for axes in grid[len(traits) :]:
        axes.set_axis_off()
    return figure, list(grid[: len(traits)])


def _finish(figure: Figure, case: Case, first: Axes) -> Figure:
    """Legend and title."""
    handles, labels = first.get_legend_handles_labels()
    top = case.top(COUNT)
    _add_top_handle(first, handles, labels, len(top))
    _add_best_handle(case, first, handles, labels)
    figure.legend(
        handles, labels, loc="outside lower center", ncols=4, fontsize=8
    )
    figure.suptitle(_title(case, top), fontsize=10)
    return figure


def draw_azimuths(case: Case) -> Figure:
    """Leaf azimuths from above, the lowest leaf innermost: the fittest
    plants, their circular mean and deviation, and the baseline."""
    top = case.top(COUNT)
    plants = azimuths(case, top.genome)
    leaves = np.arange(plants.shape[1]) + 1
    figure = style.new_figure(7.0, 6.4)
    grid = figure.add_gridspec(1, 2, width_ratios=(1, 0.16))
    axes = cast(PolarAxes, figure.add_subplot(grid[0], projection="polar"))
    draw_compass(figure.add_subplot(grid[1]), case)
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    colors = style.ranked_colors(len(top))
    for values, color in zip(plants[::-1], colors[::-1]):
        axes.plot(np.deg2rad(values), leaves, "o", color=color, alpha=0.8)
    _draw_arcs(axes, plants, leaves)
    if case.pairs:
        (values,) = azimuths(case, case.baseline.row.genome)
        axes.plot(np.deg2rad(values), leaves, **_BASELINE_MARKER)
    for genome in _bests(case):
        (values,) = azimuths(case, genome[None])
        axes.plot(np.deg2rad(values), leaves, **_BEST_MARKER)
    axes.plot([0, 0], [0, 1.1 * leaves.max()], color=style.QUIET, ls="--")
    axes.plot([np.pi] * 2, [0, 1.1 * leaves.max()], color=style.QUIET, ls="--")
    axes.set_rlim(0, leaves.max() + 0.9)
    axes.grid(color="#CFCFCF")
    axes.set_rgrids(leaves, [])
    for leaf in leaves:
        axes.text(np.pi / 8, float(leaf), str(leaf), **_RANK_LABEL)
    axes.set_thetagrids(
        np.arange(0, 360, 45),
        ["0° along the row"] + [f"{a}°" for a in range(45, 360, 45)],
    )
    handles, labels = axes.get_legend_handles_labels()
    _add_top_handle(axes, handles, labels, len(top))
    _add_best_handle(case, axes, handles, labels)
    figure.legend(
        handles, labels, loc="outside lower center", ncols=3, fontsize=8
    )
    figure.suptitle(
        f"{_title(case, top)}\n"
        "leaf azimuths from above; circles: leaf rank, lowest innermost",
        fontsize=10,
    )
    return figure


_BASELINE_MARKER: dict[str, Any] = {
    "marker": "D",
    "markersize": 5.5,
    "markerfacecolor": "none",
    "color": style.BASELINE,
    "linestyle": "none",
    "label": "baseline",
}


_BEST_MARKER: dict[str, Any] = {
    "marker": "^",
    "markersize": 6.5,
    "markerfacecolor": "none",
    "color": style.BEST,
    "linestyle": "none",
}


_RANK_LABEL: dict[str, Any] = {
    "ha": "center",
    "va": "center",
    "fontsize": 7,
    "zorder": 1.9,  # above the circles, below the plants
    "bbox": {"facecolor": "white", "edgecolor": "none", "pad": 0.5},
}


def _title(case: Case, top: Rows) -> str:
    first, last = int(top.generation.min()), int(top.generation.max())
    of = (
        f"generation {last}"
        if first == last
        else f"generations {first}-{last}"
    )
    seeds = len(case.histories)
    title = f"{case.name}\nthe {len(top)} fittest plants of {of}"
    if seeds == 1:
        return title
    return f"{title}, from {case.seeds_of_top(COUNT)} of {seeds} seeds"


def _colored(top: Rows, columns: NDArray) -> list[tuple[NDArray, NDArray]]:
    """The traits and the colour of each plant, fittest first."""
    return list(zip(top.genome[:, columns], style.ranked_colors(len(top))))


def _bests(case: Case) -> list[NDArray]:
    """Genomes of the best of each seed, which show whether seeds agree;
    nothing for a single seed."""
    if len(case.pairs) < 2:
        return []
    return [pair.best.row.genome[0] for pair in case.pairs]


def _add_best_handle(
    case: Case, axes: Axes, handles: list, labels: list
) -> None:
    if len(case.pairs) > 1:
        (handle,) = axes.plot([], [], **_BEST_MARKER)
        handles.append(handle)
        labels.append("best of each seed")


def _add_top_handle(
    axes: Axes, handles: list, labels: list, count: int
) -> None:
    (handle,) = axes.plot(
        [], [], "o", color=style.ranked_colors(count)[0], alpha=0.8
    )
    handles.insert(0, handle)
    labels.insert(0, "one plant (dark: fitter)")


def _draw_trait(axes: Axes, case: Case, trait: str, place: NDArray) -> None:
    """A trait's genes, each at its place upwards."""
    genes, top = case.genes, case.top(COUNT)
    columns = genes.columns(trait)
    is_circular = bool(genes.is_circular[columns].all())
    step = place[1] - place[0] if len(place) > 1 else 1.0
    axes.barh(
        place,
        (genes.upper - genes.lower)[columns],
        left=genes.lower[columns],
        height=0.8 * step,
        color="#F0F0F0",
        label="bounds",
    )
    for values, color in reversed(_colored(top, columns)):
        axes.plot(values, place, "o", color=color, markersize=3, alpha=0.8)
    _draw_mean(axes, top.genome[:, columns], place - 0.28 * step, is_circular)
    if case.pairs:
        plain = case.baseline.row.genome[0, columns]
        axes.plot(plain, place, **_BASELINE_MARKER)
    for genome in _bests(case):
        axes.plot(genome[columns], place, **_BEST_MARKER)
    # of the bounds, and of deviations that reach past them
    lower, upper = axes.dataLim.intervalx
    margin = 0.04 * (upper - lower)
    axes.set_xlim(lower - margin, upper + margin)
    if is_circular:
        axes.set_xticks(np.linspace(lower, upper, 5))
    axes.set_xlabel(genes.label(trait))


def _draw_mean(
    axes: Axes, values: NDArray, y: NDArray, is_circular: bool
) -> None:
    """Mean and standard deviation of each gene."""
    if is_circular:
        mean = circular_mean(values)
        deviation = np.minimum(circular_deviation(values), 180.0)
        # A bar that leaves on one side of the circle comes in on the other.
        left, right = mean - deviation, 360.0 - mean - deviation
        past, before = y[right < 0], y[left < 0]
        axes.hlines(past, 0.0, -right[right < 0], color=style.ANEW)
        axes.hlines(before, 360.0 + left[left < 0], 360.0, color=style.ANEW)
        reach = np.minimum(deviation, [mean, 360.0 - mean])
    else:
        mean, deviation = values.mean(0), _deviation(values)
        reach = np.array([deviation, deviation])
    axes.errorbar(
        mean,
        y,
        xerr=reach,
        color=style.ANEW,
        marker="|",
        linestyle="none",
        label="their mean ± standard deviation",
    )


def _deviation(values: NDArray) -> NDArray:
    return values.std(0, ddof=1) if len(values) > 1 else 0 * values[0]


def _draw_arcs(axes: Axes, values: NDArray, leaves: NDArray) -> None:
    """Circular mean and deviation by leaf, just outside the points."""
    mean = circular_mean(values)
    deviation = np.minimum(circular_deviation(values), 180.0)
    for center, width, leaf in zip(mean, deviation, leaves):
        arc = np.deg2rad(np.linspace(center - width, center + width, 60))
        axes.plot(arc, np.full(len(arc), leaf + 0.3), color=style.ANEW, lw=1.2)
    axes.plot(
        np.deg2rad(mean),
        leaves + 0.3,
        "s",
        color=style.ANEW,
        markersize=3,
        label="circular mean ± deviation",
    )
