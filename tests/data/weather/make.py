"""Makes the weather files of this folder and the table that pvlib reads from
each.

    pip install pvlib==0.16.1 && python make.py

Source is the TMY3 file of Greensboro that pvlib ships (NREL, public domain):
five days of July. The other formats hold the same days, written after their
documentation: EPW (EnergyPlus, Auxiliary Programs), NSRDB PSM 4 (NREL) and
NASA POWER hourly (power.larc.nasa.gov/docs). Expected values are pvlib's own:
its readers, its position of the sun (NREL SPA, no refraction) and its Erbs.
"""

from pathlib import Path

import pandas as pd
import pvlib

HERE = Path(__file__).parent
SOURCE = Path(pvlib.__file__).parent / "data" / "723170TYA.CSV"
DAYS = [f"07/{day:02}/" for day in range(1, 6)]
LATITUDE, LONGITUDE, OFFSET = 36.1, -79.95, -5


def make_tmy3():
    lines = SOURCE.read_text().splitlines()
    kept = lines[:2] + [row for row in lines[2:] if row[:6] in DAYS]
    (HERE / "tmy3.csv").write_text("\n".join(kept) + "\n")


def read_tmy3():
    table, _ = pvlib.iotools.read_tmy3(HERE / "tmy3.csv", map_variables=True)
    # In pvlib's index, the hour 24:00 belongs to the next day.
    table.index = pd.DatetimeIndex(table.index) - pd.Timedelta("30min")
    return table


def make_epw(table):
    head = [
        f"LOCATION,Greensboro,NC,USA,TMY3,723170,{LATITUDE},{LONGITUDE},"
        f"{OFFSET}.0,273.0",
        "DESIGN CONDITIONS,0",
        "TYPICAL/EXTREME PERIODS,0",
        "GROUND TEMPERATURES,0",
        "HOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0",
        "COMMENTS 1,made from the TMY3 file",
        "COMMENTS 2,",
        "DATA PERIODS,1,1,Data,Sunday,7/1,7/5",
    ]
    rows = [
        f"{t.year},{t.month},{t.day},{t.hour + 1},60,?,{r.temp_air},"
        f"{r.temp_dew},{r.relative_humidity:.0f},{r.pressure * 100:.0f},"
        f"9999,9999,9999,{r.ghi:.0f},{r.dni:.0f},{r.dhi:.0f},999999,999999,"
        "999999,9999,0,0.0,10,10,77777,9999,9,999999999,0,0.0000,0,88,0,0,0"
        for t, r in table.iterrows()
    ]
    (HERE / "small.epw").write_text("\n".join(head + rows) + "\n")


def make_nsrdb(table):
    head = [
        "Source,Location ID,City,State,Country,Latitude,Longitude,Time Zone,"
        "Elevation,Local Time Zone",
        f"NSRDB,1,-,-,-,{LATITUDE},{LONGITUDE},{OFFSET},273,{OFFSET}",
        "Year,Month,Day,Hour,Minute,GHI,DNI,DHI,Temperature,Relative Humidity",
    ]
    rows = [
        f"{t.year},{t.month},{t.day},{t.hour},30,{r.ghi:.0f},{r.dni:.0f},"
        f"{r.dhi:.0f},{r.temp_air},{r.relative_humidity:.2f}"
        for t, r in table.iterrows()
    ]
    (HERE / "nsrdb.csv").write_text("\n".join(head + rows) + "\n")


def make_power(table, name, clock, light):
    """Writes a file of NASA POWER. `light` maps names of columns to columns of
    the table."""
    unit, factor = ("W/m^2", 1) if clock == "UTC" else ("MJ/hr", 0.0036)
    shift = pd.Timedelta(hours=-OFFSET if clock == "UTC" else 0)
    begin = table.index - pd.Timedelta("30min") + shift
    first, last = begin[0], begin[-1]
    head = [
        "-BEGIN HEADER-",
        "NASA/POWER Source Native Resolution Hourly Data ",
        f"Dates (month/day/year): {first:%m/%d/%Y} through "
        f"{last:%m/%d/%Y} in {clock}",
        f"Location: latitude  {LATITUDE}   longitude {LONGITUDE} ",
        "elevation from MERRA-2: Average for 0.5 x 0.625 degree lat/lon "
        "region = 260.0 meters",
        "The value for missing source data that cannot be computed or is "
        "outside of the sources availability range: -999 ",
        "parameter(s): ",
        *(f"{key}     CERES SYN1deg ({unit}) " for key in light),
        "T2M     MERRA-2 Temperature at 2 Meters (C) ",
        "RH2M    MERRA-2 Relative Humidity at 2 Meters (%) ",
        "-END HEADER-",
        ",".join(["YEAR,MO,DY,HR", *light, "T2M,RH2M"]),
    ]
    rows = [
        ",".join(
            [f"{t.year},{t.month},{t.day},{t.hour}"]
            + [f"{r[column] * factor:.6g}" for column in light.values()]
            + [f"{r.temp_air},{r.relative_humidity}"]
        )
        for t, (_, r) in zip(begin, table.iterrows())
    ]
    (HERE / name).write_text("\n".join(head + rows) + "\n")


def write_expected(table):
    sun = pvlib.solarposition.get_solarposition(
        table.index, LATITUDE, LONGITUDE, altitude=273
    )
    # The solar constant of pvlib's Erbs model differs from that of the
    # project.
    scale = 1366.1 / 1361.1
    day = pd.Series(table.index.day_of_year, index=table.index)
    erbs = pvlib.irradiance.erbs(scale * table.ghi, sun.zenith, day)["dhi"]
    pd.DataFrame(
        {
            "date": table.index.strftime("%Y-%m-%d"),
            "hour": table.index.hour + table.index.minute / 60,
            "zenith": sun.zenith.round(4),
            "azimuth": sun.azimuth.round(4),
            "ghi": table.ghi,
            "dni": table.dni,
            "dhi": table.dhi,
            "erbs_dhi": (erbs / scale).round(5),
            "temperature": table.temp_air,
            "humidity": table.relative_humidity,
        }
    ).to_csv(HERE / "expected.csv", index=False)


def same(table, read):
    """Asserts that a reader returns equal numbers; pvlib may label hours
    differently."""
    for name in ("ghi", "dni", "dhi", "temp_air", "relative_humidity"):
        assert abs(read[name].to_numpy() - table[name].to_numpy()).max() < 1e-9


def main():
    make_tmy3()
    table = read_tmy3()
    make_epw(table)
    make_nsrdb(table)
    all_light = {
        "ALLSKY_SFC_SW_DWN": "ghi",
        "ALLSKY_SFC_SW_DNI": "dni",
        "ALLSKY_SFC_SW_DIFF": "dhi",
    }
    make_power(table, "power_utc.csv", "UTC", all_light)
    global_light = {"ALLSKY_SFC_SW_DWN": "ghi"}
    make_power(table, "power_lst.csv", "LST", global_light)
    same(table, pvlib.iotools.read_epw(HERE / "small.epw")[0])
    same(table, pvlib.iotools.read_nsrdb_psm4(HERE / "nsrdb.csv")[0])
    write_expected(table)


if __name__ == "__main__":
    main()
