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
    """Runs the short study with the given options; its tables are on the pages
    in `results`, by default folder/results."""
    return subprocess.run(
        [
            *(sys.executable, STUDY, folder / "study", "--short"),
            *("--results", results or folder / "results"),
            *words,
        ],
        env=os.environ | {"IDEOTYPE_EXECUTABLE": executable()},
        capture_output=True,
        text=True,
        check=False,
    )


def make_tables(folder: Path, parts: Sequence[str]) -> str:
    """Returns the tables of the given parts. Each part has a page in
    folder/results; its histories and figures are in folder/study."""
    results = folder / "results"
    results.mkdir()
    for name in parts:
        (results / f"{name}.md").write_text(
            f"# {name}\n\n"
            f"<!-- short study: {name} -->\nold\n<!-- end of study -->\n"
        )
    done = run(folder, "--only", *parts)
    assert done.returncode == 0, done.stderr
    counted = re.findall(
        r"(?m)^(\w+): .* (\d+) evaluations, \S+ differs$", done.stdout
    )
    assert [name for name, _ in counted] == list(parts), done.stdout
    pages = [(results / f"{name}.md").read_text() for name in parts]
    for name, page in zip(parts, pages, strict=True):
        assert page.startswith(f"# {name}\n\n<!-- short study: {name} -->\n")
        assert page.endswith("\n<!-- end of study -->\n")
        assert "\nold\n" not in page
    text = "\n".join(pages)
    assert text.count("|---|") >= len(parts)
    return text
