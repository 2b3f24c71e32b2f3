# SPDX-License-Identifier: Apache-2.0
"""Reads the histories that the program writes; analysis/FORMAT.md specifies
the files."""

from .atlas import Atlas, AtlasAxis
from .case import Case
from .estimate import Estimate
from .file import HistoryError, NotAHistory, UnsupportedVersion, Writer
from .front import Front, non_dominated
from .genes import Genes
from .history import History, open_history
from .indices import Indices, indices_of
from .interval import Interval
from .labelled import open_arrays
from .pair import Pair
from .quantity import Axis, Objective, Profile, Quantity
from .rows import Evaluation, Rows
from .state import Generations, Session, State
from .study import Study, open_study

__all__ = [
    "Atlas",
    "AtlasAxis",
    "Axis",
    "Case",
    "Estimate",
    "Evaluation",
    "Front",
    "Generations",
    "Genes",
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
    "Session",
    "State",
    "Study",
    "UnsupportedVersion",
    "Writer",
    "indices_of",
    "non_dominated",
    "open_arrays",
    "open_history",
    "open_study",
]
