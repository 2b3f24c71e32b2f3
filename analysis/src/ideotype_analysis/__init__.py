"""Reads the histories of ideotype: see FORMAT.md for what they hold."""

from .case import Case
from .estimate import Estimate
from .file import HistoryError, NotAHistory, UnsupportedVersion
from .history import History, open_history
from .interval import Interval
from .pair import Pair
from .rows import Evaluation, HourProfile, LayerProfile, LeafProfile, Rows
from .study import Study
from .study import open_study as open
from .table import Quantity

__all__ = [
    "Case",
    "Estimate",
    "Evaluation",
    "History",
    "HistoryError",
    "HourProfile",
    "Interval",
    "LayerProfile",
    "LeafProfile",
    "NotAHistory",
    "Pair",
    "Quantity",
    "Rows",
    "Study",
    "UnsupportedVersion",
    "open",
    "open_history",
]
