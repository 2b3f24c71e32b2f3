# SPDX-License-Identifier: Apache-2.0
"""The baseline of crops/maize.toml in fields like those of experiments: what light does
there, and what its leaves make of it."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from shared import (
    CAMPAIGNS,
    MAIZE,
    Estimate,
    Numbers,
    Settings,
    leaves,
    with_trait,
)  # fmt: skip

import ideotype
from ideotype import Stand

DAY, SEASON = CAMPAIGNS / "ames.toml", CAMPAIGNS / "bondville.toml"
SOIL_ALBEDO = 0.1
HOURS = {
    "day": "start = 07:00:00, end = 20:00:00",
    # the sun is highest at 13:20
    "noon": "start = 12:20:00, end = 14:20:00",
    "whole": "start = 05:30:00, end = 21:00:00",
}
NOON_SECONDS = 7200
QUANTITIES = [
    *("fapar", "extinction_coefficient", "soil_fraction", "lai"),
    *("reflected_fraction", "light_use_efficiency", "absorbed_par"),
    *("gross_assimilation", "respiration"),
]
CARBOHYDRATE = 30.03
"""[g mol-1]"""
BUILDING = 1.39
"""Carbohydrate that dry matter of leaves is built of [g g-1]; WOFOST."""


@dataclass(frozen=True)
class Field:
    """Distance of rows [m], plants per area [m-2], where leaves point, the
    direction of rows from north [deg], the light, and a changed plant."""

    row: float
    density: float
    azimuths: str = "random"
    direction: int = 90
    hours: str = "day"
    date: str = "2025-08-07"
    campaign: Path = DAY
    curvature: float = 1
    """Times that of each leaf."""
    more: tuple[str, ...] = ()
    """Settings."""

    def settings(self) -> list[str]:
        spacing = (
            f"row = {self.row}, plant = {1 / self.density / self.row:.6f}, "
            f"row_direction = {self.direction}"
        )
        settings = [
            f"spacing=[{{{spacing}}}]",
            f"plant.baseline={MAIZE}",
            "objective.maximise=gross_assimilation",
            f"optics.soil_albedo={SOIL_ALBEDO}",
            f"field.jitter={180 if self.azimuths == 'random' else 10}",
        ]
        if self.campaign == DAY:
            day = f"date = {self.date}, {HOURS[self.hours]}, step_minutes = 30"
            settings.append(f"day=[{{{day}}}]")
        return [*settings, *self.more]

    def plant(self, stand: Stand) -> Numbers:
        """The baseline's leaves point across the row."""
        genome: Numbers = stand.baseline
        own = leaves(stand, genome)
        if self.azimuths == "along":
            turned = (own["azimuth"] + 90) % 360
            genome = with_trait(stand, genome, "azimuth", turned)
        bent = own["curvature"] * self.curvature
        return with_trait(stand, genome, "curvature", bent)


Measured = dict[str, Estimate]


def measure(field: Field, accuracy: Settings = ()) -> Measured:
    """What the program tells of a field, and of PAR on its way down to the
    soil: `transmitted`, `fipar` = 1 - transmitted, and `k`, -ln(transmitted) /
    leaf area index."""
    stand = Stand.from_campaign(
        field.campaign, settings=[*field.settings(), *accuracy]
    )
    found = stand.evaluate(
        field.plant(stand), QUANTITIES, final=True, threads=1
    )
    if message := found.message.item():
        raise ideotype.Error(f"{stand.name}: {message}")
    known: Measured = {}
    for name in QUANTITIES:
        error = found.get(f"{name}_standard_error")
        known[name] = found[name].item(), 0 if error is None else error.item()
    lai = known["lai"][0]
    soil, error = scaled(known["soil_fraction"], 1 / (1 - SOIL_ALBEDO))
    known["transmitted"] = soil, error
    known["fipar"] = 1 - soil, error
    known["k"] = -math.log(soil) / lai, error / soil / lai
    return known


def measure_all(
    fields: Iterable[Field], accuracy: Settings = ()
) -> dict[Field, Measured]:
    wanted = list(dict.fromkeys(fields))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        found = pool.map(lambda field: measure(field, accuracy), wanted)
        return dict(zip(wanted, found, strict=True))


def scaled(x: Estimate, factor: float) -> Estimate:
    return x[0] * factor, x[1] * factor


def ratio(a: Estimate, b: Estimate) -> Estimate:
    """Of two evaluations with errors of their own."""
    mean = a[0] / b[0]
    return mean, abs(mean) * math.hypot(a[1] / a[0], b[1] / b[0])


def noon_rate(x: Measured) -> Estimate:
    """Gross assimilation around noon [umol m-2 s-1]."""
    return scaled(x["gross_assimilation"], 1e6 / NOON_SECONDS)


def dry_matter(x: Measured) -> Estimate:
    """For each MJ of PAR that leaves absorb [g], if leaves alone respire."""
    assimilated, error = x["gross_assimilation"]
    share = CARBOHYDRATE / BUILDING / x["absorbed_par"][0]
    return (assimilated - x["respiration"][0]) * share, error * share
