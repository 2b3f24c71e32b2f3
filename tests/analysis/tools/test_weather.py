# SPDX-License-Identifier: Apache-2.0
"""Conversions by `ideotype weather` agree with pvlib, which is independent
code, and the program reads the same values from the converted file."""

from __future__ import annotations

import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import h5py
import numpy as np
import pandas as pd
import pvlib
import pytest
from made_weather import (
    DATA,
    HOUR,
    MADE,
    SHIPPED,
    minutes,
    read_expected,
    write_dwd,
)
from real_program import output_of, write_campaign

from ideotype.tools.weather import main

YEAR = SHIPPED / "723170TYA.CSV"
PAR = 0.45  # The fraction of PAR in solar radiation.

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
from = {first}
to = {last}

"""


def convert(folder: Path, *arguments: object) -> pd.DataFrame:
    """Returns the table that the command writes, by the middles of time steps
    on its clock."""
    to = folder / "weather.csv"
    assert main([*map(str, arguments), "--to", str(to)]) == 0
    return read(to)


def read(file: Path) -> pd.DataFrame:
    table = pd.read_csv(file, comment="#", index_col="time")
    table.index = pd.DatetimeIndex(table.index.str[:19])
    return table


def read_weather(folder: Path, file: Path, first: str, last: str) -> dict:
    """Returns the weather that the program reads for a campaign of the given
    period."""
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


@pytest.mark.parametrize("year", [1981, 2023])
def test_the_program_reads_a_typical_year_as_pvlib(
    year: int, tmp_path: Path
) -> None:
    first, last = f"{year}-01-01", f"{year}-12-31"
    convert(tmp_path, YEAR, "--from", first, "--until", last)
    weather = read_weather(tmp_path, tmp_path / "weather.csv", first, last)
    table = pvlib.iotools.read_tmy3(YEAR, map_variables=True)[0]
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
    # Diffuse light is unchanged, except if the sun is at or below the horizon
    # or if the beam would exceed the extraterrestrial beam.
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


@pytest.mark.parametrize(
    "name",
    ["tmy3.csv", "small.epw", "nsrdb.csv", "power_utc.csv", "power_lst.csv"],
)
def test_formats_of_earlier_versions_are_converted(
    name: str, tmp_path: Path
) -> None:
    converted = convert(tmp_path, DATA / name)
    # test_wind_and_pressure_are_converted() tests other columns.
    others = ["wind", "pressure", "rain"]
    converted = converted.drop(columns=others, errors="ignore")
    expected = read_expected()[list(converted)]
    assert ("diffuse" in converted) == (name != "power_lst.csv")
    assert list(converted.index) == list(expected.index)
    assert converted.to_numpy() == pytest.approx(expected.to_numpy(), rel=1e-5)


@pytest.mark.parametrize("name", ["tmy3.csv", "small.epw"])
def test_wind_and_pressure_are_converted(name: str, tmp_path: Path) -> None:
    converted = convert(tmp_path, DATA / name)
    assert "longwave" not in converted
    assert converted["pressure"].iloc[0] == pytest.approx(98.6)
    if name == "tmy3.csv":
        assert converted["wind"].iloc[0] == pytest.approx(2.6)


def test_rain_of_power_is_converted(tmp_path: Path) -> None:
    """Rain is a rate [mm h-1], so that means over longer steps stay true."""
    head, table = (DATA / "power_utc.csv").read_text().split("-END HEADER-\n")
    names, *rows = table.splitlines()
    lines = [f"{names},PRECTOTCORR"]
    lines += [f"{row},{0.5 * (i % 4)}" for i, row in enumerate(rows)]
    file = tmp_path / "rain.csv"
    file.write_text(head + "-END HEADER-\n" + "\n".join(lines) + "\n")
    converted = convert(tmp_path, file)
    assert converted["rain"].iloc[:5].tolist() == [0, 0.5, 1, 1.5, 0]
    weather = read_weather(
        tmp_path, tmp_path / "weather.csv", "1981-07-02", "1981-07-03"
    )
    assert sum(weather["rain"]) == pytest.approx(48 * 0.75)


def test_the_program_reads_the_converted_file(tmp_path: Path) -> None:
    convert(tmp_path, DATA / "nsrdb.csv")
    written = (tmp_path / "weather.csv").read_text()
    assert written == (DATA / "converted.csv").read_text()
    weather = read_weather(
        tmp_path, tmp_path / "weather.csv", "1981-07-01", "1981-07-05"
    )
    found = np.array(weather["beam"]) + np.array(weather["diffuse"])
    assert found == pytest.approx(PAR * read_expected()["global"].to_numpy())


def test_the_error_for_another_format_states_the_conversion(
    tmp_path: Path,
) -> None:
    """The command given in the error message must work."""
    file = tmp_path / "mine.epw"
    file.write_bytes((DATA / "small.epw").read_bytes())
    with pytest.raises(AssertionError) as failure:
        read_weather(tmp_path, file, "1981-07-02", "1981-07-03")
    (command,) = (
        line.split("ideotype weather", 1)[1]
        for line in str(failure.value).splitlines()
        if "ideotype weather" in line
    )
    done = subprocess.run(
        f"{sys.executable} -m ideotype.tools.weather {command}",
        shell=True,
        check=True,
        capture_output=True,
        text=True,
    )
    assert 'file = "mine_weather.csv"' in done.stdout
    assert "from = 1981-07-02\nto = 1981-07-03" in done.stdout
    assert len(read(tmp_path / "mine_weather.csv")) == 48


def test_files_that_pvlib_refuses_or_misreads_are_converted(
    tmp_path: Path,
) -> None:
    """The cases are half-hourly data, names in Latin-1, names with commas, the
    end of 28 February in a leap year, and clocks offset by half an hour."""
    sun = read_expected()["global"].iloc[:24].tolist()
    head = "LOCATION,S\xe3o,b,c,d,1,36.1,-79.95,-5.5,300\nDATA PERIODS,1,2\n"
    rows = [
        f"2011,7,{day},{hour + 1},{minute},?,20,1,50,9,9,9,9,{sun[hour]},9999,9999"
        for day in range(1, 11)
        for hour in range(24)
        for minute in (30, 60)
    ]
    file = tmp_path / "half.epw"
    file.write_text(head + "\n".join(rows) + "\n", encoding="latin-1")
    converted = convert(tmp_path, file)
    assert len(converted) == 480
    assert converted.index[0] == pd.Timestamp("2011-07-01 00:15")
    assert converted["global"].iloc[24] == sun[12]
    assert "beam_normal" not in converted
    assert "-05:30" in (tmp_path / "weather.csv").read_text()
    head = (
        '1,"MADE, FOR A TEST",NC,-5.0,36.1,-79.95,300\n'
        "Date (MM/DD/YYYY),Time (HH:MM),GHI (W/m^2),Dry-bulb (C),RHum (%)\n"
    )
    rows = [
        f"{day:%m/%d/%Y},{hour + 1:02}:00,{sun[hour]},-9900,50"
        for day in pd.date_range("2012-02-20", "2012-02-28")
        for hour in range(24)
    ]
    file.write_text(head + "\n".join(rows) + "\n")
    converted = convert(tmp_path, file)
    assert converted.index[-1] == pd.Timestamp("2012-02-28 23:30")
    assert list(converted) == ["global", "humidity"]


# ------------------------------------------------------------- other formats


@pytest.mark.parametrize("form", MADE)
def test_files_of_other_formats_are_converted(
    form: str, tmp_path: Path
) -> None:
    write, columns = MADE[form]
    file = tmp_path / f"file.{'csv' if form == 'pvgis' else 'txt'}"
    write(file)
    place = ["--latitude", 36.1, "--longitude", -79.95]
    converted = convert(tmp_path, file, "--step", 60, *place)
    assert list(converted) == columns
    expected = read_expected().reindex(converted.index)[columns]
    assert len(converted) == 120
    assert np.abs(converted - expected).max(axis=None) <= (
        0.51 if form in ("crn", "knmi") else 0.06
    )


def test_hours_of_true_solar_time_keep_their_light(
    tmp_path: Path,
) -> None:
    """In files of DWD, hours of light end some minutes after full hours of the
    clock; temperature is in a separate file."""
    light = minutes(1)[["global"]]
    light.index += pd.Timedelta("18min")
    hours = light.resample("1h", offset="18min").mean()
    rows = [
        f"123;{t + HOUR:%Y%m%d%H:%M};1;-999;-999;{v * 0.36:.4f};0;50;x;eor"
        for t, v in hours["global"].items()
    ]
    head = "STATIONS_ID;MESS_DATUM;QN_592;ATMO_LBERG;FD_LBERG;FG_LBERG;"
    text = head + "SD_LBERG;ZENIT;MESS_DATUM_WOZ;eor\n" + "\n".join(rows)
    with zipfile.ZipFile(tmp_path / "light.zip", "w") as folder:
        folder.writestr("Metadaten_Geographie_123.txt", "x")
        folder.writestr("produkt_st_stunde_123.txt", text)
    air = minutes(60)
    rows = [
        f"123;{t + HOUR:%Y%m%d%H};9;{r.temperature:6.1f};{r.humidity:6.1f};eor"
        for t, r in air.iterrows()
    ]
    head = "STATIONS_ID;MESS_DATUM;QN_9;TT_TU;RF_TU;eor\n"
    (tmp_path / "air.txt").write_text(head + "\n".join(rows))
    place = ["--latitude", 36.1, "--longitude", -79.95]
    files = (tmp_path / "light.zip", tmp_path / "air.txt")
    converted = convert(tmp_path, *files, *place)
    expected = read_expected()
    assert list(converted) == ["global", "temperature", "humidity"]
    shifted = light["global"].resample("1D").mean()
    assert converted["global"].sum() == pytest.approx(
        expected["global"].sum(), rel=0.01
    )
    assert len(shifted) >= 5
    known = converted["temperature"].dropna()
    assert known.to_numpy() == pytest.approx(
        expected["temperature"].reindex(known.index).to_numpy()
    )


def test_a_typical_year_of_pvgis_begins_on_the_site_s_clock(
    tmp_path: Path,
) -> None:
    year = pd.read_csv(SHIPPED / "723170TYA.CSV", skiprows=1)
    utc = pd.date_range("2005-01-01", periods=8760, freq="1h")
    columns = ["Dry-bulb (C)", "RHum (%)", "GHI (W/m^2)"]
    values = np.roll(year[columns].to_numpy(), 5, axis=0)
    rows = [
        f"{t:%Y%m%d:%H%M},{a},{b},{g},0,0,0,0,0,0"
        for t, (a, b, g) in zip(utc, values)
    ]
    head = "Latitude (decimal degrees): 36.1\nLongitude (decimal degrees): "
    head += "-79.95\nElevation (m): 273\nIrradiance Time Offset (h): 0.5\n"
    head += "month,year\n" + "".join(f"{m},2005\n" for m in range(1, 13))
    names = "time(UTC),T2m,RH,G(h),Gb(n),Gd(h),IR(h),WS10m,WD10m,SP\n"
    file = tmp_path / "tmy.csv"
    file.write_text(head + names + "\n".join(rows) + "\n\n")
    text = file.read_text()
    for month, other in ((2, 2011), (7, 2015)):
        text = text.replace(f"\n2005{month:02}", f"\n{other}{month:02}")
    file.write_text(text)
    converted = convert(
        tmp_path, file, "--from", "2023-01-01", "--until", "2023-12-31"
    )
    assert len(converted) == 8760
    assert converted.index[0] == pd.Timestamp("2023-01-01 00:30")
    assert converted["global"].to_numpy() == pytest.approx(
        year["GHI (W/m^2)"].to_numpy()
    )


# ---------------------------------------------------------------- checks


def without_hours(folder: Path, *hours: int) -> Path:
    """Writes the NSRDB file without the given hours."""
    lines = (DATA / "nsrdb.csv").read_text().splitlines()
    for hour in sorted(hours, reverse=True):
        del lines[3 + hour]
    file = folder / "gaps.csv"
    file.write_text("\n".join(lines) + "\n")
    return file


def test_gaps_are_reported_with_their_dates_and_can_be_filled(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = without_hours(tmp_path, 34, 36, 37, 50)
    converted = convert(tmp_path, file)
    warnings = capsys.readouterr().err
    assert "the light from 1981-07-02 10:00 to 1981-07-02 11:00" in warnings
    assert "the light from 1981-07-02 12:00 to 1981-07-02 14:00" in warnings
    assert "2 gaps by day, the longest of 2 h" in warnings
    assert "--fill HOURS" in warnings
    assert converted["global"].isna().sum() == 4
    converted = convert(tmp_path, file, "--fill", 1)
    assert converted["global"].isna().sum() == 2
    assert "1 gaps by day" in capsys.readouterr().err
    converted = convert(tmp_path, file, "--fill", 2)
    assert capsys.readouterr().err == ""
    expected = read_expected()
    assert not converted.isna().any(axis=None)
    for hour in (34, 36, 37):
        near = expected["global"].iloc[[hour - 2, hour + 2]]
        assert near.min() * 0.8 < converted["global"].iloc[hour] < 1100


def test_a_wrong_clock_or_location_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    to = ["--to", str(tmp_path / "x.csv")]
    text = YEAR.read_text().replace(",-5.0,36.1", ",-3.0,36.1", 1)
    file = tmp_path / "clock.csv"
    file.write_text(text)
    assert main([str(file), *to]) == 3
    assert "the light comes 2 h earlier" in capsys.readouterr().err
    near = ["--latitude", "36.1", "--longitude"]
    assert main([str(YEAR), *near, "-72", *to]) == 3
    assert "km from the site (another climate)" in capsys.readouterr().err
    assert main([str(YEAR), *near, "-79.3", *to]) == 0
    assert "58 km from the site" in capsys.readouterr().err
    write_dwd(tmp_path / "dwd.txt")
    assert main([str(tmp_path / "dwd.txt"), *to]) == 3
    assert "give --latitude and --longitude" in capsys.readouterr().err


def test_errors_of_unreadable_files_take_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    to = ["--to", str(tmp_path / "x.csv")]
    file = tmp_path / "file.csv"
    for text, words in {
        "a,b\n1,2\n": "no file of a known format",
        "LOCATION,a,b,c,d,1,north,-90,-6,300\n": "cannot be read",
        "-BEGIN HEADER-\n-END HEADER-\nYEAR,DOY,T2M\n1,1,1\n": "no column HR",
        "Source,Location ID\nNSRDB,1\nYear\n1\n": "cannot be read",
    }.items():
        file.write_text(text)
        assert main([str(file), *to]) == 3
        message = capsys.readouterr().err
        assert words in message and message.count("\n") == 1
    assert main([str(tmp_path / "none.csv"), *to]) == 1
    assert "none.csv" in capsys.readouterr().err
    assert (
        main([str(YEAR), *to, "--from", "2023-01-01", "--until", "2024-12-31"])
        == 3
    )
    assert "longer than the typical year" in capsys.readouterr().err
    assert not (tmp_path / "x.csv").exists()


def test_without_pvlib_the_error_states_its_installation(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "pvlib", None)
    assert main([str(YEAR), "--to", str(tmp_path / "x.csv")]) == 1
    assert "pip install 'pvlib>=0.13'" in capsys.readouterr().err
