# SPDX-License-Identifier: Apache-2.0
"""Reading histories first where a hang or a crash does no harm.

HDF5 reads a file that may still be written again and again when a checksum
is wrong, for minutes at one damaged byte, and cannot be interrupted."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
from multiprocessing.connection import Connection
from pathlib import Path
from types import TracebackType
from typing import Self

from .file import HistoryError
from .history import History, open_history

SECONDS = 10.0
"""That a small history may take to read; a good one takes hundredths."""

_SLOWEST = 5e6
"""Of a file system [byte s-1]; larger histories may take longer."""

_PROGRAM = "from ideotype.analysis.trial import serve; serve()"


class Trial:
    """A context manager: one process that reads any number of histories, and
    another one after each that it does not survive."""

    def __init__(self, seconds: float = SECONDS) -> None:
        self._seconds = seconds
        self._process: subprocess.Popen[bytes] | None = None
        self._answers: Connection | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._stop()

    def open(self, path: Path) -> History:
        """A history of which everything can be read. Raises what read()
        raises."""
        self.read(path)
        # Its checksums have been compared.
        return History(path)

    def read(self, path: Path) -> None:
        """Raises what open_history() and the calls of its history raise, and
        HistoryError if HDF5 crashes or does not come to an end."""
        answers = self._answers or self._start()
        answers.send(path)
        size = path.stat().st_size if path.is_file() else 0
        limit = self._seconds + size / _SLOWEST
        if not answers.poll(limit):
            self._stop()
            raise HistoryError(
                f"{path}: damaged, HDF5 does not finish reading it (stopped "
                f"after {limit:.0f} s); copy it again"
            )
        try:
            error = answers.recv()
        except EOFError as end:
            self._stop()
            raise HistoryError(
                f"{path}: damaged, HDF5 crashes while reading it; copy it again"
            ) from end
        if error is not None:
            raise error

    def _start(self) -> Connection:
        self._answers, theirs = multiprocessing.Pipe()
        source = str(Path(__file__).parents[2])
        known = os.environ.get("PYTHONPATH")
        places = os.pathsep.join(filter(None, [source, known]))
        self._process = subprocess.Popen(
            [sys.executable, "-P", "-c", _PROGRAM, str(theirs.fileno())],
            pass_fds=[theirs.fileno()],
            env={**os.environ, "PYTHONPATH": places},
        )
        theirs.close()
        try:
            # Loading the libraries is not part of a file's time.
            self._answers.recv()
        except EOFError as end:
            self._stop()
            raise OSError(f"{sys.executable} does not start") from end
        return self._answers

    def _stop(self) -> None:
        if self._answers is not None:
            self._answers.close()
            self._answers = None
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process = None


def serve() -> None:
    """The other side: reads what it is told to, and answers with an error or
    None."""
    # An interrupt is for our parent, which then ends us.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with Connection(int(sys.argv[1])) as parent:
        parent.send(None)
        while True:
            try:
                path = parent.recv()
            except EOFError:
                return
            parent.send(_read(path))


def _read(path: Path) -> Exception | None:
    try:
        with open_history(path) as history:
            history.read_all()
    except (HistoryError, OSError) as error:
        return error
    return None
