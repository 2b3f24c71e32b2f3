# SPDX-License-Identifier: Apache-2.0
"""The clock that hours of a history are told on."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass

from .datasets import Datasets
from .file import HistoryError

_OLD = "local clock"
"""Until version 0.2.0 hours of a season were those of the weather file under
this name."""


@dataclass(frozen=True)
class Clock:
    """Names hours, and moves those of old histories to the clock of the
    site."""

    meaning: str
    shift: float = 0.0
    """To be added to the hours that the file has [h]."""


def clock_of(data: Datasets, group: str) -> Clock:
    """The clock of the axis `hour` of a group."""
    meaning = data.meaning(f"{group}/hour")
    if meaning and meaning != _OLD:
        return Clock(meaning)
    try:
        campaign = tomllib.loads(data.texts("campaign/resolved")[0])
        own = data.attributes()
        places = [
            (site["utc_offset"], weather["utc_offset"])
            for site in campaign["site"]
            if own.get("site") in ("all", site["name"])
            for weather in campaign.get("weather", [site])
            if weather is site
            or (
                weather["site"] == site["name"]
                and own.get("day") in ("all", weather["climate"])
            )
        ]
    except (HistoryError, KeyError, TypeError, ValueError):
        places = []
    sites, files = (
        {*offsets} for offsets in (zip(*places) if places else ([], []))
    )
    if len(sites) == 1 and len(files) == 1:
        (here,), (there,) = sites, files
        return Clock(
            f"time on the clock of the site, {clock_name(here)}", here - there
        )
    if len(files) == 1:
        name = clock_name(*files)
        return Clock(f"time on the clock of the weather file, {name}")
    return Clock("time on a clock that the history does not name")


def clock_name(utc_offset: float) -> str:
    """ "UTC-5" or "UTC+5:30"."""
    hours, minutes = divmod(round(abs(utc_offset) * 60), 60)
    if not hours and not minutes:
        return "UTC"
    sign = "-" if utc_offset < 0 else "+"
    return f"UTC{sign}{hours}" + (f":{minutes:02}" if minutes else "")
