# SPDX-License-Identifier: Apache-2.0
"""Writes days of weather as files of many formats; all contain the same
data."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pandas as pd
import pvlib

DATA = Path(__file__).parents[1] / "data" / "weather"
SHIPPED = Path(pvlib.__file__).parent / "data"
LIGHT = ["global", "beam_normal", "diffuse"]
HOUR = pd.Timedelta("1h")


def read_expected() -> pd.DataFrame:
    """Returns the weather in all files of DATA, by the middles of hours, with
    the columns of a converted file."""
    table = pd.read_csv(DATA / "expected.csv")
    table.index = pd.to_datetime(table["date"]) + pd.to_timedelta(
        table["hour"], "h"
    )
    names = {"ghi": "global", "dni": "beam_normal", "dhi": "diffuse"}
    table = table.rename(columns=names)
    return table[[*LIGHT, "temperature", "humidity"]].astype(float)


def minutes(step: int) -> pd.DataFrame:
    """Returns the weather in UTC in equal steps within hours, by their
    beginnings."""
    table = read_expected()
    table.index += 5 * HOUR - HOUR / 2
    table.loc[table.index[-1] + HOUR] = np.nan
    return table.resample(f"{step}min").ffill().iloc[:-1]


def write_surfrad(file: Path) -> None:
    rows = [
        f" {t:%Y} {t.day_of_year} {t:%m %d %H %M} 0 0 {r['global']:.1f} 0 0 0 "
        f"{r.beam_normal:.1f} 0 {r.diffuse:.1f} 0 {'0 0 ' * 11}"
        f"{r.temperature:.1f} 0 {r.humidity:.1f} 0 0 0 0 0 1000 0"
        for t, r in minutes(1).iterrows()
    ]
    head = " Made\n   36.10   79.95 273 m version 1\n"
    file.write_text(head + "\n".join(rows) + "\n")


def write_solrad(file: Path) -> None:
    rows = [
        f"{t.year:5}{t.day_of_year:4}{t.month:3}{t.day:3}{t.hour:3}{t.minute:3}"
        f"{0.0:7.3f}{0.0:7.2f}{r['global']:8.1f} 0{r.beam_normal:8.1f} 0"
        f"{r.diffuse:8.1f} 0{0.0:8.1f} 0{0.0:8.1f} 0"
        + f"{0.0:10.3f}" * 3
        + f"{0.0:9.3f}"
        for t, r in minutes(1).iterrows()
    ]
    head = " Made\n  36.10  79.95 273.0 -5\n"
    file.write_text(head + "\n".join(rows) + "\n")


def write_bsrn(file: Path) -> None:
    head = ["*U0001", "  1  7 1981  1", "*U0004", " 1  1  1", " 1  1"]
    head += ["nowhere", "0                   0", "0               0"]
    head += [f"{36.1 + 90:7.3f} {180 - 79.95:7.3f}  273 00000", "x", "-1 -1"]
    rows = []
    for t, r in minutes(1).iterrows():
        rows.append(
            f"{t.day:3} {t.hour * 60 + t.minute:5} {r['global']:6.1f}"
            f"   0.0  0.0  0.0{r.beam_normal:7.1f}   0.0  0.0  0.0"
        )
        rows.append(
            f"          {r.diffuse:6.1f}   0.0  0.0  0.0 -999.0 -99.9 -999"
            f" -999{r.temperature:9.1f}{r.humidity:6.1f} 1000"
        )
    file.write_text("\n".join([*head, "*U0100", *rows]) + "\n")


def write_crn(file: Path) -> None:
    rows = []
    for t, r in minutes(5).iterrows():
        t += pd.Timedelta("5min")
        rows.append(
            f"12345 {t:%Y%m%d} {t:%H%M} {t:%Y%m%d} {t:%H%M}      3  -79.95"
            f"   36.10 {r.temperature:7.1f}     0.0 {r['global']:6.0f} 0    20.0"
            f" C 0 {r.humidity:5.0f} 0   0.100     9.0   100 0   1.00 0"
        )
    file.write_text("\n".join(rows) + "\n")


def write_cams(file: Path) -> None:
    rows = []
    for t, r in minutes(15).iterrows():
        end = t + pd.Timedelta("15min")
        energy = ";".join(f"{r[name] / 4:.4f}" for name in LIGHT)
        rows.append(
            f"{t:%Y-%m-%dT%H:%M:%S.0}/{end:%Y-%m-%dT%H:%M:%S.0};{energy}"
        )
    file.write_text(
        "# Latitude (positive North, ISO 19115): 36.1000\n"
        "# Longitude (positive East, ISO 19115): -79.9500\n"
        "# Altitude (m): 273.00\n"
        "# Summarization (integration) period: 0 year 0 month 0 day 0 h 15 min"
        " 0 s\n# Observation period;GHI;BNI;DHI\n" + "\n".join(rows) + "\n"
    )


def write_pvgis(file: Path) -> None:
    rows = [
        f"{t:%Y%m%d:%H%M},{r['global'] - r.diffuse:.1f},{r.diffuse:.1f},0,0,"
        f"{r.temperature},0,0"
        for t, r in (minutes(60).pipe(at_half)).iterrows()
    ]
    file.write_text(
        "Latitude (decimal degrees):\t36.1\nLongitude (decimal degrees):\t"
        "-79.95\nElevation (m):\t273\nRadiation database:\tmade\n\n"
        "Slope: 0 deg. \nAzimuth: 0 deg. \n"
        "time,Gb(i),Gd(i),Gr(i),H_sun,T2m,WS10m,Int\n"
        + "\n".join(rows)
        + "\n\nT2m: made\n"
    )


def at_half(table: pd.DataFrame) -> pd.DataFrame:
    return table.set_axis(table.index + HOUR / 2)


def write_knmi(file: Path) -> None:
    rows = []
    for t, r in minutes(60).iterrows():
        # The unit of the file is J/cm2.
        energy = r["global"] * 0.36
        rows.append(
            f"  260,{t:%Y%m%d},{t.hour + 1:5},  180,{10 * r.temperature:5.0f},"
            f"{energy:9.3f},     ,{r.humidity:5.0f}"
        )
    file.write_text(
        "# BRON: made\n# STN         LON(east)   LAT(north)  ALT(m)  NAME\n"
        "# 260         -79.950     36.100      1.90    MADE\n"
        "# STN,YYYYMMDD,   HH,   DD,    T,    Q,   RH,    U\n#\n"
        + "\n".join(rows)
        + "\n"
    )


def write_dwd(file: Path) -> None:
    """Writes the light in ten-minute steps in the format of DWD."""
    rows = [
        f"       123;{t + pd.Timedelta('10min'):%Y%m%d%H%M};    3;"
        f"{r.diffuse * 0.06:.5f};{r['global'] * 0.06:.5f};0.1;  -999;eor"
        for t, r in minutes(10).iterrows()
    ]
    head = "STATIONS_ID;MESS_DATUM;  QN;DS_10;GS_10;SD_10;LS_10;eor\n"
    file.write_text(head + "\n".join(rows) + "\n")


MADE: dict[str, tuple[Callable[[Path], None], list[str]]] = {
    "surfrad": (write_surfrad, [*LIGHT, "temperature", "humidity"]),
    "solrad": (write_solrad, LIGHT),
    "bsrn": (write_bsrn, [*LIGHT, "temperature", "humidity"]),
    "crn": (write_crn, ["global", "temperature", "humidity"]),
    "cams": (write_cams, LIGHT),
    "pvgis": (write_pvgis, ["global", "diffuse", "temperature"]),
    "knmi": (write_knmi, ["global", "temperature", "humidity"]),
    "dwd": (write_dwd, ["global", "diffuse"]),
}
