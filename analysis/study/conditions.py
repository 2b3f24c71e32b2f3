# SPDX-License-Identifier: Apache-2.0
"""The conditions of arXiv:2512.06064, and campaigns with the three
objectives."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from climates import CLEAR_DAY, bondville, moved_season, season, site
from shared import (
    MAIZE,
    ROUGH,
    SEVERAL_FIELDS,
    SMALL_FIELD,
    with_former_defaults,
)

INCH = 0.0254
AMES = 42.0


@dataclass(frozen=True)
class Condition:
    name: str
    title: str
    latitude: float = AMES
    row: float = 30
    plant: float = 6
    """The distance between plants [inches]."""
    free: tuple[str, ...] = ("insertion_angle", "azimuth", "width", "length")


FIRST = Condition("all", "all traits, 42° N, 30 x 6 inches")
CONDITIONS = (
    FIRST,
    Condition("azimuth", "azimuths", free=("azimuth",)),
    Condition(
        "angles", "angles and azimuths", free=("insertion_angle", "azimuth")
    ),
    Condition(
        "widths",
        "the same and widths",
        free=("insertion_angle", "azimuth", "width"),
    ),
    *(
        Condition(f"{latitude:g}".replace(".", "p"), f"{latitude}° N", latitude)
        for latitude in (7.0, 39.35, 46.8, 56.2)
    ),
    *(
        Condition(f"{row}x{plant}", f"{row} x {plant}", row=row, plant=plant)
        for row, plant in ((15, 3), (15, 6), (20, 3), (20, 6), (30, 3))
    ),
)  # fmt: skip
UNITS = {
    "absorbed_par": "MJ m-2 day-1",
    "net_assimilation": "mol m-2 day-1",
    "carbon_balance": "mol m-2 day-1",
}


def campaign(
    where: Condition,
    objective: str,
    folder: Path,
    is_rough: bool,
    plant: Path = MAIZE,
    is_alike: bool = False,
) -> dict[str, Any]:
    """Returns the tables of a campaign under a condition, without a search."""
    tables: dict[str, Any] = {
        "name": f"{objective}_{where.name}",
        "spacing": [
            {
                "name": "stand",
                "row": round(where.row * INCH, 4),
                "plant": round(where.plant * INCH, 4),
            }
        ],
        "traits": [{"name": "free", "free": list(where.free)}],
        "plant": {"baseline": str(plant), "bounds": "paper"},
        "objective": {"maximise": objective},
        "field": {} if is_alike else SMALL_FIELD,
        "light": {} if is_alike else SEVERAL_FIELDS,
        "final": {"candidates": 3, "paths": 4096, "randomisations": 256},
    }
    if objective != "carbon_balance":
        here, light = site(where.latitude), {"day": [CLEAR_DAY]}
    elif where.latitude == AMES:
        here, light = bondville()["site"][0], {"climate": [season()]}
    else:
        moved = moved_season(where.latitude, folder)
        here = site(where.latitude)
        light = {"climate": [{**season(), "file": str(moved)}]}
    return with_former_defaults(
        {
            **tables,
            "site": [here],
            **light,
            **(ROUGH if is_rough else {}),
        }
    )
