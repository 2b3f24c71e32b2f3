# SPDX-License-Identifier: Apache-2.0
"""Writes the files of the package. A file is complete or absent, and no file
is written through a symbolic link."""

from __future__ import annotations

import argparse
import errno
import hashlib
import io
import os
import re
import secrets
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import Error

if TYPE_CHECKING:
    from matplotlib.figure import Figure

REFUSED = 4
"""The exit code of a command that refuses to write its output."""

_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC
_FOLDER = os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC
_NO_HARD_LINKS = (errno.EPERM, errno.EOPNOTSUPP, errno.ENOSYS, errno.EMLINK)
_FIGURES = ("png", "pdf", "svg")
_LONGEST = 200
"""The length of the longest name that file_name() returns [bytes]: file
systems allow 255, and extensions are added."""


class OutputRefused(Error):
    """An error for an output that would overwrite another file, or lead out of
    the folder that the user has named."""


def write_file(
    path: Path,
    content: str | bytes,
    root: Path | None = None,
    *,
    replaces: bool = True,
) -> None:
    """Writes a file under a temporary name and renames it when it is complete.
    After a failure the former file, if any, is unchanged.

    root: folder that the user has named, which may itself be a symbolic link.
        It is created if necessary, with all folders in it that lead to the
        file. By default it is the folder of the file, which must exist.
    replaces: whether the file may replace a regular file.

    Raises OutputRefused if the path or a folder below the root is a symbolic
    link or another special file, or if a file exists and `replaces` is false;
    OSError if writing fails."""
    data = content.encode() if isinstance(content, str) else content
    with _opened_folder(path, root) as folder:
        _require(_status(path.name, folder), path, replaces)
        part = f"{path.name}.{secrets.token_hex(4)}.part"
        try:
            descriptor = os.open(part, _NEW, 0o666, dir_fd=folder)
            try:
                with open(descriptor, "wb") as file:
                    file.write(data)
                _give_name(part, path, folder, replaces)
            except BaseException:
                with suppress(FileNotFoundError):
                    os.unlink(part, dir_fd=folder)
                raise
        except OSError as error:
            # The message names the file that the user knows.
            error.filename = str(path)
            raise


def require_output(
    path: Path, root: Path | None = None, *, replaces: bool = True
) -> None:
    """Checks whether write_file() would accept the file, before long
    computations. Raises OutputRefused if not."""
    for folder in _folders(path, root):
        status = _status(folder)
        if status and not stat.S_ISDIR(status.st_mode):
            raise _refusal(folder, status)
    _require(_status(path), path, replaces)


def figure_path(text: str) -> Path:
    """Returns the path of a figure, for options of a command line.

    Raises ArgumentTypeError unless the file name ends in .png, .pdf or
    .svg."""
    path = Path(text)
    if path.suffix.lower()[1:] not in _FIGURES:
        raise argparse.ArgumentTypeError(
            f"{text} (expected: a name that ends in .png, .pdf or .svg)"
        )
    return path


def save_figure(figure: Figure, path: Path) -> None:
    """Writes a figure by write_file(), in the format given by the file name
    extension."""
    out = io.BytesIO()
    figure.savefig(out, format=path.suffix.lower()[1:])
    write_file(path, out.getvalue())


def file_name(text: str) -> str:
    """Returns a text of unknown origin as part of a file name: characters
    other than letters, digits, - and _ become _, and a long name ends with a
    digest of the whole text."""
    name = re.sub(r"[^\w-]+", "_", text)
    encoded = name.encode()
    if len(encoded) <= _LONGEST:
        return name
    digest = hashlib.sha256(text.encode()).hexdigest()[:8]
    return f"{encoded[: _LONGEST - 9].decode(errors='ignore')}_{digest}"


def _folders(path: Path, root: Path | None) -> list[Path]:
    """Returns the folders below the root that lead to a file, outermost
    first. Raises OutputRefused for a path that leads out of the root."""
    if root is None:
        return []
    parts = path.relative_to(root).parts
    if ".." in parts:
        raise OutputRefused(
            f"{path}: this file is not in {root}; choose another output"
        )
    return [root.joinpath(*parts[:k]) for k in range(1, len(parts))]


@contextmanager
def _opened_folder(path: Path, root: Path | None) -> Iterator[int]:
    """Opens the folder of a file, so that no link can replace it, and yields
    its descriptor."""
    folders = _folders(path, root)
    if root is not None:
        root.mkdir(parents=True, exist_ok=True)
    opened = os.open(path.parent if root is None else root, _FOLDER)
    try:
        for folder in folders:
            with suppress(FileExistsError):
                os.mkdir(folder.name, dir_fd=opened)
            status = _status(folder.name, opened)
            if status and not stat.S_ISDIR(status.st_mode):
                raise _refusal(folder, status)
            outer = opened
            opened = os.open(
                folder.name, _FOLDER | os.O_NOFOLLOW, dir_fd=outer
            )
            os.close(outer)
        yield opened
    finally:
        os.close(opened)


def _status(
    path: str | Path, folder: int | None = None
) -> os.stat_result | None:
    try:
        return os.stat(path, dir_fd=folder, follow_symlinks=False)
    except FileNotFoundError:
        return None


def _require(
    status: os.stat_result | None, path: Path, replaces: bool
) -> None:
    if status is None:
        return
    if not stat.S_ISREG(status.st_mode):
        raise _refusal(path, status)
    if not replaces:
        raise _exists(path)


def _refusal(path: Path, status: os.stat_result) -> OutputRefused:
    if stat.S_ISLNK(status.st_mode):
        return OutputRefused(
            f"{path}: this is a symbolic link, and files are not written "
            "through links; remove it, or choose another output"
        )
    kind = "a folder" if stat.S_ISDIR(status.st_mode) else "a special file"
    if stat.S_ISREG(status.st_mode):
        kind = "a file where a folder is needed"
    return OutputRefused(f"{path}: this is {kind}; choose another output")


def _exists(path: Path) -> OutputRefused:
    return OutputRefused(
        f"{path}: this file exists already and is not overwritten; name "
        "another"
    )


def _give_name(part: str, path: Path, folder: int, replaces: bool) -> None:
    """Renames a complete file to its final name."""
    if not replaces:
        try:
            os.link(part, path.name, src_dir_fd=folder, dst_dir_fd=folder)
            os.unlink(part, dir_fd=folder)
            return
        except FileExistsError:
            raise _exists(path) from None
        except OSError as error:
            if error.errno not in _NO_HARD_LINKS:
                raise
    os.replace(part, path.name, src_dir_fd=folder, dst_dir_fd=folder)
