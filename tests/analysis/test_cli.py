"""The command ideotype-summary, as a user starts it."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

from conftest import WriterProcess

COMMAND = Path(sys.executable).with_name("ideotype-summary")


def summary(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Runs the installed command."""
    return subprocess.run(
        [str(COMMAND), *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
    )


def test_a_finished_history_is_summarized(finished: Path) -> None:
    done = summary(finished, "--no-figures")
    assert (done.returncode, done.stderr) == (0, "")
    lines = {line[:13].strip(): line[13:] for line in done.stdout.split("\n")}
    assert lines["case"] == "ames-aug-30x6-all-r1 of campaign made"
    assert lines["site"].startswith("ames, 42.00 N 93.60 W, day 2025-08-07")
    assert lines["program"].startswith("ideotype 0.1.0 (commit 0123456789")
    assert lines["state"] == "finished (generations)"
    assert lines["generations"] == "6 of at most 8"
    assert lines["evaluations"] == "72 complete, 3 failures"
    assert lines["last failure"] == "leaf 3 folds into itself"
    table = {" ".join(line.split()) for line in done.stdout.split("\n")}
    assert {
        "MJ m-2 day-1 11.0000 +- 0.0050 11.1650 +- 0.0050",
        "MWh acre-1 day-1 12.3654 +- 0.0056 12.5509 +- 0.0056",
        "mol m-2 day-1 50.270 +- 0.023 51.024 +- 0.023",
        "gain +1.50 +- 0.06 %",
    } <= table
    assert "Provisional" not in done.stdout


def test_figures_go_beside_the_history(finished: Path, tmp_path: Path) -> None:
    shutil.copy(finished, tmp_path / "case.h5")
    done = summary(tmp_path / "case.h5")
    assert done.returncode == 0
    figures = sorted((tmp_path / "case_figures").iterdir())
    assert len(figures) == 8
    printed = [
        p for p in done.stdout.split("\n") if p.endswith((".png", "pdf"))
    ]
    assert sorted(map(Path, printed)) == figures


def test_figures_go_where_they_are_told(
    finished: Path, tmp_path: Path
) -> None:
    assert summary(finished, "-o", tmp_path / "here").returncode == 0
    assert len(list((tmp_path / "here").iterdir())) == 8
    assert not finished.with_name("case_figures").exists()


def test_a_live_history_is_provisional(
    writer: WriterProcess, tmp_path: Path
) -> None:
    done = summary(writer.path, "--no-figures")
    assert "not evaluated yet" in done.stdout
    writer.do("evolve 2")
    done = summary(writer.path, "-o", tmp_path / "figures")
    assert done.returncode == 0
    assert "state        running" in done.stdout
    assert "Provisional" in done.stdout
    assert len(list((tmp_path / "figures").iterdir())) == 8
    writer.kill()
    done = summary(writer.path, "--no-figures")
    assert "state        interrupted" in done.stdout


def test_unusable_files_exit_with_1_and_a_reason(tmp_path: Path) -> None:
    (tmp_path / "text.h5").write_text("no")
    for path, reason in (
        (tmp_path / "none.h5", "no such file"),
        (tmp_path / "text.h5", "not an HDF5 file"),
        (tmp_path, "not a file"),
    ):
        done = summary(path)
        assert (done.returncode, done.stdout) == (1, "")
        assert done.stderr == f"ideotype-summary: {path}: {reason}\n"


def test_a_wrong_command_line_exits_with_2(finished: Path) -> None:
    assert summary().returncode == 2
    assert summary(finished, "--colour").returncode == 2


def test_a_closed_pipe_is_quiet(finished: Path, tmp_path: Path) -> None:
    done = subprocess.run(
        f"'{COMMAND}' '{finished}' -o '{tmp_path}' | head -n 1",
        shell=True,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stderr == ""
