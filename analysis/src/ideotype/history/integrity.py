# SPDX-License-Identifier: Apache-2.0
"""Verifies the checksums of a history; FORMAT.md specifies them."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from .datasets import Datasets
from .file import HistoryError
from .rows import Status

_HEADER = ("campaign", "genes", "objectives")
_TABLES = ("evaluations", "final", "sensitivity")
"""The groups with scales that are part of the header."""
_NOT_HASHED = ("generation", "committed", "checksum")


def verify(data: Datasets) -> None:
    """Verifies the header, the committed generations and the recorded
    finalists.

    Raises HistoryError with the file and the first part that differs."""
    _check(
        data, "the header", _header(data), data.attributes().get("checksum")
    )
    # The completion marks are read before the data that they describe.
    committed = data.read("generations/committed").astype(bool)
    status = data.read("final/status")
    table = _columns(data, "generations", _NOT_HASHED)
    rows = _columns(data, "evaluations", ())
    sums = data.texts("generations/checksum")
    count = len(committed) if committed.all() else int(committed.argmin())
    for g in range(count):
        first = int(table["first_row"][g])
        last = first + int(table["count"][g])
        digest = _digest(
            *((name, values[first:last]) for name, values in rows.items()),
            *((name, values[g : g + 1]) for name, values in table.items()),
        )
        _check(data, f"generation {g}", digest, sums[g])
    recorded = (status == Status.DONE) | (status == Status.FAILED)
    finalists = _columns(data, "final", ("checksum",))
    final_sums = data.texts("final/checksum")
    for i in np.flatnonzero(recorded):
        digest = _digest(
            *((name, values[i : i + 1]) for name, values in finalists.items())
        )
        _check(data, f"finalist {i}", digest, final_sums[i])
    if not data.read("state/finished"):
        return
    # A finished case has no checksums of rows that are not recorded.
    if count < len(sums):
        _check(data, f"the mark of generation {count}", "", sums[count])
    for i in np.flatnonzero(~recorded):
        _check(data, f"finalist {i}", "", final_sums[i])


def _check(data: Datasets, part: str, computed: str, stored: object) -> None:
    if computed != stored:
        raise HistoryError(
            f"{data.path}: damaged: {part} does not have its checksum; copy "
            "the file again or resume from a backup"
        )


def _header(data: Datasets) -> str:
    names = sorted({*data.attributes()} - {"checksum"})
    paths = [f"/{group}/{n}" for group in _HEADER for n in data.names(group)]
    known = {*data.names("/")}
    for group in (name for name in _TABLES if name in known):
        paths += [
            f"/{group}/{name}"
            for name in data.names(group)
            if data.axes(f"{group}/{name}") == (name,)
        ]
    return _digest(
        *((name, data.attribute_bytes(name)) for name in names),
        *((path, data.read(path)) for path in sorted(paths)),
    )


def _columns(
    data: Datasets, group: str, without: Iterable[str]
) -> dict[str, NDArray]:
    """Returns the datasets of a group except scales, by name."""
    return {
        name: data.read(f"{group}/{name}")
        for name in sorted({*data.names(group)} - {*without})
        if data.axes(f"{group}/{name}") != (name,)
    }


def _digest(*parts: tuple[str, NDArray | bytes]) -> str:
    digest = hashlib.sha256()
    for name, content in parts:
        digest.update(name.encode() + b"\0")
        digest.update(
            content if isinstance(content, bytes) else content.tobytes()
        )
    return digest.hexdigest()
