# SPDX-License-Identifier: Apache-2.0
"""Evaluations as a pandas frame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pandas

from .history import History
from .rows import Origin, Status

_WORDS = ("campaign", "case", "site", "day", "spacing", "trait_set")
_PLACE = {
    **dict.fromkeys((*_WORDS, "replicate"), ""),
    **dict.fromkeys(("latitude", "longitude"), "deg"),
    **dict.fromkeys(("row_spacing", "plant_spacing"), "m"),
}
"""Root attributes of a history that become columns, with their units."""


def frame_of(histories: Sequence[History]) -> pandas.DataFrame:
    """Returns one row per complete evaluation. Columns: campaign, case, site,
    day, spacing, trait_set, replicate, latitude, longitude, row_spacing and
    plant_spacing, row, generation, slot, status, origin, seconds, worker,
    violation, then quantities by their names (a quantity with an axis has one
    column for each label, such as "absorbed_by_leaf 3"), each with its
    standard error as <name>_standard_error, and genes. Histories that lack a
    column have NaN in the column; the unit of a column is
    .attrs["units"][column]."""
    tables = [_columns(history) for history in histories]
    parts = (
        pandas.DataFrame({name: values for name, (values, _) in table.items()})
        for table in tables
    )
    frame = pandas.concat(parts, ignore_index=True)
    for name in {*_WORDS} & {*frame}:
        frame[name] = frame[name].astype("category")
    units = {n: unit for table in tables for n, (_, unit) in table.items()}
    frame.attrs["units"] = {name: units[name] for name in frame}
    return frame


def _columns(history: History) -> dict[str, tuple[Any, str]]:
    """Returns the values and the unit of each column by name."""
    rows, has = history.evaluations(), history.attributes
    found: dict[str, tuple[Any, str]] = {
        name: (np.repeat(has[name], len(rows)), unit)
        for name, unit in _PLACE.items()
        if name in has
    }
    for name in ("row", "generation", "slot"):
        found[name] = getattr(rows, name), ""
    found["status"] = [Status(s).name.lower() for s in rows.status], ""
    found["origin"] = [Origin(o).name.lower() for o in rows.origin], ""
    found["seconds"] = rows.seconds, "s"
    found["worker"] = rows.worker, ""
    found["violation"] = rows.violation, "1"
    for name, quantity in rows.quantities.items():
        for column, values in (
            (name, quantity.values),
            (f"{name}_standard_error", quantity.standard_error),
        ):
            if quantity.axis is None:
                found[column] = values, quantity.unit
                continue
            for label, part in zip(quantity.axis.labels, values.T):
                found[f"{column} {label}"] = part, quantity.unit
    genes = rows.genes
    pairs = zip(rows.genome.T, genes.units)
    return found | dict(zip(genes.names, pairs))
