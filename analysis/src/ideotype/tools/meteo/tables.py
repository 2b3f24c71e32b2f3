# SPDX-License-Identifier: Apache-2.0
"""Reads weather files that pvlib cannot read (NASA POWER, KNMI, DWD) or not
completely: in TMY3, EPW and NSRDB, names in Latin-1 or with commas,
half-hourly data, the last hour of 28 February, and UTC offsets of half
hours."""

from __future__ import annotations

import csv
import io
import re
import zipfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ...errors import Error

#: The columns of readings: light [W m-2], temperature [deg C], relative
#: humidity [%], wind at 10 m [m s-1], pressure [kPa], longwave radiation of
#: the sky [W m-2] and rain [mm h-1].
COLUMNS = (
    "global",
    "beam_normal",
    "diffuse",
    "temperature",
    "humidity",
    "wind",
    "pressure",
    "longwave",
    "rain",
)
_PVLIB = ("ghi", "dni", "dhi", "temp_air", "relative_humidity")
MISSING = [-99, -999, -9900, -9999, 9999, 99999]


@dataclass
class Readings:
    """The data of a weather file: those of COLUMNS that it has, by time stamps
    on its clock."""

    frame: pd.DataFrame
    utc_offset: float
    place: tuple[float, float] | None = None  # Latitude and longitude [deg].
    stamp: str = "end"  # The point of a time step that the stamp denotes.
    is_typical: bool = False  # Whether months are of different years.


def named(
    table: pd.DataFrame,
    names: tuple[str, ...] = _PVLIB,
    pascals: float = 1000,
    **wanted: Any,
) -> Readings:
    """Returns the readings of a table indexed by time stamps, with or without
    a time zone.

    names: columns of the table that correspond to COLUMNS.
    pascals: unit of pressure [Pa].
    wanted: further fields of Readings."""
    index = pd.DatetimeIndex(table.index)
    offset = index[0].utcoffset() if index.tz else pd.Timedelta(0)
    frame = pd.DataFrame(
        {
            ours: pd.to_numeric(table[theirs])
            for ours, theirs in zip(COLUMNS, names)
            if theirs in table.columns
        }
    )
    frame = frame.where(~frame.isin(MISSING))
    if "pressure" in frame:
        frame["pressure"] *= pascals / 1000
    frame.index = index.tz_localize(None).as_unit("ns")
    wanted = {"utc_offset": offset / pd.Timedelta("1h")} | wanted
    return Readings(frame, **wanted)


def read_tmy3(path: Path) -> Readings:
    head, rows = path.read_text(encoding="latin-1").split("\n", 1)
    offset, *place = map(float, next(csv.reader([head]))[3:6])
    table = pd.read_csv(io.StringIO(rows))
    days = pd.to_datetime(table["Date (MM/DD/YYYY)"], format="%m/%d/%Y")
    clock = pd.to_timedelta(table["Time (HH:MM)"] + ":00")
    return named(
        table.set_index(pd.DatetimeIndex(days + clock)),
        (
            *(f"{name} (W/m^2)" for name in ("GHI", "DNI", "DHI")),
            "Dry-bulb (C)",
            "RHum (%)",
            "Wspd (m/s)",
            "Pressure (mbar)",
        ),
        pascals=100,
        utc_offset=offset,
        place=(place[0], place[1]),
    )


def read_epw(path: Path) -> Readings:
    lines = path.read_text(encoding="latin-1").splitlines()
    latitude, longitude, offset = map(float, next(csv.reader(lines))[6:9])
    first = next(
        i for i, x in enumerate(lines) if x.startswith("DATA PERIODS")
    )
    names = dict(enumerate(("year", "month", "day", "hour", "minute")))
    names |= {6: "temperature", 8: "humidity", 13: "global"}
    names |= {14: "beam_normal", 15: "diffuse"}
    names |= {21: "wind", 9: "pressure", 12: "longwave", 33: "rain"}
    table = pd.read_csv(
        io.StringIO("\n".join(lines[first + 1 :])), header=None
    )
    table = table[[x for x in names if x in table]].rename(columns=names)
    unknown = {"temperature": 99.9, "humidity": 999, "wind": 999, "rain": 999}
    table = table.replace(unknown | {"pressure": 999999}, np.nan)
    # A single row per hour, at minute 0 or 60, is the mean of the hour.
    is_parted = table["minute"].nunique() > 1
    minute = table["minute"].where((table["minute"] > 0) & is_parted, 60)
    stamps = (
        pd.to_datetime(table[["year", "month", "day"]])
        + pd.to_timedelta(table["hour"] - 1, "h")
        + pd.to_timedelta(minute, "min")
    )
    return named(
        table.set_index(pd.DatetimeIndex(stamps)),
        COLUMNS,
        pascals=1,
        utc_offset=offset,
        place=(latitude, longitude),
    )


def read_nsrdb(path: Path) -> Readings:
    meta = pd.read_csv(path, nrows=1, encoding="latin-1").iloc[0]
    table = pd.read_csv(path, skiprows=2, encoding="latin-1")
    table = table.loc[:, ~table.columns.str.startswith("Unnamed")]
    names = ["Year", "Month", "Day", "Hour", "Minute"]
    table.index = pd.DatetimeIndex(pd.to_datetime(table[names]))
    hourly = len(table) > 1 and (table["Minute"].iloc[:2] == 0).all()
    return named(
        table,
        (
            *("GHI", "DNI", "DHI", "Temperature", "Relative Humidity"),
            *("Wind Speed", "Pressure"),
        ),
        pascals=100,
        utc_offset=float(meta["Time Zone"]),
        place=(float(meta["Latitude"]), float(meta["Longitude"])),
        # Hourly files from before May 2019 have minute 0 in each row.
        stamp="beginning" if hourly else "middle",
    )


