# SPDX-License-Identifier: Apache-2.0
"""Seasons of maize with measured dry matter: hourly weather from daily values,
campaigns of the hybrid that grows in them, and the comparison.

Weather and dry matter are from github.com/DSSAT/dssat-csm-data (ac780c7): Maize
UFGA8201 (treatment 4: irrigated, much nitrogen) and IUAF9901 (treatment 4).
"""

from __future__ import annotations

import csv
import math
import tomllib
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass
from datetime import date, timedelta
from pathlib import Path
from typing import Any

import numpy as np
from estimates import estimate, plus_minus, print_table
from shared import CAMPAIGNS, Numbers

from ideotype import Stand

DATA = CAMPAIGNS.parent / "tests" / "data" / "growth"


@dataclass(frozen=True)
class Season:
    name: str
    weather: str
    """The weather file of `DATA`, with a row for each day."""
    latitude: float
    longitude: float
    utc_offset: int
    elevation: float
    row: float
    """The distance of rows [m]."""
    density: float
    sown: date
    depth: float
    """The depth of sowing [cm]."""
    harvest: date
    measured: Mapping[str, float]
    """The dry matter of shoots at silking or harvest [t ha-1]."""


SEASONS = (
    Season(
        "gainesville", "ufga1982_weather_daily.csv", 29.63, -82.37, -5, 10,
        0.61, 7.2, date(1982, 2, 26), 7, date(1982, 7, 8),
        {"silking": 8.299, "harvest": 22.001},
    ),
    Season(
        "ames", "ames1999_weather_daily.csv", 42.02, -93.75, -6, 335,
        0.76, 7.4, date(1999, 5, 27), 4, date(1999, 10, 25),
        {"harvest": 24.443},
    ),
)  # fmt: skip


def light_of_day(season: Season, day: date, energy: float) -> Numbers:
    """Returns the light of each hour [W m-2] from the energy of a day [MJ
    m-2], in proportion to the sine of the solar elevation."""
    clock = np.arange(24) + 0.5
    noon = 12 + season.utc_offset - season.longitude / 15
    latitude = np.deg2rad(season.latitude)
    of_year = day.timetuple().tm_yday
    tilt = -np.deg2rad(23.45) * np.cos(2 * np.pi * (of_year + 10) / 365)
    height = np.sin(latitude) * np.sin(tilt) + np.cos(latitude) * np.cos(
        tilt
    ) * np.cos((clock - noon) * np.pi / 12)
    height = np.maximum(height, 0)
    return np.asarray(energy * 1e6 / 3600 * height / height.sum())


def warmth_of_day(largest: float, smallest: float) -> Numbers:
    """Returns the temperature of each hour [deg C], a sine wave around the
    mean."""
    wave = np.sin((np.arange(24) + 0.5 - 9) * np.pi / 12)
    mean, half = (largest + smallest) / 2, (largest - smallest) / 2
    return np.asarray(mean + half * wave)


def saturated(temperature: float) -> float:
    """Returns the saturation vapour pressure [kPa] (FAO-56, equation 11)."""
    return 0.6108 * math.exp(17.27 * temperature / (temperature + 237.3))


def hourly(season: Season, folder: Path) -> tuple[Path, date]:
    """Writes hourly weather of a season. The smallest temperature of a day is
    its dew point (FAO-56, equation 48). Returns its file and the day of
    emergence, which follows sowing by 45 deg C d plus 6 deg C d per cm of
    depth (CERES)."""
    lines = (DATA / season.weather).read_text().splitlines()
    rows = list(csv.reader(x for x in lines if not x.startswith("#")))[1:]
    path = folder / f"{season.name}.csv"
    sums, emergence = 0.0, None
    zone = f"{season.utc_offset:+03}:00"
    with path.open("w", encoding="utf-8") as file:
        print("time,global,temp,rh,rain", file=file)
        for day, *numbers in rows:
            today = date.fromisoformat(day)
            energy, largest, smallest, rain = map(float, numbers[:4])
            watts = light_of_day(season, today, energy)
            warmth = warmth_of_day(largest, smallest)
            dew = saturated(smallest)
            if today > season.sown and emergence is None:
                sums += float(np.mean(np.clip(warmth, 8, 34) - 8))
                if sums >= 45 + 6 * season.depth:
                    emergence = today + timedelta(1)
            for hour in range(24):
                print(
                    f"{day}T{hour:02}:30{zone},{watts[hour]:.1f},"
                    f"{warmth[hour]:.2f},{dew / saturated(warmth[hour]):.3f},"
                    f"{rain if hour == 0 else 0}",
                    file=file,
                )
    assert emergence
    return path, emergence


