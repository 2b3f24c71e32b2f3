# SPDX-License-Identifier: Apache-2.0
"""Smooth curves over leaf position."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def curve(points: NDArray, at: NDArray) -> NDArray[np.float64]:
    """Through points at equal distances over [0, 1] on the last axis, as the
    program draws a profile: monotone between neighbours (Fritsch and Butland
    1984, doi:10.1137/0905021)."""
    # Here, since it takes as long to load as all else together.
    from scipy.interpolate import PchipInterpolator

    points = np.asarray(points)
    if points.shape[-1] == 1:
        return np.repeat(points, len(at), axis=-1)
    place = np.linspace(0, 1, points.shape[-1])
    return PchipInterpolator(place, points, axis=-1)(at)
