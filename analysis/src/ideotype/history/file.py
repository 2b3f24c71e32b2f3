# SPDX-License-Identifier: Apache-2.0
"""Opens the HDF5 file of a history in any state in which its writer may leave
it."""

from __future__ import annotations

import io
import os
import struct
import time
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import Any

import h5py

from ..errors import Error

FORMAT = "ideotype-history"
MAJOR_VERSION = 2

_SIGNATURE = b"\x89HDF\r\n\x1a\n"
_SUPERBLOCK_SIZE = 48
_CHECKED = 44
"""The length of a superblock before its checksum [bytes]."""
_LOOKS = 10
_OPEN_FOR_WRITING = 0x01


class HistoryError(Error):
    """A history can't be used; the message is for the user."""


class NotAHistory(HistoryError):
    """The file is not a history, or is damaged."""


class UnsupportedVersion(HistoryError):
    """The file has another major format version."""


class Writer(Enum):
    """The state of the process that writes a history."""

    WRITING = "being written"
    CLOSED = "closed"
    GONE = "not closed"
    """The writer was killed, or is alive on a machine whose locks are not
    visible."""


class _Unmarked(io.FileIO):
    """A file without the marks that a writer sets while it has the file open,
    and leaves if it is killed. HDF5 therefore reads it as a closed file.

    HDF5 opens marked files only in SWMR mode. In this mode it attributes a
    wrong checksum to a write in progress and retries a hundred times with
    doubling pauses, which takes days and cannot be interrupted. The metadata
    of a history never change (FORMAT.md), so that a wrong checksum of metadata
    means damage."""

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self._start = _superblock(path).unmarked()

    def __del__(self) -> None:
        self.close()

    def readinto(self, buffer: Any) -> int:
        """Fills the buffer from the file and returns the number of bytes."""
        at, view = self.tell(), memoryview(buffer).cast("B")
        done = 0
        while done < len(view):
            count = super().readinto(view[done:])
            if not count:
                raise OSError("the file ends too early")
            done += count
        patched = self._start[at : at + done]
        view[: len(patched)] = patched
        return done


def open_file(path: str | Path) -> h5py.File:
    """Opens a history for reading and leaves the file unchanged. The file may
    be closed, being written, or left by a killed writer.

    Raises FileNotFoundError, PermissionError or HistoryError."""
    path = Path(path)
    if not path.exists():
        raise FileNotFoundError(f"{path}: there is no such file")
    if not path.is_file():
        raise NotAHistory(f"{path}: this is not a file; name a history (.h5)")
    _check_length(path)
    try:
        file = h5py.File(_Unmarked(path), "r")
    except (OSError, RuntimeError, ValueError) as error:
        raise HistoryError(f"{path}: HDF5 can't open it ({error})") from error
    try:
        _check_format(file, path)
    except BaseException:
        file.close()
        raise
    return file


def text(value: object) -> str:
    """Returns a string of HDF5 as a Python string."""
    if isinstance(value, bytes):
        return value.rstrip(b"\0").decode("utf-8", errors="replace")
    return str(value)


def find_writer(path: str | Path) -> Writer:
    """Returns the state of the process that writes the file, as visible from
    this machine."""
    if not _superblock(Path(path)).is_marked:
        return Writer.CLOSED
    return Writer.WRITING if _is_locked(Path(path)) else Writer.GONE


@dataclass(frozen=True)
class _Superblock:
    """The start of a file (HDF5 file format specification, II.A)."""

    data: bytes

    @property
    def has_marks(self) -> bool:
        """Whether the superblock can have marks: only version 3 has, and the
        program writes addresses of 8 bytes only."""
        return self.data[8] == 3 and self.data[9] == 8

    @property
    def is_whole(self) -> bool:
        """Whether the checksum of the superblock is right."""
        return self._checksum(self.data) == self.data[_CHECKED:]

    @property
    def is_marked(self) -> bool:
        """Whether a writer has the file open, or was killed."""
        return self.has_marks and bool(self.data[11] & _OPEN_FOR_WRITING)

    @property
    def length(self) -> int:
        """The length of the file [bytes] in the superblock; 0 if unknown."""
        if not self.has_marks:
            return 0
        return struct.unpack_from("<Q", self.data, 28)[0]

    def unmarked(self) -> bytes:
        """Returns the superblock without marks."""
        if not self.is_marked:
            return self.data
        start = self.data[:11] + b"\0" + self.data[12:]
        return start[:_CHECKED] + self._checksum(start)

    @staticmethod
    def _checksum(data: bytes) -> bytes:
        return struct.pack("<I", lookup3(data[:_CHECKED]))


