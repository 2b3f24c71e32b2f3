# SPDX-License-Identifier: Apache-2.0
"""Makes crops of tables of measured leaves: CSV files with a line for each
leaf, as docs/plant.md describes them."""

from __future__ import annotations

import math
import re
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import tomli_w

from ...common.arrays import require_file
from ...common.compiled import _core
from ...errors import Error, InputError, Problem, did_you_mean, printable
from .plant_sources import crop_tables

Tables = dict[str, Any]

_NEEDED = 6
"""The number of first measures that a crop file must have for each leaf."""
_LIMITS = {name: (low, high) for name, _, low, high in _core.leaf_measures()}
"""The limits of the measures of a leaf [m, deg], in their order."""
_UNITS = {name: unit for name, unit, *_ in _core.leaf_measures()}
_HEIGHTS = (-1.0, 10.0)
"""The limits of heights above the soil [m]. A tip may hang below the foot of a
plant on a ridge."""


class Place(NamedTuple):
    """A place in a table; lines and columns count from 1."""

    line: int
    column: int


@dataclass(frozen=True)
class _Column:
    """A column of a table; its measure is (zero + sign x) / per_unit."""

    measure: str
    per_unit: float = 1
    sign: float = 1
    zero: float = 0
    height: str = ""
    """The point of the leaf with the height from which the measure follows:
    "tip" or "top"."""
    is_from_north: bool = False


def _sizes(name: str, measure: str, height: str = "") -> dict[str, _Column]:
    return {
        f"{name}_{unit}": _Column(measure, per_unit, height=height)
        for unit, per_unit in (("cm", 100), ("m", 1), ("mm", 1000))
    }


# Angles as in exported plants come first among columns of their measure.
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
"""The columns that have measures of leaves."""
_RANK = "leaf"
_PLANT = ("plant", "line")


@dataclass
class _Row:
    """One leaf, from one line of a table."""

    place: Place
    rank: int
    values: dict[str, float] = field(default_factory=dict)
    places: dict[str, Place] = field(default_factory=dict)
    height: tuple[str, float] | None = None
    """The point of the leaf with a measured height, and the height [m]."""


@dataclass(frozen=True)
class MeasuredCrop:
    """The crop of one plant of a table."""

    plant: str
    """The name of the plant in the table; "" if it has none."""
    tables: Tables
    """The tables of a crop file."""
    core: _core.Plants
    crop: str
    """The crop that has all that was not measured."""
    remark: str
    """A remark on the ranks of the leaves, or ""."""
    comments: tuple[str, ...]
    """Comments of the table."""

    @property
    def name(self) -> str:
        """The name of the crop."""
        return str(self.tables["name"])

    @property
    def text(self) -> str:
        """The text of the crop file."""
        return _written(self.tables)[0]


def measured_crops(
    path: Path,
    crop: str = "",
    plant: str = "",
    otherwise: Tables | None = None,
) -> list[MeasuredCrop]:
    """Returns the crops of the plants of a table, in its order. Measures that
    the table lacks are those of the same leaf of the crop, if it has as many
    leaves; all other parts are those of the crop. The stalk changes by as much
    as the highest insertion, and organs at a leaf keep its rank counted from
    the highest leaf.

    crop: name or file of the crop; by default that of the line `# crop:`.
    plant: name of the only plant to read; by default that of the line
        `# plant:`, or else all.
    otherwise: tables of the crop if nothing names one.

    Raises InputError with all problems of the table, Error if a file cannot be
    read."""
    return _Table(path).crops(crop, plant, otherwise)


