#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Answers of a two-stream model of a canopy without structure.

The leaves of the mesh are treated as randomly distributed over the ground.
Diffuse light in both directions follows Goudriaan 1977 and Sellers 1985
(doi:10.1080/01431168508948283), with the leaf area index of the mesh and the
mean projection of its leaves towards sun and sky. The two equations are solved
as a boundary value problem with the soil at the bottom."""

from __future__ import annotations

import numpy as np
from answers import write_answers
from cases import Case, material_of, mesh_of
from scipy.integrate import solve_bvp


def normals_and_areas(case: Case) -> tuple[np.ndarray, np.ndarray]:
    c = np.array(mesh_of(case).corners)
    cross = np.cross(c[:, 2] - c[:, 0], c[:, 3] - c[:, 1])
    twice = np.linalg.norm(cross, axis=1)
    return cross / twice[:, None], twice / 2


def extinction(case: Case, to_light: np.ndarray) -> np.ndarray:
    """Returns the shadow area on level ground per leaf area, for directions
    [n, 3]."""
    normals, areas = normals_and_areas(case)
    return np.abs(to_light @ normals.T) @ areas / areas.sum() / to_light[:, 2]


def sky_directions(n: int = 64) -> tuple[np.ndarray, np.ndarray]:
    """Returns directions of the sky and the share of a uniform sky's
    irradiance from each."""
    x, w = np.polynomial.legendre.leggauss(n)
    cosine, part = (x + 1) / 2, w / 2 * (x + 1)
    turns = 2 * np.pi * (np.arange(16) + 0.5) / 16
    sine = np.sqrt(1 - cosine**2)
    directions = np.stack(
        [
            np.outer(sine, np.cos(turns)),
            np.outer(sine, np.sin(turns)),
            np.repeat(cosine[:, None], 16, 1),
        ],
        axis=-1,
    )
    return directions.reshape(-1, 3), np.repeat(part / 16, 16)


def answer(case: Case) -> dict[str, tuple[float, float | None]]:
    if case["class"] in ("energy", "assimilation"):
        return {}
    mesh = mesh_of(case)
    _, areas = normals_and_areas(case)
    lai = areas.sum() / np.prod(mesh.period)
    upper, lower, through = material_of(case, mesh.groups[0])
    reflectance, albedo = (upper + lower) / 2, case["soil_albedo"]
    sky, parts = sky_directions()
    k_sky = extinction(case, sky)
    # Unscattered light of sun or sky at each depth, and its absorption by
    # leaves there.
    if "sun" in case["light"]:
        elevation, azimuth = np.radians(case["light"]["sun"])
        direction = [
            np.cos(elevation) * np.sin(azimuth),
            np.cos(elevation) * np.cos(azimuth),
            np.sin(elevation),
        ]
        k, weights = extinction(case, np.array([direction])), np.ones(1)
    else:
        k, weights = k_sky, parts
        if case["light"]["sky"] == "overcast":
            weights = parts * (1 + 2 * sky[:, 2]) * 3 / 7
    # The mean extinction of scattered light over all directions.
    diffuse = -np.log(parts @ np.exp(-k_sky * lai)) / lai

    def taken(depth: np.ndarray) -> np.ndarray:
        return (weights * k) @ np.exp(-np.outer(k, depth))

    def slopes(depth: np.ndarray, y: np.ndarray) -> np.ndarray:
        down, up = y
        first = taken(depth)
        return np.stack(
            [
                diffuse * ((through - 1) * down + reflectance * up)
                + through * first,
                diffuse * ((1 - through) * up - reflectance * down)
                - reflectance * first,
            ]
        )

    direct = float(weights @ np.exp(-k * lai))

    def ends(top: np.ndarray, bottom: np.ndarray) -> np.ndarray:
        return np.array([top[0], bottom[1] - albedo * (bottom[0] + direct)])

    depth = np.linspace(0, lai, 200)
    solved = solve_bvp(slopes, ends, depth, np.zeros((2, 200)), tol=1e-6)
    soil = (1 - albedo) * (float(solved.y[0, -1]) + direct)
    reflected = float(solved.y[1, 0])
    found: dict[str, tuple[float, float | None]] = {
        "soil": (soil, None),
        "reflected": (reflected, None),
    }
    # The model does not distinguish groups, so that the absorption is known
    # only for a mesh of a single group.
    if len(mesh.names) == 1:
        found[mesh.names[0]] = (1 - soil - reflected, None)
    return found


if __name__ == "__main__":
    write_answers("two_stream", answer)
