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

from ..errors import Error, did_you_mean
from ..stand.stand import Stand
from .table import THIRDS, Measurement, find_third

DRY_MASS = "t ha-1"

PHOTONS = 4.57
"""Photons per unit of PAR from sun and sky [umol J-1] (McCree 1972)."""


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
    check: Callable[[Seen, Measurement], None] | None = None
    """Raises Error for a row that cannot be computed, before it is."""
    reported: str = ""
    """The quantity of the program without which this one is not known; none
    for those that every campaign has."""


def _mean_light(seen: Seen, row: Measurement) -> tuple[float, float]:
    """Returns the mean PAR on a level sensor and above the canopy [W m-2]."""
    light = seen.stand.light_at(
        seen.stand.baseline, row.height, row.position, fields=2, points=256
    ).isel(sensor=0)
    return float((light.fraction * light.incident).mean()), float(
        light.incident.mean()
    )


def _light(seen: Seen, row: Measurement) -> float:
    sensor, above = _mean_light(seen, row)
    return sensor / above


def _extinction(seen: Seen, row: Measurement) -> float:
    return -float(np.log(seen.transmitted)) / seen.number("lai")


def _inclination(seen: Seen, row: Measurement) -> float:
    angle, area, rank = seen.inclination
    part = rank > 0
    if row.leaves in THIRDS:
        part = find_third(rank, rank.max()) == THIRDS[row.leaves]
    elif row.leaves:
        part = rank == int(row.leaves)
    return float(np.average(angle[part], weights=area[part]))


def _check_leaves(seen: Seen, row: Measurement) -> None:
    highest = int(seen.inclination[2].max())
    if row.leaves.isdecimal() and not 0 < int(row.leaves) <= highest:
        raise Error(
            f"leaves is {row.leaves}, but the plant has {highest} leaves; count "
            "them from the lowest, 1"
        )


def _check_date(seen: Seen, row: Measurement) -> None:
    (climate,) = seen.campaign.get("climate", [None])
    if climate is None or not row.date or not seen.emergence:
        return
    if not climate["from"] <= row.date <= climate["to"]:
        raise Error(
            f"date is {row.date}, but the climate of {seen.stand.name} is from "
            f"{climate['from']} to {climate['to']}; correct one"
        )


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


def _grain(seen: Seen, row: Measurement) -> float:
    if row.date is None:
        return seen.number("grain_yield")
    days = np.array(seen.report.day.values, "datetime64[D]").astype(float)
    day = np.datetime64(row.date).astype(float)
    return float(np.interp(day, days, seen.report.grain_by_day.values))


def _check_grain(seen: Seen, row: Measurement) -> None:
    if "grain_by_day" not in set(seen.stand.quantities.name):
        raise Error(
            f"{seen.stand.name} computes no grain, which needs growing plants "
            "of a crop with [grain]; choose another campaign or quantity"
        )
    _check_date(seen, row)


def _rate(name: str, unit: str, meaning: str) -> Quantity:
    """Returns an amount per day as a quantity; in a row with hours it is the
    rate during these hours."""

    def value(seen: Seen, row: Measurement) -> float:
        if not row.hours:
            return seen.number(name)
        begin, end = (60 * x.hour + x.minute for x in row.hours)
        return seen.number(name) * 24 * 60 / (end - begin)

    return Quantity(unit, meaning, value, reported=name)


QUANTITIES = {
    "light": Quantity(
        "1",
        "light on a level sensor at a height and a position, relative to the "
        "light above the canopy",
        _light,
    ),
    "ppfd": Quantity(
        "umol m-2 s-1",
        "photon flux of PAR on a level sensor at a height and a position",
        lambda seen, row: PHOTONS * _mean_light(seen, row)[0],
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
        "deg",
        "mean inclination of leaf surfaces by area",
        _inclination,
        _check_leaves,
    ),
    "lai": Quantity("m2 m-2", "green leaf area index", _lai, _check_date),
    "relative_lai": Quantity(
        "1",
        "green leaf area index relative to its maximum",
        _relative_lai,
        _check_date,
    ),
    "shoot": Quantity(
        DRY_MASS, "dry matter of shoots until a date", _shoot, _check_date
    ),
    "grain": Quantity(
        DRY_MASS, "dry matter of grain at a date", _grain, _check_grain
    ),
    "gross_assimilation": _rate(
        "gross_assimilation",
        "mol m-2 day-1",
        "CO2 that leaves and green organs take up per ground area",
    ),
    "net_assimilation": _rate(
        "net_assimilation",
        "mol m-2 day-1",
        "net exchange of CO2 per ground area while there is light",
    ),
    "transpiration": _rate(
        "transpiration", "mm day-1", "water that leaves transpire"
    ),
}
"""The quantities by name. Tables may also name any quantity without axes of
`Stand.quantities`."""


def find_quantity(seen: Seen, name: str) -> Quantity:
    """Returns a quantity by its name. Raises Error for unknown names."""
    known = seen.stand.quantities.set_index("name")
    plain = known[[not axes for axes in known["axes"]]]
    ours = {
        key: quantity
        for key, quantity in QUANTITIES.items()
        if not quantity.reported or quantity.reported in plain.index
    }
    if name in ours:
        return ours[name]
    if name not in plain.index:
        raise Error(
            f"{seen.stand.name} has no quantity '{name}'"
            + (
                did_you_mean(name, [*ours, *plain.index])
                or "; ideotype evaluate CAMPAIGN lists those of the campaign"
            )
        )
    return Quantity(
        plain.unit[name], plain.meaning[name], lambda s, row: s.number(name)
    )
