# SPDX-License-Identifier: Apache-2.0
"""Evaluations as a pandas DataFrame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pandas

from .history import History
from .rows import Origin, Status

_WORDS = ("campaign", "case", "site", "day", "spacing", "trait_set")
_COORDINATES = {
    **dict.fromkeys((*_WORDS, "replicate"), ""),
    **dict.fromkeys(("latitude", "longitude"), "deg"),
    **dict.fromkeys(("row_spacing", "plant_spacing"), "m"),
}
"""Root attributes of a history that become columns, with their units."""


def make_frame(histories: Sequence[History]) -> pandas.DataFrame:
    """Returns one row per complete evaluation, with the columns campaign,
    case, site, day, spacing, trait_set, replicate, latitude, longitude,
    row_spacing, plant_spacing, row, generation, slot, status, origin, seconds,
    worker and violation, then quantities by name, each with its standard error
    as <name>_standard_error, and genes. A quantity with an axis has one column
    for each label, such as "absorbed_by_leaf 3". Genes that stand for values
    of a list have these as TOML. Missing columns of a history
    are NaN. The unit of a column is .attrs["units"][column]."""
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
    columns: dict[str, tuple[Any, str]] = {
        name: (np.repeat(has[name], len(rows)), unit)
        for name, unit in _COORDINATES.items()
        if name in has
    }
    for name in ("row", "generation", "slot"):
        columns[name] = getattr(rows, name), ""
    columns["status"] = [Status(s).name.lower() for s in rows.status], ""
    columns["origin"] = [Origin(o).name.lower() for o in rows.origin], ""
    columns["seconds"] = rows.seconds, "s"
    columns["worker"] = rows.worker, ""
    columns["violation"] = rows.violation, "1"
    for name, quantity in rows.quantities.items():
        for column, values in (
            (name, quantity.values),
            (f"{name}_standard_error", quantity.standard_error),
        ):
            if quantity.axis is None:
                columns[column] = values, quantity.unit
                continue
            for label, part in zip(quantity.axis.labels, values.T):
                columns[f"{column} {label}"] = part, quantity.unit
    genes = rows.genes
    for i, (name, unit) in enumerate(zip(genes.names, genes.units)):
        numbers: Any = rows.genome[:, i]
        if genes.values and genes.values[i]:
            numbers = [genes.text(i, number) for number in numbers]
        columns[name] = numbers, unit
    return columns