def in_season(
    tables: dict[str, Any], season: Season, folder: Path
) -> dict[str, Any]:
    """Returns a campaign of growing plants, moved to a measured season."""
    weather, emergence = hourly(season, folder)
    last = date.fromisoformat(weather.read_text().splitlines()[-1][:10])
    return {
        **tables,
        "site": [
            {
                "name": season.name,
                "latitude": season.latitude,
                "longitude": season.longitude,
                "utc_offset": season.utc_offset,
                "elevation": season.elevation,
            }
        ],
        "spacing": [{"row": season.row, "density": season.density}],
        "climate": [
            {
                "name": season.name,
                "file": str(weather),
                "from": emergence,
                "to": min(last, season.harvest),
                "emergence": emergence,
                "time": ["time"],
                "stamp": "middle",
                "global": ["global", "W/m2"],
                "temperature": ["temp", "C"],
            }
        ],
    }


def crop_of(campaign: dict[str, Any]) -> dict[str, Any]:
    """Returns the crop tables of a campaign."""
    crop = campaign["plant"]["baseline"]
    if not isinstance(crop, dict):
        crop = tomllib.loads((CAMPAIGNS / crop).read_text())
    return deepcopy(crop)


def root_share(campaign: dict[str, Any]) -> float:
    """Returns the dry mass of roots relative to that of leaves and organs in
    the crop of a campaign."""
    return float(crop_of(campaign)["growth"].get("root_share", 0))


def dry_matter(stand: Stand, seed: int, share: float) -> dict[str, float]:
    """Returns the dry matter of a growing season by organ [t ha-1]. Structures
    are built until silking; the remaining carbon at silking and at harvest is
    in reserves and the ear.

    share: dry mass of roots relative to that of the structures of the
    shoot."""
    found = stand.evaluate(stand.baseline, seed=seed).isel(plant=0)
    mass = {
        str(name): float(x)
        for name, x in zip(
            found.organ.values, found.dry_mass_by_organ.values, strict=True
        )
    }
    harvest = float(found.dry_matter)
    # Growth is proportional to the carbon that is not respired.
    after_silking = float(
        found.carbon_after_silking
        / (found.gross_assimilation - found.respiration)
    )
    structures = sum(mass.values())
    roots = share * structures
    parts = {name: mass.pop(name, 0) for name in ("leaves", "stalk", "sheath")}
    silking = harvest * (1 - after_silking)
    return parts | {
        "other organs": sum(mass.values()),
        "roots": roots,
        "ear and reserves at silking": silking - structures - roots,
        "ear and reserves at harvest": harvest - structures - roots,
        "shoot at silking": silking - roots,
        "shoot at harvest": harvest - roots,
        "all at harvest": harvest,
    }


