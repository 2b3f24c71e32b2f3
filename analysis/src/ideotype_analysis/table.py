"""Columns that know their names and units."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class Quantity:
    """One column: a value per row, NaN where it is not known."""

    name: str
    unit: str
    values: Floats
    standard_error: Floats

    def take(self, index: NDArray) -> Quantity:
        """The rows of a mask or of row numbers."""
        return Quantity(
            self.name,
            self.unit,
            self.values[index],
            self.standard_error[index],
        )


@dataclass(frozen=True)
class Table:
    """Columns of the same rows; values and standard errors are
    [rows, columns]."""

    names: tuple[str, ...]
    units: tuple[str, ...]
    values: Floats
    standard_error: Floats

    def __contains__(self, name: str) -> bool:
        return name in self.names

    def __getitem__(self, name: str) -> Quantity:
        i = self.names.index(name)
        return Quantity(
            name, self.units[i], self.values[:, i], self.standard_error[:, i]
        )

    def take(self, index: NDArray) -> Table:
        """The rows of a mask or of row numbers."""
        return Table(
            self.names,
            self.units,
            self.values[index],
            self.standard_error[index],
        )

    def matching(self, pattern: str) -> list[tuple[re.Match[str], int]]:
        """Columns whose whole name matches, with their numbers."""
        found = [re.fullmatch(pattern, name) for name in self.names]
        return [(match, i) for i, match in enumerate(found) if match]
