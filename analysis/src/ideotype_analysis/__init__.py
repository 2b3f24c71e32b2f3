"""Reads the histories of ideotype: see FORMAT.md for what they hold."""

from .estimate import Estimate
from .file import HistoryError, NotAHistory, UnsupportedVersion
from .history import History, open_history
from .pair import Pair
from .rows import Evaluation, HourProfile, LeafProfile, Quantity, Rows

__all__ = [
    "Estimate",
    "Evaluation",
    "History",
    "HistoryError",
    "HourProfile",
    "LeafProfile",
    "NotAHistory",
    "Pair",
    "Quantity",
    "Rows",
    "UnsupportedVersion",
    "open_history",
]
