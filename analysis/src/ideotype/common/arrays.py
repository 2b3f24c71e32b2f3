# SPDX-License-Identifier: Apache-2.0
"""Checks arrays and tables from users."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import Error

if TYPE_CHECKING:
    import pandas

_Given = TypeVar("_Given")


def real(given: ArrayLike, name: str) -> NDArray[np.float64]:
    """Returns an array of real numbers.

    Raises Error for masked and complex arrays and for dates: numpy would use
    the hidden values of a masked array, drop the imaginary part of complex
    numbers, and count dates from 1970."""
    try:
        array = np.asarray(unmasked(given, name))
        if array.dtype.kind in "mM":
            raise Error(
                f"{name} is no array of numbers: it has dates or times "
                f"({array.dtype}); give real numbers"
            )
        if not np.iscomplexobj(array):
            return np.asarray(array, float)
    except (
        TypeError, ValueError, OverflowError, RecursionError
    ) as error:  # fmt: skip
        raise Error(f"{name} is no array of numbers: {error}") from error
    raise Error(
        f"{name} has complex numbers; give real ones, such as its .real"
    )


def real_within(
    given: ArrayLike, name: str, lower: float, upper: float
) -> NDArray[np.float64]:
    """Returns an array of real numbers within a range.

    Raises Error like real(), and for numbers outside of the range or NaN."""
    numbers = real(given, name)
    outside = ~((numbers >= lower) & (numbers <= upper))
    if outside.any():
        value = numbers[outside].flat[0]
        raise Error(
            f"{name} is {value:g}, outside {lower:g} to {upper:g}; "
            "check its unit"
        )
    return numbers


def unmasked(given: _Given, name: str) -> _Given:
    """Returns the argument unchanged. Raises Error if it is or contains a
    masked array."""
    if _is_masked(given):
        raise Error(
            f"{name} is or contains a masked array, and masked values would "
            "count; give an array without a mask, such as its .filled() or "
            ".compressed()"
        )
    return given


def _is_masked(given: Any) -> bool:
    if isinstance(given, list | tuple):
        return any(map(_is_masked, given))
    return isinstance(given, np.ma.MaskedArray)


def require_whole(given: object, name: str, lower: int, upper: int) -> None:
    """Raises Error unless the argument is a whole number in a range."""
    if not isinstance(given, (int, np.integer)) or not lower <= given <= upper:
        raise Error(
            f"{name} is {given!r}; use a whole number from {lower} to {upper}"
        )


def require_file(path: Path) -> None:
    """Raises Error unless the path is a regular file: reading a pipe or device
    might never end."""
    if not path.exists():
        raise Error(f"{path}: there is no such file")
    if not path.is_file():
        raise Error(f"{path}: this is no regular file; name one")


def read_columns(path: Path) -> pandas.DataFrame:
    """Reads a CSV file and returns it with column names in lower case.

    Raises Error if the file cannot be read."""
    import pandas

    require_file(path)
    try:
        table = pandas.read_csv(path, comment="#", skipinitialspace=True)
    except pandas.errors.EmptyDataError:
        raise Error(
            f"{path}:1: this file is empty; begin with a line of column names"
        ) from None
    except (OSError, ValueError) as error:
        raise Error(f"{path}: {error}") from None
    table.columns = table.columns.str.strip().str.lower()
    return table
