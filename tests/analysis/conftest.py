# SPDX-License-Identifier: Apache-2.0
"""Sample histories that follow analysis/FORMAT.md exactly."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from live_page import CAMPAIGNS, Served, served
from made_campaign import SITES, resolved
from made_history import MadeHistory
from made_kinds import Measured
from made_report import CASES, ELITE, Made
from real_program import run_shortened, start

from ideotype.tools.commands import report

HERE = Path(__file__).parent
# For commands of the package, the program starts the Python that runs the
# tests.
os.environ.setdefault("IDEOTYPE_PYTHON", sys.executable)
LONG = {
    "test_manual.py",
    "test_study_script.py",
    "test_examples.py",
    "test_commands.py",
    "test_front.py",
    "test_front_page.py",
    "test_report.py",
    "test_report_view.py",
    "test_campaign_scripts.py",
    "test_real_report.py",
    "test_workers.py",
    "test_viewer.py",
    "test_organs.py",
    "test_nsga2.py",
    "test_play.py",
    "test_play_files.py",
    "test_live_safety.py",
    "test_watch.py",
}
"""Tests of the manual, the study, browsers and other programs: ./test.sh
leaves these tests out. Long tests begin first, so that none runs alone at the
end."""


for profile, examples in (("quick", 25), ("long", 1000)):
    settings.register_profile(
        profile,
        max_examples=examples,
        # Examples are reproducible, and no earlier ones are stored in a
        # folder.
        derandomize=True,
        database=None,
        deadline=None,
        suppress_health_check=[HealthCheck.too_slow],
    )


# The option --hypothesis-profile=long of ./test.sh --all selects the other
# profile.
settings.load_profile("quick")


def pytest_ignore_collect(
    collection_path: Path, config: pytest.Config
) -> bool | None:
    """Skips files of long tests if none of them runs, because each process
    would import their libraries."""
    is_quick = config.getoption("markexpr") == "not long"
    return True if is_quick and collection_path.name in LONG else None


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Marks long tests and moves them to the front."""
    items.sort(key=lambda item: item.path.name not in LONG)
    for item in items:
        if item.path.name in LONG:
            item.add_marker("long")


@pytest.fixture(scope="module")
def day() -> Iterator[Served]:
    """Runs the server of `ideotype play` for maize on a clear day."""
    with served("play", CAMPAIGNS / "ames.toml") as found:
        yield found


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
        """Sends a command, and returns when the writer has executed and
        flushed it."""
        assert self._process.stdin is not None
        self._process.stdin.write(command + "\n")
        self._process.stdin.flush()
        self._await()

    def kill(self) -> None:
        """Kills the writer by SIGKILL, so that the program neither flushes,
        closes nor unlocks the file."""
        self._process.kill()
        self._process.communicate()

    def _await(self) -> None:
        assert self._process.stdout is not None
        answer = self._process.stdout.readline()
        assert answer == "ok\n", f"the writer answered {answer!r}"


@pytest.fixture
def writer(tmp_path: Path) -> Iterator[WriterProcess]:
    """Provides a live writer of an empty history."""
    process = WriterProcess(tmp_path / "live.h5")
    yield process
    process.kill()


@pytest.fixture(scope="session")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides a closed history with six generations, three failed rows and
    final evaluations."""
    path = tmp_path_factory.mktemp("finished") / "case.h5"
    made = MadeHistory(path)
    made.evolve(6)
    made.finish()
    made.close()
    return path


@pytest.fixture(scope="session")
def drained(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides a history with two generations and five rows of the third
    generation, the rest of which is only proposed. The history is closed but
    not finished."""
    path = tmp_path_factory.mktemp("drained") / "case.h5"
    made = MadeHistory(path)
    made.evolve(2)
    made.propose(2)
    for slot in (0, 2, 3, 7):
        made.record(2, slot)
    made.fail(2, 4)
    made.close()
    return path


SHIFTS = (0.0, 0.1)
"""The shifts of the seeds of the sweep [MJ m-2 day-1]."""


@pytest.fixture(scope="session")
def sweep(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides a folder with finished histories of two sites and two seeds
    each, with PAR by height layer (three) and by origin."""
    folder = tmp_path_factory.mktemp("sweep")
    layers = Measured("MJ m-2 day-1", "layer")
    sources = Measured("MJ m-2 day-1", "light_source")
    extra = {
        "absorbed_by_layer": (layers, np.full(3, 1 / 3)),
        "absorbed_by_source": (sources, np.array([0.75, 0.25])),
    }
    labels = {"layer": [0.125, 0.375, 0.75], "light_source": ["beam", "sky"]}
    for site, (latitude, angle) in SITES.items():
        for seed, shift in enumerate(SHIFTS, start=1):
            name = f"{site}_0807_762x152_all_r{seed}"
            place = {"campaign": "sweep", "case": name, "site": site}
            place |= {"latitude": latitude, "replicate": float(seed)}
            made = MadeHistory(
                folder / f"{name}.h5",
                attributes=place,
                resolved=resolved(folding_angle=angle),
                shift=shift,
                labels=labels,
                extra=extra,
            )
            made.evolve(6)
            made.finish()
            made.close()
    return folder


@pytest.fixture(scope="session")
def tiny_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides the history of a finished run of the tiny campaign; the
    campaign is in the parent folder."""
    folder = tmp_path_factory.mktemp("run")
    run = start(folder, 3)
    output, _ = run.communicate(timeout=300)
    assert run.returncode == 0, output
    (path,) = (folder / "tiny").glob("*.h5")
    return path


@pytest.fixture(scope="session")
def sorghum(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Provides two finished histories of sorghum: one with free traits of
    single leaves, one with a free profile of insertion angles."""
    return run_shortened(tmp_path_factory.mktemp("sorghum"), "sorghum")


@pytest.fixture(scope="session")
def cross(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides a cross-evaluation of two plants in both cases; edmonton lacks
    the elite plant."""
    path = tmp_path_factory.mktemp("cross") / "cross.json"
    data = {
        "plants": ["elite", "best of ames"],
        "cases": CASES,
        "mean": [[ELITE, None], [11.16, 11.05]],
        "standard_error": [[0.005, None], [0.005, 0.006]],
    }
    path.write_text(json.dumps(data))
    return path


@pytest.fixture(scope="session")
def made(
    sweep: Path,
    cross: Path,
    tmp_path_factory: pytest.TempPathFactory,
) -> Made:
    """Provides the report of the sweep."""
    folder = tmp_path_factory.mktemp("report")
    arguments = [sweep, "-o", folder, "--cross", cross]
    with pytest.MonkeyPatch.context() as patch:
        log = folder / "log"
        with log.open("w") as stream:
            patch.setattr(sys, "stderr", stream)
            assert report([str(a) for a in arguments]) == 0
    return Made(folder, log.read_text())
