# SPDX-License-Identifier: Apache-2.0
"""Exact light in crop canopies, and plants bred for it.

`Stand` evaluates plants of a campaign and `mesh` any surfaces; both need the
compiled module. `open`, `open_history` and `open_study` read what the program
has written, on any system.

The packages are `stand` (plants and their light), `search` (optimizers),
`history` (what the program has written), `figures`, `report`, `live` (pages
that follow), `validation` (measurements of fields) and `tools` (a module for
each command)."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .errors import Error, InputError, NotCompiled, Problem
from .mesh import mesh

if TYPE_CHECKING:
    from . import (
        figures,
        history,
        live,
        report,
        search,
        stand,
        tools,
        validation,
    )
    from .history import open_arrays as open
    from .history import open_history, open_study
    from .mesh.canopy import Canopy
    from .mesh.geometry import Mesh
    from .search import Search
    from .stand import Crop, Stand, leaf_energy_balance

__all__ = [
    "Canopy",
    "Crop",
    "Error",
    "InputError",
    "Mesh",
    "NotCompiled",
    "Problem",
    "Search",
    "Stand",
    "figures",
    "history",
    "leaf_energy_balance",
    "live",
    "mesh",
    "open",
    "open_history",
    "open_study",
    "report",
    "search",
    "stand",
    "tools",
    "validation",
]

# Names are imported at their first use: reading needs no compiled module, and
# evaluating needs no plotting library. The function `mesh` is made at once,
# because the package of this name would hide it.
_PLACES = {
    "Canopy": (".mesh.canopy", "Canopy"),
    "Crop": (".stand", "Crop"),
    "Mesh": (".mesh.geometry", "Mesh"),
    "Search": (".search", "Search"),
    "Stand": (".stand", "Stand"),
    "leaf_energy_balance": (".stand", "leaf_energy_balance"),
    "open": (".history", "open_arrays"),
    "open_history": (".history", "open_history"),
    "open_study": (".history", "open_study"),
}
_PACKAGES = [
    "figures",
    "history",
    "live",
    "report",
    "search",
    "stand",
    "tools",
    "validation",
]


def __dir__() -> list[str]:
    return [*__all__, "__version__"]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return import_module("importlib.metadata").version(__name__)
    if name in _PACKAGES:
        return import_module(f".{name}", __name__)
    if name not in _PLACES:
        raise AttributeError(f"module 'ideotype' has no attribute '{name}'")
    module, own = _PLACES[name]
    found = getattr(import_module(module, __name__), own)
    globals()[name] = found
    return found
