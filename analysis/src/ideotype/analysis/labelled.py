# SPDX-License-Identifier: Apache-2.0
"""Histories as labelled arrays of xarray."""

from __future__ import annotations

from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
import xarray

from .clock import clock_of
from .format_1 import Format1
from .history import open_history
from .rows import Status

_OPEN = {"swmr": True, "libver": "latest", "locking": False}


def open_arrays(
    path: str | PathLike[str],
    group: str = "evaluations",
    *,
    all_rows: bool = False,
) -> xarray.Dataset:
    """A group of a history, "evaluations", "final", "generations", "genes" and
    so on, in memory: arrays by name, whose dimensions have names and labels.
    Works on finished, live and killed files and on those of format 1.0. Of
    /evaluations and /final only the rows whose outcome is recorded; all of
    them with `all_rows`.

    Raises as open_history(), KeyError if there is no such group."""
    with open_history(Path(path)) as history:
        data = history.datasets
        if isinstance(data, Format1):
            found = _presented(data, group)
        else:
            found = _stored(history.path, group)
            if "hour" in found.coords:
                clock = clock_of(data, group)
                about = {**found.hour.attrs, "long_name": clock.meaning}
                hours = found.hour.values + clock.shift
                found = found.assign_coords(hour=("hour", hours, about))
    if "status" in found and not all_rows:
        dimension = found["status"].dims[0]
        recorded = np.flatnonzero(found["status"] >= Status.DONE)
        found = found.isel({dimension: recorded})
    return found


def _stored(path: Any, group: str) -> xarray.Dataset:
    with xarray.open_dataset(
        path, group=group, engine="h5netcdf", driver_kwds=_OPEN
    ) as lazy:
        if "status" in lazy:
            # FORMAT.md: it decides, so it is read before all else.
            lazy["status"].load()
        return _decoded(lazy.load())


def _presented(data: Format1, group: str) -> xarray.Dataset:
    """What h5netcdf would make of the file if it were of format 2.0."""
    names = data.names(group)
    arrays = {}
    for name in sorted(names, key=lambda name: name != "status"):
        path = f"{group}/{name}"
        attributes = {"units": data.units(path)}
        arrays[name] = (data.axes(path), data.read(path), attributes)
    return _decoded(xarray.Dataset(arrays))


def _decoded(found: xarray.Dataset) -> xarray.Dataset:
    """Texts as str."""
    for name, array in found.variables.items():
        if array.dtype.kind == "S":
            texts = np.char.decode(array.values, "utf-8", "replace")
            found[name] = (array.dims, texts, array.attrs)
    return found
