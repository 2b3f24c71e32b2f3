# SPDX-License-Identifier: Apache-2.0
"""Reads the histories of ideotype; FORMAT.md describes the files."""

from .case import Case
from .front import Front
from .indices import Indices
from .interval import Interval
from .pair import Pair
from .reading.estimate import Estimate
from .reading.file import HistoryError, NotAHistory, UnsupportedVersion
from .reading.history import History, open_history
from .reading.labelled import open_arrays
from .reading.quantity import Objective, Profile, Quantity
from .reading.rows import Evaluation, Rows
from .study import Study, open_study

__all__ = [
    "Case",
    "Estimate",
    "Evaluation",
    "Front",
    "History",
    "HistoryError",
    "Indices",
    "Interval",
    "NotAHistory",
    "Objective",
    "Pair",
    "Profile",
    "Quantity",
    "Rows",
    "Study",
    "UnsupportedVersion",
    "open_arrays",
    "open_history",
    "open_study",
]
