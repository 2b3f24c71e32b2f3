#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the weather of campaigns/maize_belt.toml: 30 years at five latitudes.

The years are made, not measured; their dates are in the future (2071 to 2100)
so that they are not mistaken for measurements. Each year consists of blocks of
ten days of the measured years 2011 and 2012 at Bondville, Illinois, which come
with the program. A block begins up to ten days before or after its source.
All sites have the same blocks, so that a year is dull or hot everywhere.

Light     the clearness of the source day (daily light over that outside the
          atmosphere) times the light outside the atmosphere at the site
Air       temperature of the source plus a constant of the site; its relative
          humidity
Rain      drawn: the source has none. A day of low light and humid air is wet
          with a probability of 0.6, another with 0.12, and has an exponential
          amount. These are the frequencies of days with more than 1 mm in
          Champaign, Illinois, May to September of 1995 to 2023 (weather with
          BioCro, github.com/biocro/biocro). The mean amount is one of the site.

Constants of sites are estimates of their climates from May to September (mean
temperature within 1.5 deg C, rain within a quarter).

    python campaigns/weather/make_maize_belt.py FOLDER [YEAR ...]

writes a file for each site, by default with all 30 years."""

import sys
from pathlib import Path

import numpy as np
import pandas as pd
from pvlib.irradiance import get_extra_radiation
from pvlib.solarposition import get_solarposition

FIRST, YEARS, BLOCK, REACH, SEED = 2071, 30, 10, 10, 73
HERE = Path(__file__).resolve().parent
SOURCE_PLACE = (40.05, -88.37, -6)

# name: latitude, longitude, UTC offset, warmer by [K], mean of a wet day [mm]
SITES = {
    "barinas": (7.0, -70.2, -4, 6, 26),
    "thomas_county": (39.35, -101.06, -5, 0, 8.5),
    "ames": (42.0, -93.6, -5, -1, 14),
    "bismarck": (46.8, -100.8, -5, -3, 8),
    "peace_river": (56.2, -117.3, -6, -8, 7),
}


def outside(times: pd.DatetimeIndex, place: tuple[float, ...]) -> np.ndarray:
    """Returns PAR on level ground outside the atmosphere
    [umol m-2 s-1]; 0.45 of the energy at 4.57 umol J-1."""
    sun = get_solarposition(times, *place[:2])["zenith"].to_numpy()
    above = np.maximum(np.cos(np.radians(sun)), 0)
    return 0.45 * 4.57 * get_extra_radiation(times).to_numpy() * above


def read_sources() -> list[pd.DataFrame]:
    """Returns the measured years, with clearness by day and air by step."""
    sources = []
    for year in (2011, 2012):
        table = pd.read_csv(HERE / f"bondville_{year}_0501_0930.csv")
        table.index = pd.DatetimeIndex(pd.to_datetime(table["time"]))
        above = outside(table.index, SOURCE_PLACE)  # middles of hours
        by_day = table["ppfd_umol"].groupby(table.index.date)
        whole = pd.Series(above, table.index).groupby(table.index.date).sum()
        table["clearness"] = (
            (by_day.sum() / whole).loc[table.index.date].to_numpy()
        )
        sources.append(table)
    return sources


def make(folder: Path, years: list[int]) -> None:
    """Writes a file for each site."""
    sources = read_sources()
    days = len(sources[0]) // 24
    draw = np.random.default_rng(SEED)
    made: dict[str, list[pd.DataFrame]] = {name: [] for name in SITES}
    for year in range(FIRST, FIRST + YEARS):
        parts = []
        for first in range(0, days, BLOCK):
            length = min(BLOCK, days - first)
            source = sources[draw.integers(len(sources))]
            begin = first + draw.integers(-REACH, REACH + 1)
            begin = int(np.clip(begin, 0, days - length))
            parts.append(source.iloc[24 * begin : 24 * (begin + length)])
        table = pd.concat(parts)
        clearness = table["clearness"].to_numpy()[::24]
        humidity = table["rh"].to_numpy().reshape(-1, 24).mean(1)
        is_dull = (clearness < 0.7 * np.quantile(clearness, 0.95)) & (
            humidity > 0.7
        )
        is_wet = draw.random(days) < np.where(is_dull, 0.6, 0.12)
        amount = np.where(is_wet, draw.exponential(1, days), 0)
        if year not in years:
            continue
        for name, (*place, warmer, rain) in SITES.items():
            times = pd.date_range(
                f"{year}-05-01", periods=len(table), freq="h"
            )
            middle = times + pd.Timedelta(hours=0.5 - place[2])
            light = outside(middle.tz_localize("UTC"), tuple(place))
            made[name].append(
                pd.DataFrame(
                    {
                        "time": times.strftime("%Y-%m-%dT%H:%M"),
                        "ppfd": (light * table["clearness"].to_numpy())
                        .round()
                        .astype(int),
                        "temp_c": (table["temp_c"].to_numpy() + warmer).round(
                            1
                        ),
                        "rh": (100 * table["rh"].to_numpy())
                        .round()
                        .astype(int),
                        "rain_mm": [
                            x
                            for mm in rain * amount
                            for x in (f"{mm:.1f}", *[""] * 23)
                        ],
                    }
                )
            )
    folder.mkdir(parents=True, exist_ok=True)
    for name, tables in made.items():
        pd.concat(tables).to_csv(folder / f"{name}.csv", index=False)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    make(
        Path(sys.argv[1]),
        [int(x) for x in sys.argv[2:]] or list(range(FIRST, FIRST + YEARS)),
    )
