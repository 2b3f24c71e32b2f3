# SPDX-License-Identifier: Apache-2.0
"""Makes parts of the short study of analysis/study/study.py."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from real_program import CAMPAIGNS, executable

STUDY = CAMPAIGNS.parent / "analysis" / "study" / "study.py"
PARTS = re.findall(
    r'(?m)^    "(\w+)": Part\(', (STUDY.parent / "study_parts.py").read_text()
)


def run(
    folder: Path, *words: str, results: Path | None = None
) -> subprocess.CompletedProcess[str]:
    """Runs the short study with options; its tables are in RESULTS.md of the
    folder."""
    return subprocess.run(
        [
            *(sys.executable, STUDY, folder / "study", "--short"),
            *("--results", results or folder / "RESULTS.md"),
            *words,
        ],
        env=os.environ | {"IDEOTYPE_EXECUTABLE": executable()},
        capture_output=True,
        text=True,
        check=False,
    )


def tables_of(folder: Path, parts: Sequence[str]) -> str:
    """Returns the tables of parts; their histories and figures are in
    folder/study."""
    results = folder / "RESULTS.md"
    results.write_text(
        "\n".join(
            f"<!-- short study: {name} -->\nold\n<!-- end of study -->\n"
            for name in parts
        )
    )
    done = run(folder, "--only", *parts)
    assert done.returncode == 0, done.stderr
    counted = re.findall(r"(?m)^(\w+): .* (\d+) evaluations$", done.stdout)
    assert [name for name, _ in counted] == list(parts), done.stdout
    text = results.read_text()
    assert "\nold\n" not in text
    assert text.count("|---|") >= len(parts)
    return text