def read_power(path: Path) -> Readings:
    head, _, rows = path.read_text(encoding="latin-1").partition(
        "-END HEADER-"
    )
    table = pd.read_csv(io.StringIO(rows.lstrip()))
    place = re.search(r"latitude +(\S+) +longitude +(\S+)", head)
    if "HR" not in table or not place:
        raise Error(
            f"{path}: there is no column HR, or no location in the header; "
            "download the hourly data of one point with the header"
        )
    light = ("ALLSKY_SFC_SW_DWN", "ALLSKY_SFC_SW_DNI", "ALLSKY_SFC_SW_DIFF")
    longwave = "ALLSKY_SFC_LW_DWN"
    factors = {"kwhr": 1e3, "kwh": 1e3, "mj": 1e6 / 3600, "kj": 1e3 / 3600}
    for name in (*light, longwave):
        line = re.search(rf"^{name} .*\(([^()]*)\) *$", head, re.MULTILINE)
        if line and name in table:
            unit = line[1].lower().replace("-", "").split("/")[0]
            known = table[name].where(~table[name].isin(MISSING))
            table[name] = known * factors.get(unit, 1)
    latitude, longitude = float(place[1]), float(place[2])
    dates = {"year": table.YEAR, "month": table.MO, "day": table.DY}
    table.index = pd.DatetimeIndex(
        pd.to_datetime(pd.DataFrame(dates | {"hour": table.HR}))
    )
    is_utc = re.search(r"^Dates.*UTC *$", head, re.MULTILINE)
    return named(
        table,
        (*light, "T2M", "RH2M", "WS10M", "PS", longwave, "PRECTOTCORR"),
        utc_offset=0 if is_utc else round(longitude / 15),
        place=(latitude, longitude),
        stamp="beginning",
    )


def read_knmi(path: Path) -> Readings:
    head: list[str] = []
    rows: list[str] = []
    for line in path.read_text(encoding="latin-1").splitlines():
        is_row = re.match(r"\s*\d+ *, *\d{8},", line)
        (rows if is_row else head).append(line)
    (names,) = (line for line in head if re.match("# ?STN, *YYYYMMDD", line))
    table = pd.read_csv(
        io.StringIO("\n".join(rows)),
        names=[name.strip(" #") for name in names.split(",")],
        skipinitialspace=True,
        index_col=False,
    )
    station = _only(path, table["STN"])
    day = pd.to_datetime(table["YYYYMMDD"], format="%Y%m%d")
    table.index = pd.DatetimeIndex(day + pd.to_timedelta(table["HH"], "h"))
    # The unit of the file is J/cm2.
    table["Q"] = pd.to_numeric(table["Q"]) * 1e4 / 3600
    if "T" in table:
        # The unit of the file is 0.1 deg C.
        table["T"] = pd.to_numeric(table["T"]) / 10
    if "RH" in table:
        # The unit of the file is 0.1 mm; -1 is less than 0.05 mm.
        table["RH"] = pd.to_numeric(table["RH"]).clip(lower=0) / 10
    place = re.search(
        rf"^# *{station}:? +(-?[\d.]+) +(-?[\d.]+) ",
        "\n".join(head),
        re.MULTILINE,
    )
    return named(
        table,
        ("Q", "", "", "T", "U", "", "", "", "RH"),
        place=(float(place[2]), float(place[1])) if place else None,
    )


def read_dwd(path: Path) -> Readings:
    """Reads hourly or ten-minute light, or temperature, in UTC. Hours of light
    end at full hours of true solar time."""
    text = io.BytesIO(path.read_bytes())
    if path.suffix == ".zip":
        with zipfile.ZipFile(text) as folder:
            (name,) = (n for n in folder.namelist() if n.startswith("produkt"))
            text = io.BytesIO(folder.read(name))
    table = pd.read_csv(text, sep=";", skipinitialspace=True)
    table.columns = table.columns.str.strip()
    _only(path, table["STATIONS_ID"])
    stamps = table["MESS_DATUM"].astype(str).str.replace(":", "").str.strip()
    table.index = pd.DatetimeIndex(
        pd.to_datetime(stamps.str.ljust(12, "0"), format="%Y%m%d%H%M")
    )
    ours = {"FG": "ghi", "GS": "ghi", "FD": "dhi", "DS": "dhi"}
    for name in table.columns:
        if name[:2] in ours and "_" in name:
            seconds = 600 if name.endswith("_10") else 3600
            # The unit of the file is J/cm2.
            energy = table[name].where(table[name] >= 0)
            table[ours[name[:2]]] = energy * 1e4 / seconds
        elif name[:3] in ("TT_", "RF_"):
            table[name[:2]] = table[name]
    return named(table, ("ghi", "", "dhi", "TT", "RF"))


def _only(path: Path, stations: pd.Series) -> Any:
    names = stations.unique()
    if len(names) != 1:
        raise Error(
            f"{path}: there are {len(names)} stations "
            f"({', '.join(map(str, names[:9]))}); keep the rows of one"
        )
    return names[0]
