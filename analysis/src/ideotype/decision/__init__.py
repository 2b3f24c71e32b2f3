# SPDX-License-Identifier: Apache-2.0
"""A decision about plant and management from the rows of histories.

Rows store the objective in each scenario and, with prices, the physical parts of
the margin: grain, seed, irrigation and electricity. `read_options` reads them,
so that any prices can be applied without a new evaluation. `decide` chooses a
few plants with their management, re-evaluates them with independent random
numbers, and returns a `Decision`."""

from .decision import Decision, Switch, decide
from .options import Options, read_options
from .worth import Rule, Worth

__all__ = [
    "Decision",
    "Options",
    "Rule",
    "Switch",
    "Worth",
    "decide",
    "read_options",
]
