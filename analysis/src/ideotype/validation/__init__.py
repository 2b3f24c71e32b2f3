# SPDX-License-Identifier: Apache-2.0
"""Compares the program with measurements.

A fact (`Fact`) is a table of measurements under known conditions with its
source. `compare` evaluates the plants of a campaign under the same conditions
and returns a `Result`: the computed and measured value of each point, and
whether they agree."""

from .comparison import Conditions, Point, Result, compare
from .facts import (
    Fact,
    Facts,
    Intervention,
    Read,
    Source,
    Verdict,
    read_facts,
    shipped_facts,
)
from .quantities import QUANTITIES, Quantity, Seen
from .table import Measurement, read_table

__all__ = [
    "QUANTITIES",
    "Conditions",
    "Fact",
    "Facts",
    "Intervention",
    "Measurement",
    "Point",
    "Quantity",
    "Read",
    "Result",
    "Seen",
    "Source",
    "Verdict",
    "compare",
    "read_facts",
    "read_table",
    "shipped_facts",
]
