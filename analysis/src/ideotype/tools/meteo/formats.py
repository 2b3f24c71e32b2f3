# SPDX-License-Identifier: Apache-2.0
"""Reads weather files of many formats into tables of one form, most of them by
pvlib.iotools."""

from __future__ import annotations

import gzip
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pandas as pd

from ...errors import Error
from .tables import (
    Readings,
    named,
    read_dwd,
    read_epw,
    read_knmi,
    read_nsrdb,
    read_power,
    read_tmy3,
)


def read(path: Path, form: str) -> Readings:
    """Reads a file in a format of FORMATS; "auto": by the beginning of the
    file.

    Raises Error if the format is unknown, and the errors of the reader."""
    if form == "auto":
        form = _detect_format(path)
    readings = FORMATS[form](path)
    readings.frame = readings.frame.astype(float).dropna(axis=1, how="all")
    days = (readings.frame.index - pd.Timedelta("1s")).to_series()
    # In a typical year, consecutive months come from different years.
    readings.is_typical |= bool(
        ((days.diff().abs() > pd.Timedelta("1D")) & days.dt.year.diff().ne(0))
        .iloc[1:]
        .any()
    )
    return readings


def _detect_format(path: Path) -> str:
    if path.suffix == ".zip":
        return "dwd"
    opened: Callable = gzip.open if path.suffix == ".gz" else open
    with opened(path, "rt", encoding="latin-1") as file:
        text = file.read(20000)
    for form, pattern in {
        "epw": r"LOCATION,",
        "power": r"-BEGIN HEADER-",
        "nsrdb": r"Source,Location ID",
        "tmy3": r".*\nDate \(MM/DD/YYYY\),Time \(HH:MM\)",
        "tmy2": r" \d{5} .* [NS] +\d+ +\d+ +[EW] +\d+ +\d+",
        "bsrn": r"\*[CU]0001",
        "dwd": r"STATIONS_ID *; *MESS_DATUM",
        "knmi": r"(?s:.*)# ?STN, *YYYYMMDD, *HH",
        "cams": r"(?s:.*)# Observation period;",
        "pvgis": r"Latitude \(decimal degrees\)|\{(?s:.*)\"PVGIS|\{\"inputs\"",
        "crn": r" *\d+ \d{8} +\d+ \d{8} +\d+ ",
        "surfrad": r".*\n +-?[\d.]+ +-?[\d.]+ +\d+ m version",
        "solrad": r".*\n *-?\d+\.\d+ +-?\d+\.\d+ +\d+[\d.]* +-\d",
    }.items():
        if re.match(pattern, text):
            return form
    raise Error(
        f"{path}: this is no file of a known format ({', '.join(FORMATS)}); "
        "name it with --format, or map the columns of a CSV file in the "
        "campaign"
    )


def _place(meta: Any) -> tuple[float, float]:
    return float(meta["latitude"]), float(meta["longitude"])


def _tmy2(path: Path) -> Readings:
    table, meta = _iotools().read_tmy2(str(path))
    table["DryBulb"] /= 10
    return named(
        table,
        ("GHI", "DNI", "DHI", "DryBulb", "RHum"),
        place=_place(meta),
        stamp="beginning",
        is_typical=True,
    )


def _pvlib(
    reader: str, *, stamp: str = "beginning", is_west: bool = False
) -> Callable[[Path], Readings]:
    """Returns a reader for files that pvlib.iotools reads with standard column
    names, with the location in the metadata or in each row. is_west: whether
    the network omits the minus sign of western longitudes."""

    def read_it(path: Path) -> Readings:
        data = getattr(_iotools(), reader)(str(path))
        is_pair = isinstance(data, tuple)
        table, meta = data if is_pair else (data, data.iloc[0])
        latitude, longitude = _place(meta)
        place = latitude, -abs(longitude) if is_west else longitude
        return named(table, place=place, stamp=stamp)

    return read_it


def _pvgis(path: Path) -> Readings:
    """Reads hourly data or a typical year; time stamps are instants."""
    text = path.read_text()
    form = "json" if text.lstrip().startswith("{") else "csv"
    if "time(UTC)" in text:
        table, meta = _iotools().read_pvgis_tmy(path, form)
        offset = re.search(r"(?i)time[ _]offset[^\d-]*(-?[\d.]+)", text)
        minutes = round(float(offset[1]) * 60) if offset else 0
        table.index += pd.to_timedelta(minutes, "min")
    else:
        table, meta = _iotools().read_pvgis_hourly(path, form)
        slope = re.search(
            r"Slope: *([\d.]+)|\"slope\": *\{\"value\": *([\d.]+)", text
        )
        if slope and float(slope[1] or slope[2]) != 0:
            raise Error(
                f"{path}: this file has light on a tilted plane; download "
                "it with slope 0"
            )
        parts = [
            name for name in table if re.match("poa_.*(direct|diffuse)", name)
        ]
        table["ghi"] = (
            table[parts].sum(axis=1) if parts else table["poa_global"]
        )
        if parts:
            table["dhi"] = table["poa_sky_diffuse"]
    place = meta["inputs"].get("location", meta["inputs"])
    return named(table, place=_place(place), stamp="middle")


def _iotools() -> Any:
    from pvlib import iotools

    return iotools


FORMATS: dict[str, Callable[[Path], Readings]] = {
    "tmy3": read_tmy3,
    "tmy2": _tmy2,
    "epw": read_epw,
    "nsrdb": read_nsrdb,
    "power": read_power,
    "surfrad": _pvlib("read_surfrad", is_west=True),
    "solrad": _pvlib("read_solrad", is_west=True),
    "pvgis": _pvgis,
    "bsrn": _pvlib("read_bsrn"),
    "crn": _pvlib("read_crn", stamp="end"),
    "cams": _pvlib("read_cams"),
    "knmi": read_knmi,
    "dwd": read_dwd,
}
