# SPDX-License-Identifier: Apache-2.0
"""Histories with a damaged byte, and what goes on without them."""

from __future__ import annotations

import shutil
import time
from pathlib import Path

import pytest
from test_commands import report, summary

from ideotype.analysis import HistoryError, open_study, trial
from ideotype.analysis.trial import Trial

SAMPLE = Path(__file__).parents[1] / "data" / "history" / "format_1_0.h5"
ENDLESS = (11, 45, 100, 400, 50_000)
"""Bytes of the sample that HDF5 does not get past for minutes: flags and
checksum of the superblock, headers of objects."""
UNREADABLE = 10_000
"""A byte within the numbers of a deflated dataset."""
ABORTS = """
import os
from ideotype.analysis import trial
trial._read = lambda path: os.abort() if path.stem == "bad" else None
trial.serve()
"""


def damage(path: Path, byte: int) -> Path:
    """A copy of the sample with one bit flipped."""
    data = bytearray(SAMPLE.read_bytes())
    data[byte] ^= 0x40
    path.write_bytes(data)
    return path


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A good history between two others, of which one can't be read."""
    place = tmp_path / "results"
    place.mkdir()
    damage(place / "a.h5", UNREADABLE)
    shutil.copy(SAMPLE, place / "b.h5")
    (place / "c.h5").symlink_to(tmp_path / "gone.h5")
    return place


@pytest.mark.parametrize("byte", ENDLESS)
def test_endless_reading_is_stopped(tmp_path: Path, byte: int) -> None:
    bad = damage(tmp_path / "bad.h5", byte)
    begin = time.monotonic()
    with (
        Trial(seconds=1.0) as reader,
        pytest.raises(HistoryError, match=r"bad\.h5: damaged, .* not finish"),
    ):
        reader.read(bad)
    # less the time to start the process
    assert time.monotonic() - begin < 30


def test_after_a_damaged_file_the_next_is_read(tmp_path: Path) -> None:
    bad = damage(tmp_path / "bad.h5", ENDLESS[0])
    with Trial(seconds=1.0) as reader:
        for _ in range(2):
            with pytest.raises(HistoryError):
                reader.read(bad)
        with pytest.raises(FileNotFoundError, match="none.h5: no such file"):
            reader.read(tmp_path / "none.h5")
        with pytest.raises(HistoryError, match="diagnostics can't be read"):
            reader.read(damage(bad, UNREADABLE))


def test_a_crash_of_the_reader_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trial, "_PROGRAM", ABORTS)
    with Trial() as reader:
        reader.read(SAMPLE)
        with pytest.raises(HistoryError, match="bad.h5: damaged, HDF5 crash"):
            reader.read(damage(tmp_path / "bad.h5", UNREADABLE))
        reader.read(SAMPLE)


def test_a_reader_that_does_not_start_is_told(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(trial, "_PROGRAM", "import os; os.abort()")
    with Trial() as reader, pytest.raises(OSError, match="does not start"):
        reader.read(SAMPLE)


def test_all_of_a_file_is_tried(folder: Path) -> None:
    with pytest.raises(HistoryError, match="a.h5: evaluations/diagnostics"):
        open_study(folder)
    with open_study(folder, skip_damaged=True) as study:
        assert [history.path.name for history in study] == ["b.h5"]
        first, second = map(str, study.damaged)
    assert first.startswith(f"{folder}/a.h5: evaluations/diagnostics can't be")
    assert second == f"{folder}/c.h5: no such file"
    with pytest.raises(HistoryError, match="a.h5: evaluations/diagnostics"):
        open_study(folder / "a.h5", skip_damaged=True)


def test_a_report_goes_on_without_damaged_files(
    folder: Path, tmp_path: Path
) -> None:
    done = report(folder, "-o", tmp_path / "out")
    assert done.returncode == 3
    assert f"left out: {folder}/a.h5: evaluations/diagnostics" in done.stderr
    page = (tmp_path / "out" / "report.html").read_text()
    assert "1 case, 1 history" in page
    assert page.count("<p>A history is left out. ") == 2
    assert f"{folder}/a.h5: evaluations/diagnostics can&#39;t be read" in page


def test_the_exit_code_tells_what_was_left_out(folder: Path) -> None:
    damage(folder / "d.h5", ENDLESS[1])
    done = summary(folder)
    assert done.returncode == 3
    assert done.stdout.startswith("case ") and done.stdout.count("case  ") == 1
    lines = done.stderr.splitlines()
    assert [line.split(": ")[:3] for line in lines] == [
        ["ideotype-summary", "left out", f"{folder}/{name}.h5"]
        for name in ("a", "c", "d")
    ]
    assert "does not finish reading it (stopped after 10 s)" in lines[2]
    assert summary(folder / "b.h5").returncode == 0
    assert summary(folder / "d.h5").returncode == 1
    assert "3 done without the histories" in " ".join(
        report("--help").stdout.split()
    )


def test_the_reader_finds_the_package_without_a_path(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("PYTHONPATH", raising=False)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "h5py.py").write_text("raise SystemExit('shadowed')")
    with Trial() as reader:
        reader.read(SAMPLE)
