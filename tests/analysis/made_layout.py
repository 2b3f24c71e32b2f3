"""Lays out an empty history to the letter of analysis/FORMAT.md."""

from __future__ import annotations

import h5py
import numpy as np
from made_numbers import (
    DIAGNOSTICS,
    FINALISTS,
    GENERATIONS,
    ORIGIN,
    POPULATION,
    STATUS,
    TRAITS,
)


def _fixed(length: int) -> np.dtype:
    return h5py.string_dtype("utf-8", length)


class Layout:
    """Creates what a file has before SWMR writing starts, but the dataset
    `without`."""

    def __init__(
        self,
        file: h5py.File,
        without: str | None,
        extra: list[tuple[str, str]],
    ) -> None:
        self.file = file
        self._diagnostics = [*DIAGNOSTICS, *extra]
        self._without = without

    def create(self, kind: str, version: str, place: dict[str, str | float]) -> None:
        """All of it."""
        self.attributes(kind, version, place)
        self.columns()
        for group, rows in (
            ("evaluations", GENERATIONS * POPULATION),
            ("final", FINALISTS),
        ):
            self.rows(self.file.create_group(group), rows)
        self.generations()
        self.state()

    def attributes(
        self, kind: str, version: str, place: dict[str, str | float]
    ) -> None:
        texts = {
            "format": kind,
            "format_version": version,
            "program": "ideotype",
            "program_version": "0.1.0",
            "git_sha": "0123456789abcdef",
            "git_dirty": "no",
            "isa": "avx2",
            "campaign": "made",
            "case": "ames-aug-30x6-all-r1",
            "site": "ames",
            "day": "2025-08-07",
            "spacing": "30x6",
            "trait_set": "all",
        }
        texts |= {k: v for k, v in place.items() if isinstance(v, str)}
        for name, value in texts.items():
            self.file.attrs.create(
                name, value.encode(), dtype=_fixed(len(value.encode()) + 1)
            )
        self.file.attrs["seed"] = np.uint64(2**63 + 1)
        sizes = (POPULATION, GENERATIONS, FINALISTS)
        for name, size in zip(("population", "generations", "finalists"), sizes):
            self.file.attrs[name] = np.int32(size)
        places = {"latitude": 42.0, "longitude": -93.6}
        places |= {"row_spacing": 0.762, "plant_spacing": 0.1524}
        places |= {k: v for k, v in place.items() if isinstance(v, float)}
        for name, value in places.items():
            self.file.attrs[name] = value

    def _make(
        self, name: str, shape: tuple, dtype: object, fill: object, unit: str
    ) -> None:
        if name == self._without:
            return
        keywords = {} if fill is None else {"fillvalue": fill}
        if shape:
            keywords["chunks"] = (min(POPULATION, shape[0]), *shape[1:])
        dataset = self.file.create_dataset(name, shape, dtype, **keywords)
        dataset.attrs.create("unit", unit.encode(), dtype=_fixed(32))

    def _write(self, name: str, values: object) -> None:
        if name in self.file:
            self.file[name][...] = values

    def columns(self) -> None:
        gene_count = (len(TRAITS),)
        for name in ("name", "unit"):
            self._make(f"traits/{name}", gene_count, _fixed(32), None, "")
        for name in ("lower", "upper"):
            self._make(f"traits/{name}", gene_count, "f8", np.nan, "/traits/unit")
        for name in ("is_circular", "is_free"):
            self._make(f"traits/{name}", gene_count, bool, False, "1")
        columns = zip(*TRAITS)
        for name in ("name", "unit", "lower", "upper", "is_circular"):
            column = next(columns)
            texts = [c.encode() for c in column if isinstance(c, str)]
            self._write(f"traits/{name}", texts or column)
        self._write("traits/is_free", True)
        for group, entries in (
            ("objectives", [("absorbed_par", "MJ m-2 day-1")]),
            ("diagnostics", self._diagnostics),
        ):
            for i, name in enumerate(("name", "unit")):
                self._make(f"{group}/{name}", (len(entries),), _fixed(64), None, "")
                self._write(f"{group}/{name}", [e[i].encode() for e in entries])
        for form in ("source", "resolved"):
            self._make(f"campaign/{form}", (), _fixed(64), None, "")
            self._write(f"campaign/{form}", f'name = "made" # {form}'.encode())

    def rows(self, group: h5py.Group, n: int) -> None:
        at = group.name
        status = h5py.enum_dtype(STATUS, basetype="u1")
        origin = h5py.enum_dtype(ORIGIN, basetype="u1")
        self._make(f"{at}/status", (n,), status, 0, "1")
        self._make(f"{at}/origin", (n,), origin, 0, "1")
        self._make(f"{at}/parents", (n, 2), "i4", -1, "1")
        genes = (n, len(TRAITS))
        self._make(f"{at}/genome", genes, "f8", np.nan, "/traits/unit")
        for name, count in (
            ("objectives", 1),
            ("diagnostics", len(self._diagnostics)),
        ):
            for end in ("", "_standard_error"):
                unit = f"/{name}/unit"
                self._make(f"{at}/{name}{end}", (n, count), "f8", np.nan, unit)
        self._make(f"{at}/fitness", (n,), "f8", np.nan, "MJ m-2 day-1")
        self._make(f"{at}/attempt", (n,), "u4", 0, "1")
        self._make(f"{at}/seconds", (n,), "f8", np.nan, "s")
        self._make(f"{at}/worker", (n,), "i4", -1, "1")
        self._make(f"{at}/message", (n,), _fixed(160), None, "")
        self.file["traits/name"].make_scale()
        if f"{at}/genome" in self.file:
            group["genome"].dims[1].attach_scale(self.file["traits/name"])

    def generations(self) -> None:
        n = (GENERATIONS,)
        self._make("generations/committed", n, bool, False, "1")
        for name in ("best_slot", "failures", "evaluations"):
            self._make(f"generations/{name}", n, "u4", 0, "1")
        for name in ("best", "best_standard_error", "mean", "spread"):
            self._make(f"generations/{name}", n, "f8", np.nan, "MJ m-2 day-1")
        self._make("generations/diversity", n, "f8", np.nan, "1")
        self._make("generations/wall_time", n, "f8", np.nan, "s")

    def state(self) -> None:
        self._make("state/finished", (), bool, False, "1")
        self._make("state/reason", (), _fixed(64), None, "")
        self._make("state/wall_time", (), "f8", 0.0, "s")
        session = np.dtype(
            [("started", _fixed(32)), ("host", _fixed(64))]
            + [("command", _fixed(512)), ("ranks", "i4")]
        )
        self._make("sessions", (3,), session, None, "")
        entry = (b"2025-08-07T12:00:00Z", b"node1", b"ideotype run", 3)
        unused = (b"", b"", b"", 0)
        entries = np.array([entry, unused, unused], session)
        self._write("sessions", entries)
        self._make("messages", (3,), _fixed(240), None, "")
        self._write("messages", ["Zeit f\u00fcr Licht".encode(), b"", b""])
