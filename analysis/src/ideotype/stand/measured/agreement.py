# SPDX-License-Identifier: Apache-2.0
"""Compares the fitted leaves of a crop with their measurements."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pandas as pd
from scipy.spatial import cKDTree

from ...mesh.geometry import Mesh
from .blades import Blade, Floats, parts


def agreement(
    blades: Sequence[Blade], crop: dict[str, Any], mesh: Mesh
) -> pd.DataFrame:
    """Returns the deviations of each leaf of a crop from its measurement: the
    root mean square distances of the midrib and of the measured points of the
    blade [mm], the root mean square difference of the midrib angle [deg],
    lengths [m] and areas [m2].

    blades: measured blades, lowest first.
    crop: tables of the fitted crop.
    mesh: surfaces of its plant."""
    rows = []
    for i, (blade, leaf) in enumerate(zip(blades, crop["leaf"], strict=True)):
        group = f"leaf{i + 1:02d}"
        area = mesh.area(group)
        fitted = _midrib(mesh, group)
        # Fitted leaves begin at the surface of the stalk, and leaves without a
        # measured azimuth have that of the crop.
        measured = _turned(blade, leaf["azimuth"], fitted[0])
        at = np.linspace(0, 1, 41)
        apart = _resampled(fitted, at) - _resampled(measured(blade.midrib), at)
        turn = _directions(fitted, at) * _directions(
            measured(blade.midrib), at
        )
        row = {
            "leaf": i + 1,
            "source": blade.name,
            "midrib_rms_mm": 1000 * np.sqrt((apart**2).sum(1).mean()),
            "angle_rms_deg": np.degrees(
                np.sqrt((np.arccos(np.clip(turn.sum(1), -1, 1)) ** 2).mean())
            ),
            "surface_rms_mm": np.nan,
            "out_of_plane_mm": 1000 * blade.out_of_plane,
            "length_m": leaf["length"],
            "width_m": leaf["width"],
            "area_m2": area,
            "measured_area_m2": np.nan,
        }
        if blade.points is not None:
            near, _ = cKDTree(_dense(mesh, group)).query(
                measured(blade.points)
            )
            row["surface_rms_mm"] = 1000 * np.sqrt((near**2).mean())
            row["measured_area_m2"] = blade.area
        rows.append(row)
    return pd.DataFrame(rows)


def _resampled(line: Floats, at: Floats) -> Floats:
    """Returns points of a line at the given fractions of its length."""
    return np.column_stack([np.interp(at, parts(line), x) for x in line.T])


def _directions(line: Floats, at: Floats) -> Floats:
    """Returns unit vectors along a line, from differences between the given
    fractions of its length."""
    steps = np.diff(_resampled(line, at), axis=0)
    return steps / np.linalg.norm(steps, axis=1)[:, None]


def _turned(blade: Blade, azimuth: float, base: Floats) -> Any:
    """Returns a function that moves points of a blade to the base of the
    fitted leaf and turns them about the vertical to its azimuth."""
    turn = np.radians(blade.azimuth - azimuth)
    rotation = np.array(
        [
            [np.cos(turn), -np.sin(turn), 0],
            [np.sin(turn), np.cos(turn), 0],
            [0, 0, 1],
        ]
    )
    return lambda points: (points - blade.midrib[0]) @ rotation.T + base


def _midrib(mesh: Mesh, group: str) -> Floats:
    """Returns the midrib of a fitted leaf. Its faces lie in pairs, left and
    right of the midrib, from base to tip."""
    left = mesh.corners[[name == group for name in mesh.groups]][::2]
    return np.vstack([left[:, 1], left[-1:, 2]])


def _dense(mesh: Mesh, group: str, steps: int = 24) -> Floats:
    """Returns points on the faces of a leaf, about 2 mm apart."""
    a, b, c, d = (
        mesh.corners[[name == group for name in mesh.groups]]
    ).transpose(1, 0, 2)[:, :, None, None]
    u, v = np.meshgrid(*2 * [np.linspace(0, 1, steps)])
    u, v = u[None, :, :, None], v[None, :, :, None]
    points = (1 - u) * ((1 - v) * a + v * d) + u * ((1 - v) * b + v * c)
    return points.reshape(-1, 3)
