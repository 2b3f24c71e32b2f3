# SPDX-License-Identifier: Apache-2.0
"""Statistics of angles: 359 deg and 1 deg are neighbours."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._arrays import real

_NO_DIRECTION = 1e-9
"""Below this resultant length the angles cancel and have no mean."""


def _resultant(degrees: ArrayLike, axis: int) -> NDArray[np.complex128]:
    angles = np.deg2rad(real(degrees, "degrees"))
    return np.mean(np.exp(1j * angles), axis=axis)


def circular_mean(degrees: ArrayLike, axis: int = 0) -> NDArray[np.float64]:
    """Direction of the mean unit vector, in [0, 360) [deg]; NaN where the
    angles cancel."""
    resultant = _resultant(degrees, axis)
    mean = np.mod(np.rad2deg(np.angle(resultant)), 360.0)
    # mod of a tiny negative angle rounds up to 360 itself
    mean = np.where(mean >= 360.0, 0.0, mean)
    return np.where(np.abs(resultant) > _NO_DIRECTION, mean, np.nan)


def circular_deviation(
    degrees: ArrayLike, axis: int = 0
) -> NDArray[np.float64]:
    """Circular standard deviation sqrt(-2 ln R) [deg] with R the length of
    the mean unit vector; for small angles the common one. Infinite where the
    angles cancel."""
    length = np.minimum(np.abs(_resultant(degrees, axis)), 1.0)
    with np.errstate(divide="ignore"):
        logarithm = np.log(np.where(length > _NO_DIRECTION, length, 0.0))
    # abs: log(1) is 0, and -2 * 0 would be shown as -0
    return np.rad2deg(np.sqrt(np.abs(2.0 * logarithm)))


def signed_difference(
    degrees: ArrayLike, reference: ArrayLike
) -> NDArray[np.float64]:
    """degrees - reference by the short way, in [-180, 180) [deg]."""
    difference = real(degrees, "degrees") - real(reference, "reference")
    return np.mod(difference + 180.0, 360.0) - 180.0
