# SPDX-License-Identifier: Apache-2.0
"""Creates an empty history of format 2.0 exactly as in analysis/FORMAT.md."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import h5py
import numpy as np
from made_kinds import ORIGIN, STATUS, Measured

ENERGY = "MJ m-2 day-1"
AXES_UNITS = {"layer": "m", "hour": "h"}


def fixed(length: int) -> np.dtype:
    """Returns the type of a text of at most the given number of bytes."""
    return h5py.string_dtype("utf-8", length)


def texts(values: Iterable[str]) -> np.ndarray:
    """Returns texts in the encoding of the file."""
    encoded = [value.encode() for value in values]
    return np.array(encoded, fixed(max(map(len, encoded))))


@dataclass
class Layout:
    """The content of a file before SWMR writing starts, except the dataset
    `without`."""

    file: h5py.File
    rows: int
    finalists: int
    generations: int
    genes: Mapping[str, Sequence]
    """The datasets of /genes."""
    objectives: Sequence[tuple[str, str, str]]
    """Name, unit and sense of each objective."""
    labels: Mapping[str, Sequence]
    """The labels of the axes of quantities."""
    quantities: Mapping[str, Measured]
    randomisations: tuple[int, int] = (0, 0)
    """The numbers of randomisations in /evaluations and /final; 0: none are
    kept."""
    without: str | None = None

    def create(
        self, attributes: Mapping[str, object], campaign: Mapping[str, str]
    ) -> None:
        """Creates all datasets; only the header contains data."""
        for name, value in attributes.items():
            self._attribute(name, value)
        for form, text in campaign.items():
            size = max(len(text.encode()), 256)
            self._add(f"campaign/{form}", text.encode(), (), "", fixed(size))
        self._table("genes", "gene", self.genes)
        names, units, senses = zip(*self.objectives)
        columns = {"objective": names, "unit": units, "sense": senses}
        self._table("objectives", "objective", columns)
        counts = (self.rows, self.finalists)
        places = zip(("evaluations", "final"), counts, self.randomisations)
        for group, count, draws in places:
            self._rows(group, count, draws)
        self._generations()
        self._state()
        self._attribute("checksum", header_checksum(self.file))

    def _attribute(self, name: str, value: object) -> None:
        if isinstance(value, str):
            text = value.encode()
            self.file.attrs.create(name, text, dtype=fixed(len(text) + 1))
        else:
            self.file.attrs[name] = value

    def _add(
        self,
        path: str,
        values: object,
        axes: tuple[str, ...],
        units: str = "",
        dtype: object = None,
    ) -> None:
        if path == self.without:
            return
        made = self.file.create_dataset(path, data=values, dtype=dtype)
        for i, axis in enumerate(axes):
            made.dims[i].attach_scale(self.file[axis])
        self._label(made, units)

    def _label(self, dataset: h5py.Dataset, units: str) -> None:
        name = dataset.name.rsplit("/", 1)[-1].replace("_", " ")
        for key, text in (("units", units), ("long_name", name)):
            dataset.attrs.create(key, text.encode(), dtype=fixed(64))

    def _scale(self, path: str, labels: Sequence, units: str = "1") -> None:
        if isinstance(labels[0], str):
            labels, units = texts(labels), ""
        scale = self.file.create_dataset(path, data=labels)
        scale.make_scale(path.rsplit("/", 1)[-1])
        self._label(scale, units)

    def _table(
        self, group: str, axis: str, columns: Mapping[str, Sequence]
    ) -> None:
        for name, values in columns.items():
            if name == axis:
                self._scale(f"{group}/{axis}", list(values))
            else:
                at, units, column = (f"{group}/{axis}",), "1", list(values)
                if isinstance(values[0], str):
                    units, column = "", texts(values)
                self._add(f"{group}/{name}", column, at, units)

    def _rows(self, group: str, n: int, draws: int) -> None:
        row = f"{group}/{'row' if group == 'evaluations' else 'finalist'}"
        at = {axis: f"{group}/{axis}" for axis in self.labels}
        self._scale(row, np.arange(n))
        self._scale(f"{group}/gene", list(self.genes["gene"]))
        self._scale(f"{group}/parent", np.arange(2, dtype="i4"))
        names = [name for name, _, _ in self.objectives]
        self._scale(f"{group}/objective", names)
        for axis, labels in self.labels.items():
            self._scale(at[axis], list(labels), AXES_UNITS.get(axis, "1"))

        def add(
            name: str, fill: object, dtype: object, units: str, *axes: str
        ) -> None:
            shape = (n, *(len(self.file[axis]) for axis in axes))
            values = np.full(shape, fill, dtype)
            self._add(f"{group}/{name}", values, (row, *axes), units, dtype)

        add("status", 0, h5py.enum_dtype(STATUS, "u1"), "1")
        add("genome", np.nan, "f8", "", f"{group}/gene")
        add("origin", 0, h5py.enum_dtype(ORIGIN, "u1"), "1")
        add("parents", -1, "i8", "1", f"{group}/parent")
        objective = f"{group}/objective"
        for end in ("", "_standard_error"):
            add(f"objectives{end}", np.nan, "f8", ENERGY, objective)
        draw = f"{group}/randomisation"
        self._scale(draw, np.arange(draws, dtype="i4"))
        name = "objectives_by_randomisation"
        add(name, np.nan, "f8", ENERGY, objective, draw)
        add("violation", np.nan, "f8", "1")
        for name, kind in self.quantities.items():
            axes = (at[kind.axis],) if kind.axis else ()
            for end in ("",) if kind.is_exact else ("", "_standard_error"):
                add(name + end, np.nan, "f8", kind.units, *axes)
        add("attempt", 0, "u4", "1")
        add("seconds", np.nan, "f8", "s")
        add("worker", -1, "i4", "1")
        add("message", b"", fixed(160), "")
        if group == "final":
            add("checksum", b"", fixed(64), "")

    def _generations(self) -> None:
        n, at = self.generations, "generations/generation"
        several = len(self.objectives) > 1
        self._scale(at, np.arange(n, dtype="i4"))
        for name, fill, dtype, units in (
            ("committed", False, bool, "1"),
            ("first_row", 0, "i8", "1"),
            ("count", 0, "u4", "1"),
            ("best_row", -1, "i8", "1"),
            *(
                (name, np.nan, "f8", ENERGY)
                for name in ("best", "best_standard_error", "mean", "spread")
            ),
            ("diversity", np.nan, "f8", "1"),
            ("failures", 0, "u4", "1"),
            ("evaluations", 0, "u4", "1"),
            ("wall_time", np.nan, "f8", "s"),
            *(
                (f"hypervolume{end}", np.nan, "f8", "1")
                for end in ("", "_standard_error") * several
            ),
            ("checksum", b"", fixed(64), ""),
        ):
            values = np.full(n, fill, dtype)
            self._add(f"generations/{name}", values, (at,), units, dtype)

    def _state(self) -> None:
        self._add("state/finished", False, (), "1", bool)
        self._add("state/reason", np.bytes_(b""), (), "", fixed(64))
        self._add("state/wall_time", 0.0, (), "s")
        self._scale("sessions/session", np.arange(3, dtype="i4"))
        for name, size in (
            ("started", 32),
            ("host", 64),
            ("command", 512),
            *((name, 128) for name in ("program", "compiler", "libraries")),
        ):
            empty, at = np.zeros(3, fixed(size)), ("sessions/session",)
            self._add(f"sessions/{name}", empty, at, "", fixed(size))
        self._add("sessions/ranks", np.zeros(3, "i4"), at, "1", "i4")
        self._scale("messages/message", np.arange(3, dtype="i4"))
        at, size = ("messages/message",), fixed(240)
        self._add("messages/text", np.zeros(3, size), at, "", size)


def _hash(parts: Iterable[tuple[str, bytes]]) -> str:
    digest = hashlib.sha256()
    for name, content in parts:
        digest.update(name.encode() + b"\0" + content)
    return digest.hexdigest()


def _attribute_bytes(file: h5py.File, name: str) -> bytes:
    attribute = h5py.h5a.open(file.id, name.encode())
    value = np.empty(attribute.shape, attribute.dtype)
    attribute.read(value)
    return value.tobytes()


def header_checksum(file: h5py.File) -> str:
    """Returns the checksum of the header as FORMAT.md defines it."""
    names = sorted({*file.attrs} - {"checksum"})
    parts = [(name, _attribute_bytes(file, name)) for name in names]
    tables = ("campaign", "genes", "objectives")
    paths = [file[g][n].name for g in tables for n in file[g]]
    for group in ("evaluations", "final"):
        each = file[group].values()
        paths += [dataset.name for dataset in each if dataset.is_scale]
    parts += [(path, file[path][...].tobytes()) for path in sorted(paths)]
    return _hash(parts)


def generation_checksum(file: h5py.File, generation: int) -> str:
    """Returns the checksum of a generation as FORMAT.md defines it."""
    table = file["generations"]
    first = int(table["first_row"][generation])
    last = first + int(table["count"][generation])
    parts = [
        (name, dataset[first:last].tobytes())
        for name, dataset in sorted(file["evaluations"].items())
        if not dataset.is_scale
    ]
    parts += [
        (name, dataset[generation : generation + 1].tobytes())
        for name, dataset in sorted(table.items())
        if name not in ("generation", "committed", "checksum")
    ]
    return _hash(parts)


def finalist_checksum(file: h5py.File, finalist: int, status: int) -> str:
    """Returns the checksum of a finalist as FORMAT.md defines it, for the
    status that the row will get."""
    rows = sorted(file["final"].items())
    return _hash(
        (name, bytes([status]))
        if name == "status"
        else (name, dataset[finalist : finalist + 1].tobytes())
        for name, dataset in rows
        if not dataset.is_scale and name != "checksum"
    )


def seal(file: h5py.File) -> None:
    """Recomputes all checksums after a test has modified a finished file."""
    del file.attrs["checksum"]
    text = header_checksum(file).encode()
    file.attrs.create("checksum", text, dtype=fixed(len(text) + 1))
    committed = np.flatnonzero(file["generations/committed"][:])
    for generation in committed:
        text = generation_checksum(file, generation).encode()
        file["generations/checksum"][generation] = text
    for slot, status in enumerate(file["final/status"][:]):
        if status >= STATUS["done"]:
            text = finalist_checksum(file, slot, status).encode()
            file["final/checksum"][slot] = text
