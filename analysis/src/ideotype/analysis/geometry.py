# SPDX-License-Identifier: Apache-2.0
"""The shape of plants, as `ideotype export` gives it."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .file import HistoryError

_TIMEOUT = 60
"""For the export of one plant [s]; it takes well under one."""


@dataclass(frozen=True)
class Mesh:
    """A plant at the origin; metres, z up, y along the rows."""

    vertices: NDArray[np.float64]
    """[vertices, 3]"""
    faces: tuple[tuple[int, ...], ...]
    """Three or four vertices each."""
    groups: tuple[str, ...]
    """Organ of each face: "leaf01", ..., "stalk", "sheath", and others as
    "stalk_NAME" or "sheath_NAME" by their tissue."""

    def area(self, group: str) -> float:
        """Of an organ [m2]; faces are cut into triangles."""
        total = 0.0
        for face, name in zip(self.faces, self.groups):
            if name == group:
                a, *rest = self.vertices[list(face)]
                for b, c in zip(rest, rest[1:]):
                    total += float(np.linalg.norm(np.cross(b - a, c - a))) / 2
        return total


def find_program(given: str | Path | None = None) -> Path | None:
    """The program: the given path, else IDEOTYPE_EXECUTABLE, else `ideotype`
    on PATH; None if there is none.

    Raises HistoryError if the first two name no program."""
    for name, source in (
        (given, "--ideotype"),
        (os.environ.get("IDEOTYPE_EXECUTABLE"), "IDEOTYPE_EXECUTABLE"),
    ):
        if name:
            found = shutil.which(name)
            if found is None:
                raise HistoryError(f"{name}: no program ({source})")
            return Path(found).absolute()
    found = shutil.which("ideotype")
    return Path(found).absolute() if found else None


def export_plant(
    program: Path, history: str | Path, row: Sequence[str]
) -> Mesh:
    """The mesh of a row: ["--best"], or ["--generation", G, "--slot", S].

    Raises HistoryError with what the program says."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "plant.obj"
        command = [program, "export", history, *row, "--to", path]
        try:
            done = subprocess.run(
                [str(word) for word in command],
                capture_output=True,
                text=True,
                timeout=_TIMEOUT,
                check=False,
            )
        except (OSError, subprocess.TimeoutExpired) as error:
            raise HistoryError(
                f"{program}: export failed ({error})"
            ) from error
        if done.returncode:
            said = (done.stderr or done.stdout).strip().splitlines()
            raise HistoryError(
                f"{program} export: {said[-1] if said else done.returncode}"
            )
        return read_obj(path)


def read_obj(path: str | Path) -> Mesh:
    """The statements v, f and g of an OBJ file."""
    vertices: list[list[float]] = []
    faces: list[tuple[int, ...]] = []
    groups: list[str] = []
    group = ""
    for line in Path(path).read_text().splitlines():
        word, _, rest = line.partition(" ")
        if word == "v":
            vertices.append([float(x) for x in rest.split()[:3]])
        elif word == "g":
            group = rest.strip()
        elif word == "f":
            faces.append(tuple(int(v.split("/")[0]) - 1 for v in rest.split()))
            groups.append(group)
    return Mesh(np.array(vertices), tuple(faces), tuple(groups))
