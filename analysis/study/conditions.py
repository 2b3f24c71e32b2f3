# SPDX-License-Identifier: Apache-2.0
"""The conditions of arXiv:2512.06064, and campaigns with four objectives."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from climates import (
    CLEAR_DAY,
    bondville,
    growing_season,
    moved_season,
    site,
)
from shared import (
    HYBRID,
    MAIZE,
    ROUGH,
    SEVERAL_FIELDS,
    SMALL_FIELD,
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
    "grain_yield": "t ha-1",
}
#: The objectives of arXiv:2512.06064 and their successors, for the plant at
#: silking. Grain needs the hybrid that grows.
AT_SILKING = ("absorbed_par", "net_assimilation", "carbon_balance")


def campaign(
    where: Condition,
    objective: str,
    folder: Path,
    is_rough: bool,
    plant: Path = MAIZE,
    is_alike: bool = False,
) -> dict[str, Any]:
    """Returns the tables of a campaign under a condition, without a search.
    For grain the hybrid grows from emergence to maturity, with the traits that
    can be selected, whatever `plant` and the traits of the condition are."""
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
    if objective == "grain_yield":
        del tables["traits"]
        tables["plant"] = {"baseline": str(HYBRID), "bounds": "breedable"}
        found = growing_season()
    elif objective == "carbon_balance":
        found = bondville()
    else:
        found = {"day": [CLEAR_DAY]}
    (here,) = found.get("site", [site(where.latitude)])
    for climate in found.get("climate", []):
        if where.latitude != AMES:
            here = site(where.latitude)
            moved = moved_season(where.latitude, folder, climate["file"])
            climate["file"] = str(moved)
    return {
        **tables,
        "site": [here],
        **{name: found[name] for name in ("day", "climate") if name in found},
        **(ROUGH if is_rough else {}),
    }
