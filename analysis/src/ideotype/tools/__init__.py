# SPDX-License-Identifier: Apache-2.0
"""The commands of the package, one module each.

`write_crate` describes a study as a Research Object Crate."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .crate import write_crate

__all__ = ["write_crate"]


def __getattr__(name: str) -> Any:
    # The import at first use keeps the other commands quick to start.
    if name in __all__:
        return getattr(import_module(".crate", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
