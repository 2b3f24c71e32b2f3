# SPDX-License-Identifier: Apache-2.0
"""The script analysis/study/what_pays.py computes the values of single traits
correctly."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

from real_program import CAMPAIGNS, executable, run_crop


def test_only_leaf_traits_are_reset(tmp_path: Path) -> None:
    """Sheaths and other organs also have lengths and azimuths, which must not
    change."""
    history = run_crop(tmp_path, "maize", ["length", "azimuth"])
    script, under = (
        CAMPAIGNS.parent / "analysis" / "study" / "what_pays.py",
        tmp_path / "tiny.toml",
    )
    done = subprocess.run(
        [sys.executable, script, "--under", under, history],
        env=os.environ | {"IDEOTYPE_EXECUTABLE": executable()},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert len(re.findall(r"(?m)^\| \d+ \|", done.stdout)) == 10
    row = re.search(r"(?m)^\| lengths of the baseline \| (\S+) ±", done.stdout)
    assert row is not None and abs(float(row[1])) < 20
