# SPDX-License-Identifier: Apache-2.0
"""The quantities that the program can compare with field measurements."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from datetime import date
from functools import cached_property
from typing import Any

import numpy as np
import xarray

from ..errors import Error
from ..stand.stand import Stand
from .table import THIRDS, Measurement, find_third

DRY_MASS = "t ha-1"


class Seen:
    """The baseline of a stand, evaluated with one seed under the common
    conditions of measurements. Results are cached."""

    def __init__(self, stand: Stand) -> None:
        self.stand = stand

    @cached_property
    def campaign(self) -> dict[str, Any]:
        """The tables of the resolved campaign."""
        return tomllib.loads(self.stand.campaign)

    @cached_property
    def report(self) -> xarray.Dataset:
        """The evaluation of the baseline. Raises Error if it fails."""
        evaluated = self.stand.evaluate(self.stand.baseline, threads=1)
        if message := evaluated.message.item():
            raise Error(f"{self.stand.name}: {message}")
        return evaluated.isel(plant=0)

    def number(self, name: str) -> float:
        """Returns a quantity without axes, in the unit of the program."""
        return float(self.report[name])

    @cached_property
    def emergence(self) -> date | None:
        """The day of emergence; None for full-grown plants."""
        (climate,) = self.campaign.get("climate", [{}])
        emergence: date | None = climate.get("emergence")
        return emergence

    def on(self, name: str, day: date) -> float:
        """Returns a quantity by growth stage on a day, by linear interpolation
        between stages."""
        assert self.emergence
        age = (day - self.emergence).days
        stages = self.report[f"{name}_by_stage"].values
        return float(np.interp(age, self.report.day_of_stage.values, stages))

    @cached_property
    def transmitted(self) -> float:
        """The fraction of the incident light that reaches the soil."""
        albedo = self.campaign["optics"]["soil_albedo"]
        return self.number("soil_fraction") / (1 - albedo)

    @cached_property
    def inclination(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The inclination [deg], area [m2] and leaf rank of each leaf face in
        the field, each [faces]."""
        mesh = self.stand.field_mesh(self.stand.baseline)
        rank = np.array(mesh.ranks)
        corners = mesh.corners[rank > 0]
        # The area of a flat quadrilateral is half the cross product of its
        # diagonals.
        normals = np.cross(
            corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
        )
        area = np.linalg.norm(normals, axis=1) / 2
        cosine = np.abs(normals[:, 2]) / (2 * np.maximum(area, 1e-12))
        return np.degrees(np.arccos(cosine)), area, rank[rank > 0]


@dataclass(frozen=True)
class Quantity:
    """A quantity of tables of measurements; `value` computes it."""

    unit: str
    meaning: str
    value: Callable[[Seen, Measurement], float]


def _light(seen: Seen, row: Measurement) -> float:
    light = seen.stand.light_at(
        seen.stand.baseline, row.height, row.position, fields=2, points=256
    ).isel(sensor=0)
    return float(
        (light.fraction * light.incident).sum() / light.incident.sum()
    )


def _extinction(seen: Seen, row: Measurement) -> float:
    return -float(np.log(seen.transmitted)) / seen.number("lai")


def _inclination(seen: Seen, row: Measurement) -> float:
    angle, area, rank = seen.inclination
    third = find_third(rank, rank.max())
    part = third == THIRDS[row.leaves] if row.leaves else rank > 0
    return float(np.average(angle[part], weights=area[part]))


def _lai(seen: Seen, row: Measurement) -> float:
    if seen.emergence and row.date:
        return seen.on("lai", row.date)
    return seen.number("lai")


def _relative_lai(seen: Seen, row: Measurement) -> float:
    return _lai(seen, row) / float(seen.report.lai_by_stage.max())


def _shoot(seen: Seen, row: Measurement) -> float:
    """Returns the dry matter without roots, which are a fraction of all
    structures."""
    growth = seen.campaign["plant"]["baseline"].get("growth", {})
    share = growth.get("root_share", 0)
    # Crops without densities have no organ masses and no roots.
    built = float(seen.report.dry_mass_by_organ.sum()) if share else 0
    return seen.number("dry_matter") - share * built


QUANTITIES = {
    "light": Quantity(
        "1",
        "light on a level sensor at a height and a position, relative to the "
        "light above the canopy",
        _light,
    ),
    "transmitted": Quantity(
        "1",
        "light that reaches the soil, relative to the light above the canopy",
        lambda seen, row: seen.transmitted,
    ),
    "intercepted": Quantity(
        "1", "1 - transmitted", lambda seen, row: 1 - seen.transmitted
    ),
    "extinction": Quantity(
        "1",
        "extinction coefficient, -ln(transmitted) / leaf area index",
        _extinction,
    ),
    "inclination": Quantity(
        "deg", "mean inclination of leaf surfaces by area", _inclination
    ),
    "lai": Quantity("m2 m-2", "green leaf area index", _lai),
    "relative_lai": Quantity(
        "1", "green leaf area index relative to its maximum", _relative_lai
    ),
    "shoot": Quantity(DRY_MASS, "dry matter of shoots until a date", _shoot),
}
"""The quantities by name. Tables may also name any quantity without axes of
`Stand.quantities`."""


def find_quantity(seen: Seen, name: str) -> Quantity:
    """Returns a quantity by its name. Raises Error for unknown names."""
    if name in QUANTITIES:
        return QUANTITIES[name]
    known = seen.stand.quantities.set_index("name")
    plain = known[[not axes for axes in known["axes"]]]
    if name not in plain.index:
        raise Error(f"{seen.stand.name} has no quantity '{name}'")
    return Quantity(
        plain.unit[name], plain.meaning[name], lambda s, row: s.number(name)
    )
