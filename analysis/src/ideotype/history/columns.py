# SPDX-License-Identifier: Apache-2.0
"""Reads the arrays of a group of a history, with dimensions and units."""

from __future__ import annotations

import tomllib
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .datasets import Datasets
from .file import HistoryError, text
from .rows import Status

_OLD = "local clock"
"""The name of the clock in histories of version 0.2.0 and earlier, whose
seasons have hours on the clock of the weather file."""


class Column(NamedTuple):
    """An array of a history; texts are Python strings."""

    axes: tuple[str, ...]
    values: NDArray
    about: dict[str, str]
    """The attributes `units` and `long_name` of the array, if the file has
    them."""


class Columns(dict[str, Column]):
    """Columns by name. Raises HistoryError for unknown names."""

    def __init__(self, where: str) -> None:
        super().__init__()
        self._where = where

    def __missing__(self, name: str) -> Column:
        raise HistoryError(f"{self._where}/{name}")


def columns(
    data: Datasets,
    group: str,
    first: int = 0,
    last: int | None = None,
    *,
    all_rows: bool = False,
) -> Columns:
    """Reads a group. Of /evaluations and /final it reads rows first to last,
    without `all_rows` only the rows with a recorded outcome. Hours are on the
    clock of the site.

    Raises HistoryError if data are missing or damaged."""
    names = data.names(group)
    table = Columns(f"{data.path}: has no {group}")
    row = ""
    kept: Any = slice(None)
    if "status" in names:
        # The status is read first: it marks the rows that are complete
        # (FORMAT.md).
        status = data.read(f"{group}/status", first, last)
        (row,) = data.axes(f"{group}/status")
        if not all_rows:
            kept = np.flatnonzero(status >= Status.DONE)
            last = first + int(kept[-1]) + 1 if len(kept) else first
    for name in names:
        path = f"{group}/{name}"
        axes = data.axes(path)
        if row and axes[:1] == (row,):
            values = data.read(path, first, last)[kept]
        else:
            values = data.read(path)
        if values.dtype.kind in "SO":
            texts = np.array([*map(text, values.ravel())], dtype=str)
            values = texts.reshape(values.shape)
        table[name] = Column(axes, values, data.about(path))
    if "hour" in table:
        axes, hours, about = table["hour"]
        meaning, shift = _clock(data, about.get("long_name", ""))
        about = about | {"long_name": meaning}
        table["hour"] = Column(axes, hours + shift, about)
    return table


def _clock(data: Datasets, meaning: str) -> tuple[str, float]:
    """Returns the name of the clock of a history, and the shift that converts
    hours of histories of version 0.2.0 to the clock of the site [h]."""
    if meaning and meaning != _OLD:
        return meaning, 0.0
    try:
        campaign = tomllib.loads(data.texts("campaign/resolved")[0])
        attributes = data.attributes()
        places = [
            (site["utc_offset"], weather["utc_offset"])
            for site in campaign["site"]
            if attributes.get("site") in ("all", site["name"])
            for weather in campaign.get("weather", [site])
            if weather is site
            or (
                weather["site"] == site["name"]
                and attributes.get("day") in ("all", weather["climate"])
            )
        ]
    except (HistoryError, KeyError, TypeError, ValueError):
        places = []
    sites, files = ({place[k] for place in places} for k in (0, 1))
    if len(files) != 1:
        return "time on a clock that the history does not name", 0.0
    (there,) = files
    if len(sites) != 1:
        name = _clock_name(there)
        return f"time on the clock of the weather file, {name}", 0.0
    (here,) = sites
    return f"time on the clock of the site, {_clock_name(here)}", here - there


def _clock_name(utc_offset: float) -> str:
    """Returns the name of a clock, such as "UTC-5" or "UTC+5:30"."""
    hours, minutes = divmod(round(abs(utc_offset) * 60), 60)
    if not hours and not minutes:
        return "UTC"
    sign = "-" if utc_offset < 0 else "+"
    return f"UTC{sign}{hours}" + (f":{minutes:02}" if minutes else "")
