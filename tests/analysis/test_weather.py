# SPDX-License-Identifier: Apache-2.0
"""The weather that a history holds is what pvlib, which is independent code,
reads from the same file: a whole typical year, and small files of other
formats."""

from __future__ import annotations

import tomllib
from pathlib import Path

import h5py
import numpy as np
import pandas as pd
import pvlib
import pytest
from real_program import output_of, write_campaign

DATA = Path(__file__).parents[1] / "data" / "weather"
YEAR = Path(pvlib.__file__).parent / "data" / "723170TYA.CSV"
PAR = 0.45  # of all solar radiation

_SITE = """
[[site]]
name = "greensboro"
latitude = 36.1
longitude = -79.95
utc_offset = -5
elevation = 273

[[climate]]
name = "period"
file = "{file}"
from = 1981-{first}
to = 1981-{last}

"""


def read_year(path: Path) -> pd.DataFrame:
    return pvlib.iotools.read_tmy3(path, map_variables=True)[0]


def read_epw(path: Path) -> pd.DataFrame:
    return pvlib.iotools.read_epw(path)[0]


def read_nsrdb(path: Path) -> pd.DataFrame:
    return pvlib.iotools.read_nsrdb_psm4(path)[0]


CASES = {
    "a typical year": (YEAR, "01-01", "12-31", read_year),
    "TMY3": (DATA / "tmy3.csv", "07-01", "07-05", read_year),
    "EPW": (DATA / "small.epw", "07-01", "07-05", read_epw),
    "NSRDB": (DATA / "nsrdb.csv", "07-01", "07-05", read_nsrdb),
}


def weather_of(folder: Path, file: Path, first: str, last: str) -> dict:
    """What the program reads for a campaign of this period."""
    campaign = write_campaign(folder, 1)
    text = campaign.read_text()
    begin, end = text.index("[[site]]"), text.index("[[spacing]]")
    table = _SITE.format(file=file, first=first, last=last)
    campaign.write_text(text[:begin] + table + text[end:])
    output_of("run", campaign, "--out", folder)
    (path,) = (folder / "tiny").glob("*.h5")
    with h5py.File(path) as history:
        resolved = history["campaign/resolved"].asstr()[()]
    (weather,) = tomllib.loads(resolved)["weather"]
    return weather


@pytest.mark.parametrize("name", CASES)
def test_weather_is_what_pvlib_reads(name: str, tmp_path: Path) -> None:
    file, first, last, read = CASES[name]
    weather = weather_of(tmp_path, file, first, last)
    table = read(file)
    steps = len(table)
    assert len(weather["dates"]) * 24 == steps
    assert weather["hours"] == [hour + 0.5 for hour in range(24)]
    at = pd.DatetimeIndex(
        [pd.Timestamp(date) for date in weather["dates"] for _ in range(24)]
    ) + pd.to_timedelta(np.tile(weather["hours"], steps // 24), "h")
    sun = pvlib.solarposition.get_solarposition(
        at.tz_localize("Etc/GMT+5"), 36.1, -79.95
    )
    cosine = np.cos(np.radians(sun.zenith.to_numpy()))
    found = np.array(weather["beam"]) + np.array(weather["diffuse"])
    ghi, dhi = table.ghi.to_numpy(), table.dhi.to_numpy()
    assert found == pytest.approx(PAR * ghi, abs=1e-9)
    temperature = table.temp_air.to_numpy()
    assert np.array(weather["temperature"]) == pytest.approx(temperature)
    # Diffuse light as given, but with the sun at or below the horizon, and where
    # the beam would be more than there is outside the atmosphere.
    is_up = cosine > 0.02
    outside = (
        pvlib.irradiance.get_extra_radiation(at, 1361.1).to_numpy() * cosine
    )
    plain = is_up & (ghi - dhi < 0.99 * outside)
    diffuse = np.array(weather["diffuse"])
    assert diffuse[plain] == pytest.approx(
        PAR * np.minimum(dhi, ghi)[plain], abs=1e-9
    )
    assert plain[ghi > 0].mean() > 0.9
    assert np.array(weather["beam"])[cosine < -0.01] == pytest.approx(0)
