# SPDX-License-Identifier: Apache-2.0
"""Measured leaf blades."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, dijkstra
from scipy.spatial import cKDTree

from ...errors import Error

Floats = NDArray[np.float64]

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001}
_NEIGHBOURS = 16
"""The number of nearest neighbours to which paths along the blade may lead
from a point of a cloud."""
_SLICES = 24
"""The number of cross sections of a point cloud."""


@dataclass(frozen=True)
class Blade:
    """The midrib of a leaf and other measurements of its blade, in metres: z
    points up from the soil, x to the right of the row and y along the row."""

    name: str
    midrib: Floats
    """The points of the midrib from base to tip [points, 3]."""
    has_azimuth: bool = True
    has_height: bool = True
    """Whether azimuth and insertion height were measured."""
    left: Floats | None = None
    """The left edge of the blade at each point of the midrib."""
    right: Floats | None = None
    points: Floats | None = None
    """Points distributed evenly over the blade [points, 3]."""
    area: float = np.nan
    """The one-sided area of the blade [m2]."""
    stated_width: float | None = None
    """A width that was measured without edges [m]."""

    @property
    def length(self) -> float:
        """The length of the midrib [m]."""
        return float(
            np.linalg.norm(np.diff(self.midrib, axis=0), axis=1).sum()
        )

    @property
    def width(self) -> float | None:
        """The largest width [m], if any was measured."""
        if self.stated_width is not None or self.left is None:
            return self.stated_width
        assert self.right is not None
        return float(
            (
                np.linalg.norm(self.left - self.midrib, axis=1)
                + np.linalg.norm(self.right - self.midrib, axis=1)
            ).max()
        )

    @cached_property
    def azimuth(self) -> float:
        """The azimuth of the blade, clockwise from the row [deg]: the
        direction of the mean horizontal displacement from the base."""
        x, y, _ = (self.midrib - self.midrib[0]).mean(axis=0)
        return float(np.degrees(np.arctan2(x, y)))

    @property
    def in_its_plane(self) -> tuple[Floats, Floats]:
        """The coordinates of the midrib in its vertical plane, outward from
        the base and up [m]."""
        turn = np.radians(self.azimuth)
        x, y, z = (self.midrib - self.midrib[0]).T
        return x * np.sin(turn) + y * np.cos(turn), z

    @property
    def out_of_plane(self) -> float:
        """The root mean square distance of the midrib from its plane [m]."""
        turn = np.radians(self.azimuth)
        x, y, _ = (self.midrib - self.midrib[0]).T
        return float(
            np.sqrt(((x * np.cos(turn) - y * np.sin(turn)) ** 2).mean())
        )

    @property
    def roll_and_twist(self) -> tuple[float, float]:
        """The roll, the mean rotation of the cross sections about the midrib,
        and the twist, its slope from base to tip [deg], by least squares
        weighted by width; both are 0 without edges."""
        if self.left is None or self.right is None:
            return 0.0, 0.0
        across = self.right - self.left
        width = np.linalg.norm(across, axis=1)
        along = np.gradient(self.midrib, axis=0)
        along /= np.maximum(np.linalg.norm(along, axis=1), 1e-12)[:, None]
        turn = np.radians(self.azimuth)
        level = np.array([np.cos(turn), -np.sin(turn), 0.0])
        normal = np.cross(along, level)
        angle = np.arctan2((across * normal).sum(1), across @ level)
        angle = np.degrees(np.unwrap(angle, period=np.pi))
        s = parts(self.midrib)
        design = np.column_stack([np.ones(len(s)), s - 0.5])
        (roll, twist), *_ = np.linalg.lstsq(
            design * width[:, None], angle * width, rcond=None
        )
        return float((roll + 90) % 180 - 90), float(twist)

    def on_stalk(self, origin: Floats, factor: float) -> Blade:
        """Returns the blade, from its end nearer to the stalk, in metres from
        `origin`, the foot of the stalk. factor: metres per unit of this
        blade."""
        ends = np.linalg.norm(self.midrib[[0, -1], :2] - origin[:2], axis=1)
        step = 1 if ends[0] <= ends[1] else -1

        def moved(points: Floats | None) -> Floats | None:
            return (
                None if points is None else (points[::step] - origin) * factor
            )

        midrib = moved(self.midrib)
        assert midrib is not None
        return replace(
            self,
            midrib=midrib,
            left=moved(self.left),
            right=moved(self.right),
            points=moved(self.points),
            area=self.area * factor**2,
        )


def parts(line: Floats) -> Floats:
    """Returns the fraction of the length of a line before each of its points,
    0 to 1."""
    sizes = np.linalg.norm(np.diff(line, axis=0), axis=1)
    length = np.concatenate([[0.0], np.cumsum(sizes)])
    if length[-1] == 0:
        raise Error(
            "a midrib has no two points that differ; give points from the "
            "base to the tip"
        )
    return length / length[-1]


def locate_stalk(ends: Floats) -> Floats:
    """Returns the position of a stalk [x, y]: the point with the least median
    distance to the nearer end of each leaf. ends: ends of the leaves
    [leaves, 2, 3]."""
    candidates = ends.reshape(-1, 3)[:, :2]
    for _ in range(3):
        apart = np.linalg.norm(
            ends[None, :, :, :2] - candidates[:, None, None, :], axis=3
        )
        best = candidates[np.median(apart.min(axis=2), axis=1).argmin()]
        nearest = np.linalg.norm(ends[:, :, :2] - best, axis=2).argmin(axis=1)
        chosen = ends[np.arange(len(ends)), nearest, :2]
        candidates = np.vstack([best, np.median(chosen, axis=0)])
    return best


def metres(unit: str, lengths: list[float]) -> float:
    """Returns the size of a unit [m]. "auto" is the longest unit for which the
    median leaf length is 0.05 to 3 m."""
    if unit != "auto":
        return UNITS[unit]
    median = float(np.median(lengths))
    for name in ("m", "cm", "mm"):
        if 0.05 <= median * UNITS[name] <= 3:
            return UNITS[name]
    raise Error(
        f"the median leaf length is {median:g}, implausible in m, cm and mm; "
        "give the unit by --unit"
    )


def on_stalk(
    blades: list[Blade], unit: str, axis: Floats, ground: float
) -> list[Blade]:
    """Returns blades in metres from the foot of their stalk, which stands at
    `axis` [x, y] on soil at height `ground`."""
    factor = metres(unit, [blade.length for blade in blades])
    origin = np.array([*axis, ground])
    return [blade.on_stalk(origin, factor) for blade in blades]


def from_cloud(name: str, points: Floats, axis: Floats, area: float) -> Blade:
    """Returns the blade of a point cloud with even coverage. Its cross
    sections are slices of equal distance from the base along shortest paths
    over the blade; the base are the points nearest to the axis of the stalk
    [x, y]."""
    if len(points) < 5 * _SLICES:
        raise Error(
            f"{name} has {len(points)} points; {5 * _SLICES} are needed"
        )
    along = _distance_from_base(points, axis)
    points, along = points[np.isfinite(along)], along[np.isfinite(along)]
    for _ in range(3):
        along = _projected(points, _sections(points, along)[0])
    line, left, right = _sections(points, along)
    return Blade(name, line, left=left, right=right, points=points, area=area)


def _distance_from_base(points: Floats, axis: Floats) -> Floats:
    """Returns the distances of points from the base along shortest paths over
    nearest neighbours (Dijkstra); infinite if there is no path."""
    apart, near = cKDTree(points).query(points, _NEIGHBOURS + 1)
    rows = np.repeat(np.arange(len(points)), _NEIGHBOURS)
    graph = csr_array(
        (apart[:, 1:].ravel(), (rows, near[:, 1:].ravel())),
        (len(points), len(points)),
    )
    _, piece = connected_components(graph, directed=False)
    largest = piece == np.bincount(piece).argmax()
    from_axis = np.linalg.norm(points[:, :2] - axis, axis=1)
    from_axis[~largest] = np.inf
    base = np.argsort(from_axis)[: max(3, len(points) // 200)]
    return np.asarray(
        dijkstra(graph, directed=False, indices=base, min_only=True)
    )


def _sections(points: Floats, along: Floats) -> tuple[Floats, Floats, Floats]:
    """Returns the midrib through the middles of slices, and the left and right
    edges of the slices."""
    edges = np.linspace(along.min(), along.max(), _SLICES + 1)
    slices = np.clip(
        np.searchsorted(edges, along, "right") - 1, 0, _SLICES - 1
    )
    kept = [i for i in range(_SLICES) if (slices == i).sum() > 3]
    centre = np.array([points[slices == i].mean(axis=0) for i in kept])
    tangent = np.gradient(centre, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    left, right, middle = [], [], []
    previous = None
    for i, c, t in zip(kept, centre, tangent, strict=True):
        here = points[slices == i]
        flat = (here - c) - ((here - c) @ t)[:, None] * t
        direction = np.linalg.svd(flat, full_matrices=False)[2][0]
        if previous is not None and direction @ previous < 0:
            direction = -direction
        previous = direction
        at = flat @ direction
        low, high = np.quantile(at, [0.01, 0.99]) / 0.98
        # The midrib of a folded blade is its keel.
        inner = np.abs(at - (low + high) / 2) < max(0.15 * (high - low), 1e-4)
        keel = c + (flat[inner].mean(axis=0) if inner.any() else 0)
        middle.append(keel)
        left.append(keel + (low - (low + high) / 2) * direction)
        right.append(keel + (high - (low + high) / 2) * direction)
    line = np.array(middle)
    # The line is extended to the ends of the first and last slice.
    first = line[0] - tangent[0] * max(
        0.0, -((points[slices == kept[0]] - line[0]) @ tangent[0]).min()
    )
    last = line[-1] + tangent[-1] * max(
        0.0, ((points[slices == kept[-1]] - line[-1]) @ tangent[-1]).max()
    )
    return (
        np.vstack([first, line, last]),
        np.vstack([left[0] + first - line[0], left, last]),
        np.vstack([right[0] + first - line[0], right, last]),
    )


def _projected(points: Floats, line: Floats) -> Floats:
    """Returns the distance along a line to the position nearest to each
    point."""
    steps = np.diff(line, axis=0)
    sizes = np.linalg.norm(steps, axis=1)
    at = ((points[:, None] - line[None, :-1]) * steps).sum(2) / sizes**2
    # The first and the last segment extend beyond the ends of the line.
    lower = np.zeros(len(steps))
    upper = np.ones(len(steps))
    lower[0], upper[-1] = -np.inf, np.inf
    at = np.clip(at, lower, upper)
    near = line[None, :-1] + at[:, :, None] * steps
    segment = np.linalg.norm(points[:, None] - near, axis=2).argmin(axis=1)
    start = np.concatenate([[0.0], np.cumsum(sizes)])[segment]
    within = at[np.arange(len(points)), segment] * sizes[segment]
    return np.asarray(start + within)
