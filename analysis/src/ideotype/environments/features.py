# SPDX-License-Identifier: Apache-2.0
"""What the model feels of the climates of a campaign: radiation, temperature,
vapour pressure deficit and rain by phase of the season."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..common.compiled import _core
from ..errors import Error

PHASES = ("before flowering", "flowering", "filling")
_DAYS_AROUND_SILKING = 15
"""Half of the period around silking in which kernels are set [d], as in the
model (Andrade and others 2002, doi:10.2135/cropsci2002.1173)."""


@dataclass(frozen=True)
class Features:
    """The features of the climates of a campaign."""

    values: pd.DataFrame
    """One row for each climate, by its name, and one column for each
    feature, with the unit in its name."""
    missing: tuple[str, ...] = ()
    """Columns of the weather that no feature describes since some climate
    lacks them."""


def read_features(
    campaign: str | os.PathLike[str], settings: Sequence[str] = ()
) -> Features:
    """Returns the features of all climates of a campaign, as the program reads
    their weather. With several sites, each has separate features.

    Phases are those of the main crop: flowering is the period within 15 days
    of silking, and filling ends at maturity. Where plants do not grow, phases
    are thirds of the period.

    Raises InputError with all problems of the campaign, Error if it has no
    climates."""
    stand = _core.CaseStand.from_file(
        os.fspath(campaign), 0, list(settings), ""
    )
    resolved = tomllib.loads(stand.resolved)
    climates = resolved.get("climate", [])
    if not climates:
        raise Error(
            f"{campaign}: there are no climates to choose from; add "
            "[[climate]] with 'years'"
        )
    emergence = {x["name"]: x.get("emergence") for x in climates}
    growth = resolved["plant"]["baseline"].get("growth", {})
    columns = ("temperature", "humidity", "rain")
    missing = tuple(
        name
        for name in columns
        if not all(w.get(name) for w in resolved["weather"])
    )
    has_sites = len(resolved["site"]) > 1
    rows: dict[str, dict[str, float]] = {x["name"]: {} for x in climates}
    for weather in resolved["weather"]:
        site, climate = weather["site"], weather["climate"]
        prefix = f"{site}: " if has_sites else ""
        table = _tabulate_days(weather, missing)
        phases = _find_phases(table, emergence[climate], growth)
        for name, value in _summarize(table, phases).items():
            rows[climate][prefix + name] = value
    return Features(pd.DataFrame(rows).T, missing)


def _tabulate_days(
    weather: Mapping[str, Any], missing: Sequence[str]
) -> pd.DataFrame:
    """Returns one row for each date: PAR [MJ m-2], mean temperature [deg C],
    vapour pressure deficit in the mean over light [kPa] and rain [mm]."""
    dates: Sequence[date] = weather["dates"]
    shape = len(dates), len(weather["hours"])
    seconds = 86400 / shape[1]

    def grid(name: str) -> NDArray[np.float64]:
        return np.asarray(weather[name], float).reshape(shape)

    par = grid("beam") + grid("diffuse")
    days = {"par": par.sum(1) * seconds / 1e6}
    if "temperature" not in missing:
        temperature = grid("temperature")
        days["temperature"] = temperature.mean(1)
        if "humidity" not in missing:
            # Saturation pressure: FAO-56 (Allen and others 1998), equation 11.
            saturated = 0.6108 * np.exp(
                17.27 * temperature / (temperature + 237.3)
            )
            deficit = saturated * np.clip(1 - grid("humidity"), 0, None)
            light = np.maximum(par.sum(1), 1e-9)
            days["deficit"] = (deficit * par).sum(1) / light
    if "rain" not in missing:
        days["rain"] = grid("rain").sum(1)
    return pd.DataFrame(days, index=pd.DatetimeIndex(dates))


def _find_phases(
    days: pd.DataFrame,
    emergence: date | None,
    growth: Mapping[str, float],
) -> NDArray[np.int64]:
    """Returns the phase of each day: an index of PHASES, or -1 outside the
    season."""
    count = len(days)
    if emergence is None or "temperature" not in days:
        return np.arange(count) * len(PHASES) // count
    base, cap = growth["base"], growth["cap"]
    thermal = np.clip(days["temperature"].to_numpy(), base, cap) - base
    thermal[days.index < pd.Timestamp(emergence)] = 0
    time = thermal.cumsum()
    silking = growth["leaves"] * growth["interval"] + growth["silking"]
    silks = int(np.searchsorted(time, silking))
    end = int(np.searchsorted(time, silking + growth["maturity"]))
    day = np.arange(count)
    phases = np.full(count, 2)
    phases[day < silks + _DAYS_AROUND_SILKING] = 1
    phases[day < silks - _DAYS_AROUND_SILKING] = 0
    phases[(day > end) | (days.index < pd.Timestamp(emergence))] = -1
    return phases


def _summarize(
    days: pd.DataFrame, phases: NDArray[np.int64]
) -> dict[str, float]:
    """Returns the features of one climate."""
    features: dict[str, float] = {"season [d]": float((phases >= 0).sum())}
    names = {
        "par": "PAR [MJ m-2 d-1]",
        "temperature": "temperature [deg C]",
        "deficit": "vapour pressure deficit [kPa]",
    }
    for index, phase in enumerate(PHASES):
        part = days[phases == index]
        for column, name in names.items():
            if column in days:
                features[f"{name}, {phase}"] = (
                    float(part[column].mean()) if len(part) else 0.0
                )
        if "rain" in days:
            features[f"rain [mm], {phase}"] = float(part["rain"].sum())
    return features
