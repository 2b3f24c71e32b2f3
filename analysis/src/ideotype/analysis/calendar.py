# SPDX-License-Identifier: Apache-2.0
"""A season as a calendar: a cell for each day, a line for each week."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .case import Case
from .file import HistoryError

_DAYS = ("Mo", "Tu", "We", "Th", "Fr", "Sa", "Su")


def draw_calendar(case: Case) -> Figure:
    """What is known by day: of the best plant, and best minus baseline.

    Raises HistoryError if there is nothing by day."""
    case.need_pairs()
    found = [q.name for q in case.best.row.with_axis("day")]
    if not found:
        raise HistoryError("the history has no figures by day")
    days = case.best.profile(found[0]).labels.astype("datetime64[D]")
    weeks = _weeks(days)
    height = 1.5 + 0.24 * len(weeks)
    figure = style.new_figure(5.8, 0.4 + height * len(found))
    for row, name in zip(figure.subplots(len(found), 2, squeeze=False), found):
        _draw_quantity(figure, row, case, name, days)
    figure.suptitle(case.name, fontsize=10)
    return figure


def _draw_quantity(
    figure: Figure, row: NDArray, case: Case, name: str, days: NDArray
) -> None:
    baseline, best = case.baseline.profile(name), case.best.profile(name)
    change = best.values - baseline.values
    error = np.hypot(best.standard_error, baseline.standard_error)
    most = np.nanmax(np.abs(change)) or 1.0
    what = style.words(name).removesuffix(" by day")
    what = "absorbed PAR" if what == "absorbed" else what
    unit = f"[{style.unit_label(best.unit)}]"
    for axes, values, errors, told, colors, norm in (
        (
            row[0], best.values, best.standard_error,
            f"{what}, best", "viridis", Normalize(0, np.nanmax(best.values)),
        ),
        (
            row[1], change, error,
            "best − baseline", "PuOr_r", Normalize(-most, most),
        ),
    ):  # fmt: skip
        image = axes.imshow(
            cells(days, values), cmap=colors, norm=norm, aspect="auto"
        )
        _label(axes, days)
        axes.set_title(f"{told}\n{unit}", fontsize=9)
        bar = figure.colorbar(
            image, ax=axes, location="bottom", aspect=25, pad=0.03
        )
        bar.ax.tick_params(labelsize=8)
        bar.set_label(
            f"standard errors at most {np.nanmax(errors):.2g}", fontsize=8
        )


def cells(days: NDArray, values: NDArray) -> NDArray[np.float64]:
    """[weeks, 7], from Monday; NaN where there is no such day."""
    weeks = _weeks(days)
    found = np.full((len(weeks), 7), np.nan)
    since = (days - weeks[0]).astype(int)
    found[since // 7, since % 7] = values
    return found


def _weeks(days: NDArray) -> NDArray:
    """The Mondays of all weeks from the first day to the last."""
    # 1970-01-01 was a Thursday
    first, last = (
        day - (day.astype(int) + 3) % 7 for day in (days.min(), days.max())
    )
    return np.arange(first, last + 1, 7)


def _label(axes: Axes, days: NDArray) -> None:
    weeks = _weeks(days)
    named = np.maximum(weeks, days.min()).tolist()
    labels = [f"{day.day} {day:%b}" for day in named]
    axes.set_yticks(range(len(weeks)), labels, fontsize=8)
    axes.set_xticks(range(7), _DAYS, fontsize=8)
    axes.xaxis.tick_top()
    axes.tick_params(length=0)
    axes.grid(visible=False)
    for side in axes.spines.values():
        side.set_visible(False)
    for i in range(len(weeks) + 1):
        axes.axhline(i - 0.5, color="white", linewidth=1.5)
    for i in range(8):
        axes.axvline(i - 0.5, color="white", linewidth=1.5)
