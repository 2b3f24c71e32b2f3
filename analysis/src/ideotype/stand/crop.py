# SPDX-License-Identifier: Apache-2.0
"""Crops with growing and ageing plants."""

from __future__ import annotations

import os
from datetime import date
from os import PathLike

import numpy as np
import xarray
from numpy.typing import ArrayLike

from ..common.arrays import real
from ..common.compiled import _core
from ..errors import Error
from ..mesh.geometry import Mesh

_THERMAL = {"units": "degC day"}
_UNITS = {
    "green_area": {"units": "m2", "long_name": "green area of the blade"},
    "dead_area": {"units": "m2", "long_name": "dead area of the blade"},
    "tip": {**_THERMAL, "long_name": "thermal time at which the tip appears"},
    "collar": {
        **_THERMAL,
        "long_name": "thermal time at which the blade is out",
    },
    "death": {
        **_THERMAL,
        "long_name": "thermal time at which the blade fades",
    },
    "collar_height": {"units": "m", "long_name": "height of the collar"},
}


class Crop:
    """A growing crop, from a crop file with a [growth] table."""

    def __init__(self, core: _core.GrowingCrop) -> None:
        self._core = core

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> Crop:
        """Reads a crop file.

        Raises Error if the file has no [growth] table, InputError with all
        problems of the file."""
        return cls(_core.GrowingCrop(os.fspath(path)))

    @property
    def name(self) -> str:
        """The name of the plant."""
        return self._core.name

    @property
    def silking(self) -> float:
        """Thermal time from emergence to silking [deg C d]."""
        return self._core.silking

    @property
    def maturity(self) -> float:
        """Thermal time from emergence to maturity [deg C d]."""
        return self._core.maturity

    def at(self, thermal_time: float) -> xarray.Dataset:
        """Returns the leaves of one plant at a thermal time from emergence
        [deg C d]: a Dataset over `rank`, from 1 for the lowest leaf, with the
        `green_area` and `dead_area` of blades [m2], the thermal times `tip`,
        `collar` and `death` [deg C d], and `collar_height` [m].

        Raises Error if the thermal time is not finite."""
        time = _finite(thermal_time)
        measures = self._core.at(time)
        ranks = np.arange(1, len(measures["tip"]) + 1)
        return xarray.Dataset(
            {name: ("rank", measures[name], _UNITS[name]) for name in _UNITS},
            {"rank": ranks},
            {"thermal_time": time},
        )

    def mesh(self, thermal_time: float) -> Mesh:
        """Returns the surfaces of one plant at a thermal time from emergence
        [deg C d], in metres, with its foot at the origin, y along the row and
        z up."""
        return Mesh.of(*self._core.mesh(_finite(thermal_time)))

    def season(
        self,
        emergence: date | str,
        temperatures: ArrayLike,
        density: float,
    ) -> xarray.Dataset:
        """Simulates the growth of a stand in daily steps.

        emergence: date of emergence.
        temperatures: hourly air temperature [24 days] from the beginning of
            the day of emergence, for whole days [deg C].
        density: plants per ground area [m-2].

        Returns a Dataset over `day` with values at the end of each day:
        `thermal_time` [deg C d], `leaf_area_index` of green blades and
        `dead_area_index`.

        Raises Error if an argument is invalid."""
        hourly = np.ascontiguousarray(real(temperatures, "temperatures"))
        if hourly.ndim != 1 or hourly.size == 0 or hourly.size % 24:
            raise Error(
                f"temperatures are an array of {hourly.shape}; give 24 hours "
                "of each day, in one row"
            )
        bad = np.flatnonzero(~np.isfinite(hourly))
        if bad.size:
            raise Error(
                f"temperatures[{bad[0]}] is {hourly[bad[0]]}; fill gaps first"
            )
        if not (np.isfinite(density) and density > 0):
            raise Error(f"density is {density}; it must be positive [m-2]")
        time, green, dead = self._core.season(hourly)
        try:
            first = np.datetime64(str(emergence), "D")
        except ValueError:
            raise Error(
                f"emergence is {emergence!r}; give a date such as 2011-05-15"
            ) from None
        index = {"units": "m2 m-2"}
        return xarray.Dataset(
            {
                "thermal_time": ("day", time, _THERMAL),
                "leaf_area_index": ("day", density * green, index),
                "dead_area_index": ("day", density * dead, index),
            },
            {"day": (first + np.arange(time.size)).astype("datetime64[ns]")},
        )


def _finite(thermal_time: float) -> float:
    number = real(thermal_time, "thermal_time")
    if number.ndim or not np.isfinite(number):
        raise Error(f"thermal_time is {thermal_time}; give a finite number")
    return float(number)
