# SPDX-License-Identifier: Apache-2.0
"""Makes the light of the campaigns that scripts of this folder write: a clear
day, the season measured at Bondville, this season under the sun of another
latitude, and an overcast day."""

from __future__ import annotations

import csv
import math
from datetime import date, time
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from shared import SEVERAL_FIELDS, Numbers, campaign_of

DAY = date(2025, 8, 7)
#: A whole clear day as a [[day]] of a campaign.
CLEAR_DAY: dict[str, Any] = {"date": DAY, "start": time(0), "end": "24:00"}
SOLAR_CONSTANT = 1361.0
"""The light of the sun outside of the atmosphere [W m-2]."""
LOW_SUN = 0.05
"""The sine of the sun's height below which an hour does not tell how much
light passes the atmosphere."""
OVERCAST_SHARE = 0.25
"""The share of the light outside of the atmosphere that passes a closed layer
of clouds (E)."""

#: The [light] and [final] of plants that grow or exchange water. Most of the
#: time is spent on fields and leaves, so that more paths cost little; with few
#: paths, rare large values cause errors of several per cent.
PRECISE_LIGHT = {"tolerance": 0.005}
PRECISE_FINAL = {"paths": 4096, "randomisations": 48}


def bondville() -> dict[str, Any]:
    """Returns the campaign of the Bondville season."""
    return campaign_of("bondville")


def season() -> dict[str, Any]:
    """Returns the Bondville season as a [[climate]]."""
    return dict(bondville()["climate"][0])


def growing_season(year: int = 2011, **tables: Any) -> dict[str, Any]:
    """Returns the campaign of the hybrid that grows and ages during a year at
    Bondville, with the carbon balance as objective. `tables` replace tables of
    the campaign."""
    found = campaign_of(
        "growing_season", objective={"maximise": "carbon_balance"}, **tables
    )
    found["climate"] = [x for x in found["climate"] if x["name"] == str(year)]
    return found


def dry_month() -> dict[str, Any]:
    """Returns site, climate, photosynthesis, water and light of a campaign of
    July in the drought of 2012 at Bondville, in which leaves exchange
    water."""
    found = growing_season(2012)
    (climate,) = found["climate"]
    del climate["emergence"]
    dates = {"from": date(2012, 7, 1), "to": date(2012, 7, 31)}
    return {
        **{name: found[name] for name in ("site", "photosynthesis")},
        "climate": [climate | dates],
        "water": {},
        "light": {**PRECISE_LIGHT, **SEVERAL_FIELDS},
        "final": {**PRECISE_FINAL, "randomisations": 32},
    }


def growth() -> dict[str, Any]:
    """Returns site, climate, plant and light for optimising the hybrid that
    grows and ages in 2011 at Bondville. Several fields are evaluated, because
    results of a single field would depend on its few plants."""
    found = growing_season()
    return {
        **{name: found[name] for name in ("site", "climate", "plant")},
        "light": {**PRECISE_LIGHT, **SEVERAL_FIELDS},
        "final": {"candidates": 3, **PRECISE_FINAL},
    }


def site(latitude: float) -> dict[str, Any]:
    """Returns a site where clocks show solar time, except for the equation of
    time."""
    return {
        "name": "site",
        "latitude": latitude,
        "longitude": 0.0,
        "utc_offset": 0,
    }


def declination(day: date) -> float:
    """Returns the declination of the sun [rad] (Spencer 1971)."""
    x = 2 * math.pi * (day.timetuple().tm_yday - 1) / 365
    return (
        0.006918
        - 0.399912 * math.cos(x)
        + 0.070257 * math.sin(x)
        - 0.006758 * math.cos(2 * x)
        + 0.000907 * math.sin(2 * x)
    )


def light_outside(latitude: float, day: date, hours: Numbers) -> Numbers:
    """Returns the extraterrestrial light on a horizontal plane [W m-2] at
    hours of solar time."""
    tilt, turn = math.radians(latitude), declination(day)
    height = math.sin(tilt) * math.sin(turn) + math.cos(tilt) * math.cos(
        turn
    ) * np.cos(np.radians(15 * (hours - 12)))
    return np.asarray(SOLAR_CONSTANT * np.maximum(height, 0))


def half_day(latitude: float, day: date) -> float:
    """Returns the time from sunrise to noon [h]."""
    x = -math.tan(math.radians(latitude)) * math.tan(declination(day))
    return math.degrees(math.acos(min(1.0, max(-1.0, x)))) / 15


@cache
def overcast_file(latitude: float, folder: Path) -> Path:
    """Writes a weather file of one day without direct light."""
    path = folder / f"overcast_{latitude:g}.csv"
    hours = np.arange(24) + 0.5
    light = OVERCAST_SHARE * light_outside(latitude, DAY, hours)
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(["time", "global", "diffuse_fraction", "temperature"])
        for hour, each in enumerate(light):
            rows.writerow([f"{DAY}T{hour:02}:30", round(each, 3), 1, 25])
    return path


def overcast_day(latitude: float, folder: Path) -> dict[str, Any]:
    """Returns a [[climate]] of one day without direct light."""
    return {
        "name": "overcast",
        "file": str(overcast_file(latitude, folder)),
        "from": DAY,
        "to": DAY,
        "time": ["time"],
        "stamp": "middle",
        "global": ["global", "W/m2"],
        "diffuse_fraction": ["diffuse_fraction", "1"],
        "temperature": ["temperature", "C"],
    }


@cache
def moved_season(
    latitude: float, folder: Path, file: str | None = None
) -> Path:
    """Writes a weather file: the season of Bondville, or another file of this
    site, under the sun of another latitude.

    At each fraction of a day from sunrise to sunset, the atmosphere transmits
    and scatters the same fractions of the light as at Bondville at this
    fraction of the day. Temperature and humidity are those of the hour."""
    here = bondville()["site"][0]
    fast = here["longitude"] / 15 - here["utc_offset"]
    days = []
    source = Path(file or season()["file"])
    measured = pd.read_csv(source)
    for _, rows in measured.groupby(measured.time.str[:10]):
        day = date.fromisoformat(rows.time.iloc[0][:10])
        hours = np.arange(24.0)
        outside = light_outside(here["latitude"], day, hours + fast)
        shines = outside > LOW_SUN * SOLAR_CONSTANT
        part = (hours + fast - 12) / half_day(here["latitude"], day)
        part_there = (hours - 12) / half_day(latitude, day)

        known = part_there, part[shines]
        passing = rows.ppfd_umol.to_numpy() / np.maximum(outside, 1)
        light = np.interp(*known, passing[shines])
        moved = rows.assign(
            time=rows.time.str[:16],
            ppfd_umol=light * light_outside(latitude, day, hours),
        )
        # In other files, the program derives diffuse light from the clearness
        # of the sky.
        name = "diffuse_fraction_erbs"
        if name in rows:
            share = rows[name].to_numpy()[shines]
            moved[name] = np.interp(*known, share)
        days.append(moved)
    path = folder / f"{source.stem}_{latitude:g}.csv"
    pd.concat(days).round(4).to_csv(path, index=False)
    return path
