# SPDX-License-Identifier: Apache-2.0
"""Light on axes: per area of ground, and in photons beside energy."""

from __future__ import annotations

from typing import Literal

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray

from . import style
from .estimate import DAILY_ENERGY, MOL_PER_MJ_PAR

_PHOTONS = {DAILY_ENERGY: "mol m-2 day-1", "W m-2": "µmol m-2 s-1"}
"""Unit of photons for each unit of energy; the factor is that of mol and
MJ."""


def label_light(
    axes: Axes, which: Literal["x", "y"], name: str, unit: str
) -> None:
    """Labels an axis of light, and adds a second one of photons on its other
    side. An axis of anything else only gets its label."""
    axes.set(**{f"{which}label": style.axis_label(name, unit)})
    if unit not in _PHOTONS:
        return
    is_x = which == "x"
    both = (_to_photons, _to_energy)
    other = (
        axes.secondary_xaxis("top", functions=both)
        if is_x
        else axes.secondary_yaxis("right", functions=both)
    )
    other.spines["top" if is_x else "right"].set_visible(True)
    label = f"photons [{style.unit_label(_PHOTONS[unit])}]"
    other.set(**{f"{which}label": label})


def _to_photons(energy: ArrayLike) -> NDArray[np.float64]:
    return np.asarray(energy) * MOL_PER_MJ_PAR


def _to_energy(photons: ArrayLike) -> NDArray[np.float64]:
    return np.asarray(photons) / MOL_PER_MJ_PAR
