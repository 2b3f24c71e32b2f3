# SPDX-License-Identifier: Apache-2.0
"""Reads meshes and point clouds of digitised plants."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import Error
from .blades import Blade, Floats, from_cloud, locate_stalk, on_stalk

_POINTS = 6000
"""The number of points sampled on the mesh of a leaf."""
_NO_LEAF = re.compile(r"(?i)stalk|stem|sheath|tassel|ear\b|soil|ground")


def _read_parts(path: Path) -> dict[str, tuple[Floats, float]]:
    """Returns points distributed evenly over each part of a file, and the area
    of the part. Parts are the groups or objects of an OBJ file, or the colours
    of a PLY file."""
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
            f"{path}: vertices have no colours, by which leaves are "
            "distinguished; give each leaf a colour"
        )
    kinds, colour_index = np.unique(
        colours[:, :3], axis=0, return_inverse=True
    )
    parts = {}
    for i, colour in enumerate(kinds):
        name = (
            "stalk" if not colour.any() else f"colour {tuple(colour.tolist())}"
        )
        is_part = colour_index.ravel() == i
        faces = getattr(whole, "faces", None)
        if faces is not None and len(faces):
            whole_faces = faces[is_part[faces].all(axis=1)]
            if len(whole_faces):
                parts[name] = _evenly(
                    trimesh.Trimesh(whole.vertices, whole_faces, process=False)
                )
        else:
            parts[name] = (np.asarray(whole.vertices)[is_part], np.nan)
    return parts


def _evenly(mesh: Any) -> tuple[Floats, float]:
    """Returns points distributed evenly over a mesh, and its area."""
    points, _ = mesh.sample(_POINTS, return_index=True, seed=1)
    return np.asarray(points, float), float(mesh.area)


def read_clouds(path: Path, unit: str, ground: float) -> list[Blade]:
    """Returns the blades of the parts of a file that are leaves. A missing
    stalk is assumed where most blades have an end. ground: z of the soil; NaN:
    the lowest z of all points."""
    parts = _read_parts(path)
    leaves = {x: part for x, part in parts.items() if not _NO_LEAF.search(x)}
    stalk = [points for x, (points, _) in parts.items() if x not in leaves]
    if not leaves:
        return []
    cloud = np.vstack([*stalk, *(points for points, _ in leaves.values())])
    if np.isnan(ground):
        ground = cloud[:, 2].min()
    ends = [_ends(points) for points, _ in leaves.values()]
    axis = (
        np.median(np.vstack(stalk)[:, :2], axis=0)
        if stalk
        else locate_stalk(np.array(ends))
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
