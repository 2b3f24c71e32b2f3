# SPDX-License-Identifier: Apache-2.0
"""Evaluations as a pandas frame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pandas

from .history import History
from .quantity import Floats, Quantity
from .rows import Origin, Rows, Status

PLACE = (
    "campaign",
    "case",
    "site",
    "day",
    "spacing",
    "trait_set",
    "replicate",
    "latitude",
    "longitude",
    "row_spacing",
    "plant_spacing",
)
"""Root attributes that become columns, as far as a history has them."""

_PLACE_UNITS = {
    "latitude": "deg",
    "longitude": "deg",
    "row_spacing": "m",
    "plant_spacing": "m",
}


def frame_of(histories: Sequence[History]) -> pandas.DataFrame:
    """One row per complete evaluation. Columns: the place (PLACE), row,
    generation, slot, status, origin, seconds, worker, violation, then
    quantities by their names, of those with an axis one column for each
    label, such as "absorbed_by_leaf 3", each with its standard error as
    <name>_standard_error, and genes. Histories without a column have NaN
    there."""
    units: dict[str, str] = {}
    parts = [_part(history, units) for history in histories]
    frame = pandas.concat(parts, ignore_index=True)
    for name in ("campaign", "case", "site", "day", "spacing", "trait_set"):
        if name in frame:
            frame[name] = frame[name].astype("category")
    frame.attrs["units"] = {name: units.get(name, "") for name in frame}
    return frame


def _part(history: History, units: dict[str, str]) -> pandas.DataFrame:
    rows = history.evaluations()
    columns: dict[str, Any] = {}
    for name in PLACE:
        if name in history.attributes:
            columns[name] = np.repeat(history.attributes[name], len(rows))
            units[name] = _PLACE_UNITS.get(name, "")
    columns |= _bookkeeping(rows)
    units |= {"seconds": "s", "violation": "1"}
    for quantity in rows.quantities.values():
        errors = quantity.standard_error
        _add(quantity.name, quantity, quantity.values, columns, units)
        _add(
            f"{quantity.name}_standard_error", quantity, errors, columns, units
        )
    columns |= dict(zip(rows.genes.names, rows.genome.T))
    units |= dict(zip(rows.genes.names, rows.genes.units))
    return pandas.DataFrame(columns)


def _bookkeeping(rows: Rows) -> dict[str, Any]:
    return {
        "row": rows.row,
        "generation": rows.generation,
        "slot": rows.slot,
        "status": [Status(s).name.lower() for s in rows.status],
        "origin": [Origin(o).name.lower() for o in rows.origin],
        "seconds": rows.seconds,
        "worker": rows.worker,
        "violation": rows.violation,
    }


def _add(
    name: str,
    quantity: Quantity,
    values: Floats,
    columns: dict[str, Any],
    units: dict[str, str],
) -> None:
    found = {name: values}
    if quantity.axis:
        labels = quantity.axis.labels
        found = {f"{name} {x}": column for x, column in zip(labels, values.T)}
    columns |= found
    units |= dict.fromkeys(found, quantity.unit)
