# SPDX-License-Identifier: Apache-2.0
"""Trials of lines and their genetic parameters.

`read_trial` reads a trial, `estimate` its genetic parameters, and `read_lines`
a file of lines."""

from .covariances import mean_products
from .genetics import Population, estimate, read_lines
from .made import make_trial
from .traits import Trait
from .trial import Trial, read_trial

__all__ = [
    "Population",
    "Trait",
    "Trial",
    "estimate",
    "make_trial",
    "mean_products",
    "read_lines",
    "read_trial",
]
