# SPDX-License-Identifier: Apache-2.0
"""The surfaces of plants, panels and neighbours for the live page."""

from __future__ import annotations

import tempfile
from datetime import timedelta
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.compiled import _core
from ..report.scene import describe_shape, pack_vertices
from ..stand.stand import Stand
from .conditions import Conditions, Tables


def grows(base: Tables) -> bool:
    """Returns whether the plants of a campaign grow."""
    return "emergence" in base.get("climate", [{}])[0]


class Growth:
    """The plant of a campaign that grows, day by day."""

    def __init__(self, base: Tables) -> None:
        climate, weather = base["climate"][0], base["weather"][0]
        self._emergence = climate["emergence"]
        first = weather["dates"].index(self._emergence)
        hourly = np.array(weather["temperature"], float)
        steps = len(weather["hours"])
        daily = hourly.reshape(-1, steps)[first:]
        # The crop model uses 24 hours per day, whatever the time step of the
        # file.
        at = np.arange(24) * steps // 24
        self._hourly = np.ascontiguousarray(daily[:, at].ravel())
        self._times: NDArray[np.float64] | None = None
        self.days = len(daily)

    def thermal_time(self, stand: Stand, age: int) -> float:
        """Returns the thermal time on a day after emergence [deg C d], at most
        that of maturity."""
        if self._times is None:
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder) / "plant.toml"
                path.write_text(stand.crop_file(stand.baseline), "utf-8")
                crop = _core.GrowingCrop(str(path))
            times = np.array(crop.season(self._hourly)[0])
            self._times = np.minimum(times, crop.maturity)
        return float(self._times[min(age, len(self._times) - 1)])

    def date(self, age: int) -> str:
        """Returns the date of a day after emergence."""
        return (self._emergence + timedelta(age)).strftime("%-d %B")


def make_plant(
    stand: Stand,
    genome: NDArray[np.float64],
    component: int,
    growth: Growth | None,
    age: int,
) -> dict[str, Any]:
    """Returns a plant in the form that the page draws, with the area of each
    leaf [m2]."""
    if growth is not None and age and component == 0:
        time = growth.thermal_time(stand, age)
        mesh = stand.mesh(genome, component, time)
    else:
        mesh = stand.mesh(genome, component)
    shape = describe_shape(mesh)
    shape["areas"] = [mesh.area(group) for group in shape["groups"]]
    return {**shape, **pack_vertices(mesh.vertices)}


def place_modules(now: Conditions, base: Tables) -> list[list[list[float]]]:
    """Returns the modules above a plant, each as its four corners [m]: x
    across the rows, y along them, z up."""
    if not now.panels:
        return []
    panel = base.get("panel", [{}])[0]
    tilt = np.radians(0 if panel.get("tracks", True) else panel.get("tilt", 0))
    half, long = now.panel_width / 2, 1.3
    pitch = now.panel_rows * now.row
    modules = []
    for middle in (-pitch / 2, pitch / 2):
        ends = [
            (middle + side * half * np.cos(tilt),
             now.panel_height - side * half * np.sin(tilt))
            for side in (-1, 1)
        ]  # fmt: skip
        (a, low), (b, high) = ends
        modules.append(
            [
                [a, -long, low],
                [b, -long, high],
                [b, long, high],
                [a, long, low],
            ]
        )
    return modules


def place_neighbours(now: Conditions) -> list[list[float]]:
    """Returns the places of neighbours [m], across the rows and along them: a
    row on each side, and some plants before and behind."""
    gap = 1 / (now.density * now.row)
    along = max(1, min(4, round(0.7 / gap)))
    step = max(gap, 0.12)
    return [
        [i * now.row, j * step]
        for i in (-1, 0, 1)
        for j in range(-along, along + 1)
        if i or j
    ]
