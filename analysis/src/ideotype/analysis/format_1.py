# SPDX-License-Identifier: Apache-2.0
"""A file of format 1.0 as if it were one of 2.0. Only here are columns found
by their names."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .datasets import Datasets
from .file import HistoryError

_ERROR = "_standard_error"
_SAME = {
    **dict.fromkeys(("status", "origin", "attempt", "worker"), "1"),
    "genome": "",
    "message": "",
    "seconds": "s",
}
"""Datasets of rows that are as in 2.0, with their units."""
_LIGHT, _PER_AREA = "absorbed_par", "absorbed_par_per_leaf_area"
_PARTS = {
    **dict.fromkeys(("beam", "sky", "scattered"), ("source", "light_source")),
    **dict.fromkeys(("adaxial", "abaxial"), ("side", "leaf_side")),
}
"""Last word of the quantity, and axis, of columns absorbed_<part>."""
_AXIS_UNITS = {"hour": "h", "layer": "m"}
_FIRST_WITH_PARENTS = 3
"""Origin elite; 1.0 has 0 for the parents of baseline and random plants."""

_Read = Callable[[int, int | None], NDArray]


@dataclass(frozen=True)
class _View:
    """A dataset that the file does not have."""

    axes: tuple[str, ...]
    units: str
    read: _Read


@dataclass
class _Columns:
    """Columns of /diagnostics that make up one quantity."""

    units: str
    axis: str | None
    labels: list[Any] = field(default_factory=list)
    numbers: list[int] = field(default_factory=list)


class Format1(Datasets):
    """Presents slots as rows, and columns such as absorbed_leaf01 as
    quantities with axes. There are no randomisations and no checksums."""

    def __init__(self, path: str | Path) -> None:
        super().__init__(path)
        self._views: dict[str, _View] = {}
        self._size = int(self.attributes()["population"])
        self._objectives = self.texts("objectives/name")
        self._unit = self.texts("objectives/unit")[0]
        self._add_tables()
        columns = self._grouped()
        for group, row in (("evaluations", "row"), ("final", "finalist")):
            self._add_rows(group, row)
            self._add_quantities(group, row, columns)
        self._add_generations()
        for name in ("started", "host", "command", "ranks"):
            units = "1" if name == "ranks" else ""
            read = self._stored("sessions", name)
            self._add(f"sessions/{name}", ("session",), units, read)
        read = self._stored("messages")
        self._add("messages/text", ("message",), "", read)

    def names(self, group: str) -> list[str]:
        start = f"{group}/"
        found = [
            n.removeprefix(start) for n in self._views if n.startswith(start)
        ]
        return found or super().names(group)

    def axes(self, name: str) -> tuple[str, ...]:
        return self._views[name].axes if name in self._views else ()

    def about(self, name: str) -> dict[str, str]:
        return {
            "units": self._views[name].units if name in self._views else ""
        }

    def meaning(self, name: str) -> str:
        return ""

    def read(
        self,
        name: str,
        first: int = 0,
        last: int | None = None,
        columns: slice = slice(None),
    ) -> NDArray:
        if name in self._views:
            return self._views[name].read(first, last)
        return super().read(name, first, last, columns)

    def _add(
        self, name: str, axes: tuple[str, ...], units: str, read: _Read
    ) -> None:
        self._views[name] = _View(axes, units, read)

    def _add_labels(
        self, name: str, values: Sequence[Any] | NDArray, axis: str = "",
        units: str = "1",
    ) -> None:  # fmt: skip
        """A scale, or with `axis` a column beside that one."""
        labels = np.asarray(values)
        axis = axis or name.rsplit("/", 1)[-1]
        units = "" if labels.dtype.kind == "U" else units
        self._add(name, (axis,), units, lambda first, last: labels[first:last])

    def _stored(self, name: str, part: str | None = None) -> _Read:
        """A dataset of the file, or a part of a compound one."""
        read = super().read
        if part is None:
            return lambda first, last: read(name, first, last)
        return lambda first, last: read(name, first, last)[part]

    def _add_tables(self) -> None:
        names = [
            name.replace("_inclination", "_insertion_angle")
            for name in self.texts("traits/name")
        ]
        found = [re.fullmatch(r"leaf(\d+)_(.+)", name) for name in names]
        traits = [m[2] if m else name for m, name in zip(found, names)]
        leaves = [int(m[1]) if m else 0 for m in found]
        self._genes = names
        self._add_labels("genes/gene", names)
        self._add_labels("genes/trait", traits, "gene")
        self._add_labels("genes/leaf", leaves, "gene")
        self._add_labels("genes/unit", self.texts("traits/unit"), "gene")
        for name in ("lower", "upper", "is_circular", "is_free"):
            self._add_labels(
                f"genes/{name}", self.read(f"traits/{name}"), "gene"
            )
        self._add_labels("objectives/objective", self._objectives)
        units = self.texts("objectives/unit")
        self._add_labels("objectives/unit", units, "objective")
        senses = ["maximise"] * len(units)
        self._add_labels("objectives/sense", senses, "objective")

    def _add_rows(self, group: str, row: str) -> None:
        rows = np.arange(len(self.read(f"{group}/status")))
        self._add_labels(f"{group}/{row}", rows)
        self._add_labels(f"{group}/gene", self._genes)
        self._add_labels(f"{group}/parent", np.arange(2))
        self._add_labels(f"{group}/objective", self._objectives)
        for name, units in _SAME.items():
            axes = (row, "gene") if name == "genome" else (row,)
            path = f"{group}/{name}"
            self._add(path, axes, units, self._stored(path))
        for end in ("", _ERROR):
            path = f"{group}/objectives{end}"
            read = self._stored(path)
            self._add(path, (row, "objective"), self._unit, read)
        parents = self._parents(group)
        self._add(f"{group}/parents", (row, "parent"), "1", parents)
        self._add(f"{group}/violation", (row,), "1", self._violation(group))

    def _parents(self, group: str) -> _Read:
        slots_of = self._stored(f"{group}/parents")
        origin_of = self._stored(f"{group}/origin")

        def read(first: int, last: int | None) -> NDArray:
            slots = slots_of(first, last).astype(int)
            generation = np.arange(first, first + len(slots)) // self._size
            if group == "final":
                generation[:] = self.read("generations/committed").sum()
            has_none = origin_of(first, last) < _FIRST_WITH_PARENTS
            start = self._size * (generation - 1)[:, None]
            is_none = (slots < 0) | has_none[:, None]
            return np.where(is_none, -1, slots + start)

        return read

    def _violation(self, group: str) -> _Read:
        fitness_of = self._stored(f"{group}/fitness")

        def read(first: int, last: int | None) -> NDArray:
            fitness = fitness_of(first, last)
            fitness[~np.isfinite(fitness)] = np.nan
            return np.maximum(0.0, -fitness)

        return read

    def _grouped(self) -> dict[str, _Columns]:
        """The diagnostics by the quantities that they are part of."""
        found: dict[str, _Columns] = {}
        units = self.texts("diagnostics/unit")
        for i, column in enumerate(self.texts("diagnostics/name")):
            if column == "violation":
                continue
            name, axis, label = _place(column)
            columns = found.setdefault(name, _Columns(units[i], axis))
            columns.labels.append(label)
            columns.numbers.append(i)
        return found

    def _add_quantities(
        self, group: str, row: str, found: dict[str, _Columns]
    ) -> None:
        for name, columns in found.items():
            numbers = np.array(columns.numbers)
            at: NDArray | int = int(numbers[0])
            axes: tuple[str, ...] = (row,)
            if axis := columns.axis:
                axes = (row, axis)
                labels = np.array(columns.labels)
                order = np.arange(len(labels))
                if labels.dtype.kind != "U":
                    order = np.argsort(labels, kind="stable")
                at = numbers[order]
                units = _AXIS_UNITS.get(axis, "1")
                self._add_labels(f"{group}/{axis}", labels[order], units=units)
            for end in ("", _ERROR):
                read = self._columns(f"{group}/diagnostics{end}", at)
                self._add(f"{group}/{name}{end}", axes, columns.units, read)
        for k, name in enumerate(self._objectives):
            for end in ("", _ERROR):
                read = self._columns(f"{group}/objectives{end}", k)
                self._add(f"{group}/{name}{end}", (row,), self._unit, read)
        # Of both, 1.0 has the one that is the objective.
        had = {_LIGHT, _PER_AREA}.intersection(self._objectives)
        if len(had) == 1 and "lai" in found:
            for end in ("", _ERROR):
                self._add_other(group, row, had == {_LIGHT}, end)

    def _add_other(
        self, group: str, row: str, has_light: bool, end: str
    ) -> None:
        """Light per leaf area of light, or the other way round. The leaf area
        is exact."""
        known, other = (
            (_LIGHT, _PER_AREA) if has_light else (_PER_AREA, _LIGHT)
        )
        value_of = self._views[f"{group}/{known}{end}"].read
        area_of = self._views[f"{group}/lai"].read

        def read(first: int, last: int | None) -> NDArray:
            value, lai = value_of(first, last), area_of(first, last)
            lai[lai <= 0] = np.nan
            return value / lai if has_light else value * lai

        self._add(f"{group}/{other}{end}", (row,), self._unit, read)

    def _columns(self, table: str, at: int | NDArray) -> _Read:
        # Columns of a quantity stand together: one block of the file.
        numbers = np.atleast_1d(at)
        block = slice(int(numbers.min()), int(numbers.max()) + 1)
        read = super().read
        return lambda first, last: read(table, first, last, block)[
            :, at - block.start
        ]

    def _add_generations(self) -> None:
        def add(name: str, units: str, read: _Read) -> None:
            self._add(f"generations/{name}", ("generation",), units, read)

        committed_of = self._stored("generations/committed")
        best_of = self._stored("generations/best")
        slot_of = self._stored("generations/best_slot")
        first_rows = self._size * np.arange(len(committed_of(0, None)))

        def best_row(first: int, last: int | None) -> NDArray:
            rows = first_rows[first:last] + slot_of(first, last)
            return np.where(committed_of(first, last), rows, -1)

        def of_objective(name: str) -> _Read:
            """Where no row keeps all constraints, 1.0 has the violation
            there, which is no objective."""
            stored = self._stored(f"generations/{name}")
            return lambda first, last: np.where(
                best_of(first, last) < 0, np.nan, stored(first, last)
            )

        for name in ("committed", "diversity", "failures", "evaluations"):
            add(name, "1", self._stored(f"generations/{name}"))
        add("wall_time", "s", self._stored("generations/wall_time"))
        for name in ("best", f"best{_ERROR}", "mean", "spread"):
            add(name, self._unit, of_objective(name))
        counts = np.full(len(first_rows), self._size)
        self._add_labels("generations/generation", np.arange(len(counts)))
        self._add_labels("generations/first_row", first_rows, "generation")
        self._add_labels("generations/count", counts, "generation")
        add("best_row", "1", best_row)


def _place(column: str) -> tuple[str, str | None, Any]:
    """Quantity, axis and label of a column."""
    if m := re.fullmatch(r"(.+)_leaf(\d+)", column):
        return f"{m[1]}_by_leaf", "leaf", int(m[2])
    if m := re.fullmatch(r"(.+)_hour_(\d\d)_(\d\d)", column):
        return f"{m[1]}_by_hour", "hour", int(m[2]) + int(m[3]) / 60
    if m := re.fullmatch(r"(.+)_layer_(\d+)_(\d+)cm", column):
        return f"{m[1]}_by_layer", "layer", (int(m[2]) + int(m[3])) / 200
    word = column.removeprefix("absorbed_")
    if word in _PARTS and word != column:
        name, axis = _PARTS[word]
        return f"absorbed_by_{name}", axis, word
    return column, None, None


def open_datasets(path: str | Path) -> Datasets:
    """A file of any format that can be read, as one of 2.0.

    Raises as file.open_file()."""
    data = Datasets(path)
    if not str(data.attributes()["format_version"]).startswith("1."):
        return data
    data.close()
    try:
        return Format1(path)
    except KeyError as error:
        raise HistoryError(f"{path}: has no {error}") from error
