# SPDX-License-Identifier: Apache-2.0
"""Meshes of any shape and the light that they absorb."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .canopy import Canopy


def mesh(
    vertices: ArrayLike,
    faces: ArrayLike | Sequence[Sequence[int]],
    *,
    groups: Sequence[str] | None = None,
) -> Canopy:
    """Returns a canopy of any surfaces, such as meshes from trimesh, PlantGL
    or another plant model.

    vertices: [vertices, 3] in metres; x is east, y is north, z is up.
    faces: [faces, 3], [faces, 4], or a list of polygons of any number of
        corners, counted from 0; polygons are divided into triangles like the
        polygons of OBJ files.
    groups: name of the organ of each face [faces]; "leaf" by default.

    Raises Error if shapes disagree, or an index or coordinate is invalid."""
    from .canopy import Canopy

    return Canopy(vertices, faces, groups)
