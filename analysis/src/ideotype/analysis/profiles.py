# SPDX-License-Identifier: Apache-2.0
"""Where and when the leaves absorb: by hour, leaf rank and height."""

from __future__ import annotations

from typing import cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .case import Case
from .file import HistoryError
from .photons import label_light
from .quantity import Axis, Profile

_ELSEWHERE = (
    "sunlit_lai_by_hour",
    *("assimilation_by_hour", "assimilation_by_leaf"),
    "net_assimilation_by_leaf",
)
"""Quantities that have figures of their own."""

Looks = tuple[str, str, str, str]
"""Label, colour, marker, line."""

PLANTS: tuple[Looks, Looks] = (
    ("baseline", style.BASELINE, "D", "--"),
    ("best", style.BEST, "o", "-"),
)


def draw_hours(case: Case) -> Figure:
    """PAR absorbed by leaves at each hour, and best minus baseline. The error
    of the difference takes both as independent. Parts of the light have a
    panel each if the history tells them apart."""
    names = _names(case, "hour", "hour")
    figure = style.new_figure(max(6.4, 3.6 * len(names)), 5.2)
    grid = figure.subplots(
        2, len(names), sharex="col", height_ratios=(2, 1), squeeze=False
    )
    for (upper, lower), name in zip(grid.T, names):
        _draw_hours(upper, lower, case, name)
    span = "season" if case.best.row.with_axis("day") else "day"
    kind = "" if case.best_pair.is_final else "provisional "
    gain = case.best_pair.gain.number().replace("+-", "±")
    figure.suptitle(
        f"{case.name}: {kind}gain over the {span} {gain} % (standard error)",
        fontsize=10,
    )
    return figure


def _draw_hours(upper: Axes, lower: Axes, case: Case, name: str) -> None:
    baseline, best = case.baseline.profile(name), case.best.profile(name)
    for profile, (label, color, marker, line) in zip((baseline, best), PLANTS):
        upper.errorbar(
            best.labels,
            profile.values,
            profile.standard_error,
            color=color,
            marker=marker,
            markersize=3.5,
            linestyle=line,
            label=f"{label} ± standard error",
        )
    lower.axhline(0, color=style.QUIET, linewidth=1)
    lower.errorbar(
        best.labels,
        best.values - baseline.values,
        np.hypot(best.standard_error, baseline.standard_error),
        color=style.BEST,
        marker="o",
        markersize=3.5,
    )
    label_light(upper, "y", _title(name), best.unit)
    lower.set_ylabel(style.axis_label("best − baseline\n", best.unit))
    set_hours(lower, best)
    upper.set_ylim(bottom=0)
    upper.legend()


def set_hours(axes: Axes, profile: Profile) -> None:
    """Whole hours, as many as there is room for, and their clock."""
    axes.set_xlabel(f"{profile.meaning} [h]")
    first, last = np.floor(profile.labels.min()), np.ceil(profile.labels.max())
    step = max(1, round((last - first) / 14))
    axes.set_xticks(np.arange(first, last + 1, step))


def draw_leaves(case: Case) -> Figure:
    """What is known by leaf rank, such as absorbed PAR: baseline and best
    with standard errors, a panel each."""
    figure, panels = _draw_along(case, _names(case, "leaf", "leaf rank"))
    leaf = cast(Axis, case.best.row.with_axis("leaf")[0].axis)
    for axes in panels:
        axes.set_yticks(leaf.labels)
    panels[0].set_ylabel("leaf rank (1 = lowest)")
    return figure


def draw_layers(case: Case) -> Figure:
    """What is known by height above the soil, as by leaf rank; points are at
    the middle of their layers."""
    figure, panels = _draw_along(case, _names(case, "layer", "height layer"))
    for axes in panels:
        axes.set_ylim(bottom=0)
    panels[0].set_ylabel("height above the soil [m]")
    return figure


def _draw_along(case: Case, names: list[str]) -> tuple[Figure, NDArray]:
    """Labels upwards, values to the right."""
    figure, panels = _panels(case, len(names))
    for axes, name in zip(panels, names):
        for plant, looks in zip((case.baseline, case.best), PLANTS):
            found = plant.profile(name)
            _draw(
                axes, found.values, found.standard_error, found.labels, looks
            )
        label_light(axes, "x", _title(name), found.unit)
        axes.set_xlim(left=min(0, axes.get_xlim()[0]))
    panels[0].legend(fontsize=8)
    return figure, panels


def draw_parts(case: Case) -> Figure:
    """Light that leaves absorb by origin, face of the leaf, or whatever else
    has words for labels and the objective's unit."""
    case.need_pairs()
    unit = case.best.objective.unit
    names = [
        q.name
        for q in case.best.row.quantities.values()
        if q.axis
        and q.axis.labels.dtype.kind == "U"
        and q.axis.name not in ("organ", "day")
        and q.unit == unit
    ]
    if not names:
        raise HistoryError("the history does not tell parts of the light")
    words = [w for name in names for w in case.best.profile(name).labels]
    figure, (axes,) = _panels(case, 1, 1.6 + 0.45 * len(words))
    place = np.arange(len(words))
    for plant, looks, shift in zip(
        (case.baseline, case.best), PLANTS, (-0.15, 0.15)
    ):
        parts = [plant.profile(name) for name in names]
        _draw(
            axes,
            np.concatenate([part.values for part in parts]),
            np.concatenate([part.standard_error for part in parts]),
            place + shift,
            (*looks[:3], "none"),
        )
    axes.set_yticks(place, words)
    axes.set_ylim(len(words) - 0.5, -0.5)
    axes.set_xlim(left=0)
    label_light(axes, "x", _title(names[0]), unit)
    axes.legend(fontsize=8)
    return figure


def _names(case: Case, axis: str, what: str) -> list[str]:
    case.need_pairs()
    names = [
        q.name
        for q in case.best.row.with_axis(axis)
        if q.name not in _ELSEWHERE
    ]
    if not names:
        raise HistoryError(f"the history has no figures by {what}")
    return names


def _panels(
    case: Case, count: int, height: float = 4.2
) -> tuple[Figure, NDArray]:
    figure = style.new_figure(max(5.2, 3.4 * count), height)
    panels = figure.subplots(1, count, sharey=True, squeeze=False)[0]
    figure.suptitle(case.name, fontsize=10)
    return figure, panels


def _draw(
    axes: Axes, x: NDArray, error: NDArray, y: NDArray, looks: Looks
) -> None:
    label, color, marker, line = looks
    axes.errorbar(
        x,
        y,
        xerr=error,
        color=color,
        marker=marker,
        markersize=4,
        linestyle=line,
        label=f"{label} ± standard error",
    )


def _title(name: str) -> str:
    what = style.words(name).split(" by ")[0]
    return "absorbed PAR" if what == "absorbed" else what
