# SPDX-License-Identifier: Apache-2.0
"""The meshes of the benchmark, each made by a function."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np


@dataclass
class Mesh:
    """Flat quadrilaterals [m] over a cell that repeats; z is up.

    `corners` contains an array [4, 3] for each face, counter-clockwise as seen
    from its upper side, and `groups` the name of the organ of each face."""

    period: tuple[float, float]
    corners: list[np.ndarray] = field(default_factory=list)
    groups: list[str] = field(default_factory=list)

    def add(self, group: str, *corners: tuple[float, float, float]) -> None:
        self.corners.append(np.round(np.array(corners, float), 9))
        self.groups.append(group)

    def level(self, group: str, x: tuple[float, float], height: float) -> None:
        """Adds a horizontal strip along the whole cell in y."""
        y = self.period[1]
        self.add(
            group,
            (x[0], 0, height),
            (x[1], 0, height),
            (x[1], y, height),
            (x[0], y, height),
        )

    @property
    def names(self) -> list[str]:
        return list(dict.fromkeys(self.groups))

    @property
    def area(self) -> np.ndarray:
        """Returns the one-sided area of each face [m2]."""
        c = np.array(self.corners)
        return (
            np.linalg.norm(
                np.cross(c[:, 2] - c[:, 0], c[:, 3] - c[:, 1]), axis=1
            )
            / 2
        )


def sheets(number: int) -> Mesh:
    mesh = Mesh((1, 1))
    for i in range(number):
        mesh.level(f"leaf{i + 1:02d}", (0, 1), 0.2 * (i + 1))
    return mesh


def beer(layers: int) -> Mesh:
    """Returns layers of strips. Each layer covers half of the area of any
    layer above it, in every direction, so that it intercepts exactly half of
    the light."""
    mesh = Mesh((1, 1))
    for i in range(layers):
        strips = 2**i
        for j in range(strips):
            left = j / strips
            mesh.level(
                f"leaf{i + 1:02d}",
                (left, left + 0.5 / strips),
                0.9 - 0.8 * i / layers,
            )
    return mesh


def walls() -> Mesh:
    """Returns hedges without thickness, 0.6 m high and 1 m apart."""
    mesh = Mesh((1, 1))
    mesh.add("leaf01", (0.5, 0, 0), (0.5, 1, 0), (0.5, 1, 0.6), (0.5, 0, 0.6))
    return mesh


def strips() -> Mesh:
    mesh = Mesh((1, 1))
    mesh.level("leaf01", (0.1, 0.5), 0.3)
    mesh.level("leaf02", (0.3, 0.7), 0.6)
    return mesh


def panels(tilt: float, width: float, pitch: float, height: float) -> Mesh:
    """Returns a row of modules with their front to the west (270 deg), for
    which infinite sheds are computed."""
    mesh = Mesh((pitch, 1))
    angle = np.radians(tilt)
    dx, dz = width / 2 * np.cos(angle), width / 2 * np.sin(angle)
    x = pitch / 2
    mesh.add(
        "panel",
        (x - dx, 0, height - dz),
        (x + dx, 0, height + dz),
        (x + dx, 1, height + dz),
        (x - dx, 1, height - dz),
    )
    return mesh


def scattered(number: int, side: float, lean: float, seed: int) -> Mesh:
    """Returns randomly placed square leaves. Their zenith angles have the
    density of the sine times a power of the cosine (`lean` > 0: flat leaves)
    or of the sine (`lean` < 0: erect leaves)."""
    random = np.random.default_rng(seed)
    mesh = Mesh((1, 1))
    for i in range(number):
        u = random.random()
        if lean >= 0:
            cosine = u ** (1 / (1 + lean))
        else:
            cosine = np.sin(np.arcsin(u) * (1 / (1 - lean)))
        zenith, turn, spin = np.arccos(cosine), *random.random(2) * 2 * np.pi
        normal = np.array(
            [
                np.sin(zenith) * np.cos(turn),
                np.sin(zenith) * np.sin(turn),
                np.cos(zenith),
            ]
        )
        a = np.cross(normal, [np.cos(spin), np.sin(spin), 0.1])
        a *= side / 2 / np.linalg.norm(a)
        b = np.cross(normal, a)
        middle = np.array([*random.random(2), 0.25 + 0.7 * random.random()])
        mesh.add(
            f"leaf{1 + i * 4 // number:02d}",
            *(
                tuple(middle + s * a + t * b)
                for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))
            ),
        )
    return mesh


def plant(
    period: tuple[float, float],
    leaves: int,
    segments: int,
    length: float,
    width: float,
    stalk: float,
    rise: tuple[float, float],
    turn: float,
    at: tuple[float, float] = (0.5, 0.5),
    prefix: str = "",
    mesh: Mesh | None = None,
) -> Mesh:
    """Returns the leaves of a stalk. Each leaf consists of flat pieces that
    taper. They rise by `rise[0]` at the base and bend by `rise[1]` to the tip
    [deg]. Successive leaves differ by `turn` in azimuth [deg]."""
    mesh = mesh or Mesh(period)
    foot = np.array([at[0] * period[0], at[1] * period[1], 0.0])
    for i in range(leaves):
        azimuth = np.radians(i * turn + 20)
        out = np.array([np.cos(azimuth), np.sin(azimuth), 0])
        across = np.array([-out[1], out[0], 0])
        point = foot + np.array([0, 0, 0.05 + stalk * i / max(leaves - 1, 1)])
        for j in range(segments):
            angle = np.radians(rise[0] - rise[1] * (j + 0.5) / segments)
            step = np.array([*(np.cos(angle) * out[:2]), np.sin(angle)])
            end = point + length / segments * step
            end[2] = max(end[2], 0.02)
            wide = [
                width / 2 * np.sqrt(1 - (j + k) / (segments + 0.3))
                for k in (0, 1)
            ]
            mesh.add(
                f"{prefix}leaf{i + 1:02d}",
                tuple(point - wide[0] * across),
                tuple(end - wide[1] * across),
                tuple(end + wide[1] * across),
                tuple(point + wide[0] * across),
            )
            point = end
    return mesh


def mixture() -> Mesh:
    mesh = plant(
        (1, 0.3), 6, 3, 0.6, 0.09, 0.9, (60, 100), 180, (0.25, 0.5), "tall_"
    )
    return plant(
        (1, 0.3),
        5,
        2,
        0.25,
        0.12,
        0.25,
        (30, 50),
        144,
        (0.75, 0.5),
        "low_",
        mesh,
    )


MESHES: dict[str, Callable[[], Mesh]] = {
    "sheet1": lambda: sheets(1),
    "sheet2": lambda: sheets(2),
    "sheet5": lambda: sheets(5),
    "beer2": lambda: beer(2),
    "beer4": lambda: beer(4),
    "beer6": lambda: beer(6),
    "walls": walls,
    "strips": strips,
    "panels_tilted": lambda: panels(30, 2, 5, 1.5),
    "panels_dense": lambda: panels(20, 2, 3, 1.0),
    "panels_upright": lambda: panels(90, 1.6, 6, 1.2),
    "spherical": lambda: scattered(24, 0.25, 0, 1),
    "erect": lambda: scattered(20, 0.25, -1, 2),
    "flat": lambda: scattered(20, 0.25, 2, 3),
    "rosette": lambda: plant(
        (0.4, 0.4), 8, 3, 0.28, 0.08, 0.06, (50, 70), 137.5
    ),
    "maize": lambda: plant((0.76, 0.2), 8, 4, 0.7, 0.09, 1.2, (65, 110), 170),
    "mixture": mixture,
}


def write_obj(mesh: Mesh, path: Path) -> None:
    lines = ["# Metres, z up. Made by make.py."]
    count, group = 0, ""
    for name, corners in zip(mesh.groups, mesh.corners):
        lines += [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in corners]
        if name != group:
            lines.append(f"g {name}")
            group = name
        lines.append("f " + " ".join(str(count + i) for i in (1, 2, 3, 4)))
        count += 4
    path.write_text("\n".join(lines) + "\n")


def read_obj(path: Path, period: tuple[float, float]) -> Mesh:
    mesh, vertices, group = Mesh(period), [], ""
    for line in path.read_text().splitlines():
        kind, *words = line.split()
        if kind == "v":
            vertices.append(tuple(map(float, words)))
        elif kind == "g":
            group = words[0]
        elif kind == "f":
            mesh.add(group, *(vertices[int(i) - 1] for i in words))
    return mesh
