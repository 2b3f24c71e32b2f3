# SPDX-License-Identifier: Apache-2.0
"""Reads the files of trials: wide and long tables, and observations of BrAPI
2, as one row of cells for each plot or line."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..common.csv_rows import Problems, read_rows, read_text
from ..errors import Error
from .traits import find_factor

FACTORS = ("line", "environment", "replicate", "block", "plot")
"""The columns of a trial that describe its design."""

_Record = tuple[str, dict[str, str], str, str]
"""A place in the file, factors, trait and value."""


@dataclass(frozen=True)
class Cells:
    """The cells of a trial by column."""

    names: list[str]
    rows: list[tuple[str, dict[str, str]]]
    """The place in the file, and the cells by column; "": missing."""
    has_decimal_commas: bool = False


def read_cells(path: Path, problems: Problems) -> Cells:
    """Reads a CSV file, separated by commas, semicolons or tabs, or a JSON
    file of BrAPI 2. Raises Error if it cannot be read at all."""
    if path.suffix.lower() == ".json":
        return _read_brapi(path, problems)
    table = read_rows(path, problems, ";\t,")
    rows = [(where, dict(zip(table.names, row))) for where, row in table.rows]
    has_decimal_commas = table.separator != ","
    short = {name.lower(): name for name in table.names}
    if not {"trait", "value"} <= short.keys():
        return Cells(table.names, rows, has_decimal_commas)
    # A long table, as Field Book exports it.
    given = [name for name in table.names if find_factor(name)]
    unit = short.get("units", short.get("scale", ""))
    records = (
        (
            where,
            {name: row[name] for name in given},
            row[short["trait"]]
            + (f" [{row[unit]}]" if unit and row[unit] else ""),
            row[short["value"]],
        )
        for where, row in rows
    )
    return _pivot(given, records, problems, has_decimal_commas)


def _pivot(
    given: Iterable[str],
    records: Iterable[_Record],
    problems: Problems,
    has_decimal_commas: bool = False,
) -> Cells:
    """Returns one row for each unit of observation."""
    factors_of = list(given)
    units: dict[tuple[str, ...], tuple[str, dict[str, str]]] = {}
    names: dict[str, None] = {}
    for where, factors, trait, value in records:
        key = tuple(factors[name] for name in factors_of)
        place, row = units.setdefault(key, (where, dict(factors)))
        if trait in row:
            problems.add(
                where,
                f"{trait} of {'/'.join(key)} was observed already at {place}; "
                "remove one, or give each plot a name",
            )
        row[trait] = value
        names[trait] = None
    rows = [
        (where, {**dict.fromkeys(names, ""), **row})
        for where, row in units.values()
    ]
    return Cells([*factors_of, *names], rows, has_decimal_commas)


def _read_brapi(path: Path, problems: Problems) -> Cells:
    """Reads a response of BrAPI 2 (brapi.org) to /observations, or to
    /observationunits with their observations."""
    try:
        answer = json.loads(read_text(path))
        data = answer["result"]["data"] if "result" in answer else answer
        if not isinstance(data, list):
            raise TypeError("result.data is no list")
    except (ValueError, KeyError, TypeError) as error:
        raise Error(
            f"{path}: this is no response of BrAPI 2 ({error}); save the answer "
            "to /observations or /observationunits"
        ) from None
    records = []
    for number, item in enumerate(data, 1):
        place = f"{path}, data {number}"
        nested = item.get("observations") if isinstance(item, dict) else None
        for observation in [item] if nested is None else nested:
            if not isinstance(observation, dict):
                problems.add(place, "this is no object; see brapi.org")
                continue
            merged = {**item, **observation}
            name = merged.get("observationVariableName")
            if not name or not merged.get("germplasmName"):
                problems.add(
                    place,
                    "an observation lacks observationVariableName or "
                    "germplasmName; request them from the server",
                )
                continue
            value = _text(merged.get("value"))
            records.append((place, _brapi_factors(merged), name, value))
    return _pivot(FACTORS, records, problems)


def _brapi_factors(item: Mapping[str, Any]) -> dict[str, str]:
    position = item.get("observationUnitPosition")
    position = position if isinstance(position, dict) else {}
    levels = {
        str(x.get("levelName", "")).lower(): str(x.get("levelCode", ""))
        for x in position.get("observationLevelRelationships") or []
    }
    season = item.get("season")
    year = season.get("year", "") if isinstance(season, dict) else season
    places = [item.get("studyName"), year]
    unit = item.get("observationUnitName") or item.get("observationUnitDbId")
    return {
        "line": _text(item["germplasmName"]),
        "environment": " ".join(_text(x) for x in places if x),
        "replicate": levels.get("rep", levels.get("replicate", "")),
        "block": levels.get("block", ""),
        "plot": _text(unit),
    }


def _text(value: Any) -> str:
    return "" if value is None else str(value).strip()
