# SPDX-License-Identifier: Apache-2.0
"""The Python package is built without the program and its libraries."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import ideotype

PROJECT = Path(__file__).parents[3]


def test_the_package_needs_no_library_of_the_program(tmp_path: Path) -> None:
    without = ("MPI", "HDF5", "nlohmann_json", "GTest")
    done = subprocess.run(
        [
            *("cmake", "-S", PROJECT, "-B", tmp_path, "-G", "Ninja"),
            *("-DIDEOTYPE_PYTHON=ON", "-DIDEOTYPE_PROGRAM=OFF"),
            f"-DPython_EXECUTABLE={sys.executable}",
            *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{each}=ON" for each in without),
        ],
        check=False,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr


def test_the_package_has_the_version_of_the_project() -> None:
    text = (PROJECT / "CMakeLists.txt").read_text()
    assert f"set(IDEOTYPE_VERSION {ideotype.__version__})" in text
