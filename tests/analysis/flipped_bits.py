# SPDX-License-Identifier: Apache-2.0
"""Makes histories with single wrong bits."""

from __future__ import annotations

import struct
from pathlib import Path

import h5py
import numpy as np
import pytest

import ideotype
from ideotype.history.file import _Unmarked, lookup3, open_file

OPEN = 5
"""The marks of a file that a process has open to write."""


def flip(content: bytes, bit: int) -> bytes:
    """Returns the content with one bit flipped."""
    damaged = bytearray(content)
    damaged[bit // 8] ^= 1 << bit % 8
    return bytes(damaged)


def marked(content: bytes, marks: int) -> bytes:
    """Returns the content with the given marks in the superblock."""
    start = content[:11] + bytes([marks]) + content[12:44]
    return start + struct.pack("<I", lookup3(start)) + content[48:]


def metadata(path: Path) -> np.ndarray:
    """Returns the bits of a history that ideotype.open() reads, except the
    data, which checksums protect."""
    is_read = np.zeros(path.stat().st_size, bool)
    readinto = _Unmarked.readinto

    def look(file: _Unmarked, buffer: memoryview) -> int:
        start = file.tell()
        count = readinto(file, buffer)
        is_read[start : start + count] = True
        return count

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(_Unmarked, "readinto", look)
        ideotype.open(path)

    def leave_out(_: str, dataset: object) -> None:
        if isinstance(dataset, h5py.Dataset) and dataset.id.get_offset():
            start = dataset.id.get_offset()
            is_read[start : start + dataset.id.get_storage_size()] = False

    with open_file(path) as file:
        file.visititems(leave_out)
    return (8 * np.flatnonzero(is_read)[:, None] + np.arange(8)).ravel()
