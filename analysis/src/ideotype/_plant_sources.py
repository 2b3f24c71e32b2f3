# SPDX-License-Identifier: Apache-2.0
"""Reads files of digitised plants: midribs, NURBS surfaces, meshes and point
clouds."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from scipy.interpolate import BSpline

from ._blades import Blade, Floats, axis_of, from_cloud, parts
from ._errors import Error

_UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001}
_POINTS = 6000
"""The number of points that are drawn on the mesh of a leaf."""


def read_plant(
    path: Path,
    plant: str | None = None,
    leaves: Path | None = None,
    unit: str = "auto",
    ground: float = np.nan,
) -> list[Blade]:
    """Returns the blades of a digitised plant, lowest first.

    path: CSV of midribs, DAT of NURBS surfaces, or OBJ or PLY with a group,
        object or colour for each leaf.
    plant: name in the column `plant` of a CSV file.
    leaves: CSV of further measures of each leaf of a CSV file.
    unit: "m", "cm", "mm" or "auto".
    ground: z of the soil in this unit; NaN: that of the lowest point.

    Raises Error with the line of what cannot be read."""
    if not path.is_file():
        raise Error(f"{path}: there is no such file")
    suffix = path.suffix.lower()
    if suffix == ".csv":
        blades = _midribs(path, plant, leaves, unit)
    elif suffix in {".dat", ".txt"}:
        blades = _on_stalk(_nurbs(path), unit, ground)
    elif suffix in {".obj", ".ply"}:
        blades = _clouds(path, unit, ground)
    else:
        raise Error(
            f"{path}: give a CSV file of midribs, a DAT file of NURBS surfaces, "
            "or an OBJ or PLY file"
        )
    if not blades:
        raise Error(f"{path}: no leaf is in it")
    if suffix != ".csv":
        blades.sort(key=lambda blade: blade.midrib[0, 2])
    return blades


def _factor(unit: str, lengths: list[float]) -> float:
    """Returns a unit in metres; auto takes the longest unit in which the
    median leaf has 0.05 to 3 m."""
    if unit != "auto":
        return _UNITS[unit]
    median = float(np.median(lengths))
    for name in ("m", "cm", "mm"):
        if 0.05 <= median * _UNITS[name] <= 3:
            return _UNITS[name]
    raise Error(
        f"the median leaf is {median:g} long, which is no leaf in m, cm or mm; "
        "tell its unit by --unit"
    )


# Midribs.


def _column(
    table: pd.DataFrame, names: str
) -> tuple[pd.Series, str | None] | None:
    """Returns the column with one of these names, and its unit if it has
    one."""
    for column in table:
        if match := re.fullmatch(rf"(?:{names})(?:_(m|cm|mm))?", str(column)):
            return table[column], match[1]
    return None


def _table(path: Path) -> pd.DataFrame:
    try:
        table = pd.read_csv(path, comment="#", skipinitialspace=True)
    except (OSError, ValueError) as error:
        raise Error(f"{path}: {error}") from None
    table.columns = table.columns.str.strip().str.lower()
    return table


def _midribs(
    path: Path, plant: str | None, leaves: Path | None, unit: str
) -> list[Blade]:
    table = _table(path)
    if "plant" in table:
        names = list(dict.fromkeys(table["plant"].astype(str)))
        if plant is None and len(names) == 1:
            plant = names[0]
        if plant not in names:
            raise Error(
                f"{path}: name one of its plants by --plant: {', '.join(names)}"
            )
        table = table[table["plant"].astype(str) == plant]
    found = {
        "out": _column(table, "x|out|r|x_along|distance"),
        "up": _column(table, "z|up|z_up|height"),
        "side": _column(table, "y|side|y_across"),
    }
    for name, each in found.items():
        if each is None and name != "side":
            raise Error(
                f"{path}:1: there is no column of the points {name}; name it "
                f"{'x' if name == 'out' else 'z'}_m, _cm or _mm"
            )
    if "leaf" not in table:
        raise Error(
            f"{path}:1: there is no column leaf, the rank of each point"
        )
    points = np.zeros((len(table), 3))
    told = None
    for axis, name in enumerate(("side", "out", "up")):
        if (each := found[name]) is not None:
            told = told or each[1]
            try:
                points[:, axis] = each[0].astype(float)
            except ValueError as error:
                raise Error(
                    f"{path}: a number cannot be read ({error})"
                ) from None
    bad = ~np.isfinite(points).all(axis=1)
    points, table = points[~bad], table[~bad]
    keys = ["leaf", *(n for n in ("number", "sample") if n in table)]
    lines: dict[int, list[Floats]] = {}
    for _, rows in table.reset_index(drop=True).groupby(keys, sort=True):
        line = points[rows.index]
        if len(line) > 1 and np.ptp(line, axis=0).max() > 0:
            lines.setdefault(int(rows["leaf"].iloc[0]), []).append(line)
    if not lines:
        raise Error(f"{path}: no leaf has two points that differ")
    factor = _factor(
        told or unit,
        [
            float(np.linalg.norm(np.diff(each, axis=0), axis=1).sum())
            for several in lines.values()
            for each in several
        ],
    )
    more = _measures(leaves, plant) if leaves else {}
    if leaves and (without := sorted(lines.keys() - more.keys())):
        raise Error(
            f"{leaves}: leaf {without[0]} of {path.name} is not in this table; "
            "add it, or take its midrib out"
        )
    return [
        _flat_blade(
            rank, [factor * line for line in several], more.get(rank, {})
        )
        for rank, several in sorted(lines.items())
    ]


def _flat_blade(
    rank: int, lines: list[Floats], more: dict[str, float]
) -> Blade:
    """Returns the mean of the digitisations of a leaf, at equal parts of their
    lengths, with the length, width and height that were measured."""
    at = np.linspace(0, 1, 41)
    mean = np.mean(
        [
            np.column_stack([np.interp(at, parts(x), part) for part in x.T])
            for x in lines
        ],
        axis=0,
    )
    height = more.get("insertion_height", 0.0)
    size = float(np.linalg.norm(np.diff(mean, axis=0), axis=1).sum())
    midrib = (mean - mean[0]) * more.get("length", size) / size
    turn = np.radians(more.get("azimuth", 0.0))
    rotation = np.array(
        [
            [np.cos(turn), np.sin(turn), 0],
            [-np.sin(turn), np.cos(turn), 0],
            [0, 0, 1],
        ]
    )
    return Blade(
        f"leaf {rank}",
        midrib @ rotation.T + np.array([0, 0, height]),
        has_azimuth="azimuth" in more,
        has_height="insertion_height" in more,
        told_width=more.get("width"),
    )


def _measures(path: Path, plant: str | None) -> dict[int, dict[str, float]]:
    """Returns lengths, widths and heights [m] and azimuths [deg] by rank, from
    a table as docs/plant.md describes it, which may have a column of
    plants."""
    table = _table(path)
    if "plant" in table:
        table = table[table["plant"].astype(str) == plant]
    rank = (
        table["leaf"]
        if "leaf" in table
        else pd.Series(range(1, len(table) + 1))
    )
    found: dict[int, dict[str, float]] = {int(each): {} for each in rank}
    for name in ("length", "width", "insertion_height"):
        if (column := _column(table, name)) is None:
            continue
        values, unit = column
        for i, value in zip(rank, values, strict=True):
            if np.isfinite(value):
                found[int(i)][name] = float(value) * _UNITS[unit or "m"]
    for name in ("azimuth_from_row_clockwise_deg", "azimuth_deg"):
        if name in table:
            for i, value in zip(rank, table[name], strict=True):
                found[int(i)]["azimuth"] = float(value)
    return found


# NURBS surfaces.


def _numbers(path: Path) -> Iterator[tuple[int, list[float]]]:
    """Yields the lines of a file that are numbers, with where they are."""
    for at, line in enumerate(
        path.read_text(errors="replace").splitlines(), 1
    ):
        try:
            numbers = [
                float(word) for word in re.split(r"[\s,;]+", line.strip())
            ]
        except ValueError:
            continue
        yield at, numbers


def _nurbs(path: Path) -> list[Blade]:
    """Reads surfaces that follow each other: dimension 3, degrees, sizes,
    knots of both directions, and the control points x y z w, in either
    order."""
    lines = list(_numbers(path))
    starts = [
        i
        for i in range(len(lines) - 4)
        if lines[i][1] == [3.0]
        and len(lines[i + 1][1]) == 2
        and len(lines[i + 2][1]) == 2
    ]
    blades = []
    for number, start in enumerate(starts, 1):
        here = lines[start][0]
        degrees = [int(x) for x in lines[start + 1][1]]
        sizes = [int(x) for x in lines[start + 2][1]]
        knots = [np.array(lines[start + i][1]) for i in (3, 4)]
        count = sizes[0] * sizes[1]
        points = [x for _, x in lines[start + 5 : start + 5 + count]]
        if (
            any(
                len(k) != d + n + 1
                for k, d, n in zip(knots, degrees, sizes, strict=True)
            )
            or len(points) < count
            or {len(x) for x in points} - {3, 4}
            or len({len(x) for x in points}) != 1
        ):
            raise Error(
                f"{path}:{here}: the surface that begins here does not have the "
                f"knots and the {count} control points of its degrees and sizes"
            )
        net = np.array(points)
        if net.shape[1] == 3:
            net = np.column_stack([net, np.ones(count)])
        blades.append(_of_net(f"surface {number}", net, degrees, sizes, knots))
    return blades


def _of_net(
    name: str,
    net: Floats,
    degrees: list[int],
    sizes: list[int],
    knots: list[Floats],
) -> Blade:
    """Returns the blade of a net of control points, whichever index runs
    fastest: in the order that is meant, neighbours are near each other."""
    orders = [
        net.reshape(sizes[1], sizes[0], 4).transpose(1, 0, 2),
        net.reshape(sizes[0], sizes[1], 4),
    ]

    def way(grid: Floats) -> float:
        return float(
            sum(
                np.linalg.norm(np.diff(grid[..., :3], axis=axis), axis=2).sum()
                for axis in (0, 1)
            )
        )

    grid = min(orders, key=way)
    weighted = grid[..., :3] * grid[..., 3:]
    homogeneous = np.concatenate([weighted, grid[..., 3:]], axis=2)
    steps = (13, 61)
    for axis in (0, 1):
        k, n = degrees[axis], sizes[axis]
        at = np.linspace(knots[axis][k], knots[axis][n], steps[axis])
        spline = BSpline(knots[axis], np.moveaxis(homogeneous, axis, 0), k)
        homogeneous = np.moveaxis(spline(at), 0, axis)
    surface = homogeneous[..., :3] / homogeneous[..., 3:]
    # The blade is longer than wide.
    along = [
        np.linalg.norm(np.diff(surface, axis=axis), axis=2)
        .sum(axis=axis)
        .mean()
        for axis in (0, 1)
    ]
    if along[0] > along[1]:
        surface = surface.transpose(1, 0, 2)
    a, b, c, d = (
        surface[:-1, :-1], surface[1:, :-1], surface[1:, 1:], surface[:-1, 1:],
    )  # fmt: skip
    area = np.linalg.norm(np.cross(c - a, d - b), axis=2).sum() / 2
    return Blade(
        name,
        midrib=surface[len(surface) // 2],
        left=surface[0],
        right=surface[-1],
        points=surface.reshape(-1, 3),
        area=float(area),
    )


def _on_stalk(blades: list[Blade], unit: str, ground: float) -> list[Blade]:
    """Returns the blades in metres about their stalk, which is where most of
    them have an end. ground: z of the soil, NaN for the lowest point of
    all."""
    if not blades:
        return []
    factor = _factor(unit, [blade.length for blade in blades])
    if np.isnan(ground):
        ground = min(
            (b.midrib if b.points is None else b.points)[:, 2].min()
            for b in blades
        )
    axis = axis_of(np.array([blade.midrib[[0, -1]] for blade in blades]))
    origin = np.array([*axis, ground])
    return [blade.on_stalk(origin, factor) for blade in blades]


# Meshes and clouds of points.


def _parts_of(path: Path) -> dict[str, tuple[Floats, float]]:
    """Returns points that lie evenly on each part of a file, and its area.
    Parts are groups or objects of an OBJ file, and colours of a PLY file."""
    try:
        import trimesh
    except ImportError:
        raise Error(
            f"{path}: meshes are read by trimesh; pip install 'ideotype[fit]'"
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
        raise Error(f"{path}: its vertices have no colours, which tell leaves")
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
    """Returns points that lie evenly on a mesh, and its area."""
    points, _ = mesh.sample(_POINTS, return_index=True, seed=1)
    return np.asarray(points, float), float(mesh.area)


def _clouds(path: Path, unit: str, ground: float) -> list[Blade]:
    """Returns blades of the parts that are no stalk; without a stalk it is
    where most of them have an end."""
    found = _parts_of(path)
    stalk = [
        points
        for name, (points, _) in found.items()
        if re.search(r"(?i)stalk|stem|sheath|tassel|ear\b|soil|ground", name)
    ]
    leaves = {
        name: each
        for name, each in found.items()
        if not re.search(
            r"(?i)stalk|stem|sheath|tassel|ear\b|soil|ground", name
        )
    }
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
    factor = _factor(unit, [blade.length for blade in blades])
    origin = np.array([*axis, ground])
    return [blade.on_stalk(origin, factor) for blade in blades]


def _ends(points: Floats) -> Floats:
    """Returns two points of a cloud that are far apart."""
    first = points[
        np.linalg.norm(points - points.mean(axis=0), axis=1).argmax()
    ]
    second = points[np.linalg.norm(points - first, axis=1).argmax()]
    return np.array([first, second])
