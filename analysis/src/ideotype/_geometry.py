# SPDX-License-Identifier: Apache-2.0
"""The shape of plants."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Mesh:
    """Surfaces in metres, z up; of a plant its foot at the origin, y along
    the rows."""

    vertices: NDArray[np.float64]
    """[vertices, 3]"""
    faces: tuple[tuple[int, ...], ...]
    """Three or four vertices each."""
    groups: tuple[str, ...]
    """Organ of each face: "leaf01", ..., "stalk", "sheath", and others as
    "stalk_NAME" or "sheath_NAME" by their tissue."""

    @classmethod
    def of(
        cls,
        vertices: NDArray[np.float64],
        faces: NDArray[np.integer[Any]],
        face_group: NDArray[np.integer[Any]],
        names: list[str],
    ) -> Self:
        """Of faces with four corners, in which triangles repeat the last."""
        return cls(
            vertices,
            tuple(
                tuple(face[:3]) if face[2] == face[3] else tuple(face)
                for face in faces.tolist()
            ),
            tuple(names[group] for group in face_group),
        )

    def area(self, group: str) -> float:
        """Of an organ [m2]; faces are cut into triangles."""
        total = 0.0
        for face, name in zip(self.faces, self.groups):
            if name == group:
                a, *rest = self.vertices[list(face)]
                for b, c in pairwise(rest):
                    total += float(np.linalg.norm(np.cross(b - a, c - a))) / 2
        return total


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
