# SPDX-License-Identifier: Apache-2.0
"""Makes crops from tables of measured leaves: CSV files with one line for each
leaf, described in docs/plant.md."""

from __future__ import annotations

import math
import re
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import tomli_w

from ...common.compiled import _core
from ...errors import Error, InputError
from .leaf_rows import COLUMNS, LIMITS, LeafTable, Place, Row
from .plant_sources import crop_tables

Tables = dict[str, Any]

_NEEDED = 6
"""The number of leading measures that a crop file requires for each leaf."""


@dataclass(frozen=True)
class MeasuredCrop:
    """The crop of one plant of a table."""

    plant: str
    """The name of the plant in the table; "" if it has none."""
    tables: Tables
    """The tables of a crop file."""
    core: _core.Plants
    crop: str
    """The crop that supplies everything not measured."""
    remark: str
    """A remark on leaf ranks, or ""."""
    comments: tuple[str, ...]
    """The comments of the table."""

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
    """Returns the crops of the plants of a table, in their order. Missing
    measures are those of the same leaf of the crop, if leaf counts are equal;
    all other parts are those of the crop. The height of the stalk changes with
    the highest insertion, and organs at leaves keep their rank counted from
    the highest leaf.

    path: CSV file with one line for each leaf.
    crop: name or file of the crop, by default that of the line `# crop:`.
    plant: name of the only plant to read, by default that of the line
        `# plant:`, or all plants.
    otherwise: tables of the crop if neither names one.

    Raises InputError with all problems of the table, Error if a file cannot be
    read."""
    return _Crops(path).crops(crop, plant, otherwise)


class _Crops:
    """Replaces the leaves of a crop by the measured leaves of a table."""

    def __init__(self, path: Path) -> None:
        self._table = LeafTable(path)

    def crops(
        self, crop: str, plant: str, otherwise: Tables | None
    ) -> list[MeasuredCrop]:
        self._table.read(plant)
        source, base = self._crop(crop, otherwise)
        comments = tuple(self._table.comments())
        spoilt = {problem.line for problem in self._table.problems}
        lines = {
            row.place.line
            for rows in self._table.rows.values()
            for row in rows
        }
        measured = []
        for name, rows in self._table.rows.items():
            remark = self._table.sort(rows)
            # Further checks require all columns and values of a plant.
            if (
                base is None
                or remark is None
                or not spoilt <= lines - {row.place.line for row in rows}
            ):
                continue
            made = self._overlay(name, rows, base)
            core = made and self._checked(made, rows)
            if made and core:
                measured.append(
                    MeasuredCrop(name, made, core, source, remark, comments)
                )
        self._table.raise_problems()
        return measured

    def _crop(
        self, crop: str, otherwise: Tables | None
    ) -> tuple[str, Tables | None]:
        """Returns the name or file of the crop and its tables; records a
        problem if the crop cannot be read."""
        note = self._table.note("crop")
        if not crop and not note:
            if otherwise is None:
                self._table.add(
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
            return note[0], crop_tables(note[0], self._table.path.parent)
        except InputError:
            raise
        except Error as error:
            self._table.add(note[1], f"{error} (named by # crop)")
            return note[0], None

    def _overlay(
        self, plant: str, rows: list[Row], crop: Tables
    ) -> Tables | None:
        """Returns the tables of a crop with the leaves of a plant; None if a
        measure is unknown."""
        crop_leaves = crop["leaf"]
        is_equal = len(crop_leaves) == len(rows)
        leaves: list[Tables] = [
            {**(crop_leaves[i] if is_equal else {}), **row.values}
            for i, row in enumerate(rows)
        ]
        if {"insertion_angle", "curvature"} & self._table.has:
            for leaf in leaves:
                leaf.pop("midrib", None)
        self._stack(leaves, crop_leaves)
        missing = [
            measure
            for measure in list(LIMITS)[:_NEEDED]
            if measure not in self._table.has
            and not ({measure, "midrib"} & leaves[0].keys())
        ]
        for measure in missing:
            reason = (
                "digitised leaves of the crop are replaced"
                if is_equal
                else f"plants do not have the {len(crop_leaves)} leaves of the "
                "crop"
            )
            ways = {
                kind.height: name
                for name, kind in reversed(COLUMNS.items())
                if kind.measure == measure
            }
            self._table.add(
                self._table.header,
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
            "name": _make_name(plant or self._table.path.stem),
            "stalk": dict(crop["stalk"]),
            "leaf": leaves,
        }
        if "height" in made["stalk"]:
            # Rounding must not place the highest leaf above the stalk.
            above = made["stalk"]["height"] - _highest(crop_leaves)
            made["stalk"]["height"] = _highest(leaves) + above
        if "organ" in crop:
            more = len(rows) - len(crop_leaves)
            made["organ"] = [
                organ | {"leaf": max(1, organ["leaf"] + more)}
                if organ.get("leaf", 0) > 0
                else organ
                for organ in crop["organ"]
            ]
        return made

    def _stack(self, leaves: list[Tables], crop_leaves: list[Tables]) -> None:
        """Derives insertion heights from internodes of the table, or
        internodes of the crop from heights of the table."""
        has_internodes = crop_leaves[-1].get("internode", 0) > 0
        if "internode" in self._table.has:
            for leaf, height in zip(leaves, _heights(leaves)):
                leaf["insertion_height"] = height
                if not has_internodes:
                    leaf.pop("internode")
        elif has_internodes and "insertion_height" in self._table.has:
            below = 0.0
            for leaf in leaves:
                leaf["internode"] = max(0.0, leaf["insertion_height"] - below)
                below = leaf["insertion_height"]

    def _bend(self, row: Row, leaf: Tables, blade: Tables) -> bool:
        """Computes by bisection the curvature at which the tip or the highest
        point of a leaf has the measured height; both decrease with curvature.
        Returns whether there is a solution."""
        assert row.height is not None
        point, measured = row.height
        height = _height_by_curvature(leaf, blade, point)
        lower, upper = LIMITS["curvature"]
        lowest, highest = height(upper), height(lower)
        # Rulers are read to the nearest centimetre.
        if not lowest - 0.01 <= measured <= highest + 0.01:
            self._table.add(
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

    def _checked(self, made: Tables, rows: list[Row]) -> _core.Plants | None:
        """Returns the plant of a crop. If the program refuses the crop, its
        problems are recorded at the entries of the table."""
        text, leaves = _written(made)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "crop.toml"
            file.write_text(text, encoding="utf-8")
            try:
                return _core.read_plant(str(file))
            except InputError as error:
                problems = error.problems
        for problem in problems:
            place = self._table.header
            if problem.line in leaves:
                leaf, measure = leaves[problem.line]
                place = rows[leaf].places.get(measure, rows[leaf].place)
            self._table.add(place, problem.what)
        return None


def _make_name(title: str) -> str:
    """Returns a name that is a valid file name on any system."""
    name = re.sub(rb"[^A-Za-z0-9_-]", b"_", title.encode()[:64]).decode()
    return re.sub("^[_-]+", "", name) or "name"


def _heights(leaves: list[Tables]) -> list[float]:
    """Returns the insertion heights of leaves [m], from internodes where
    given."""
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
    """Returns a function of the curvature [deg]: the height of the tip or of
    the highest point of a leaf [m], by the midpoint rule along the midrib."""
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
    """Returns the text of a crop file, and the leaf (from 0) and measure of
    each line with a measure."""
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
