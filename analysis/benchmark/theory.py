# SPDX-License-Identifier: Apache-2.0
"""Exact values for cases with a known solution."""

from __future__ import annotations

import numpy as np
from cases import Case, material_of, mesh_of
from leaf import gross
from scipy.integrate import quad
from shapely import affinity, union_all
from shapely.geometry import Polygon, box


def sheets(case: Case) -> dict[str, float]:
    """Solves horizontal sheets that cover the ground, and soil, by linear
    equations for the light that falls on each surface and rises from it."""
    mesh = mesh_of(case)
    order = np.argsort([-c[0, 2] for c in mesh.corners])
    layers = [
        (mesh.groups[i], material_of(case, mesh.groups[i])) for i in order
    ]
    n = len(layers)
    # Unknowns: down[0..n] above each sheet and the soil, up[0..n].
    a, b = np.eye(2 * n + 2), np.zeros(2 * n + 2)
    b[0] = 1
    for i, (_, (upper, lower, through)) in enumerate(layers):
        a[i + 1, i] -= through
        a[i + 1, n + 1 + i + 1] -= lower
        a[n + 1 + i, i] -= upper
        a[n + 1 + i, n + 1 + i + 1] -= through
    a[2 * n + 1, n] -= case["soil_albedo"]
    x = np.linalg.solve(a, b)
    found = {
        "soil": x[n] * (1 - case["soil_albedo"]),
        "reflected": x[n + 1],
    }
    for i, (name, (upper, lower, through)) in enumerate(layers):
        found[name] = x[i] * (1 - upper - through) + x[n + 2 + i] * (
            1 - lower - through
        )
    return found


def beer(case: Case) -> dict[str, float]:
    """Each layer transmits half of the incident light: exp(-ln 2 i)."""
    n = len(mesh_of(case).names)
    found = {f"leaf{i + 1:02d}": 0.5 ** (i + 1) for i in range(n)}
    return found | {"soil": 0.5**n, "reflected": 0.0}


def shadow(case: Case) -> dict[str, float]:
    """Returns the absorption by black surfaces over black soil in the sun: the
    area of the union of all shadows on the soil. Theory does not distinguish
    groups."""
    mesh = mesh_of(case)
    elevation, azimuth = np.radians(case["light"]["sun"])
    drift = -np.array([np.sin(azimuth), np.cos(azimuth)]) / np.tan(elevation)
    cell = box(0, 0, *mesh.period)
    pieces = []
    for c in mesh.corners:
        fallen = Polygon(c[:, :2] + c[:, 2:] * drift)
        if fallen.area < 1e-14:
            continue
        low, high = np.array(fallen.bounds[:2]), np.array(fallen.bounds[2:])
        for i in range(*_images(low[0], high[0], mesh.period[0])):
            for j in range(*_images(low[1], high[1], mesh.period[1])):
                moved = affinity.translate(
                    fallen, i * mesh.period[0], j * mesh.period[1]
                )
                pieces.append(moved.intersection(cell))
    area = union_all(pieces).area / cell.area
    only = {mesh.names[0]: area} if len(mesh.names) == 1 else {}
    return only | {"soil": 1 - area, "reflected": 0.0}


def _images(low: float, high: float, period: float) -> tuple[int, int]:
    return int(np.floor(-high / period)), int(np.ceil(1 - low / period)) + 1


def walls(case: Case) -> dict[str, float]:
    """Solves black walls 0.6 m high and 1 m apart under a uniform sky. The
    soil follows from crossed strings. The reflected light is the integral over
    the soil of its squared view of the sky; the walls absorb the remainder."""

    def view(x: float) -> float:
        left, right = x / np.hypot(x, 0.6), (1 - x) / np.hypot(1 - x, 0.6)
        return (left + right) / 2

    albedo = case["soil_albedo"]
    falls = np.hypot(1, 0.6) - 0.6
    leaves = albedo * quad(lambda x: view(x) ** 2, 0, 1, epsabs=1e-13)[0]
    soil = falls * (1 - albedo)
    return {"soil": soil, "reflected": leaves, "leaf01": 1 - soil - leaves}


def strips(case: Case) -> dict[str, float]:
    """Solves two black horizontal strips under a uniform sky, by crossed
    strings from the lower strip to all images of the upper one; black soil
    absorbs the remainder."""
    mesh = mesh_of(case)
    (low, up), (z0, z1) = (
        [(c[0, 0], c[1, 0]) for c in mesh.corners],
        [c[0, 2] for c in mesh.corners],
    )
    h = z1 - z0
    met = 0.0
    for i in range(-20000, 20001):
        a, b = up[0] + i, up[1] + i
        crossed = np.hypot(b - low[0], h) + np.hypot(a - low[1], h)
        straight = np.hypot(a - low[0], h) + np.hypot(b - low[1], h)
        met += (crossed - straight) / 2
    upper = up[1] - up[0]
    # The omitted images contribute less than 1e-9.
    lower = (low[1] - low[0]) - met
    return {
        "leaf01": lower,
        "leaf02": upper,
        "soil": 1 - upper - lower,
        "reflected": 0.0,
    }


def assimilation(case: Case) -> dict[str, float]:
    """Solves horizontal sheets that cover the ground, on which light is
    uniform."""
    light = sheets(case)
    names = mesh_of(case).names
    return {
        "gross_assimilation": sum(
            gross(case["ppfd"] * light[name], case["photosynthesis"])
            for name in names
        )
    }


def answer(case: Case) -> dict[str, float]:
    """Returns the values of a case that theory provides: all, some or none."""
    kind = case["class"]
    light, soil = case.get("light", {}), case.get("soil_albedo")
    black = not any(any(m) for m in case.get("materials", {"": [1]}).values())
    if kind == "sheets":
        return sheets(case)
    if kind == "beer":
        return beer(case)
    if kind == "assimilation":
        return {} if black else assimilation(case)
    if not black or kind == "energy":
        return {}
    if "sun" in light and soil == 0:
        return shadow(case)
    if case["mesh"].endswith("walls.obj"):
        return walls(case)
    if case["mesh"].endswith("strips.obj"):
        return strips(case)
    return {}
