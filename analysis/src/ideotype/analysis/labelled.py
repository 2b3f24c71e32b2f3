# SPDX-License-Identifier: Apache-2.0
"""Histories as labelled arrays of xarray."""

from __future__ import annotations

from os import PathLike
from pathlib import Path

import numpy as np
import xarray

from .clock import clock_of
from .datasets import Datasets
from .file import HistoryError
from .history import open_history
from .rows import Status


def open_arrays(
    path: str | PathLike[str],
    group: str = "evaluations",
    *,
    all_rows: bool = False,
) -> xarray.Dataset:
    """A group of a history, "evaluations", "final", "generations", "genes" and
    so on, in memory: arrays by name, whose dimensions have names and labels.
    Works on finished, live and killed files. Of /evaluations and /final only the rows whose outcome is recorded; all of
    them with `all_rows`. The attribute `unchecked_rows` of /evaluations counts
    those of a generation that is not complete and so has no checksum.

    Raises as open_history(), KeyError if there is no such group."""
    with open_history(Path(path)) as history:
        data = history.datasets
        try:
            names = data.names(group)
        except HistoryError as error:
            if isinstance(error.__cause__, KeyError):
                raise KeyError(str(error)) from error
            raise
        found = _labelled(data, group, names)
        if "hour" in found.coords:
            clock = clock_of(data, group)
            about = {**found.hour.attrs, "long_name": clock.meaning}
            hours = found.hour.values + clock.shift
            found = found.assign_coords(hour=("hour", hours, about))
        if group == "evaluations":
            found.attrs["unchecked_rows"] = history.unchecked()
    if "status" in found and not all_rows:
        dimension = found["status"].dims[0]
        recorded = np.flatnonzero(found["status"] >= Status.DONE)
        found = found.isel({dimension: recorded})
    return found


def _labelled(data: Datasets, group: str, names: list[str]) -> xarray.Dataset:
    arrays = {}
    # FORMAT.md: the status decides, so it is read before all else.
    for name in sorted(names, key=lambda name: name != "status"):
        path = f"{group}/{name}"
        values = data.read(path)
        if values.dtype.kind == "S":
            values = np.char.decode(values, "utf-8", "replace")
        arrays[name] = (data.axes(path), values, data.about(path))
    return xarray.Dataset(arrays)
