# SPDX-License-Identifier: Apache-2.0
"""Reads the numbers that a figure shows from the figure."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.category import StrCategoryLocator
from matplotlib.container import BarContainer, ErrorbarContainer
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator
from numpy.typing import NDArray

HEADER = ("panel", "series", "x", "y", "x_low", "x_high", "y_low", "y_high")
"""The columns; low and high are the ends of error bars and ranges."""

RANGE = "range"
"""The gid of bars that show a range from end to end, which have no length."""

_NO_BARS = ("",) * 4


def read_numbers(figure: Figure) -> str:
    """Returns the numbers of a figure as CSV, a line for each point, bar or
    cell of a map."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(HEADER)
    for panel, axes in enumerate(figure.axes, start=1):
        title = _panel(axes) or str(panel)
        for series, line in _lines(axes):
            writer.writerow((title, series, *map(_text, line)))
    return text.getvalue()


def _panel(axes: Axes) -> str:
    words = (axes.get_title(), axes.get_ylabel(), axes.get_xlabel())
    return " | ".join(word.replace("\n", " ") for word in words if word)


def _text(value: Any) -> str:
    if isinstance(value, str):
        return value
    return "" if np.isnan(value) else f"{value:.7g}"


def _lines(axes: Axes) -> Iterator[tuple[str, tuple[Any, ...]]]:
    """Returns the name of a series and the numbers of its line."""
    inside: set[int] = set()
    for group in axes.containers:
        parts = (x for x in group if x is not None)
        for part in parts:
            inside |= {
                id(x) for x in (part if isinstance(part, tuple) else (part,))
            }
        if isinstance(group, ErrorbarContainer):
            yield from _errorbars(axes, group)
        elif isinstance(group, BarContainer):
            yield from _bars(axes, group)
    for line in axes.lines:
        label = str(line.get_label())
        if id(line) not in inside and not label.startswith("_"):
            for x, y in zip(*_numbers(line), strict=True):
                yield (
                    label,
                    (_named(axes, "x", x), _named(axes, "y", y), *_NO_BARS),
                )
    for image in axes.images:
        array: NDArray[Any] = np.ma.filled(
            np.ma.asarray(image.get_array(), float), np.nan
        )
        if array.ndim == 2 and image.get_gid() != "painted":
            for (i, j), value in np.ndenumerate(array):
                if not np.isnan(value):
                    place = f"{_named(axes, 'x', j)}, {_named(axes, 'y', i)}"
                    yield place, (value, "", *_NO_BARS)


def _errorbars(
    axes: Axes, group: ErrorbarContainer
) -> Iterator[tuple[str, tuple[Any, ...]]]:
    line, _, collections = group.lines
    if line is None:
        return
    x, y = _numbers(line)
    ends: dict[str, list[Any]] = {name: [("", "")] * len(x) for name in "xy"}
    names = [x for x in "xy" if getattr(group, f"has_{x}err")]
    for name, bars in zip(names, collections, strict=False):
        axis = 0 if name == "x" else 1
        ends[name] = [
            np.sort(np.asarray(segment)[:, axis])
            if len(segment)
            else (np.nan, np.nan)
            for segment in bars.get_segments()
        ]
    for i in range(len(x)):
        yield _label(group, line), (
            _named(axes, "x", x[i]), _named(axes, "y", y[i]),
            *ends["x"][i], *ends["y"][i],
        )  # fmt: skip


def _bars(
    axes: Axes, group: BarContainer
) -> Iterator[tuple[str, tuple[Any, ...]]]:
    for bar in group.patches:
        x, y, width, height = (
            bar.get_x(), bar.get_y(), bar.get_width(), bar.get_height(),
        )  # fmt: skip
        if bar.get_gid() == RANGE:
            yield str(group.get_label()), _range(axes, group, bar)
            continue
        if group.orientation == "horizontal":
            at = width, _named(axes, "y", y + height / 2)
        else:
            at = _named(axes, "x", x + width / 2), height
        yield str(group.get_label()), (*at, *_NO_BARS)


def _range(axes: Axes, group: BarContainer, bar: Any) -> tuple[Any, ...]:
    (left, below), (right, above) = bar.get_bbox().get_points()
    if group.orientation == "horizontal":
        at = _named(axes, "y", (below + above) / 2)
        return "", at, left, right, "", ""
    return _named(axes, "x", (left + right) / 2), "", "", "", below, above


def _label(group: Any, line: Any) -> str:
    for each in (group, line):
        if (label := str(each.get_label())) and not label.startswith("_"):
            return label
    return ""


def _numbers(line: Line2D) -> list[NDArray[np.float64]]:
    """Returns the coordinates of the points of a line; dates are days."""
    return [
        np.atleast_1d(np.asarray(values, float))
        for values in line.get_data(orig=False)
    ]


def _named(axes: Axes, which: str, value: float) -> Any:
    """Returns the text of the tick at a coordinate if ticks are words, the
    date if it is a day, else the number."""
    axis = getattr(axes, f"{which}axis")
    locator = axis.get_major_locator()
    if isinstance(locator, FixedLocator | StrCategoryLocator):
        ticks = locator()
        labels = axis.get_major_formatter().format_ticks(ticks)
        if len(ticks):
            near = int(np.argmin(np.abs(np.asarray(ticks) - value)))
            is_word = labels[near] and not _is_number(labels[near])
            if is_word and abs(ticks[near] - value) < 0.45:
                return labels[near].replace("\n", " ")
    if "Date" in type(axis.get_converter()).__name__:
        return str(np.datetime64(round(value), "D"))
    return float(value)


def _is_number(text: str) -> bool:
    try:
        float(text.replace("\N{MINUS SIGN}", "-"))
    except ValueError:
        return False
    return True