def lookup3(data: bytes) -> int:
    """Returns the checksum of HDF5's metadata (Bob Jenkins 2006, lookup3.c,
    the function hashlittle)."""

    def turned(x: int, bits: int) -> int:
        return (x << bits | x >> 32 - bits) & 0xFFFFFFFF

    a = b = c = 0xDEADBEEF + len(data)
    words = struct.unpack(
        f"<{-(-len(data) // 12) * 3}I",
        data.ljust(-(-len(data) // 12) * 12, b"\0"),
    )
    for i in range(0, len(words), 3):
        a, b, c = (
            x + word & 0xFFFFFFFF for x, word in zip((a, b, c), words[i:])
        )
        if i + 3 == len(words):
            break
        for bits in (4, 6, 8, 16, 19, 4):
            a = (a - c & 0xFFFFFFFF) ^ turned(c, bits)
            a, b, c = b, c + b & 0xFFFFFFFF, a
    for bits in (14, 11, 25, 16, 4, 14, 24):
        c = (c ^ b) - turned(b, bits) & 0xFFFFFFFF
        a, b, c = b, c, a
    return b


def _superblock(path: Path) -> _Superblock:
    """Returns the superblock of a file. Raises NotAHistory if there is no
    superblock, or its checksum is wrong."""
    with path.open("rb") as file:
        block = _Superblock(file.read(_SUPERBLOCK_SIZE))
        if block.data[:8] != _SIGNATURE:
            raise NotAHistory(f"{path}: this is not an HDF5 file")
        if len(block.data) < _SUPERBLOCK_SIZE:
            raise NotAHistory(
                f"{path}: this history was cut short, only {len(block.data)} "
                "bytes are left"
            )
        # A writer may be changing its mark at this moment.
        for _ in range(_LOOKS):
            if not block.has_marks or block.is_whole:
                return block
            time.sleep(0.01)
            file.seek(0)
            block = _Superblock(file.read(_SUPERBLOCK_SIZE))
    raise NotAHistory(
        f"{path}: damaged: the superblock does not have its checksum; copy it "
        "again"
    )


def _check_length(path: Path) -> None:
    """Refuses a truncated file: the program creates a history in its full
    length."""
    missing = _superblock(path).length - path.stat().st_size
    if missing > 0:
        raise NotAHistory(
            f"{path}: this history was cut short, {missing} bytes are "
            "missing; copy it again (`ideotype status` lists the readable "
            "part)"
        )


def _check_format(file: h5py.File, path: Path) -> None:
    try:
        form = text(file.attrs.get("format", ""))
        version = text(file.attrs.get("format_version", ""))
    except (OSError, RuntimeError, KeyError) as error:
        raise NotAHistory(f"{path}: damaged ({error})") from error
    if form != FORMAT:
        raise NotAHistory(
            f"{path}: this is an HDF5 file, but not a history "
            f'(no attribute format = "{FORMAT}")'
        )
    major = version.split(".")[0]
    if major != str(MAJOR_VERSION):
        raise UnsupportedVersion(
            f"{path}: history format {version or 'unknown'}, but this reads "
            f"{MAJOR_VERSION}.x; "
            + (
                "version 0.2.1 of the ideotype package reads it"
                if major == "1"
                else "install the ideotype package that belongs to the "
                "program that wrote it"
            )
        )


def _is_locked(path: Path) -> bool:
    """Returns whether a writer holds its lock on the file, on any machine if
    the file system supports locks. The function only queries the lock, because
    even a short lock could stop a writer that starts."""
    try:
        import fcntl

        look, write, none = fcntl.F_OFD_GETLK, fcntl.F_WRLCK, fcntl.F_UNLCK
    except (ImportError, AttributeError):  # Linux alone has F_OFD_GETLK.
        return False
    form = "hhqqi4x"  # The layout of struct flock.
    whole = struct.pack(form, write, os.SEEK_SET, 0, 0, 0)
    try:
        with path.open("rb") as file:
            lock = fcntl.fcntl(file, look, whole)
    except OSError:
        return False
    return bool(struct.unpack(form, lock)[0] != none)
