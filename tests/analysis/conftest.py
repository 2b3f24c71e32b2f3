"""Sample histories made to the letter of analysis/FORMAT.md."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from made_history import MadeHistory

HERE = Path(__file__).parent


class WriterProcess:
    """A history that another process holds open for SWMR writing."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._process = subprocess.Popen(
            [sys.executable, str(HERE / "made_history.py"), str(path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self._await()

    def do(self, command: str) -> None:
        """Returns when the command is carried out and flushed."""
        assert self._process.stdin is not None
        self._process.stdin.write(command + "\n")
        self._process.stdin.flush()
        self._await()

    def kill(self) -> None:
        """SIGKILL: nothing is flushed, closed or unlocked by the program."""
        self._process.kill()
        self._process.communicate()

    def _await(self) -> None:
        assert self._process.stdout is not None
        answer = self._process.stdout.readline()
        assert answer == "ok\n", f"the writer answered {answer!r}"


@pytest.fixture
def writer(tmp_path: Path) -> Iterator[WriterProcess]:
    """A live writer of an empty history."""
    process = WriterProcess(tmp_path / "live.h5")
    yield process
    process.kill()


@pytest.fixture(scope="session")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Six generations, three failures, finals, closed."""
    path = tmp_path_factory.mktemp("finished") / "case.h5"
    made = MadeHistory(path)
    made.evolve(6)
    made.finish()
    made.close()
    return path


@pytest.fixture(scope="session")
def drained(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two generations, five rows of the third, the rest of it only proposed;
    closed, not finished."""
    path = tmp_path_factory.mktemp("drained") / "case.h5"
    made = MadeHistory(path)
    made.evolve(2)
    made.propose(2)
    for slot in (0, 2, 3, 7):
        made.record(2, slot)
    made.fail(2, 4)
    made.close()
    return path
