# SPDX-License-Identifier: Apache-2.0
"""Makes evaluations from the columns of a history."""

from __future__ import annotations

import numpy as np

from .columns import Columns
from .genes import Genes
from .quantity import Axis, Integers, Objective, Quantity
from .rows import Rows

_FINAL = -1
"""The generation number of finalists."""
_ERROR = "_standard_error"
_NO_QUANTITIES = {
    *("status", "genome", "origin", "parents", "violation"),
    *("objectives", "objectives_by_randomisation", "checksum"),
    *("attempt", "seconds", "worker", "message"),
}
"""The columns of rows that are not quantities."""


def make_rows(
    table: Columns,
    starts: Integers | None,
    genes: Genes,
    goals: tuple[Objective, ...],
) -> Rows:
    """Returns evaluations with all quantities of the columns. starts: first
    row of each generation; None for finalists.

    Raises HistoryError if a column is missing."""
    (row_axis,) = table["status"].axes
    row = table[row_axis].values.astype(int)
    generation, slot = np.full(len(row), _FINAL), row
    if starts is not None and len(row):
        # The first generation begins with row 0, even if it is incomplete.
        starts = starts if len(starts) else np.zeros(1, int)
        generation = np.searchsorted(starts, row, side="right") - 1
        slot = row - starts[generation]

    def quantity(name: str) -> Quantity:
        axes, values, about = table[name]
        axis = None
        if len(axes) > 1:
            _, labels, description = table[axes[1]]
            meaning = description.get("long_name", "")
            unit = description.get("units", "")
            axis = Axis(axes[1], labels, unit, meaning)
        # Exact quantities have no standard error.
        is_exact = name + _ERROR not in table
        error = 0 * values if is_exact else table[name + _ERROR].values
        return Quantity(name, about.get("units", ""), values, error, axis)

    def integers(name: str) -> Integers:
        return table[name].values.astype(int)

    return Rows(
        genes=genes,
        goals=goals,
        quantities={
            name: quantity(name)
            for name, column in table.items()
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
        genome=table["genome"].values,
        objectives=table["objectives"].values,
        objectives_standard_error=table["objectives" + _ERROR].values,
        randomisations=table["objectives_by_randomisation"].values,
        violation=table["violation"].values,
        attempt=integers("attempt"),
        seconds=table["seconds"].values,
        worker=integers("worker"),
        message=table["message"].values,
    )
