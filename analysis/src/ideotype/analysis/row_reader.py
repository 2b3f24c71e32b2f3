# SPDX-License-Identifier: Apache-2.0
"""Rows of a history as arrays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .clock import clock_of
from .datasets import Datasets
from .file import text
from .genes import Genes
from .quantity import Axis, Objective, Quantity
from .rows import Rows, Status

_FINAL = -1
"""Stands for the generation of a finalist."""

_ERROR = "_standard_error"
_NO_QUANTITIES = {
    *("status", "genome", "origin", "parents", "violation"),
    *("objectives", "objectives_by_randomisation", "checksum"),
    *("attempt", "seconds", "worker", "message"),
}
"""Datasets of rows that are something else."""


@dataclass(frozen=True)
class RowReader:
    """Reads rows of /evaluations and /final, whatever quantities they
    have."""

    data: Datasets
    genes: Genes
    objectives: tuple[Objective, ...]

    def read(self, group: str, first: int, last: int | None) -> Rows:
        """The complete ones."""
        # FORMAT.md: the status decides, so it is read before all else.
        status = self.data.read(f"{group}/status", first, last)
        complete = np.flatnonzero(status >= Status.DONE)
        last = first + int(complete[-1]) + 1 if len(complete) else first
        names = self.data.names(group)

        def read(name: str) -> NDArray:
            return self.data.read(f"{group}/{name}", first, last)[complete]

        def quantity(name: str) -> Quantity:
            # Exact ones have no error of their own.
            values = read(name)
            error = (
                read(name + _ERROR) if name + _ERROR in names else 0 * values
            )
            path = f"{group}/{name}"
            axis = self._axis(group, self.data.axes(path)[1:])
            return Quantity(name, self.data.units(path), values, error, axis)

        def is_quantity(name: str) -> bool:
            if name in _NO_QUANTITIES or name.endswith(_ERROR):
                return False
            first, *others = self.data.axes(f"{group}/{name}")
            is_of_rows = first in ("row", "finalist") and name != first
            return is_of_rows and len(others) <= 1

        row = first + complete
        generation, slot = self._places(group, row)
        return Rows(
            genes=self.genes,
            goals=self.objectives,
            quantities={n: quantity(n) for n in names if is_quantity(n)},
            row=row,
            generation=generation,
            slot=slot,
            status=status[complete].astype(int),
            origin=read("origin").astype(int),
            parents=read("parents").astype(int),
            genome=read("genome"),
            objectives=read("objectives"),
            objectives_standard_error=read("objectives" + _ERROR),
            randomisations=read("objectives_by_randomisation"),
            violation=read("violation"),
            attempt=read("attempt").astype(int),
            seconds=read("seconds"),
            worker=read("worker").astype(int),
            message=np.array([text(m) for m in read("message")], dtype=str),
        )

    def _places(self, group: str, row: NDArray) -> tuple[NDArray, NDArray]:
        """Generation and slot."""
        if group == "final":
            return np.full(len(row), _FINAL), row
        count = self.data.read("generations/count")
        first = self.data.read("generations/first_row").astype(int)
        # Generations that have no rows yet come after all others.
        first = first[: np.count_nonzero(count)]
        generation = np.searchsorted(first, row, side="right") - 1
        return generation, row - first[generation] if len(row) else row

    def _axis(self, group: str, names: tuple[str, ...]) -> Axis | None:
        if not names:
            return None
        path = f"{group}/{names[0]}"
        labels = self.data.read(path)
        if labels.dtype.kind in "SO":
            labels = np.array([text(label) for label in labels])
        meaning = ""
        if names[0] == "hour":
            clock = clock_of(self.data, group)
            labels, meaning = labels + clock.shift, clock.meaning
        return Axis(names[0], labels, self.data.units(path), meaning)
