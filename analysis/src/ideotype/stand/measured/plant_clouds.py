# SPDX-License-Identifier: Apache-2.0
"""Reads meshes and clouds of points of digitised plants."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import Error
from .blades import Blade, Floats, axis_of, from_cloud, on_stalk

_POINTS = 6000
"""The number of points that are drawn on the mesh of a leaf."""
_NO_LEAF = re.compile(r"(?i)stalk|stem|sheath|tassel|ear\b|soil|ground")


def _parts_of(path: Path) -> dict[str, tuple[Floats, float]]:
    """Returns points that lie evenly on each part of a file, and the part's
    area. Parts are groups or objects of an OBJ file, and colours of a PLY
    file."""
    try:
        import trimesh
    except ImportError:
        raise Error(
            f"{path}: meshes are read by trimesh; pip install 'trimesh>=5.0'"
        ) from None
    try:
        whole: Any = trimesh.load(
            path, process=False, split_groups=True, split_objects=True,
            group_material=False,
        )  # fmt: skip
    except (OSError, ValueError, IndexError, KeyError) as error:
        raise Error(f"{path}: {error}") from None
    if isinstance(whole, trimesh.Scene):
        return {
            name: _evenly(mesh)
            for name, mesh in whole.geometry.items()
            if isinstance(mesh, trimesh.Trimesh)
        }
    colours = np.asarray(getattr(whole, "colors", np.empty((0, 4))))
    if not len(colours) and getattr(whole, "visual", None) is not None:
        colours = np.asarray(whole.visual.vertex_colors)
    if len(colours) != len(whole.vertices) or not len(colours):
        raise Error(
            f"{path}: its vertices have no colours, which tell leaves apart; "
            "give each leaf a colour"
        )
    kinds, of = np.unique(colours[:, :3], axis=0, return_inverse=True)
    found = {}
    for i, colour in enumerate(kinds):
        name = (
            "stalk" if not colour.any() else f"colour {tuple(colour.tolist())}"
        )
        mine = of.ravel() == i
        faces = getattr(whole, "faces", None)
        if faces is not None and len(faces):
            whole_faces = faces[mine[faces].all(axis=1)]
            if len(whole_faces):
                found[name] = _evenly(
                    trimesh.Trimesh(whole.vertices, whole_faces, process=False)
                )
        else:
            found[name] = (np.asarray(whole.vertices)[mine], np.nan)
    return found


def _evenly(mesh: Any) -> tuple[Floats, float]:
    """Returns points that lie evenly on a mesh, and the area of the mesh."""
    points, _ = mesh.sample(_POINTS, return_index=True, seed=1)
    return np.asarray(points, float), float(mesh.area)


def read_clouds(path: Path, unit: str, ground: float) -> list[Blade]:
    """Returns blades of the parts that are no stalk; a missing stalk is taken
    to stand where most blades have an end."""
    found = _parts_of(path)
    leaves = {x: each for x, each in found.items() if not _NO_LEAF.search(x)}
    stalk = [points for x, (points, _) in found.items() if x not in leaves]
    if not leaves:
        return []
    every = np.vstack([*stalk, *(points for points, _ in leaves.values())])
    if np.isnan(ground):
        ground = every[:, 2].min()
    thin = [_ends(points) for points, _ in leaves.values()]
    axis = (
        np.median(np.vstack(stalk)[:, :2], axis=0)
        if stalk
        else axis_of(np.array(thin))
    )
    blades = [
        from_cloud(name, points, axis, area)
        for name, (points, area) in leaves.items()
    ]
    return on_stalk(blades, unit, axis, ground)


def _ends(points: Floats) -> Floats:
    """Returns two points of a cloud that are far apart."""
    first = points[
        np.linalg.norm(points - points.mean(axis=0), axis=1).argmax()
    ]
    second = points[np.linalg.norm(points - first, axis=1).argmax()]
    return np.array([first, second])
