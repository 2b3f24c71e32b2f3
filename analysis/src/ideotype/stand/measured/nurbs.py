# SPDX-License-Identifier: Apache-2.0
"""Reads NURBS surfaces of digitised leaves."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from scipy.interpolate import BSpline

from ...errors import Error
from .blades import Blade, Floats, locate_stalk, on_stalk


def read_nurbs(path: Path, unit: str, ground: float) -> list[Blade]:
    """Returns the blades of a file of NURBS surfaces, in metres from the foot
    of the stalk, which is assumed where most blades have an end. ground: z of
    the soil; NaN: the lowest z of all blades."""
    blades = _nurbs(path)
    if not blades:
        return []
    if np.isnan(ground):
        ground = min(
            (b.midrib if b.points is None else b.points)[:, 2].min()
            for b in blades
        )
    axis = locate_stalk(np.array([blade.midrib[[0, -1]] for blade in blades]))
    return on_stalk(blades, unit, axis, ground)


def _numbers(path: Path) -> Iterator[tuple[int, list[float]]]:
    """Yields the lines of a file that contain only numbers, with their line
    numbers."""
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
    """Reads the surfaces of a file. Each has the dimension 3, degrees, sizes,
    the knots of both directions, and control points x y z w, in either index
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
        blades.append(
            _make_blade(f"surface {number}", net, degrees, sizes, knots)
        )
    return blades


def _make_blade(
    name: str,
    net: Floats,
    degrees: list[int],
    sizes: list[int],
    knots: list[Floats],
) -> Blade:
    """Returns the blade of a net of control points. The index order is the one
    with the smaller distances between neighbours."""
    orders = [
        net.reshape(sizes[1], sizes[0], 4).transpose(1, 0, 2),
        net.reshape(sizes[0], sizes[1], 4),
    ]

    def distance(grid: Floats) -> float:
        return float(
            sum(
                np.linalg.norm(np.diff(grid[..., :3], axis=axis), axis=2).sum()
                for axis in (0, 1)
            )
        )

    grid = min(orders, key=distance)
    weighted = grid[..., :3] * grid[..., 3:]
    homogeneous = np.concatenate([weighted, grid[..., 3:]], axis=2)
    steps = (13, 61)
    for axis in (0, 1):
        k, n = degrees[axis], sizes[axis]
        at = np.linspace(knots[axis][k], knots[axis][n], steps[axis])
        spline = BSpline(knots[axis], np.moveaxis(homogeneous, axis, 0), k)
        homogeneous = np.moveaxis(spline(at), 0, axis)
    surface = homogeneous[..., :3] / homogeneous[..., 3:]
    # The longer direction is that of the midrib.
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
