# SPDX-License-Identifier: Apache-2.0
"""Computes results that must remain bitwise equal through changes of the
program.

`golden.py write` rewrites tests/data/golden/*.txt with the program of
IDEOTYPE_EXECUTABLE, after an intended change of results; the commit states the
reason. Each line has the name of a result, the number of values, a digest of
their bits and the first value as text."""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import golden_names
import h5py
import numpy as np
from real_program import executable

DATA = Path(__file__).parents[1] / "data"
CAMPAIGNS = ("stand", "plot", "limited")
MESHES = {
    "mesh_sun": ["maize1.obj", "--period", ".76", ".15", "--sun", "30", "100"],
    "mesh_day": [
        *("maize1.obj", "--period", ".76", ".15", "--sky", "clear"),
        *("--date", "2025-08-07", "--site", "42", "-93.6", "-5"),
    ],
    "mesh_plot": [
        "maize1.obj",
        "--boundary",
        "isolated",
        "--ground-area",
        ".114",
        "--sky",
        "overcast",
    ],
}


def figures(name: str) -> dict[str, np.ndarray]:
    """Returns the results of a campaign or mesh of this module, computed by
    the program."""
    if name in MESHES:
        return _mesh_figures(MESHES[name])
    with tempfile.TemporaryDirectory() as folder:
        campaign = DATA / "golden" / f"{name}.toml"
        _run("run", str(campaign), "--out", folder)
        (path,) = Path(folder).glob("*/*.h5")
        return _history_figures(path)


def text(found: dict[str, np.ndarray]) -> str:
    lines = []
    for name, array in found.items():
        values = np.ascontiguousarray(array, dtype="<f8").ravel()
        digest = hashlib.sha256(values.tobytes()).hexdigest()[:16]
        lines.append(f"{name} {values.size} {digest} {float(values[0])!r}\n")
    return "".join(lines)


def _run(*words: str) -> str:
    done = subprocess.run(
        [executable(), *words], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def _history_figures(path: Path) -> dict[str, np.ndarray]:
    with h5py.File(path, "r") as file:
        return golden_names.figures(file)


def _mesh_figures(options: list[str]) -> dict[str, np.ndarray]:
    mesh, *others = options
    path = str(DATA / "reference" / mesh)
    values: dict[str, np.ndarray] = {}
    report = json.loads(
        _run(
            "light",
            path,
            *others,
            "--tolerance",
            ".003",
            "--json",
        )
    )
    _flatten("", report, values)
    values.pop("seconds")
    # Quantities that were added later have no golden values.
    return {k: v for k, v in values.items() if not k.startswith("quantities.")}


def _flatten(name: str, value: object, values: dict[str, np.ndarray]) -> None:
    if isinstance(value, dict):
        for key, item in value.items():
            _flatten(f"{name}.{key}" if name else key, item, values)
    elif isinstance(value, list):
        for i, item in enumerate(value):
            _flatten(f"{name}.{i}", item, values)
    elif isinstance(value, (int, float)):
        values[name] = np.array([value], dtype=float)


def main() -> None:
    if sys.argv[1:] != ["write"]:
        sys.exit(__doc__)
    for name in (*CAMPAIGNS, *MESHES):
        (DATA / "golden" / f"{name}.txt").write_text(text(figures(name)))


if __name__ == "__main__":
    main()
