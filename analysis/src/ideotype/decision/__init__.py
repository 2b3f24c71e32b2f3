# SPDX-License-Identifier: Apache-2.0
"""A decision about plant and management from the rows of histories with
prices.

Rows store the physical parts of the margin in each environment: grain, seed,
irrigation and electricity. `read_options` reads them, so that any prices can be
applied without a new evaluation. `decide` chooses a few plants with their
management, re-evaluates them with independent random numbers, and returns a
`Decision`."""

from .decision import Decision, Switch, decide
from .margin import Rule, weights_of_prices
from .options import Options, read_options

__all__ = [
    "Decision",
    "Options",
    "Rule",
    "Switch",
    "decide",
    "read_options",
    "weights_of_prices",
]
