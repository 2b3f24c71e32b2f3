# SPDX-License-Identifier: Apache-2.0
"""The examples of analysis/examples work as users run them."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

TOP = Path(__file__).parents[2]
EXAMPLES = TOP / "analysis" / "examples"
TESTED = {
    "pycma_search.py": r"gain (\d+\.\d) %",
    "optuna_search.py": r"gain (\d+\.\d) %",
    "scipy_search.py": r"absorb (\d+\.\d+) MJ",
    "libensemble_search.py": r"160 plants, gain (\d+\.\d) %",
    "agrivoltaics_pvlib.py": r"(?m)^land equivalent ratio (\d+\.\d+)$",
    "agrivoltaics_bifacial_radiance.py": r"is left to maize (\d+\.\d+)",
}
LEAST = {
    "pycma_search.py": 18,
    "optuna_search.py": 2,
    "scipy_search.py": 9.5,
    "libensemble_search.py": 12,
    "agrivoltaics_pvlib.py": 0.9,
    "agrivoltaics_bifacial_radiance.py": 0.5,
}


def at(folder: Path) -> Path:
    """Makes a folder with the campaigns, where nothing else is overwritten."""
    (folder / "campaigns").symlink_to(TOP / "campaigns")
    return folder


@pytest.mark.parametrize("name", TESTED)
def test_an_example_finds_what_it_looks_for(name: str, tmp_path: Path) -> None:
    said = subprocess.run(
        [sys.executable, EXAMPLES / name],
        cwd=at(tmp_path),
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert said.returncode == 0, said.stderr
    found = re.search(TESTED[name], said.stdout)
    assert found, said.stdout
    assert float(found[1]) > LEAST[name]


def test_every_example_is_tested() -> None:
    assert {path.name for path in EXAMPLES.glob("*.py")} == set(TESTED)


def test_the_notebook_of_the_main_study_runs(tmp_path: Path) -> None:
    notebook = nbformat.read(EXAMPLES / "main_study.ipynb", as_version=4)
    NotebookClient(
        notebook, timeout=300, resources={"metadata": {"path": at(tmp_path)}}
    ).execute()
    told = "".join(
        output.get("text", "")
        for cell in notebook.cells
        for output in cell.get("outputs", [])
    )
    found = re.search(r"gain (\d+\.\d) ± (\d+\.\d) %", told)
    assert found, told
    assert float(found[1]) > 20 and float(found[2]) < 0.5
