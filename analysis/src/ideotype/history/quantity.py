# SPDX-License-Identifier: Apache-2.0
"""Quantities of plants: values with units, axes and standard errors."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .estimate import Estimate

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class Axis:
    """The second dimension of a quantity."""

    name: str
    labels: NDArray
    """The labels along the axis, numbers or words."""
    units: str = "1"
    meaning: str = ""
    """The description of the axis; "" if the name is clear."""

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Axis)
            and self.name == other.name
            and np.array_equal(self.labels, other.labels)
        )

    def __hash__(self) -> int:
        return hash((self.name, len(self.labels)))


@dataclass(frozen=True)
class Quantity:
    """Values [rows], or [rows, axis]; unknown values are NaN."""

    name: str
    unit: str
    values: Floats
    standard_error: Floats
    axis: Axis | None = None

    def take(self, index: NDArray) -> Quantity:
        """Returns the quantity of the rows given by a mask or row numbers."""
        values, error = self.values[index], self.standard_error[index]
        return Quantity(self.name, self.unit, values, error, self.axis)


@dataclass(frozen=True)
class Profile:
    """A quantity of one plant along an axis, such as the time of day [h] or
    leaf rank."""

    labels: NDArray
    unit: str
    values: Floats
    standard_error: Floats
    meaning: str = ""
    """The description of the labels."""

    def scaled(self, factor: float) -> Profile:
        """Returns the profile times an exact positive factor."""
        return replace(
            self,
            values=factor * self.values,
            standard_error=factor * self.standard_error,
        )

    def lowered(self, by: float) -> Profile:
        """Returns the profile less an exact number in the same unit."""
        return replace(self, values=self.values - by)

    def estimates(self) -> list[Estimate]:
        """Returns the estimate of each label."""
        pairs = zip(self.values, self.standard_error)
        return [
            Estimate(float(x), float(error), self.unit) for x, error in pairs
        ]

    def over(self, whole: float) -> dict[str, Estimate]:
        """Returns the share of each label in an exact total in the same
        unit."""
        return {
            str(label): part.scaled(1 / whole, "1")
            for label, part in zip(self.labels, self.estimates())
        }


@dataclass(frozen=True)
class Objective:
    """A quantity that a search maximises or minimises."""

    name: str
    unit: str
    sense: str
    """The sense of the search: maximise or minimise."""

    @property
    def sign(self) -> int:
        """The sign of a better value: 1 where larger is better, else -1."""
        return -1 if self.sense == "minimise" else 1
