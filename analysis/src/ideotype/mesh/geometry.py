# SPDX-License-Identifier: Apache-2.0
"""Meshes of plants."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Mesh:
    """Surfaces in metres, with z up. The foot of a plant is at the origin, and
    y is along the rows."""

    vertices: NDArray[np.float64]
    """The corners of faces [vertices, 3]."""
    faces: tuple[tuple[int, ...], ...]
    """The three or four vertices of each face."""
    groups: tuple[str, ...]
    """The organ of each face: "leaf01", ..., "stalk", "sheath"; other organs
    are "stalk_NAME" or "sheath_NAME" by their tissue."""
    ranks: tuple[int, ...] = ()
    """The leaf rank of each face, from 1 for the lowest leaf; 0 for other
    organs. Empty if unknown."""

    @classmethod
    def of(
        cls,
        vertices: NDArray[np.float64],
        faces: NDArray[np.integer[Any]],
        face_group: NDArray[np.integer[Any]],
        names: list[str],
        ranks: list[int],
    ) -> Self:
        """Returns a mesh of faces [faces, 4]; a triangle repeats its last
        corner. names, ranks: organ and leaf rank of each group, to which
        `face_group` [faces] refers."""
        return cls(
            vertices,
            tuple(
                tuple(face[:3]) if face[2] == face[3] else tuple(face)
                for face in faces.tolist()
            ),
            tuple(names[group] for group in face_group),
            tuple(ranks[group] for group in face_group),
        )

    @property
    def corners(self) -> NDArray[np.float64]:
        """The corners of faces [faces, 4, 3] in metres; a triangle repeats its
        last corner."""
        return self.vertices[[(*face, face[-1])[:4] for face in self.faces]]

    def area(self, group: str) -> float:
        """Returns the area of an organ [m2], the sum over its triangles."""
        faces = self.corners[[name == group for name in self.groups]]
        a, b, c, d = faces.transpose(1, 0, 2)
        twice = np.cross([b - a, c - a], [c - a, d - a])
        return float(np.linalg.norm(twice, axis=2).sum()) / 2


def shaded(
    colors: NDArray[np.float64],
    corners: NDArray[np.float64],
    light: NDArray[np.float64],
    least: float,
) -> NDArray[np.float64]:
    """Returns the shaded colours [faces, 3] of faces with corners
    [faces, 4, 3]. Brightness falls from 1 to `least` with the angle between a
    face's normal and `light`, a unit vector."""
    normals = np.cross(
        corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    )
    length = np.maximum(np.linalg.norm(normals, axis=1), 1e-12)
    shade = least + (1 - least) * np.abs(normals @ light) / length
    return colors * shade[:, None]
