# SPDX-License-Identifier: Apache-2.0
"""Exact light in crop canopies, and plants bred for it.

`Stand` evaluates plants of a campaign and `mesh` any surfaces; both need the
compiled module. `open`, `open_history` and `open_study` read what the program
has written, on any system."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._errors import Error, InputError, Problem

if TYPE_CHECKING:
    from ._crop import Crop
    from ._energy import leaf_energy_balance
    from ._mesh import Canopy, mesh
    from ._search import Search
    from ._stand import Stand
    from .analysis import open_arrays as open
    from .analysis import open_history, open_study

__all__ = [
    "Canopy",
    "Crop",
    "Error",
    "InputError",
    "Problem",
    "Search",
    "Stand",
    "leaf_energy_balance",
    "mesh",
    "open",
    "open_history",
    "open_study",
]

# The module that defines each name. Names are imported at their first use:
# reading needs no compiled module, and evaluating needs no plotting library.
_PLACES = {
    "Canopy": ("._mesh", "Canopy"),
    "Crop": ("._crop", "Crop"),
    "Search": ("._search", "Search"),
    "Stand": ("._stand", "Stand"),
    "leaf_energy_balance": ("._energy", "leaf_energy_balance"),
    "mesh": ("._mesh", "mesh"),
    "open": (".analysis", "open_arrays"),
    "open_history": (".analysis", "open_history"),
    "open_study": (".analysis", "open_study"),
}


def __dir__() -> list[str]:
    return [*__all__, "__version__"]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return import_module("importlib.metadata").version(__name__)
    if name not in _PLACES:
        raise AttributeError(f"module 'ideotype' has no attribute '{name}'")
    module, own = _PLACES[name]
    try:
        found = getattr(import_module(module, __name__), own)
    except ImportError as error:
        if "_core" not in str(error):
            raise
        raise Error(
            f"ideotype.{name} needs the compiled module, which this "
            "installation lacks (it can only read and report); install a "
            "wheel of this system, or build it with pip install and without "
            "IDEOTYPE_PURE_PYTHON"
        ) from error
    globals()[name] = found
    return found
