# SPDX-License-Identifier: Apache-2.0
"""Histories as labelled arrays of xarray."""

from __future__ import annotations

from os import PathLike
from pathlib import Path

import xarray

from .columns import columns
from .file import HistoryError
from .history import open_history


def open_arrays(
    path: str | PathLike[str],
    group: str = "evaluations",
    *,
    all_rows: bool = False,
) -> xarray.Dataset:
    """Reads a group of a history, such as "evaluations", "final",
    "generations" or "genes", into memory as labelled arrays. The history may
    be finished, live or killed. Of /evaluations and /final only rows with a
    recorded outcome are read, with `all_rows` all rows. The attribute
    `unchecked_rows` of /evaluations is the number of rows in incomplete
    generations, which have no checksum.

    Raises the errors of open_history(), and KeyError if there is no such
    group."""
    with open_history(Path(path)) as history:
        try:
            table = columns(history.datasets, group, all_rows=all_rows)
        except HistoryError as error:
            if isinstance(error.__cause__, KeyError):
                raise KeyError(str(error)) from error
            raise
        arrays = xarray.Dataset(dict(table))
        if group == "evaluations":
            arrays.attrs["unchecked_rows"] = history.unchecked()
    return arrays