class _Table:
    """Reads a table and reports its problems."""

    def __init__(self, path: Path) -> None:
        require_file(path)
        self._path = path
        self._problems: dict[Problem, None] = {}
        self._columns: list[str] = []
        self._has: set[str] = set()
        self._rows: dict[str, list[_Row]] = {}
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

    def crops(
        self, crop: str, plant: str, otherwise: Tables | None
    ) -> list[MeasuredCrop]:
        chosen = self._note("plant")
        self._read(plant or (chosen[0] if chosen else ""))
        if plant and self._named_at is None:
            self._add(
                self._header,
                f"there is no plant '{plant}' (the table has no column plant "
                "or line); add one, or choose no plant",
            )
        source, base = self._crop(crop, otherwise)
        comments = tuple(self._comments())
        spoilt = {problem.line for problem in self._problems}
        every = {
            row.place.line for rows in self._rows.values() for row in rows
        }
        found = []
        for name, rows in self._rows.items():
            remark = self._sort(rows)
            # Further checks need the columns, and all values of a plant.
            if (
                base is None
                or remark is None
                or not spoilt <= every - {row.place.line for row in rows}
            ):
                continue
            made = self._overlay(name, rows, base)
            core = made and self._checked(made, rows)
            if made and core:
                found.append(
                    MeasuredCrop(name, made, core, source, remark, comments)
                )
        self._raise_problems()
        return found

    def _add(self, place: Place, what: str) -> None:
        self._problems[Problem(str(self._path), *place, what)] = None

    def _raise_problems(self) -> None:
        if self._problems:
            found = sorted(self._problems, key=lambda x: (x.line, x.column))
            raise InputError(
                "\n".join(
                    f"{each.file}:{each.line}:{each.column}: {each.what}"
                    for each in found
                ),
                found,
            )

    # Reading of lines.

    def _note(self, name: str) -> tuple[str, Place] | None:
        """Returns the value of a line "# NAME: VALUE", which spreadsheet
        programs quote and fill up with commas."""
        for number, line in enumerate(self._lines, 1):
            match = re.match(rf'[ \t"]*#[ \t]*{name}:[ \t",;]*', line)
            if match and (value := line[match.end() :].rstrip(' \t",;\r')):
                return value, Place(number, match.end() + 1)
        return None

    def _comments(self) -> Iterator[str]:
        for line in self._lines:
            text = line.strip(' \t",;\r')
            if text.startswith("#") and not re.match(
                r"#[ \t]*(crop|plant|row_direction):", text
            ):
                yield printable(text.removeprefix("#").strip())

    def _read(self, plant: str) -> None:
        self._header = Place(1, 1)
        is_headed = False
        for number, line in enumerate(self._lines, 1):
            text = line.lstrip(' \t,;"\r')
            if not text or text.startswith("#"):
                continue
            if is_headed:
                self._read_row(line, Place(number, 1), plant)
            else:
                is_headed = True
                self._header = Place(number, 1)
                self._read_header(line)
        if not self._rows:
            self._add(
                self._header,
                "there are no leaves (a table has a line with the names of "
                "its columns, then one for each leaf); add them",
            )
        elif plant and self._named_at is not None:
            names = list(self._rows)
            self._rows = {x: self._rows[x] for x in names if x == plant}
            if not self._rows:
                self._add(
                    self._header,
                    f"there is no plant '{plant}' (the table has "
                    f"{_some(names)})"
                    + (did_you_mean(plant, names) or "; correct it"),
                )

    def _read_header(self, line: str) -> None:
        if "," not in line and re.search("[;\t]", line):
            return self._add(
                self._header,
                "columns are not separated by commas (numbers have a decimal "
                "point, so that a comma ends an entry); save the table with "
                "commas",
            )
        strange: list[tuple[str, Place]] = []
        for name, column in _fields(line):
            place = Place(self._header.line, column)
            if name in COLUMNS:
                self._choose(name, place)
            elif name == _RANK:
                self._has_ranks = True
            elif name in _PLANT:
                self._choose_plants(name, place)
            else:
                # The column may be meant for any measure.
                self._has |= set(_LIMITS)
                if remedy := _remedy_for(name):
                    self._add(place, remedy)
                else:
                    strange.append((name, place))
            self._columns.append(name)
        if strange:
            verb = "is no column" if len(strange) == 1 else "are no columns"
            names = "', '".join(name for name, _ in strange)
            self._add(
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
        self._has.add(kind.measure)
        if not kind.is_from_north:
            return None
        note = self._note("row_direction")
        direction = _number(note[0]) if note else None
        if direction is not None and 0 <= direction <= 360:
            self._row_direction = direction
            return None
        return self._add(
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
        self._add(
            place,
            f"{name} is given twice ({other} too); remove one of the columns",
        )

    def _read_row(self, line: str, place: Place, plant: str) -> None:
        if not self._columns:
            return
        fields = list(_fields(line))
        if len(fields) != len(self._columns):
            self._add(
                place,
                f"there are {len(fields)} entries (the table has "
                f"{len(self._columns)} columns); give each column one",
            )
            return
        name = ""
        if self._named_at is not None:
            name, column = fields[self._named_at]
            if not name:
                self._add(
                    Place(place.line, column),
                    f"{self._columns[self._named_at]} is empty; name the "
                    "plant of the leaf",
                )
                return
        rows = self._rows.setdefault(name, [])
        if plant and name and name != plant:
            return
        row = _Row(place, len(rows) + 1)
        rows.append(row)
        for title, (text, column) in zip(self._columns, fields):
            if title in COLUMNS or title == _RANK:
                self._read_entry(title, text, row, Place(place.line, column))

    def _read_entry(
        self, title: str, text: str, row: _Row, place: Place
    ) -> None:
        number = _number(text)
        if number is None:
            return self._add(
                place,
                f'{title} is "{text}" (which is no number); write one with a '
                "decimal point, or leave the column out",
            )
        if title == _RANK:
            if number < 1 or number % 1:
                return self._add(
                    place,
                    f"leaf is {number:g} (expected: 1 for the lowest, 2 for "
                    "the next); correct it",
                )
            row.rank = int(number)
            return None
        kind = COLUMNS[title]
        value = (kind.zero + kind.sign * number) / kind.per_unit
        lower, upper = _HEIGHTS if kind.height else _LIMITS[kind.measure]
        inside = lower <= value <= upper
        if kind.measure == "azimuth":
            lower, inside = -upper, abs(number) <= upper
            if kind.is_from_north:
                value -= self._row_direction
            value = math.fmod(value + 2 * upper, upper)
        if not inside:
            return self._add(
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

    def _sort(self, rows: list[_Row]) -> str | None:
        """Sorts leaves and returns a remark on their ranks, if there is one;
        None for wrong ranks. Field books count the leaves of a plant from the
        first that it had, so that the lowest living leaf may have any rank."""
        rows.sort(key=lambda row: row.rank)
        if not self._has_ranks:
            return ""
        lowest = rows[0].rank
        for expected, row in enumerate(rows, lowest):
            if row.rank == expected:
                continue
            self._add(
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

    # Crops.

    def _crop(
        self, crop: str, otherwise: Tables | None
    ) -> tuple[str, Tables | None]:
        """Returns the name or file of the crop and its tables; reports a crop
        that cannot be read."""
        note = self._note("crop")
        if not crop and not note:
            if otherwise is None:
                self._add(
                    Place(1, 1),
                    "the table names no crop (which has stalk, organs and "
                    "traits); begin it with a line such as # crop: maize, or "
                    "# crop: FILE.toml, or use --crop",
                )
            return "", otherwise
        if crop:
            return crop, crop_tables(crop)
        assert note is not None
        try:
            return note[0], crop_tables(note[0], self._path.parent)
        except InputError:
            raise
        except Error as error:
            self._add(note[1], f"{error} (named by # crop)")
            return note[0], None

    def _overlay(
        self, plant: str, rows: list[_Row], crop: Tables
    ) -> Tables | None:
        """Returns the tables of a crop with the leaves of a plant; None if a
        measure is not known."""
        own = crop["leaf"]
        is_like = len(own) == len(rows)
        leaves: list[Tables] = [
            {**(own[i] if is_like else {}), **row.values}
            for i, row in enumerate(rows)
        ]
        if {"insertion_angle", "curvature"} & self._has:
            for leaf in leaves:
                leaf.pop("midrib", None)
        self._stack(leaves, own)
        missing = [
            measure
            for measure in list(_LIMITS)[:_NEEDED]
            if measure not in self._has
            and not ({measure, "midrib"} & leaves[0].keys())
        ]
        for measure in missing:
            reason = (
                "digitised leaves of the crop are replaced"
                if is_like
                else f"plants do not have the {len(own)} leaves of the crop"
            )
            ways = {
                kind.height: name
                for name, kind in reversed(COLUMNS.items())
                if kind.measure == measure
            }
            self._add(
                self._header,
                f"there is no column for the {measure} of leaves (needed "
                f"where {reason}); add {' or '.join([*ways.values()][::-1])}",
            )
        if missing:
            return None
        blade = crop.get("blade", {})
        are_bent = [
            row.height is None or self._bend(row, leaf, blade)
            for row, leaf in zip(rows, leaves)
        ]
        if not all(are_bent):
            return None
        made = crop | {
            "name": _name_of(plant or self._path.stem),
            "stalk": dict(crop["stalk"]),
            "leaf": leaves,
        }
        if "height" in made["stalk"]:
            rise = _highest(leaves) - _highest(own)
            made["stalk"]["height"] += rise
        if "organ" in crop:
            more = len(rows) - len(own)
            made["organ"] = [
                organ | {"leaf": max(1, organ["leaf"] + more)}
                if organ.get("leaf", 0) > 0
                else organ
                for organ in crop["organ"]
            ]
        return made

    def _stack(self, leaves: list[Tables], own: list[Tables]) -> None:
        """Makes heights and internodes agree if the table has one of them. A
        crop keeps the one that it has."""
        has_internodes = own[-1].get("internode", 0) > 0
        if "internode" in self._has:
            for leaf, height in zip(leaves, _heights(leaves)):
                leaf["insertion_height"] = height
                if not has_internodes:
                    leaf.pop("internode")
        elif has_internodes and "insertion_height" in self._has:
            below = 0.0
            for leaf in leaves:
                leaf["internode"] = max(0.0, leaf["insertion_height"] - below)
                below = leaf["insertion_height"]

    def _bend(self, row: _Row, leaf: Tables, blade: Tables) -> bool:
        """Finds by bisection the curvature at which a leaf has the measured
        height; the more a leaf bends, the lower are its tip and its highest
        point. Returns whether there is one."""
        assert row.height is not None
        point, measured = row.height
        height = _height_by_curvature(leaf, blade, point)
        lower, upper = _LIMITS["curvature"]
        lowest, highest = height(upper), height(lower)
        # Rulers are read to the nearest centimetre.
        if not lowest - 0.01 <= measured <= highest + 0.01:
            self._add(
                row.places["curvature"],
                f"the {'tip' if point == 'tip' else 'highest point'} of the "
                f"leaf is at {measured:.4g} m (a leaf of {leaf['length']:.4g} "
                f"m that leaves the stalk at {leaf['insertion_height']:.4g} m "
                f"by {leaf['insertion_angle']:.4g} deg has it at "
                f"{lowest:.4g} .. {highest:.4g} m); correct one of these",
            )
            return False
        while upper - lower > 1e-6:
            middle = (lower + upper) / 2
            if height(middle) > measured:
                lower = middle
            else:
                upper = middle
        leaf["curvature"] = (lower + upper) / 2
        return True

    def _checked(self, made: Tables, rows: list[_Row]) -> _core.Plants | None:
        """Returns the plant of a crop; reports what the program finds wrong
        with it, at the entries of the table."""
        text, leaves = _written(made)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "crop.toml"
            file.write_text(text, encoding="utf-8")
            try:
                return _core.read_plant(str(file))
            except InputError as error:
                problems = error.problems
        for problem in problems:
            place = self._header
            if problem.line in leaves:
                leaf, measure = leaves[problem.line]
                place = rows[leaf].places.get(measure, rows[leaf].place)
            self._add(place, problem.what)
        return None


def _number(text: str) -> float | None:
    """Returns a finite number with a decimal point, or None."""
    if re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", text, re.ASCII):
        number = float(text)
        return number if math.isfinite(number) else None
    return None


def _fields(line: str) -> Iterator[tuple[str, int]]:
    """Yields the entries of a line without quotes, and their columns."""
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
    """Returns the message on an unknown column that resembles a known one, or
    else an empty text."""
    if name in _UNITS:
        unit = _UNITS[name]
        return (
            f"column '{name}' has no unit; name it "
            f"{name}_{'cm' if unit == 'm' else unit}"
        )
    near = did_you_mean(name, [_RANK, *COLUMNS])
    return f"there is no column '{name}'{near}" if near else ""


def _known_columns() -> str:
    """Returns the names of all columns, units of a measure together:
    "length_cm/_m/_mm"."""
    text, last = f"{_RANK}, {' or '.join(_PLANT)}", ""
    for name in COLUMNS:
        stem, _, unit = name.rpartition("_")
        text += f"/_{unit}" if stem == last else f", {name}"
        last = stem
    return text


def _name_of(title: str) -> str:
    """Returns a name that is also the name of a file on any system."""
    name = re.sub(rb"[^A-Za-z0-9_-]", b"_", title.encode()[:64]).decode()
    return re.sub("^[_-]+", "", name) or "name"


def _heights(leaves: list[Tables]) -> list[float]:
    """Returns the heights of insertions, which may be given by internodes."""
    heights, below = [], 0.0
    for leaf in leaves:
        if leaf.get("internode", 0) > 0:
            below += leaf["internode"]
        else:
            below = leaf.get("insertion_height", 0.0)
        heights.append(below)
    return heights


def _highest(leaves: list[Tables]) -> float:
    return max([0.0, *_heights(leaves)])


def _height_by_curvature(
    leaf: Tables, blade: Tables, point: str
) -> Callable[[float], float]:
    """Returns the height of the tip or of the highest point of a leaf by its
    curvature [m]."""
    steps = 400
    angle, length = leaf["insertion_angle"], leaf["length"]
    exponent = blade.get("curvature_exponent", 1.5)
    base = (
        leaf["insertion_height"]
        + leaf.get("petiole_length", 0)
        * math.cos(math.radians(leaf.get("petiole_angle", 0)))
        + blade.get("rachis_length", 0) * math.cos(math.radians(angle))
    )
    parts = [((i + 0.5) / steps) ** exponent for i in range(steps)]

    def height(curvature: float) -> float:
        at = highest = base
        for part in parts:
            at += (
                length
                / steps
                * math.cos(math.radians(angle + curvature * part))
            )
            highest = max(highest, at)
        return at if point == "tip" else highest

    return height


def _written(tables: Tables) -> tuple[str, dict[int, tuple[int, str]]]:
    """Returns the text of a crop file, and the leaf (from 0) and the measure
    of each line that has one."""
    rest = {key: value for key, value in tables.items() if key != "leaf"}
    lines = tomli_w.dumps(rest).splitlines()
    places = {}
    for i, leaf in enumerate(tables["leaf"]):
        lines += ["", "[[leaf]]"]
        places[len(lines)] = (i, "")
        for key, value in leaf.items():
            for line in tomli_w.dumps({key: value}).splitlines():
                lines.append(line)
                places[len(lines)] = (i, key)
    return "\n".join(lines) + "\n", places
