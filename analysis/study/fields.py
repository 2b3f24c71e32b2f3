# SPDX-License-Identifier: Apache-2.0
"""Evaluates the light and the assimilation of maize in fields like those of
experiments."""

from __future__ import annotations

import math
import os
import tomllib
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from estimates import Estimate
from shared import CAMPAIGNS, FIELD_PLANTS, Settings

import ideotype
from ideotype import Stand

DAY, SEASON = CAMPAIGNS / "ames.toml", CAMPAIGNS / "bondville.toml"
ROW, DENSITY = 0.762, 7.5
SOIL_ALBEDO = 0.1
HOURS = {
    "day": ("07:00:00", "20:00:00"),
    # The sun is at its highest at 13:20.
    "noon": ("12:20:00", "14:20:00"),
    "whole": ("05:30:00", "21:00:00"),
}
QUANTITIES = [
    *("soil_fraction", "lai"),
    *("light_use_efficiency", "gross_assimilation"),
]
#: One-sided leaf area per plant [m2].
AREAS = {"hybrid": 0.6308, "hybrid of the 1980s": 0.4793}

Tables = dict[str, Any]


def crop(name: str) -> Tables:
    """Returns the tables of a crop file."""
    return tomllib.loads((CAMPAIGNS / name).read_text())


PLANTS: dict[str, Tables] = {
    "hybrid": crop("crops/maize_hybrid.toml"),
    "hybrid of the 1980s": crop("plants/maize_hybrid_1980s.toml"),
}
#: The standard deviation of positions along the row in 354 fields from 1987 to
#: 1996 [m], calculated from that of plant distances, 4.5 inches (Nielsen,
#: kingcorn.org/research/psv/Update2004).
SURVEYED_POSITION = 0.075
VARIATIONS: dict[str, Tables] = {
    "field": FIELD_PLANTS,
    "exact positions": FIELD_PLANTS | {"position": 0.0},
    "positions of surveys": FIELD_PLANTS | {"position": SURVEYED_POSITION},
}


@dataclass(frozen=True)
class Field:
    """A field: distance between rows [m], plants per area [m-2], plant,
    within-line variation and light."""

    row: float
    density: float
    plant: str = "hybrid"
    variation: str = "field"
    hours: str = "day"
    date: str = "2025-08-07"
    campaign: Path = DAY
    more: tuple[str, ...] = ()
    """Further settings of the campaign."""

    def tables(self) -> Tables:
        """Returns the campaign of this field."""
        tables = tomllib.loads(self.campaign.read_text())
        tables["spacing"] = [
            {
                "row": self.row,
                "plant": round(1 / self.density / self.row, 6),
                "row_direction": 90,
            }
        ]
        plant = PLANTS[self.plant]
        tables["optics"] = plant.get("optics", {}) | {
            "soil_albedo": SOIL_ALBEDO
        }
        tables["plant"] = {"baseline": plant}
        tables["objective"] = {"maximise": "gross_assimilation"}
        tables["field"] = {
            "rows": 4,
            "plants": 4,
            "variation": VARIATIONS[self.variation],
        }
        if self.campaign == DAY:
            start, end = HOURS[self.hours]
            tables["day"] = [
                tomllib.loads(
                    f"date = {self.date}\nstart = {start}\nend = {end}\n"
                    "step_minutes = 30"
                )
            ]
        return tables


def density_of(area: float) -> float:
    """Returns the number of sown plants of the hybrid per area [m-2] for a
    leaf area index, with the missing plants of fields."""
    return area / AREAS["hybrid"] / (1 - FIELD_PLANTS["missing"])


JULY = Field(ROW, density_of(6), hours="whole", date="2025-07-10")
JULY_NOON = replace(JULY, hours="noon")


def measure(field: Field, accuracy: Settings = ()) -> dict[str, Estimate]:
    """Returns quantities of a field, and the extinction coefficient `k` of the
    light that reaches the soil, -ln(transmitted) / leaf area index."""
    stand = Stand(
        field.tables(),
        folder=field.campaign.parent,
        settings=[*field.more, *accuracy],
    )
    found = stand.evaluate(stand.baseline, QUANTITIES, final=True, threads=1)
    if message := found.message.item():
        raise ideotype.Error(f"{stand.name}: {message}")
    known: dict[str, Estimate] = {}
    for name in QUANTITIES:
        error = found.get(f"{name}_standard_error")
        known[name] = found[name].item(), 0 if error is None else error.item()
    transmitted, error = (
        x / (1 - SOIL_ALBEDO) for x in known["soil_fraction"]
    )
    lai = known["lai"][0]
    known["k"] = -math.log(transmitted) / lai, error / transmitted / lai
    return known


def measure_all(
    fields: Iterable[Field], accuracy: Settings = ()
) -> dict[Field, dict[str, Estimate]]:
    wanted = list(dict.fromkeys(fields))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        found = pool.map(lambda field: measure(field, accuracy), wanted)
        return dict(zip(wanted, found, strict=True))
