# SPDX-License-Identifier: Apache-2.0
"""Histories with a damaged byte are refused, and others are read without
them."""

from __future__ import annotations

import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest
from flipped_bits import OPEN, flip, marked, metadata
from installed import report, summary
from made_history import MadeHistory
from real_program import SAMPLE, executable

import ideotype
from ideotype.history import HistoryError, open_history, open_study
from ideotype.history.file import lookup3
from ideotype.tools import commands

METADATA = (11, 45, 100, 400)
"""Bytes of the sample in flags and checksum of the superblock, and in headers
of objects."""
UNREADABLE = 24_062
"""A byte within the numbers of a deflated dataset."""


def damage(path: Path, byte: int) -> Path:
    """Makes a copy of the sample with one bit flipped."""
    data = bytearray(SAMPLE.read_bytes())
    data[byte] ^= 0x40
    path.write_bytes(data)
    return path


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Provides a good history between two others, one of which cannot be
    read."""
    place = tmp_path / "results"
    place.mkdir()
    damage(place / "a.h5", UNREADABLE)
    shutil.copy(SAMPLE, place / "b.h5")
    (place / "c.h5").symlink_to(tmp_path / "gone.h5")
    return place


@pytest.mark.parametrize("byte", METADATA)
def test_damaged_metadata_are_reported_without_delay(
    tmp_path: Path, byte: int
) -> None:
    bad = damage(tmp_path / "bad.h5", byte)
    for read in (open_history, ideotype.open, open_study):
        begin = time.monotonic()
        with pytest.raises(HistoryError, match=r"bad\.h5: "):
            read(bad)
        assert time.monotonic() - begin < 5


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """Provides a finished history of two generations."""
    made = MadeHistory(tmp_path / "small.h5")
    made.evolve(2)
    made.finish()
    made.close()
    return tmp_path / "small.h5"


@pytest.mark.parametrize("marks", [0, OPEN])
def test_no_flipped_bit_of_metadata_makes_reading_endless(
    small: Path, marks: int
) -> None:
    """Forty bits are flipped, in a closed file and in a file marked as open;
    tests/stress/flip.py tests any number."""
    content = marked(small.read_bytes(), marks)
    small.write_bytes(content)
    whole = ideotype.open(small)
    bits = metadata(small)
    assert len(bits) > 50_000
    noticed = 0
    for bit in bits[:: len(bits) // 40]:
        small.write_bytes(flip(content, bit))
        try:
            arrays = ideotype.open(small)
        except HistoryError:
            noticed += 1
        else:
            assert arrays.identical(whole), bit
    assert noticed > 20


@pytest.mark.long
def test_every_reader_reports_flipped_bits() -> None:
    script = Path(__file__).parents[2] / "stress" / "flip.py"
    done = subprocess.run(
        [sys.executable, str(script), executable(), "6"],
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.startswith("2 flips in each state")


def test_marks_of_a_writer_do_not_change_results(finished: Path) -> None:
    block = finished.read_bytes()[:48]
    assert lookup3(block[:44]) == int.from_bytes(block[44:], "little")
    assert lookup3(b"Four score and seven years ago") == 0x17770551


def test_all_files_are_tried_and_damaged_ones_reported(folder: Path) -> None:
    with pytest.raises(
        HistoryError, match="a.h5: evaluations/absorbed_by_leaf"
    ):
        open_study(folder)
    with open_study(folder, skip_damaged=True) as study:
        assert [history.path.name for history in study] == ["b.h5"]
        first, second = map(str, study.damaged)
    assert first.startswith(
        f"{folder}/a.h5: evaluations/absorbed_by_leaf can't be"
    )
    assert second == f"{folder}/c.h5: there is no such file"
    with pytest.raises(
        HistoryError, match="a.h5: evaluations/absorbed_by_leaf"
    ):
        open_study(folder / "a.h5", skip_damaged=True)


def test_a_report_leaves_out_damaged_files(
    folder: Path, tmp_path: Path
) -> None:
    done = report(folder, "-o", tmp_path / "out")
    assert done.returncode == 3
    assert (
        f"left out: {folder}/a.h5: evaluations/absorbed_by_leaf" in done.stderr
    )
    page = (tmp_path / "out" / "report.html").read_text()
    assert "1 case, 1 history" in page
    assert page.count("<p>A history is left out. ") == 2
    assert (
        f"{folder}/a.h5: evaluations/absorbed_by_leaf can&#39;t be read"
        in page
    )


def test_the_exit_code_is_3_if_files_are_left_out(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    damage(folder / "d.h5", METADATA[1])
    done = summary(folder)
    assert done.returncode == 3
    assert done.stdout.startswith("| case ")
    lines = done.stderr.splitlines()
    assert [line.split(": ")[:3] for line in lines] == [
        ["ideotype summary", "left out", f"{folder}/{name}.h5"]
        for name in ("a", "c", "d")
    ]
    assert "the superblock does not have its checksum" in lines[2]
    assert commands.summary([str(folder / "b.h5")]) == 0
    assert summary(folder / "d.h5").returncode == 1
    capsys.readouterr()
    with pytest.raises(SystemExit):
        commands.report(["--help"])
    printed = " ".join(capsys.readouterr().out.split())
    assert "3 success without the histories" in printed
