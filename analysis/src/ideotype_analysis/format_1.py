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

_SAME = (
    *("status", "genome", "origin", "objectives"),
    *("objectives_standard_error", "attempt", "seconds", "worker", "message"),
)
_GENERATIONS = ("committed", "diversity", "failures", "evaluations", "wall_time")
_IN_UNIT_OF_OBJECTIVE = ("best", "best_standard_error", "mean", "spread")
_SESSION = ("started", "host", "command", "ranks")
_PARTS = {
    **dict.fromkeys(("beam", "sky", "scattered"), ("source", "light_source")),
    **dict.fromkeys(("adaxial", "abaxial"), ("side", "leaf_side")),
}
"""Last word of the quantity, and axis, of columns absorbed_<part>."""
_UNITS = {"hour": "h", "layer": "m"}
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
    """Columns of a table that make up one quantity."""

    units: str
    axis: str | None = None
    labels: list[Any] = field(default_factory=list)
    numbers: list[int] = field(default_factory=list)


class Format1(Datasets):
    """Presents slots as rows, and columns such as absorbed_leaf01 as
    quantities with axes. There are no randomisations and no checksums."""

    def __init__(self, path: str | Path) -> None:
        super().__init__(path)
        self._population = int(self.attributes()["population"])
        self._views: dict[str, _View] = {}
        self._quantities = self._grouped()
        self._add_genes()
        self._add_objectives()
        for group, row in (("evaluations", "row"), ("final", "finalist")):
            self._add_rows(group, row)
            self._add_quantities(group, row)
        self._add_generations()
        self._add_lists()

    def names(self, group: str) -> list[str]:
        start = f"{group}/"
        found = [n.removeprefix(start) for n in self._views if n.startswith(start)]
        return found or super().names(group)

    def axes(self, name: str) -> tuple[str, ...]:
        return self._views[name].axes if name in self._views else ()

    def units(self, name: str) -> str:
        return self._views[name].units if name in self._views else ""

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
        self, name: str, values: Sequence[Any] | NDArray, units: str = "1"
    ) -> None:
        """A scale, or a column beside one."""
        labels = np.asarray(values)
        axis = {"genes": "gene", "objectives": "objective"}.get(
            name.split("/")[0], name.rsplit("/", 1)[-1]
        )
        units = "" if labels.dtype.kind == "U" else units
        self._add(name, (axis,), units, lambda first, last: labels[first:last])

    def _stored(self, name: str) -> _Read:
        read = super().read
        return lambda first, last: read(name, first, last)

    def _add_genes(self) -> None:
        names = [
            name.replace("_inclination", "_insertion_angle")
            for name in self.texts("traits/name")
        ]
        found = [re.fullmatch(r"leaf(\d+)_(.+)", name) for name in names]
        self._genes = names
        self._add_labels("genes/gene", names)
        self._add_labels(
            "genes/trait",
            [m[2] if m else name for m, name in zip(found, names)],
        )
        self._add_labels("genes/leaf", [int(m[1]) if m else 0 for m in found])
        self._add_labels("genes/unit", self.texts("traits/unit"))
        for name in ("lower", "upper", "is_circular", "is_free"):
            self._add_labels(f"genes/{name}", super().read(f"traits/{name}"))

    def _add_objectives(self) -> None:
        self._objectives = self.texts("objectives/name")
        units = self.texts("objectives/unit")
        self._unit = units[0]
        self._add_labels("objectives/objective", self._objectives)
        self._add_labels("objectives/unit", units)
        senses = ["maximise"] * len(units)
        self._add_labels("objectives/sense", senses)

    def _add_rows(self, group: str, row: str) -> None:
        count = len(super().read(f"{group}/status"))
        self._add_labels(f"{group}/{row}", np.arange(count))
        self._add_labels(f"{group}/gene", self._genes)
        self._add_labels(f"{group}/parent", np.arange(2))
        self._add_labels(f"{group}/objective", self._objectives)
        more = {"genome": ("gene",), "parents": ("parent",)}
        for name in _SAME:
            is_objective = name.startswith("objectives")
            axes = ("objective",) if is_objective else more.get(name, ())
            units = "s" if name == "seconds" else "1"
            units = self._unit if is_objective else units
            units = "" if name in ("message", "genome") else units
            path = f"{group}/{name}"
            self._add(path, (row, *axes), units, self._stored(path))
        self._add(
            f"{group}/parents",
            (row, "parent"),
            "1",
            lambda first, last: self._parents(group, first, last),
        )
        self._add(
            f"{group}/violation",
            (row,),
            "1",
            lambda first, last: self._violation(group, first, last),
        )

    def _parents(self, group: str, first: int, last: int | None) -> NDArray:
        slots = self._stored(f"{group}/parents")(first, last).astype(int)
        origin = self._stored(f"{group}/origin")(first, last)
        size = self._population
        if group == "final":
            committed = int(self.read("generations/committed").sum())
            start = np.full(len(slots), (committed - 1) * size)
        else:
            start = (np.arange(first, first + len(slots)) // size - 1) * size
        has_none = (slots < 0) | (origin < _FIRST_WITH_PARENTS)[:, None]
        return np.where(has_none, -1, slots + start[:, None])

    def _violation(self, group: str, first: int, last: int | None) -> NDArray:
        fitness = self._stored(f"{group}/fitness")(first, last)
        known = np.where(np.isfinite(fitness), fitness, np.nan)
        return np.where(known < 0, -known, 0 * known)

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

    def _add_quantities(self, group: str, row: str) -> None:
        for name, columns in self._quantities.items():
            axes: tuple[str, ...] = (row,)
            order = np.arange(len(columns.numbers))
            if columns.axis:
                axes = (row, columns.axis)
                order = _order(columns.labels)
                labels = np.array(columns.labels)[order]
                path = f"{group}/{columns.axis}"
                units = _UNITS.get(columns.axis, "1")
                self._add_labels(path, labels, units)
            numbers = np.array(columns.numbers)[order]
            at = numbers if columns.axis else int(numbers[0])
            for end in ("", "_standard_error"):
                read = self._columns(f"{group}/diagnostics{end}", at)
                self._add(f"{group}/{name}{end}", axes, columns.units, read)
        for k, name in enumerate(self._objectives):
            for end in ("", "_standard_error"):
                read = self._columns(f"{group}/objectives{end}", k)
                self._add(f"{group}/{name}{end}", (row,), self._unit, read)
        self._add_light_and_its_leaf_area(group, row)

    def _add_light_and_its_leaf_area(self, group: str, row: str) -> None:
        """Of absorbed PAR with and without "per leaf area", 1.0 has the one
        that is the objective; the leaf area is exact."""
        light, per_area = "absorbed_par", "absorbed_par_per_leaf_area"
        known = {light, per_area}.intersection(self._objectives)
        if len(known) != 1 or "lai" not in self._quantities:
            return
        (had,) = known
        lacks = per_area if had == light else light
        for end in ("", "_standard_error"):
            value = self._views[f"{group}/{had}{end}"].read
            area = self._views[f"{group}/lai"].read

            def read(
                first: int,
                last: int | None,
                value: _Read = value,
                area: _Read = area,
            ) -> NDArray:
                lai = area(first, last)
                lai = np.where(lai > 0, lai, np.nan)
                known = value(first, last)
                return known / lai if had == light else known * lai

            self._add(f"{group}/{lacks}{end}", (row,), self._unit, read)

    def _columns(self, table: str, at: int | NDArray) -> _Read:
        # Columns of a quantity stand together: one block of the file.
        numbers = np.atleast_1d(at)
        block = slice(int(numbers.min()), int(numbers.max()) + 1)
        read = super().read
        return lambda first, last: read(table, first, last, block)[
            :, at - block.start
        ]

    def _add_generations(self) -> None:
        axes = ("generation",)

        def add(name: str, units: str, read: _Read) -> None:
            self._add(f"generations/{name}", axes, units, read)

        for name in _GENERATIONS:
            units = "s" if name == "wall_time" else "1"
            add(name, units, self._stored(f"generations/{name}"))
        for name in _IN_UNIT_OF_OBJECTIVE:
            add(name, self._unit, self._of_kept(f"generations/{name}"))
        committed = self._stored("generations/committed")
        size = self._population

        def first_row(first: int, last: int | None) -> NDArray:
            return size * np.arange(first, first + len(committed(first, last)))

        def best_row(first: int, last: int | None) -> NDArray:
            best = first_row(first, last)
            best += self._stored("generations/best_slot")(first, last)
            return np.where(committed(first, last), best, -1)

        count = len(committed(0, None))
        self._add_labels("generations/generation", np.arange(count))
        add("first_row", "1", first_row)
        add("count", "1", lambda a, b: np.full(len(committed(a, b)), size))
        add("best_row", "1", best_row)

    def _of_kept(self, name: str) -> _Read:
        """Of generations that have no row which keeps all constraints, 1.0
        has the violation there, which is no objective."""

        def read(first: int, last: int | None) -> NDArray:
            best = self._stored("generations/best")(first, last)
            values = self._stored(name)(first, last)
            return np.where(best < 0, np.nan, values)

        return read

    def _add_lists(self) -> None:
        for name in _SESSION:
            self._add(
                f"sessions/{name}",
                ("session",),
                "1" if name == "ranks" else "",
                lambda first, last, name=name: self._stored("sessions")(
                    first, last
                )[name],
            )
        self._add("messages/text", ("message",), "", self._stored("messages"))


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


def _order(labels: list[Any]) -> NDArray:
    """Of numbers; words stay as they are."""
    if isinstance(labels[0], str):
        return np.arange(len(labels))
    return np.argsort(labels, kind="stable")
