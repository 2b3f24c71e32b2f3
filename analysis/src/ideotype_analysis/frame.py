"""Evaluations as a pandas frame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pandas

from .history import History
from .rows import Origin, Rows, Status
from .table import Table

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
    """One row per complete evaluation. Columns: the place (PLACE), generation,
    slot, status, origin, seconds, worker, fitness, then objectives,
    diagnostics and traits by their names, and <name>_standard_error of the
    first two. Histories without a column have NaN there."""
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
    units |= {"seconds": "s", "fitness": rows.fitness.unit}
    for table in (rows.objectives, rows.diagnostics):
        _add(table, columns, units)
        _add(table, columns, units, "_standard_error")
    _add(rows.traits, columns, units)
    return pandas.DataFrame(columns)


def _bookkeeping(rows: Rows) -> dict[str, Any]:
    return {
        "generation": rows.generation,
        "slot": rows.slot,
        "status": [Status(s).name.lower() for s in rows.status],
        "origin": [Origin(o).name.lower() for o in rows.origin],
        "seconds": rows.seconds.values,
        "worker": rows.worker,
        "fitness": rows.fitness.values,
    }


def _add(
    table: Table, columns: dict[str, Any], units: dict[str, str], end: str = ""
) -> None:
    values = table.standard_error if end else table.values
    for i, (name, unit) in enumerate(zip(table.names, table.units)):
        columns[name + end] = values[:, i]
        units[name + end] = unit
