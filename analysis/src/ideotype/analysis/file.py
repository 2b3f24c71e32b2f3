# SPDX-License-Identifier: Apache-2.0
"""Opening the HDF5 file in any state that its writer can leave it in."""

from __future__ import annotations

import fcntl
import os
import struct
from enum import Enum
from pathlib import Path

import h5py

from .._errors import Error

FORMAT = "ideotype-history"
MAJOR_VERSIONS = (1, 2)

_SIGNATURE = b"\x89HDF\r\n\x1a\n"
_SUPERBLOCK_SIZE = 48
_OPEN_FOR_WRITING = 0x01


class HistoryError(Error):
    """A history can't be used; the message is meant for the user."""


class NotAHistory(HistoryError):
    """The file is something else, or damaged."""


class UnsupportedVersion(HistoryError):
    """The file has another major format version."""


class Writer(Enum):
    """What is known of the process that writes a history."""

    WRITING = "being written"
    CLOSED = "closed"
    GONE = "not closed"
    """Killed, or alive where its lock can't be seen from here."""


def open_file(path: str | Path) -> h5py.File:
    """Opens a history to read, without ever changing it.

    SWMR reading is right for a file that is being written, one whose writer
    was killed (both marked as open, which plain reading refuses) and a closed
    one, where it leaves `ideotype run --resume` free to open the file
    meanwhile.

    Raises FileNotFoundError or PermissionError, HistoryError."""
    path = Path(path)
    if not path.exists():
        raise FileNotFoundError(f"{path}: no such file")
    if not path.is_file():
        raise NotAHistory(f"{path}: not a file")
    _check_length(path)
    try:
        file = h5py.File(path, "r", libver="latest", swmr=True, locking=False)
    except PermissionError:
        raise
    except (OSError, RuntimeError) as error:
        raise HistoryError(f"{path}: HDF5 can't open it ({error})") from error
    try:
        _check_format(file, path)
    except BaseException:
        file.close()
        raise
    return file


def text(value: object) -> str:
    """A string of HDF5 as a Python string."""
    if isinstance(value, bytes):
        return value.rstrip(b"\0").decode("utf-8", errors="replace")
    return str(value)


def writer_of(path: str | Path) -> Writer:
    """Whether a process writes the file, as far as this machine can tell."""
    version, flags, _ = _superblock(Path(path))
    if version < 3 or not flags & _OPEN_FOR_WRITING:
        return Writer.CLOSED
    return Writer.WRITING if _is_locked(Path(path)) else Writer.GONE


def _superblock(path: Path) -> tuple[int, int, int]:
    """Version, consistency flags and the length of the file according to
    itself [bytes]; flags and length are 0 for versions without them (HDF5
    file format specification, II.A)."""
    with path.open("rb") as file:
        block = file.read(_SUPERBLOCK_SIZE)
    if block[:8] != _SIGNATURE:
        raise NotAHistory(f"{path}: not an HDF5 file")
    version = block[8] if len(block) > 8 else 0
    if version < 2:
        return version, 0, 0
    if len(block) < _SUPERBLOCK_SIZE:
        raise NotAHistory(f"{path}: cut short, only {len(block)} bytes left")
    # offsets of 8 bytes: the only ones that the writer's HDF5 makes
    length = struct.unpack_from("<Q", block, 28)[0] if block[9] == 8 else 0
    return version, block[11], length


def missing_bytes(path: str | Path) -> int:
    """By how much the file is shorter than it says [bytes]. SWMR reading
    does not notice, and reads zeros there."""
    _, _, length = _superblock(Path(path))
    return max(0, length - Path(path).stat().st_size)


def _check_length(path: Path) -> None:
    """Refuses a closed file that was cut short. One that is open may grow
    between both looks at it, so that is left to whoever shows it."""
    if writer_of(path) is Writer.CLOSED and (missing := missing_bytes(path)):
        raise NotAHistory(
            f"{path}: cut short, {missing} bytes are missing; copy it again "
            "(`ideotype status` tells what is left)"
        )


def _check_format(file: h5py.File, path: Path) -> None:
    try:
        found = text(file.attrs.get("format", ""))
        version = text(file.attrs.get("format_version", ""))
    except (OSError, RuntimeError, KeyError) as error:
        raise NotAHistory(f"{path}: damaged ({error})") from error
    if found != FORMAT:
        raise NotAHistory(
            f"{path}: an HDF5 file, but not a history "
            f'(no attribute format = "{FORMAT}")'
        )
    major = version.split(".")[0]
    if major not in map(str, MAJOR_VERSIONS):
        known = " and ".join(f"{version}.x" for version in MAJOR_VERSIONS)
        raise UnsupportedVersion(
            f"{path}: history format {version or 'unknown'}, but this reads "
            f"{known}; install the ideotype package that belongs to the "
            "program that wrote it"
        )


def _is_locked(path: Path) -> bool:
    """Whether a writer holds its lock on the file, on any machine if the file
    system has locks. Looks only: a lock of our own, however short, could stop
    a writer that starts."""
    form = "hhqqi4x"  # struct flock
    whole = struct.pack(form, fcntl.F_WRLCK, os.SEEK_SET, 0, 0, 0)
    try:
        with path.open("rb") as file:
            found = fcntl.fcntl(file, fcntl.F_OFD_GETLK, whole)
    except OSError:
        return False
    return bool(struct.unpack(form, found)[0] != fcntl.F_UNLCK)
