# SPDX-License-Identifier: Apache-2.0
"""The commands run as users start them."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from conftest import WriterProcess
from installed import BIN, report, summary
from made_history import MadeHistory
from real_program import executable

from ideotype.__main__ import COMMANDS


def test_summary_prints_one_line_for_each_case(sweep: Path) -> None:
    done = summary(sweep)
    assert (done.returncode, done.stderr) == (0, "")
    parts = done.stdout.split("\n\n")
    table = [x.split("|") for x in parts[0].split("\n")]
    assert [word.strip() for word in table[0][1:4]] == [
        "case",
        "searches",
        "gain [%]",
    ]
    assert all(len(row) == len(table[0]) for row in table)
    assert {row[2].strip() for row in table[2:]} == {"2"} and len(table) == 4
    assert all("±" in row[3] for row in table[2:])
    # The output consists of the table and the split of gains, each with a
    # caption, and a note on traits at a bound.
    assert len(parts) == 5
    assert parts[2].startswith("| case ") and "leaves alone" in parts[2]
    lines = summary(sweep, "--csv").stdout.splitlines()
    assert len(lines) == 3 and lines[0].startswith("case,campaign,site,")


def test_unusable_files_exit_with_1_and_a_reason(tmp_path: Path) -> None:
    (tmp_path / "text.h5").write_text("no")
    for path, reason in (
        (tmp_path / "none.h5", "there is no such file"),
        (tmp_path / "text.h5", "this is not an HDF5 file"),
    ):
        for command in (summary, report):
            done = command(path)
            assert (done.returncode, done.stdout) == (1, "")
            name = f"ideotype {command.__name__}"
            assert done.stderr == f"{name}: {path}: {reason}\n"


def test_a_wrong_command_line_exits_with_2(finished: Path) -> None:
    for command in (summary, report):
        assert command().returncode == 2
        assert command(finished, "--colour").returncode == 2


def test_a_report_without_results_is_refused(
    writer: WriterProcess, tmp_path: Path
) -> None:
    done = report(writer.path, "-o", tmp_path / "out")
    assert done.returncode == 1
    assert done.stderr.startswith(f"ideotype report: {writer.path}: ")
    assert "not evaluated yet; try again when" in done.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("word", ["--help", "FILE"])
def test_a_full_disk_is_reported(finished: Path, word: str) -> None:
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [
                str(BIN / "ideotype"),
                "summary",
                word.replace("FILE", str(finished)),
            ],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert done.returncode == 1
    assert "ideotype summary: [Errno 28] No space left" in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_texts_of_a_history_cannot_control_the_terminal(
    tmp_path: Path,
) -> None:
    path = tmp_path / "foreign\x1b[1A.h5"
    attributes = {"case": "a\x1b[2Jb\nstate  finished", "site": "\x9b1A"}
    made = MadeHistory(path, attributes=attributes)
    made.evolve(1)
    made.close()
    done = summary(path)
    assert "a\\x1b[2Jb" in done.stdout and "\x1b" not in done.stdout
    path.write_bytes(b"")
    done = summary(path)
    assert "foreign\\x1b[1A.h5: this is not an HDF5 file" in done.stderr


def test_a_closed_pipe_gives_no_message(finished: Path) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    with os.fdopen(writer, "w") as closed:
        done = subprocess.run(
            [str(BIN / "ideotype"), "summary", str(finished)],
            stdout=closed,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert (done.returncode, done.stderr) == (1, "")


def test_program_and_package_hand_commands_to_each_other(
    finished: Path, tmp_path: Path
) -> None:
    program = executable()
    helped = subprocess.run(
        [program, "--help"], capture_output=True, text=True, check=True
    ).stdout.split("Commands of the Python package:\n")[1]
    listed = [line.split()[0] for line in helped.splitlines() if line.strip()]
    assert listed == list(COMMANDS)

    def run(
        command: object,
        *words: object,
        cwd: Path | None = None,
        **names: str,
    ) -> list[object]:
        done = subprocess.run(
            [str(command), *map(str, words)],
            capture_output=True,
            text=True,
            check=False,
            cwd=cwd,
            timeout=60,
            env=os.environ | {"PATH": f"{BIN}:/usr/bin:/bin"} | names,
        )
        return [done.returncode, done.stdout, done.stderr]

    by_package = run(BIN / "ideotype", "summary", finished)
    assert by_package[0] == 0
    assert run(program, "summary", finished) == by_package
    # Files in the current folder must not be imported as modules.
    (tmp_path / "numpy.py").write_text("raise SystemExit('not NumPy')")
    assert run(program, "summary", finished, cwd=tmp_path) == by_package
    python = {"IDEOTYPE_PYTHON": "/usr/bin/python3"}
    code, _, error = run(program, "summary", finished, **python)
    assert code == 2 and "pip install . && export" in str(error)
    python = {"IDEOTYPE_PYTHON": str(tmp_path / "none")}
    code, _, error = run(program, "summary", finished, **python)
    assert code == 2 and "summary: cannot start" in str(error)

    compiled = {"IDEOTYPE_EXECUTABLE": program}
    by_program = run(program, "status", "--help")
    assert run(BIN / "ideotype", "status", "--help", **compiled) == by_program
    # The package finds its own command on PATH instead of the compiled
    # program, and must not start it.
    itself = {"IDEOTYPE_EXECUTABLE": str(BIN / "ideotype")}
    missing = run(BIN / "ideotype", "status", **itself)
    assert missing[0] == 2 and "need the compiled program" in str(missing[2])
    code, listed, _ = run(BIN / "ideotype", "--help", **itself)
    assert code == 0 and listed == missing[2]
    back = tmp_path / "ideotype"
    back.write_text(f'#!/bin/sh\nexec {tmp_path}/again "$@"\n')
    back.chmod(0o755)
    (tmp_path / "again").symlink_to(BIN / "ideotype")
    assert missing == run(
        BIN / "ideotype", "status", IDEOTYPE_EXECUTABLE=str(back)
    )
