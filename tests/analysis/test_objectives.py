"""The scripts of campaigns/ about what light is for."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

from real_program import CAMPAIGNS, executable


def run(script: str, *words: object) -> str:
    done = subprocess.run(
        [sys.executable, CAMPAIGNS / script, *map(str, words)],
        env=os.environ | {"IDEOTYPE_EXECUTABLE": executable()},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_erect_leaves_pay_only_where_plants_stand_close() -> None:
    """As in the field: Winter and Ohlrogge 1973, Agronomy Journal 65, 395."""
    table = run("erect_leaves.py", "--densities", 3, 12)
    for name in "upper 5 leaves at 12 deg", "all leaves at 15 deg instead of 45":
        row = re.search(rf"(?m)^\| {name}.*\| (\S+) ± \S+ \| (\S+) ±", table)
        assert row is not None, table
        assert float(row[1]) < -2 and float(row[2]) > 2


def test_objectives_are_bred_for_and_compared(tmp_path: Path) -> None:
    words = [tmp_path, "--only", "area", "--generations", 1, "--seeds", 1]
    figure = tmp_path / "angles.png"
    table = run("objectives.py", *words, "--figure", figure)
    rows = re.findall(r"(?m)^\| the same, fixed leaf area \| (\S+) \|.*", table)
    assert rows == ["30x6", "15x3"]
    assert figure.stat().st_size > 10000
    # What is there is not bred again.
    files = sorted(tmp_path.glob("*/*.h5"))
    written = [file.read_bytes() for file in files]
    assert run("objectives.py", *words) == table
    assert len(files) == 2
    assert [file.read_bytes() for file in files] == written
