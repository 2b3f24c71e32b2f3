# SPDX-License-Identifier: Apache-2.0
"""Reads midribs of digitised plants from CSV files."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pandas as pd

from ...common.arrays import read_columns
from ...errors import Error
from .blades import UNITS, Blade, Floats, metres, parts


def _column(
    table: pd.DataFrame, names: str
) -> tuple[pd.Series, str | None] | None:
    """Returns the column with one of the given names, and its unit, if any."""
    for column in table:
        if match := re.fullmatch(rf"(?:{names})(?:_(m|cm|mm))?", str(column)):
            return table[column], match[1]
    return None


_OUT = "x|out|r|x_along|distance"
_UP = "z|up|z_up|height"
"""The column names of coordinates, outward from the stalk and up."""


def is_coordinate(column: str) -> bool:
    """Returns whether a column has coordinates of points. A column "height"
    may be that of a plant."""
    names = f"{_OUT}|{_UP}".removesuffix("|height")
    return bool(re.fullmatch(rf"(?:{names})(?:_(?:m|cm|mm))?", column))


def read_midribs(
    path: Path, plant: str | None, leaves: Path | None, unit: str
) -> list[Blade]:
    """Returns the blades of a CSV file of points along midribs; the arguments
    are those of read_plant()."""
    table = read_columns(path)
    if "plant" in table:
        names = list(dict.fromkeys(table["plant"].astype(str)))
        if plant is None and len(names) == 1:
            plant = names[0]
        if plant not in names:
            raise Error(
                f"{path}: this file has several plants; name one by --plant: "
                f"{', '.join(names)}"
            )
        table = table[table["plant"].astype(str) == plant]
    columns = {
        "out": _column(table, _OUT),
        "up": _column(table, _UP),
        "side": _column(table, "y|side|y_across"),
    }
    for name, column in columns.items():
        if column is None and name != "side":
            raise Error(
                f"{path}:1: there is no column of the points {name}; name it "
                f"{'x' if name == 'out' else 'z'}_m, _cm or _mm"
            )
    if "leaf" not in table:
        raise Error(
            f"{path}:1: there is no column leaf; add it with the rank of the "
            "leaf of each point"
        )
    points = np.zeros((len(table), 3))
    named_unit = None
    for axis, name in enumerate(("side", "out", "up")):
        if (column := columns[name]) is not None:
            named_unit = named_unit or column[1]
            try:
                points[:, axis] = column[0].astype(float)
            except ValueError as error:
                raise Error(
                    f"{path}: a number cannot be read ({error})"
                ) from None
    bad = ~np.isfinite(points).all(axis=1)
    points, table = points[~bad], table[~bad]
    keys = ["leaf", *(n for n in ("number", "sample") if n in table)]
    lines: dict[int, list[Floats]] = {}
    for _, rows in table.reset_index(drop=True).groupby(keys, sort=True):
        line = points[rows.index]
        if len(line) > 1 and np.ptp(line, axis=0).max() > 0:
            lines.setdefault(int(rows["leaf"].iloc[0]), []).append(line)
    if not lines:
        raise Error(
            f"{path}: no leaf has two points that differ; give points from "
            "base to tip"
        )
    factor = metres(
        named_unit or unit,
        [
            float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())
            for several in lines.values()
            for line in several
        ],
    )
    more = _measures(leaves, plant) if leaves else {}
    if leaves and (without := sorted(lines.keys() - more.keys())):
        raise Error(
            f"{leaves}: leaf {without[0]} of {path.name} is not in this table; "
            "add it, or take its midrib out"
        )
    return [
        _flat_blade(
            rank, [factor * line for line in several], more.get(rank, {})
        )
        for rank, several in sorted(lines.items())
    ]


def _flat_blade(
    rank: int, lines: list[Floats], more: dict[str, float]
) -> Blade:
    """Returns the mean of the digitisations of a leaf, at equal fractions of
    their lengths, with the measured length, width and height."""
    at = np.linspace(0, 1, 41)
    mean = np.mean(
        [
            np.column_stack([np.interp(at, parts(x), part) for part in x.T])
            for x in lines
        ],
        axis=0,
    )
    height = more.get("insertion_height", 0.0)
    size = float(np.linalg.norm(np.diff(mean, axis=0), axis=1).sum())
    midrib = (mean - mean[0]) * more.get("length", size) / size
    turn = np.radians(more.get("azimuth", 0.0))
    rotation = np.array(
        [
            [np.cos(turn), np.sin(turn), 0],
            [-np.sin(turn), np.cos(turn), 0],
            [0, 0, 1],
        ]
    )
    return Blade(
        f"leaf {rank}",
        midrib @ rotation.T + np.array([0, 0, height]),
        has_azimuth="azimuth" in more,
        has_height="insertion_height" in more,
        stated_width=more.get("width"),
    )


def _measures(path: Path, plant: str | None) -> dict[int, dict[str, float]]:
    """Returns lengths, widths and heights [m] and azimuths [deg] by rank, from
    a table as docs/plant.md describes it, which may have a column of
    plants."""
    table = read_columns(path)
    if "plant" in table:
        table = table[table["plant"].astype(str) == plant]
    rank = (
        table["leaf"]
        if "leaf" in table
        else pd.Series(range(1, len(table) + 1))
    )
    measures: dict[int, dict[str, float]] = {int(leaf): {} for leaf in rank}
    for name in ("length", "width", "insertion_height"):
        if (column := _column(table, name)) is None:
            continue
        values, unit = column
        for i, value in zip(rank, values, strict=True):
            if np.isfinite(value):
                measures[int(i)][name] = float(value) * UNITS[unit or "m"]
    for name in ("azimuth_from_row_clockwise_deg", "azimuth_deg"):
        if name in table:
            for i, value in zip(rank, table[name], strict=True):
                measures[int(i)]["azimuth"] = float(value)
    return measures
