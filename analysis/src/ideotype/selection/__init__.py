# SPDX-License-Identifier: Apache-2.0
"""From measured lines to an ideotype: selection indices from the gradient of
an objective, and programmes of recurrent selection.

`read_trial` reads a trial, `estimate` its genetic parameters, `read_lines` a
file of lines. `Field` evaluates the plants of lines in a campaign. `select`
computes everything, and `write_selection` writes it."""

from .covariances import MeanProducts, mean_products
from .field import Field
from .genetics import Population, estimate, read_lines
from .genome import Founders, GeneticMap
from .index import Advice, Index, intensity, response, smith_hazel
from .made import make_trial
from .page import write_selection
from .programme import Method, Plan, World, simulate
from .reach import Reach, rank_lines
from .selection import Options, Selection, select
from .store import Store
from .surface import Surface, explore
from .traits import Trait
from .trial import Trial, read_trial

__all__ = [
    "Advice",
    "Field",
    "Founders",
    "GeneticMap",
    "Index",
    "MeanProducts",
    "Method",
    "Options",
    "Plan",
    "Population",
    "Reach",
    "Selection",
    "Store",
    "Surface",
    "Trait",
    "Trial",
    "World",
    "estimate",
    "explore",
    "intensity",
    "make_trial",
    "mean_products",
    "rank_lines",
    "read_lines",
    "read_trial",
    "response",
    "select",
    "simulate",
    "smith_hazel",
    "write_selection",
]
