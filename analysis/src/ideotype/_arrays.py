# SPDX-License-Identifier: Apache-2.0
"""Checks arrays that users give."""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import Error

_Given = TypeVar("_Given")


def real(given: ArrayLike, name: str) -> NDArray[np.float64]:
    """Returns an array of real numbers.

    Raises Error for masked and complex arrays: numpy would use the hidden
    values of a masked array, and drop the imaginary part of complex
    numbers."""
    try:
        found = np.asarray(unmasked(given, name))
        if not np.iscomplexobj(found):
            return np.asarray(found, float)
    except (TypeError, ValueError) as error:
        raise Error(f"{name} is no array of numbers: {error}") from error
    raise Error(
        f"{name} has complex numbers; give real ones, such as its .real"
    )


def unmasked(given: _Given, name: str) -> _Given:
    """Returns the argument. Raises Error if the argument is or holds a masked
    array."""
    if _is_masked(given):
        raise Error(
            f"{name} is or holds a masked array, whose hidden values would "
            "count; give an array without a mask, such as its .filled() or "
            ".compressed()"
        )
    return given


def _is_masked(given: Any) -> bool:
    if isinstance(given, list | tuple):
        return any(map(_is_masked, given))
    return isinstance(given, np.ma.MaskedArray)
