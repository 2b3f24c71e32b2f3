# SPDX-License-Identifier: Apache-2.0
"""Turns columns of a history into evaluations."""

from __future__ import annotations

import numpy as np

from .columns import Columns
from .genes import Genes
from .quantity import Axis, Integers, Objective, Quantity
from .rows import Rows

_FINAL = -1
"""The number of the generation that finalists have."""
_ERROR = "_standard_error"
_NO_QUANTITIES = {
    *("status", "genome", "origin", "parents", "violation"),
    *("objectives", "objectives_by_randomisation", "checksum"),
    *("attempt", "seconds", "worker", "message"),
}
"""Columns of rows that are no quantities."""


def rows_of(
    found: Columns,
    starts: Integers | None,
    genes: Genes,
    goals: tuple[Objective, ...],
) -> Rows:
    """Returns evaluations with all quantities of the columns. `starts` has the
    first row of each generation; without it the rows are finalists.

    Raises HistoryError if a column is missing."""
    (row_axis,) = found["status"].axes
    row = found[row_axis].values.astype(int)
    generation, slot = np.full(len(row), _FINAL), row
    if starts is not None and len(row):
        # The first generation begins with row 0 even while it is incomplete.
        starts = starts if len(starts) else np.zeros(1, int)
        generation = np.searchsorted(starts, row, side="right") - 1
        slot = row - starts[generation]

    def quantity(name: str) -> Quantity:
        axes, values, about = found[name]
        axis = None
        if len(axes) > 1:
            _, labels, told = found[axes[1]]
            meaning = told.get("long_name", "")
            axis = Axis(axes[1], labels, told.get("units", ""), meaning)
        # Exact quantities have no standard error.
        is_exact = name + _ERROR not in found
        error = 0 * values if is_exact else found[name + _ERROR].values
        return Quantity(name, about.get("units", ""), values, error, axis)

    def integers(name: str) -> Integers:
        return found[name].values.astype(int)

    return Rows(
        genes=genes,
        goals=goals,
        quantities={
            name: quantity(name)
            for name, column in found.items()
            if name not in (*_NO_QUANTITIES, row_axis)
            and not name.endswith(_ERROR)
            and column.axes[0] == row_axis
            and len(column.axes) <= 2
        },
        row=row,
        generation=generation,
        slot=slot,
        status=integers("status"),
        origin=integers("origin"),
        parents=integers("parents"),
        genome=found["genome"].values,
        objectives=found["objectives"].values,
        objectives_standard_error=found["objectives" + _ERROR].values,
        randomisations=found["objectives_by_randomisation"].values,
        violation=found["violation"].values,
        attempt=integers("attempt"),
        seconds=found["seconds"].values,
        worker=integers("worker"),
        message=found["message"].values,
    )
