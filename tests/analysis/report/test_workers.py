# SPDX-License-Identifier: Apache-2.0
"""Several processes draw the figures of a report."""

from __future__ import annotations

import os
import pickle
import signal
import time
from functools import partial
from pathlib import Path

import pytest
from conftest import WriterProcess

from ideotype.history.study import open_study
from ideotype.report.report import write_report
from ideotype.report.workers import start_workers


def meet(folder: Path, number: int) -> tuple[int, int]:
    """Returns the number and the process, after both numbers 0 and 1 have
    started; number 0 returns last."""
    (folder / str(number)).touch()
    other = folder / str(1 - number)
    end = time.monotonic() + 60
    while not other.exists():
        assert time.monotonic() < end, "alone"
        time.sleep(0.01)
    if number == 0:
        time.sleep(0.2)
    return number, os.getpid()


def die(number: int) -> None:
    """Kills its own process, as the system does when memory runs out."""
    os.kill(os.getpid(), signal.SIGKILL)


def test_processes_work_at_once_and_keep_the_order(tmp_path: Path) -> None:
    with start_workers(2) as run:
        found = list(run(partial(meet, tmp_path), [0, 1]))
    assert [number for number, _ in found] == [0, 1]
    assert len({os.getpid(), *(process for _, process in found)}) == 3


def test_many_arguments_go_together_and_keep_the_order() -> None:
    with start_workers(2) as run:
        assert list(run(abs, range(-100, 0))) == [*range(100, 0, -1)]


def test_a_killed_process_is_reported() -> None:
    with (
        pytest.raises(OSError, match="was killed .* --jobs 1"),
        start_workers(2) as run,
    ):
        list(run(die, [0]))


def test_any_number_of_processes_makes_the_same_report(
    sweep: Path, tmp_path: Path
) -> None:
    first = min(sweep.iterdir())
    content = []
    for jobs in (1, 3):
        folder = tmp_path / str(jobs)
        with open_study(first) as study:
            written = write_report(study, folder, has_pdf=True, jobs=jobs)
        assert sorted(written.figures) == sorted(
            [*(folder / "figures").iterdir(), *folder.glob("figure.*")]
        )
        content.append(
            [path.read_bytes() for path in (written.page, *written.figures)]
        )
    assert len(content[0]) > 20
    assert sum(data.startswith(b"%PDF") for data in content[0]) > 9
    assert content[0] == content[1]


def test_a_copy_of_a_case_shows_the_same_moment(writer: WriterProcess) -> None:
    writer.do("evolve 1")
    with open_study(writer.path) as study:
        (case,) = study.cases()
        case.remember()
        writer.do("evolve 2")
        copy = pickle.loads(pickle.dumps(case))
        assert copy.best.objective == case.best.objective
        assert list(copy.top(3).generation) == [0, 0, 0]
        # All other data are read from the file again.
        assert len(copy.histories[0].generations()) == 2
