# SPDX-License-Identifier: Apache-2.0
"""Reads the histories of ideotype; FORMAT.md says what they hold."""

from .case import Case
from .estimate import Estimate
from .file import HistoryError, NotAHistory, UnsupportedVersion
from .front import Front
from .history import History, open_history
from .indices import Indices
from .interval import Interval
from .labelled import open_arrays
from .pair import Pair
from .quantity import Objective, Profile, Quantity
from .rows import Evaluation, Rows
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
