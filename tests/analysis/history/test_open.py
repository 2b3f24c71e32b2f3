# SPDX-License-Identifier: Apache-2.0
"""Files are read in every state in which a writer can leave a file."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import h5py
import pytest
from conftest import WriterProcess
from made_history import MadeHistory
from made_numbers import POPULATION, absorbed

import ideotype
from ideotype.history import (
    HistoryError,
    NotAHistory,
    UnsupportedVersion,
    open_history,
)


def fingerprint(path: Path) -> tuple[str, int]:
    """Returns the content and the modification time of a file."""
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    return digest, path.stat().st_mtime_ns


def test_a_live_file_is_read_and_followed(writer: WriterProcess) -> None:
    writer.do("propose 0")
    writer.do("record 0 3")
    with open_history(writer.path) as history:
        assert str(history.state()) == "running"
        assert history.evaluations()["absorbed_par"].values == absorbed(0, 3)
        assert len(history.generations()) == 0
        for slot in {*range(POPULATION)} - {3}:
            writer.do(f"record 0 {slot}")
        assert len(history.evaluations()) == POPULATION
        assert len(history.generations()) == 0
        writer.do("commit 0")
        assert len(history.generations()) == 1


def test_a_reader_does_not_disturb_the_writer(writer: WriterProcess) -> None:
    writer.do("propose 0")
    with open_history(writer.path) as history:
        history.evaluations()
        writer.do("evolve 1")
        writer.do("close")
    with open_history(writer.path) as history:
        assert len(history.evaluations()) == POPULATION
        assert str(history.state()).startswith("stopped")


def test_a_killed_file_is_read_and_left_unchanged(
    writer: WriterProcess,
) -> None:
    writer.do("evolve 2")
    writer.do("propose 2")
    writer.do("record 2 6")
    writer.kill()
    with pytest.raises(OSError, match="already open for write"):
        h5py.File(writer.path)
    before = fingerprint(writer.path)
    with open_history(writer.path) as history:
        rows = history.evaluations()
        assert len(rows) == 2 * POPULATION + 1
        assert rows["absorbed_par"].values[-1] == absorbed(2, 6)
        assert len(history.generations()) == 2
        assert str(history.state()).startswith("interrupted")
    assert fingerprint(writer.path) == before


def test_every_kill_leaves_the_recorded_rows(tmp_path: Path) -> None:
    for count in range(0, POPULATION, 3):
        writer = WriterProcess(tmp_path / f"killed{count}.h5")
        writer.do("propose 0")
        for slot in range(count):
            writer.do(f"record 0 {slot}")
        writer.kill()
        with open_history(writer.path) as history:
            assert list(history.evaluations().slot) == list(range(count))


@pytest.mark.parametrize("locking", ["TRUE", "FALSE", "BEST_EFFORT"])
def test_histories_are_read_with_any_setting_of_file_locking(
    writer: WriterProcess, locking: str
) -> None:
    """The file is read while its writer lives, and after the writer is
    killed."""
    writer.do("evolve 1")
    program = (
        "import sys; from ideotype.history import open_history\n"
        "for _ in range(2): print(len(open_history(sys.argv[1])"
        ".evaluations()), flush=True); input()"
    )
    with subprocess.Popen(
        [sys.executable, "-c", program, str(writer.path)],
        env={**os.environ, "HDF5_USE_FILE_LOCKING": locking},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as reader:
        assert reader.stdout
        assert reader.stdout.readline() == f"{POPULATION}\n"
        writer.kill()
        assert reader.communicate("\n\n") == (f"{POPULATION}\n", "")


def test_a_read_only_file_in_a_read_only_folder_is_read(
    finished: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "archive"
    folder.mkdir()
    path = folder / "case.h5"
    shutil.copy(finished, path)
    path.chmod(0o444)
    folder.chmod(0o555)
    try:
        with open_history(path) as history:
            assert (
                str(history.state()) == "finished (reached stop.generations)"
            )
    finally:
        folder.chmod(0o755)
    assert os.listdir(folder) == ["case.h5"]


def test_reading_a_closed_file_lets_a_writer_open_it(drained: Path) -> None:
    program = "import h5py, sys; h5py.File(sys.argv[1], 'r+').close()"
    with open_history(drained):
        done = subprocess.run(
            [sys.executable, "-c", program, str(drained)],
            capture_output=True,
            text=True,
            check=False,
        )
    assert done.returncode == 0, done.stderr


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(
        FileNotFoundError, match=r"none\.h5: there is no such file"
    ):
        open_history(tmp_path / "none.h5")


@pytest.mark.parametrize("content", [b"", b"abc", b"x" * 5000])
def test_files_of_other_content_are_refused(
    tmp_path: Path, content: bytes
) -> None:
    path = tmp_path / "other.h5"
    path.write_bytes(content)
    with pytest.raises(NotAHistory, match="not an HDF5 file"):
        open_history(path)
    with pytest.raises(NotAHistory, match="not a file"):
        open_history(tmp_path)


def test_other_hdf5_files_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "other.h5"
    h5py.File(path, "w").close()
    with pytest.raises(NotAHistory, match="not a history"):
        open_history(path)
    MadeHistory(path, attributes={"format": "something-else"}).close()
    with pytest.raises(NotAHistory, match="not a history"):
        open_history(path)


def test_another_major_version_is_refused_with_its_number(
    tmp_path: Path,
) -> None:
    for version in ("3.0", "10.0", "0.9", "unknown"):
        attributes = {"format_version": version}
        MadeHistory(tmp_path / "new.h5", attributes=attributes).close()
        with pytest.raises(UnsupportedVersion, match=f"format {version},"):
            open_history(tmp_path / "new.h5")
    MadeHistory(tmp_path / "old.h5", attributes={"format_version": "1.0"})
    with pytest.raises(UnsupportedVersion, match=r"version 0\.2\.1 of the"):
        open_history(tmp_path / "old.h5")
    attributes = {"format_version": "2.7"}
    MadeHistory(tmp_path / "minor.h5", attributes=attributes).close()
    with open_history(tmp_path / "minor.h5") as history:
        assert history.attributes["format_version"] == "2.7"


@pytest.mark.parametrize("part", [0.2, 0.5, 0.9, 0.999])
def test_a_file_that_was_cut_short_is_refused(
    finished: Path, tmp_path: Path, part: float
) -> None:
    data = finished.read_bytes()
    path = tmp_path / "cut.h5"
    path.write_bytes(data[: int(part * len(data))])
    with pytest.raises(NotAHistory, match="cut short"):
        open_history(path)


def test_a_killed_file_that_was_cut_short_is_refused(
    writer: WriterProcess, tmp_path: Path
) -> None:
    writer.do("evolve 4")
    writer.kill()
    data = writer.path.read_bytes()
    path = tmp_path / "cut.h5"
    path.write_bytes(data[:-1000])
    with pytest.raises(NotAHistory, match="cut short, 1000 bytes"):
        open_history(path)


def test_dimensions_without_scales_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "loose.h5"
    MadeHistory(path).close()
    with h5py.File(path, "r+") as file:
        file["evaluations/loose"] = [1.0, 2.0]
    with pytest.raises(HistoryError, match="of /evaluations/loose have no"):
        open_history(path)


def test_dimensions_with_scales_of_others_are_refused(
    finished: Path, tmp_path: Path
) -> None:
    path = tmp_path / "moved.h5"
    shutil.copy(finished, path)
    with h5py.File(path, "r+") as file:
        rows = file["evaluations"]
        dimension = rows["absorbed_by_hour"].dims[1]
        dimension.detach_scale(rows["hour"])
        dimension.attach_scale(rows["row"])
    with pytest.raises(HistoryError, match="no scales, or not theirs"):
        open_history(path)


def test_a_missing_dataset_is_named(tmp_path: Path) -> None:
    path = tmp_path / "lacks.h5"
    MadeHistory(path, without="generations/mean").close()
    with (
        open_history(path) as history,
        pytest.raises(HistoryError, match="has no generations/mean"),
    ):
        history.generations()


def test_dir_lists_the_public_names() -> None:
    assert {*ideotype.__all__, "__version__"} == {*dir(ideotype)}
    assert {"Stand", "mesh", "Search", "open_study", "Crop"} <= {
        *dir(ideotype)
    }
