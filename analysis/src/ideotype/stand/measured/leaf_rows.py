# SPDX-License-Identifier: Apache-2.0
"""Reads tables of measured leaves: the leaves of each plant in metres and
degrees, and the line and column of each value and problem."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from ...common.arrays import require_file
from ...common.compiled import _core
from ...errors import Error, InputError, Problem, did_you_mean, printable

LIMITS = {name: (low, high) for name, _, low, high in _core.leaf_measures()}
"""The limits of the measures of a leaf [m, deg], in their order."""
_UNITS = {name: unit for name, unit, *_ in _core.leaf_measures()}
_HEIGHTS = (-1.0, 10.0)
"""The limits of heights above the soil [m]. A tip may hang below the foot of a
plant on a ridge."""


class Place(NamedTuple):
    """A line and column of a table, from 1."""

    line: int
    column: int


@dataclass(frozen=True)
class _Column:
    """A column of a table. An entry x means (zero + sign x) / per_unit."""

    measure: str
    per_unit: float = 1
    sign: float = 1
    zero: float = 0
    height: str = ""
    """The point of the leaf with the height from which the curvature follows:
    "tip" or "top"."""
    is_from_north: bool = False


def _sizes(name: str, measure: str, height: str = "") -> dict[str, _Column]:
    return {
        f"{name}_{unit}": _Column(measure, per_unit, height=height)
        for unit, per_unit in (("cm", 100), ("m", 1), ("mm", 1000))
    }


# The convention of exported plants comes first among angles of a measure.
COLUMNS = {
    **_sizes("length", "length"),
    **_sizes("width", "width"),
    "insertion_angle_deg": _Column("insertion_angle"),
    "insertion_angle_from_vertical_deg": _Column("insertion_angle"),
    "insertion_angle_from_horizontal_deg": _Column(
        "insertion_angle", sign=-1, zero=90
    ),
    "curvature_deg": _Column("curvature"),
    **_sizes("tip_height", "curvature", "tip"),
    **_sizes("top_height", "curvature", "top"),
    "azimuth_deg": _Column("azimuth"),
    "azimuth_from_row_clockwise_deg": _Column("azimuth"),
    "azimuth_from_row_counterclockwise_deg": _Column("azimuth", sign=-1),
    "azimuth_from_north_deg": _Column("azimuth", is_from_north=True),
    **_sizes("insertion_height", "insertion_height"),
    "roll_deg": _Column("roll"),
    "twist_deg": _Column("twist"),
    **_sizes("petiole_length", "petiole_length"),
    "petiole_angle_deg": _Column("petiole_angle"),
    **_sizes("internode", "internode"),
}
"""The columns with measures of leaves."""
_RANK = "leaf"
_PLANT = ("plant", "line")


@dataclass
class Row:
    """One leaf, from one line of a table."""

    place: Place
    rank: int
    values: dict[str, float] = field(default_factory=dict)
    places: dict[str, Place] = field(default_factory=dict)
    height: tuple[str, float] | None = None
    """The point of the leaf with a measured height ("tip" or "top"), and this
    height [m]."""


class LeafTable:
    """The leaves of a table and its problems; `read` reads the lines."""

    def __init__(self, path: Path) -> None:
        require_file(path)
        self.path = path
        self.problems: dict[Problem, None] = {}
        # The position of the line of column names.
        self.header = Place(1, 1)
        # The measures of the table, and the leaves by the name of the plant.
        self.has: set[str] = set()
        self.rows: dict[str, list[Row]] = {}
        self._columns: list[str] = []
        self._named_at: int | None = None
        self._has_ranks = False
        self._row_direction = 0.0
        try:
            self._lines = path.read_text(encoding="utf-8-sig").split("\n")
        except UnicodeDecodeError as error:
            raise Error(
                f"{path}: this is no text in UTF-8 ({error.reason}); save the "
                "table so"
            ) from None

    def add(self, place: Place, text: str) -> None:
        """Records a problem; equal problems at one position count once."""
        self.problems[Problem(str(self.path), *place, text)] = None

    def raise_problems(self) -> None:
        """Raises InputError with all problems, if any, in the order of the
        file."""
        if self.problems:
            problems = sorted(self.problems, key=lambda x: (x.line, x.column))
            raise InputError(
                "\n".join(
                    f"{x.file}:{x.line}:{x.column}: {x.what}" for x in problems
                ),
                problems,
            )

    def note(self, name: str) -> tuple[str, Place] | None:
        """Returns the value and position of a line "# NAME: VALUE".
        Spreadsheet programs add quotes and commas to it."""
        for number, line in enumerate(self._lines, 1):
            match = re.match(rf'[ \t"]*#[ \t]*{name}:[ \t",;]*', line)
            if match and (value := line[match.end() :].rstrip(' \t",;\r')):
                return value, Place(number, match.end() + 1)
        return None

    def comments(self) -> Iterator[str]:
        """Yields the comments, except lines "# NAME: VALUE"."""
        for line in self._lines:
            text = line.strip(' \t",;\r')
            if text.startswith("#") and not re.match(
                r"#[ \t]*(crop|plant|row_direction):", text
            ):
                yield printable(text.removeprefix("#").strip())

    def read(self, plant: str) -> None:
        """Reads the leaves of a plant, by default of the one in the line
        `# plant:`, or of all plants."""
        chosen = self.note("plant")
        self._read_lines(plant or (chosen[0] if chosen else ""))
        if plant and self._named_at is None:
            self.add(
                self.header,
                f"there is no plant '{plant}' (the table has no column plant "
                "or line); add one, or choose no plant",
            )

    def _read_lines(self, plant: str) -> None:
        is_headed = False
        for number, line in enumerate(self._lines, 1):
            text = line.lstrip(' \t,;"\r')
            if not text or text.startswith("#"):
                continue
            if is_headed:
                self._read_row(line, Place(number, 1), plant)
            else:
                is_headed = True
                self.header = Place(number, 1)
                self._read_header(line)
        if not self.rows:
            self.add(
                self.header,
                "there are no leaves (a table has a line with the names of "
                "its columns, then one for each leaf); add them",
            )
        elif plant and self._named_at is not None:
            names = list(self.rows)
            self.rows = {x: self.rows[x] for x in names if x == plant}
            if not self.rows:
                self.add(
                    self.header,
                    f"there is no plant '{plant}' (the table has "
                    f"{_some(names)})"
                    + (did_you_mean(plant, names) or "; correct it"),
                )

    def _read_header(self, line: str) -> None:
        if "," not in line and re.search("[;\t]", line):
            return self.add(
                self.header,
                "columns are not separated by commas (numbers have a decimal "
                "point, so that a comma ends an entry); save the table with "
                "commas",
            )
        strange: list[tuple[str, Place]] = []
        for name, column in _fields(line):
            place = Place(self.header.line, column)
            if name in COLUMNS:
                self._choose(name, place)
            elif name == _RANK:
                self._has_ranks = True
            elif name in _PLANT:
                self._choose_plants(name, place)
            else:
                # The column may be meant for any measure.
                self.has |= set(LIMITS)
                if remedy := _remedy_for(name):
                    self.add(place, remedy)
                else:
                    strange.append((name, place))
            self._columns.append(name)
        if strange:
            verb = "is no column" if len(strange) == 1 else "are no columns"
            names = "', '".join(name for name, _ in strange)
            self.add(
                strange[0][1],
                f"there {verb} '{names}' (a table has one line for each leaf "
                f"of a plant); columns are {_known_columns()}",
            )
        return None

    def _choose(self, name: str, place: Place) -> None:
        kind = COLUMNS[name]
        for other in self._columns:
            if other in COLUMNS and COLUMNS[other].measure == kind.measure:
                return self._add_twice(name, other, place)
        self.has.add(kind.measure)
        if not kind.is_from_north:
            return None
        note = self.note("row_direction")
        direction = _number(note[0]) if note else None
        if direction is not None and 0 <= direction <= 360:
            self._row_direction = direction
            return None
        return self.add(
            note[1] if note else place,
            "azimuth_from_north_deg needs the direction of the rows in which "
            "the plants stood (0 .. 360 deg clockwise from north); write a "
            "line such as # row_direction: 90",
        )

    def _choose_plants(self, name: str, place: Place) -> None:
        if self._named_at is not None:
            self._add_twice(name, self._columns[self._named_at], place)
        self._named_at = len(self._columns)

    def _add_twice(self, name: str, other: str, place: Place) -> None:
        self.add(
            place,
            f"{name} is given twice ({other} too); remove one of the columns",
        )

    def _read_row(self, line: str, place: Place, plant: str) -> None:
        if not self._columns:
            return
        fields = list(_fields(line))
        if len(fields) != len(self._columns):
            self.add(
                place,
                f"there are {len(fields)} entries (the table has "
                f"{len(self._columns)} columns); give each column one",
            )
            return
        name = ""
        if self._named_at is not None:
            name, column = fields[self._named_at]
            if not name:
                self.add(
                    Place(place.line, column),
                    f"{self._columns[self._named_at]} is empty; name the "
                    "plant of the leaf",
                )
                return
        rows = self.rows.setdefault(name, [])
        if plant and name and name != plant:
            return
        row = Row(place, len(rows) + 1)
        rows.append(row)
        for title, (text, column) in zip(self._columns, fields):
            if title in COLUMNS or title == _RANK:
                self._read_entry(title, text, row, Place(place.line, column))

    def _read_entry(
        self, title: str, text: str, row: Row, place: Place
    ) -> None:
        number = _number(text)
        if number is None:
            return self.add(
                place,
                f'{title} is "{text}" (which is no number); write one with a '
                "decimal point, or leave the column out",
            )
        if title == _RANK:
            if number < 1 or number % 1:
                return self.add(
                    place,
                    f"leaf is {number:g} (expected: 1 for the lowest, 2 for "
                    "the next); correct it",
                )
            row.rank = int(number)
            return None
        kind = COLUMNS[title]
        value = (kind.zero + kind.sign * number) / kind.per_unit
        lower, upper = _HEIGHTS if kind.height else LIMITS[kind.measure]
        inside = lower <= value <= upper
        if kind.measure == "azimuth":
            lower, inside = -upper, abs(number) <= upper
            if kind.is_from_north:
                value -= self._row_direction
            value = math.fmod(value + 2 * upper, upper)
        if not inside:
            return self.add(
                place,
                f"{title} is {number:g} (expected: {lower * kind.per_unit:g} "
                f".. {upper * kind.per_unit:g}); check the unit and the "
                "convention of the column",
            )
        row.places[kind.measure] = place
        if kind.height:
            row.height = (kind.height, value)
        else:
            row.values[kind.measure] = value
        return None

    def sort(self, rows: list[Row]) -> str | None:
        """Sorts leaves by rank and returns a remark on the ranks, or "", and
        None for wrong ranks. Field books count leaves from the first leaf of a
        plant, so the lowest living leaf may have any rank."""
        rows.sort(key=lambda row: row.rank)
        if not self._has_ranks:
            return ""
        lowest = rows[0].rank
        for expected, row in enumerate(rows, lowest):
            if row.rank == expected:
                continue
            self.add(
                row.place,
                f"leaf {row.rank} is given twice (each leaf has one line); "
                "remove one of the lines"
                if row.rank < expected
                else f"leaf {expected} is missing (the lowest is {lowest}, "
                "and ranks have no gaps); add it or renumber the leaves",
            )
            return None
        if lowest == 1:
            return ""
        return (
            f"leaves {lowest} .. {rows[-1].rank} of the table are leaves 1 .. "
            f"{len(rows)} here, and lower leaves are absent"
        )


def _number(text: str) -> float | None:
    """Returns a finite number with a decimal point, or None."""
    if re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", text, re.ASCII):
        number = float(text)
        return number if math.isfinite(number) else None
    return None


def _fields(line: str) -> Iterator[tuple[str, int]]:
    """Yields the entries of a line, without quotes, and their columns."""
    begin, is_quoted = 0, False
    for i, letter in enumerate(line + ","):
        if letter == '"':
            is_quoted = not is_quoted
        if i == len(line) or (letter == "," and not is_quoted):
            entry = line[begin:i]
            text = entry.lstrip(' \t\r"')
            yield text.rstrip(' \t\r"'), begin + len(entry) - len(text) + 1
            begin = i + 1


def _some(names: list[str]) -> str:
    return ", ".join(names[:5]) + (", ..." if len(names) > 5 else "")


def _remedy_for(name: str) -> str:
    """Returns a message for an unknown column that resembles a known one, else
    an empty text."""
    if name in _UNITS:
        unit = _UNITS[name]
        return (
            f"column '{name}' has no unit; name it "
            f"{name}_{'cm' if unit == 'm' else unit}"
        )
    near = did_you_mean(name, [_RANK, *COLUMNS])
    return f"there is no column '{name}'{near}" if near else ""


def _known_columns() -> str:
    """Returns the names of all columns, with the units of a measure together:
    "length_cm/_m/_mm"."""
    text, last = f"{_RANK}, {' or '.join(_PLANT)}", ""
    for name in COLUMNS:
        stem, _, unit = name.rpartition("_")
        text += f"/_{unit}" if stem == last else f", {name}"
        last = stem
    return text