def compare_dry_matter(
    plants: Mapping[str, dict[str, Any]], seeds: int, folder: Path
) -> None:
    """Prints the simulated dry matter by organ in measured seasons, and the
    measured dry matter of shoots."""
    for season in SEASONS:
        columns = []
        for plain in plants.values():
            stand = Stand(in_season(plain, season, folder))
            each = [
                dry_matter(stand, seed, root_share(plain))
                for seed in range(1, seeds + 1)
            ]
            columns.append(
                {name: estimate([x[name] for x in each]) for name in each[0]}
            )
        rows = []
        for name in columns[0]:
            measured = season.measured.get(
                name.removeprefix("shoot at "), math.nan
            )
            row = [name, f"{measured:.1f}" if measured == measured else ""]
            for values in (x[name] for x in columns):
                row.append(plus_minus(values, 2))
                row.append(
                    f"{100 * (values[0] / measured - 1):+.0f}"
                    if measured == measured
                    else ""
                )
            rows.append(row)
        titles = [f"dry matter at {season.name} [t ha-1]", "measured"]
        for plant in plants:
            titles += [plant, "difference [%]"]
        print_table(titles, rows)
        print()


def without_parts(campaign: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Returns a campaign of growing plants, with single parts of its carbon
    budget omitted or replaced."""
    crop = crop_of(campaign)
    growth = crop["growth"]

    def with_crop(**tables: Any) -> dict[str, Any]:
        return {**campaign, "plant": {"baseline": {**crop, **tables}}}

    def no_maintenance(table: dict[str, Any]) -> dict[str, Any]:
        return {**table, "maintenance": 0}

    organs = {
        "stalk": no_maintenance(crop["stalk"]),
        "sheath": no_maintenance(crop["sheath"]),
        "organ": [no_maintenance(x) for x in crop["organ"]],
    }
    none = {**growth, "root_share": 0, "ear_maintenance": 0, "ageing": [1]}
    return {
        "no respiration of stalk, sheaths and other organs": with_crop(
            **organs
        ),
        "no roots": with_crop(growth={**growth, "root_share": 0}),
        "no respiration of the growing ear": with_crop(
            growth={**growth, "ear_maintenance": 0}
        ),
        "leaves that do not age": with_crop(growth={**growth, "ageing": [1]}),
        "these four together": with_crop(**organs, growth=none),
        "the hyperbola of the crop file": {**campaign, "photosynthesis": {}},
        "neither gaps nor late plants": {
            **campaign,
            "field": {
                **campaign["field"],
                "variation": {
                    **campaign["field"]["variation"],
                    "missing": 0,
                    "late": 0,
                },
            },
        },
    }


def compare_parts(plain: dict[str, Any], seeds: int, folder: Path) -> None:
    """Prints the change of the total dry matter at harvest if one part of the
    carbon budget is omitted or replaced, in pairs with common random
    numbers."""

    def harvest(campaign: dict[str, Any], season: Season) -> list[float]:
        stand = Stand(in_season(campaign, season, folder))
        return [
            stand.evaluate(
                stand.baseline, ["dry_matter"], seed=seed
            ).dry_matter.item()
            for seed in range(1, seeds + 1)
        ]

    changed = without_parts(plain)
    before = [harvest(plain, season) for season in SEASONS]
    rows = []
    for name, campaign in changed.items():
        row = [name]
        for season, first in zip(SEASONS, before, strict=True):
            pairs = zip(harvest(campaign, season), first, strict=True)
            change = estimate([100 * (x / y - 1) for x, y in pairs])
            row.append(plus_minus(change, 1, "+"))
        rows.append(row)
    titles = [f"dry matter, {x.name} [%]" for x in SEASONS]
    print_table(["changed", *titles], rows)


def figures_of_light(
    campaign: dict[str, Any], seeds: int
) -> dict[str, list[float]]:
    """Returns for each seed the carbon of gross assimilation per absorbed PAR
    [g MJ-1] and the dry matter of shoots at harvest [t ha-1]."""
    stand = Stand(campaign)
    share = root_share(campaign)
    names = ("gross_efficiency", "harvest")
    figures: dict[str, list[float]] = {name: [] for name in names}
    for seed in range(1, seeds + 1):
        found = stand.evaluate(
            stand.baseline, ["light_use_efficiency"], seed=seed
        )
        dry = dry_matter(stand, seed, share)
        figures["gross_efficiency"].append(found.light_use_efficiency.item())
        figures["harvest"].append(dry["shoot at harvest"])
    return figures
