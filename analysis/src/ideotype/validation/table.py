# SPDX-License-Identifier: Apache-2.0
"""Reads tables of measurements and converts their units."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import date, time
from functools import cache
from pathlib import Path
from typing import Any

from ..common.csv_rows import Problems, read_rows
from ..errors import Error, did_you_mean

COLUMNS = {
    "date": "day, YYYY-MM-DD",
    "hour": "time on the clock of the site, 13:20 or 12:20-14:20",
    "quantity": "name of the measured quantity",
    "height": "height of the sensor above the soil [m]",
    "position": "distance of the sensor across the rows, from a row [m]",
    "leaves": "third of the leaves by rank: lower, middle, upper; or a rank",
    "value": "measured value",
    "error": "standard error of the value",
    "low": "smallest measured value, instead of a value",
    "high": "largest measured value",
    "unit": "unit of value, error, low and high",
}
"""The columns of a table. A column with a dot in its name is a key of the
campaign that takes the value of the row."""

THIRDS = {"lower": 0, "middle": 1, "upper": 2}
"""The thirds of the leaves of a plant by rank, as named in the column
`leaves`."""


def find_third(rank: Any, leaves: int) -> Any:
    """Returns the third, 0 to 2, to which a rank or an array of ranks belongs;
    the lowest leaf has rank 1."""
    return 3 * (2 * rank - 1) // (2 * leaves)


@dataclass(frozen=True)
class Measurement:
    """A row of a table of measurements, in the unit of the table."""

    quantity: str
    unit: str
    low: float
    """The value, or the smallest measured value; NaN: no value."""
    high: float
    """The value, or the largest measured value."""
    error: float
    """The standard error; NaN: not known."""
    date: date | None = None
    hours: tuple[time, time] | None = None
    height: float = 0.0
    position: float = math.nan
    leaves: str = ""
    keys: Mapping[str, Any] = field(default_factory=dict)
    where: str = ""
    """The file and line of the row."""

    @property
    def is_measured(self) -> bool:
        """Whether it has a value. Else it only states conditions under which a
        value is computed."""
        return not math.isnan(self.low)

    @property
    def hours_text(self) -> str:
        """The hours as "12:20-14:20"; "" for the whole day."""
        return "-".join(f"{end:%H:%M}" for end in self.hours or ())

    @property
    def value(self) -> float:
        """The value, or the middle of the measured range; of an open range its
        finite end."""
        if math.isinf(self.low) or math.isinf(self.high):
            return self.high if math.isinf(self.low) else self.low
        return (self.low + self.high) / 2


def read_table(path: Path) -> list[Measurement]:
    """Reads a CSV file with the columns `COLUMNS`; lines that begin with # are
    comments.

    Raises Error with all problems of the file and their lines."""
    problems = Problems()
    measured = collect_table(path, problems)
    problems.raise_any()
    return measured


def collect_table(path: Path, problems: Problems) -> list[Measurement]:
    """Returns the rows of a file as for `read_table` that have no problems,
    and adds the problems of the others."""
    table = read_rows(path, problems)
    names = [name.lower() for name in table.names]
    _check_names(names, table.head, problems)
    measured = [
        _measurement(
            {name: cell for name, cell in zip(names, cells) if cell},
            where,
            problems,
        )
        for where, cells in table.rows
    ]
    return [row for row in measured if row]


def measurements_from_rows(
    rows: Iterable[Mapping[str, Any]], where: str
) -> list[Measurement]:
    """Returns the measurements of rows of a file of facts, with the names of
    `COLUMNS`. Raises Error with all problems."""
    problems = Problems()
    measured = []
    for number, row in enumerate(rows, 1):
        place = f"{where}, row {number}"
        _check_names(list(row), place, problems)
        measured.append(_measurement(row, place, problems))
    problems.raise_any()
    return [row for row in measured if row]


def _check_names(names: list[str], where: str, problems: Problems) -> None:
    for name in names:
        if name not in COLUMNS and "." not in name:
            problems.add(
                where,
                f"there is no column '{name}'"
                + (
                    did_you_mean(name, list(COLUMNS))
                    or f"; use {', '.join(COLUMNS)} or a key of the campaign "
                    "such as spacing.density"
                ),
            )
    if "quantity" not in names:
        problems.add(
            where, "there is no column quantity; name the measured quantity"
        )


def _measurement(
    cells: Mapping[str, Any], where: str, problems: Problems
) -> Measurement | None:
    before = len(problems.texts)

    def read(name: str, reader: Any, remedy: str) -> Any:
        if name not in cells:
            return None
        try:
            return reader(cells[name])
        except (ValueError, TypeError):
            problems.add(where, f"{name} is '{cells[name]}'; {remedy}")
            return None

    number = "give a finite number"
    numbers = {
        name: read(name, _finite, number)
        for name in ("height", "position", "value", "error", "low", "high")
    }
    unit = str(cells.get("unit", "1"))
    day = read("date", _date, "write it as 2025-08-07")
    hours = read("hour", _hours, "write it as 13:20 or 12:20-14:20")
    leaves = str(cells.get("leaves", ""))
    quantity = str(cells.get("quantity", ""))
    if not quantity and "quantity" not in cells:
        problems.add(where, "quantity is empty; name the measured quantity")
    if leaves not in ("", *THIRDS) and not leaves.isdecimal():
        problems.add(
            where,
            f"leaves is '{leaves}'; use lower, middle, upper or a rank",
        )
    error = numbers["error"]
    if error is not None and error < 0:
        problems.add(where, f"error is {error:g}; give 0 or more")
    if numbers["value"] is not None and (
        numbers["low"] is not None or numbers["high"] is not None
    ):
        problems.add(
            where,
            "a row has a value or a range; remove value, or low and high",
        )
    try:
        factor_to(unit, unit)
    except Error as unknown:
        problems.add(where, str(unknown))
    if len(problems.texts) > before:
        return None
    low, high = _range(numbers)
    if low > high:
        problems.add(where, f"low is {low:g} and high {high:g}; swap them")
        return None
    return Measurement(
        quantity,
        unit,
        low,
        high,
        math.nan if error is None else error,
        day,
        hours,
        numbers["height"] or 0.0,
        math.nan if numbers["position"] is None else numbers["position"],
        leaves,
        {name: _value(cell) for name, cell in cells.items() if "." in name},
        where,
    )


def _range(numbers: Mapping[str, float | None]) -> tuple[float, float]:
    value, low, high = (numbers[name] for name in ("value", "low", "high"))
    if value is not None:
        return value, value
    if low is None and high is None:
        return math.nan, math.nan
    return (
        -math.inf if low is None else low,
        math.inf if high is None else high,
    )


def _finite(cell: Any) -> float:
    number = float(cell)
    if not math.isfinite(number):
        raise ValueError
    return number


def _date(cell: Any) -> date:
    return cell if isinstance(cell, date) else date.fromisoformat(str(cell))


def _hours(cell: Any) -> tuple[time, time]:
    """Returns the ends of a period; a single time means the half hour around
    it."""
    first, _, last = str(cell).partition("-")
    if last:
        span = _minutes(first), _minutes(last)
    else:
        span = _minutes(first) - 15, _minutes(first) + 15
    if not 0 <= span[0] < span[1] < 24 * 60:
        raise ValueError
    return tuple(time(*divmod(x, 60)) for x in span)  # type: ignore[return-value]


def _minutes(text: str) -> int:
    match = re.fullmatch(r"\s*(\d{1,2}):(\d\d)(?::\d\d)?\s*", text)
    if match is None:
        return round(60 * float(text))
    return 60 * int(match[1]) + int(match[2])


def _value(cell: Any) -> Any:
    """Returns the value of a key of the campaign."""
    if not isinstance(cell, str):
        return cell
    try:
        return float(cell)
    except ValueError:
        return cell


@cache
def _registry() -> Any:
    """Returns the registry of units, created at first use."""
    try:
        from pint import UnitRegistry
    except ImportError:
        raise Error(
            "pint, which reads the units of measurements, is not installed; run "
            'pip install "ideotype[validate]"'
        ) from None

    # Units have exponents at their end, such as g m-2 day-1.
    exponent = re.compile(r"([A-Za-z%µ]+)\s*\^?(-?\d)(?![\d.])")
    registry: Any = UnitRegistry(
        preprocessors=[
            lambda text: exponent.sub(r"\1**\2", text.replace("%", "percent"))
        ],
        on_redefinition="ignore",
    )
    registry.define("@alias mole = mol")
    return registry


@cache
def factor_to(unit: str, to: str) -> float:
    """Returns the conversion factor from `unit` to `to`.

    Raises Error if a unit is unknown, or dimensions differ."""
    registry = _registry()
    try:
        given, wanted = (_parsed(registry, name) for name in (unit, to))
        return float((1 * given).to(wanted).magnitude)
    except Exception as error:  # The errors of pint have many classes.
        raise Error(
            f"unit '{unit}' cannot be read as '{to}' ({error}); write it as "
            "t ha-1, MJ m-2 day-1, deg, % or 1"
        ) from None


def _parsed(registry: Any, unit: str) -> Any:
    text = unit.strip()
    if text in ("", "1", "fraction"):
        return registry.dimensionless
    # Blanks between units mean a product.
    return registry.parse_units("*".join(text.split()))
