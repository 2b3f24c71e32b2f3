# SPDX-License-Identifier: Apache-2.0
"""Computes the light in crop canopies and designs crops for it.

`Stand` evaluates the plants of a campaign, and `mesh` evaluates any surfaces;
both need the compiled module. `open`, `open_history` and `open_study` read the
histories that the program writes, on any system.

The packages are `stand` (plants and their light), `search` (optimizers),
`history` (histories of searches), `figures`, `report`, `live` (interactive
pages), `validation` (field measurements), `calibration` (parameters from
measurements), `selection` (breeding programmes), `environments`
(representative years), `decision` (plant and management at prices) and `tools`
(one module for each command)."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .errors import Error, InputError, NotCompiled, Problem
from .mesh import mesh

if TYPE_CHECKING:
    from . import (
        calibration,
        decision,
        environments,
        figures,
        history,
        live,
        report,
        search,
        selection,
        stand,
        tools,
        validation,
    )
    from .history import open_arrays as open
    from .history import open_history, open_study
    from .mesh.canopy import Canopy
    from .mesh.geometry import Mesh
    from .search import Search
    from .stand import (
        Crop,
        Stand,
        leaf_energy_balance,
        soil_water_balance,
    )

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
    "calibration",
    "decision",
    "environments",
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
    "selection",
    "soil_water_balance",
    "stand",
    "tools",
    "validation",
]

# Names are imported at first use: reading needs no compiled module, and
# evaluating needs no plotting library. The function `mesh` is imported at once,
# because the package of this name would hide it.
_SOURCES = {
    "Canopy": (".mesh.canopy", "Canopy"),
    "Crop": (".stand", "Crop"),
    "Mesh": (".mesh.geometry", "Mesh"),
    "Search": (".search", "Search"),
    "Stand": (".stand", "Stand"),
    "leaf_energy_balance": (".stand", "leaf_energy_balance"),
    "open": (".history", "open_arrays"),
    "open_history": (".history", "open_history"),
    "open_study": (".history", "open_study"),
    "soil_water_balance": (".stand", "soil_water_balance"),
}
_PACKAGES = [
    "calibration",
    "decision",
    "environments",
    "figures",
    "history",
    "live",
    "report",
    "search",
    "selection",
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
    if name not in _SOURCES:
        raise AttributeError(f"module 'ideotype' has no attribute '{name}'")
    module, attribute = _SOURCES[name]
    value = getattr(import_module(module, __name__), attribute)
    globals()[name] = value
    return value
