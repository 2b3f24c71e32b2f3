# SPDX-License-Identifier: Apache-2.0
"""Checks the location, the clock and the gaps of weather data."""

from __future__ import annotations

import argparse
from typing import Any

import numpy as np
import pandas as pd

from ...errors import Error

_HOUR = pd.Timedelta("1h")


def find_place(
    options: argparse.Namespace, places: list, warn: Any
) -> tuple[float, float]:
    """Returns latitude and longitude [deg] from the options, or else from the
    files. Raises Error if neither states them, or if they are more than 500 km
    apart; warns from 50 km on."""
    given = (options.latitude, options.longitude)
    known = next((place for place in places if place), None)
    if None in given:
        if known is None:
            raise Error(
                f"{options.files[0]}: this file does not state its location; "
                "give --latitude and --longitude"
            )
        return known
    for place in {place for place in places if place}:
        a, b = np.radians(place), np.radians(given)
        # The haversine formula for distances on a sphere.
        h = (
            np.sin((a[0] - b[0]) / 2) ** 2
            + np.cos(a[0]) * np.cos(b[0]) * np.sin((a[1] - b[1]) / 2) ** 2
        )
        apart = 2 * 6371 * np.arcsin(np.sqrt(h))
        mismatch = (
            f"the file is from {place[0]:.2f} N {place[1]:.2f} E, "
            f"{apart:.0f} km from the site"
        )
        if apart > 500:
            raise Error(
                f"{mismatch} (another climate); choose a file of the site"
            )
        if apart > 50:
            warn(f"warning: {mismatch}")
    return given


def _sun(index: Any, offset: float, place: tuple[float, float]) -> Any:
    """Returns a function of a shift [h]: the cosine of the zenith angle of the
    sun at the times of an index plus this shift."""
    import pvlib

    pad = 13 * _HOUR
    grid = pd.date_range(index[0] - pad, index[-1] + pad, freq="15min")
    positions = pvlib.solarposition.get_solarposition(
        (grid - offset * _HOUR).tz_localize("UTC"), *place, method="ephemeris"
    )
    cosine = np.cos(np.radians(positions["elevation"].rsub(90).to_numpy()))
    hours = (grid - grid[0]) / _HOUR
    at = (index - grid[0]) / _HOUR
    return lambda shift: np.interp(at + shift, hours, cosine)


def _light(frame: pd.DataFrame, cosine: Any) -> pd.Series:
    """Returns the light on a horizontal plane; NaN: unknown."""
    light = pd.Series(np.nan, frame.index)
    if {"beam_normal", "diffuse"} <= {*frame}:
        light = frame["beam_normal"] * np.maximum(cosine, 0) + frame["diffuse"]
    return frame["global"].fillna(light) if "global" in frame else light


def check_clock(
    frame: pd.DataFrame, offset: float, place: Any, warn: Any
) -> None:
    """Compares the course of light with that of the sun. Raises Error if
    the best correlation is below 0.5 or at a shift of 0.75 h or more (2 h for
    9 days or fewer); warns from 0.5 h (1 h) on."""
    sun = _sun(frame.index, offset, place)
    light = _light(frame, sun(0))
    known = light.notna()
    if not (light > 0).any():
        warn("warning: the period has no light at all")
        return
    shifts = np.arange(-48, 49) / 4
    # Polar night and constant light have no correlation.
    with np.errstate(all="ignore"):
        fits = [
            np.corrcoef(light[known], np.maximum(sun(-shift), 0)[known])[0, 1]
            for shift in shifts
        ]
    if not np.isfinite(fits).any():
        raise Error(
            "the light does not follow the sun at all "
            f"({place[0]:.2f} N {place[1]:.2f} E); check the location and the "
            "columns"
        )
    best = shifts[int(np.nanargmax(fits))]
    mismatch = (
        f"the light comes {abs(best):.4g} h {'later' if best > 0 else 'earlier'}"
        f" than the sun of {place[0]:.2f} N {place[1]:.2f} E (correlation "
        f"{fits[48]:.3f}, and {np.nanmax(fits):.3f} with that shift); check the "
        "location, the clock, and --format"
    )
    if np.nanmax(fits) < 0.5:
        raise Error(
            "the light hardly follows the sun (a correlation of "
            f"{np.nanmax(fits):.2f}); check its times and columns"
        )
    is_long = frame.index[-1] - frame.index[0] > pd.Timedelta("9D")
    if abs(best) >= (0.75 if is_long else 2):
        raise Error(mismatch)
    if abs(best) >= (0.5 if is_long else 1):
        warn(f"warning: {mismatch}")


def mend(
    frame: pd.DataFrame,
    step: Any,
    offset: float,
    place: Any,
    fill: float,
    warn: Any,
) -> None:
    """Interpolates gaps of up to `fill` hours in `frame`, of light relative to
    the cosine of the zenith angle, and warns of remaining gaps by day."""
    sun = _sun(frame.index, offset, place)
    half = step / 2 / _HOUR
    is_up = np.maximum(np.maximum(sun(-half), sun(half)), sun(0)) > 0
    cosine = pd.Series(np.maximum(sun(0), 0.02), frame.index)
    for name in frame:
        by = cosine if name in ("global", "diffuse") else 1
        known = frame[name].notna()
        if known.all() or not known.any():
            continue
        length = (~known).groupby(known.cumsum()).transform("sum") * (
            step / _HOUR
        )
        values = (frame[name] / by).interpolate("time") * by
        frame.loc[~known & (length <= fill), name] = values
    gone = _light(frame, sun(0)).isna() & is_up
    gaps = gone[gone].index.to_series()
    runs = gaps.groupby((gaps.diff() > step).cumsum()).agg(["min", "max"])
    for begin, end in runs.head(20).itertuples(index=False):
        warn(
            f"warning: the light from {begin - step / 2:%Y-%m-%d %H:%M} to "
            f"{end + step / 2:%Y-%m-%d %H:%M} is missing"
        )
    if len(runs):
        longest = (runs["max"] - runs["min"]).max() / _HOUR + step / _HOUR
        warn(
            f"warning: {len(runs)} gaps by day, the longest of {longest:.4g} h;"
            " interpolate short gaps with --fill HOURS, or choose days without"
            " gaps by --from and --until or in the campaign"
        )
