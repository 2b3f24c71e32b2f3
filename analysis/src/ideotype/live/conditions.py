# SPDX-License-Identifier: Apache-2.0
"""The conditions under which plants stand in the live page: density, rows,
place, time, panels and prices."""

from __future__ import annotations

import copy
import datetime
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

from ..decision.worth import PRICE_UNITS
from ..errors import Error

Tables = dict[str, Any]


@dataclass(frozen=True)
class Conditions:
    """Conditions of a plant that a page can change."""

    density: float
    """Plants per ground area [m-2]."""
    row: float
    """Distance between rows [m]."""
    direction: float
    """Direction of rows, clockwise from north [deg]."""
    latitude: float
    """Latitude [deg], of clear days only; a season has that of its weather."""
    when: str
    """"season" of measured weather, clear "day", or "hour" of one."""
    season: int
    """Number of the season among those of the campaign, from 0."""
    day: int
    """Day of the year, from 1."""
    hour: int
    """Beginning of the hour in local time [h]."""
    age: int
    """Day after emergence at which a plant that grows is shown."""
    panels: bool
    """Whether photovoltaic modules stand above the rows."""
    panel_height: float
    """Height of the middle of modules above the soil [m]."""
    panel_width: float
    """Width of modules across the row [m]."""
    panel_rows: int
    """Rows of plants from one row of modules to the next."""
    price_grain: float
    """Prices of [prices], in its units; 0 without that table."""
    price_seed: float
    price_water: float
    price_electricity: float
    price_other: float

    @classmethod
    def of(cls, base: Tables) -> Conditions:
        """Returns the conditions of a campaign that cut_case() has cut."""
        spacing = base["spacing"][0]
        has_season = "climate" in base
        panel = base.get("panel", [{}])[0]
        row = float(spacing["row"])
        pitch = panel.get("pitch") or base["field"]["rows"] * row
        start = base["climate"][0]["from"] if has_season else _date(base)
        return cls(
            density=1 / (row * float(spacing["plant"])),
            row=row,
            direction=float(spacing.get("row_direction", 90)),
            latitude=float(base["site"][0]["latitude"]),
            when="season" if has_season else "day",
            season=0,
            day=start.timetuple().tm_yday,
            hour=12,
            age=0,
            panels="panel" in base,
            panel_height=float(panel.get("height", 3.0)),
            panel_width=float(panel.get("width", 2.0)),
            panel_rows=round(pitch / row) if "panel" in base else 8,
            **{
                _price_field(name): float(base.get("prices", {}).get(name, 0))
                for name in PRICE_UNITS
            },
        )

    @property
    def kind(self) -> tuple[str, bool]:
        """Returns the kind of conditions, which determines their quantities."""
        return self.when, self.panels

    @property
    def prices(self) -> dict[str, float]:
        """Returns the prices by name."""
        return {x: getattr(self, _price_field(x)) for x in PRICE_UNITS}

    def changed(self, numbers: dict[str, Any]) -> Conditions:
        """Returns the conditions with the numbers of a page. Raises Error if a
        number is impossible."""
        changes: dict[str, Any] = {}
        for field in fields(self):
            if field.name not in numbers:
                continue
            value, kind = numbers[field.name], type(getattr(self, field.name))
            is_kind = type(value) in (
                (int, float) if kind is float else (kind,)
            )
            if not is_kind or not _is_possible(field.name, value):
                raise Error(
                    f"{field.name} is {value!r:.40}, which is impossible; "
                    "send a value within its range"
                )
            changes[field.name] = kind(value)
        return replace(self, **changes)


def _price_field(name: str) -> str:
    return f"price_{name}"


_RANGES: dict[str, tuple[float, float]] = {
    **{_price_field(name): (0, 1e6) for name in PRICE_UNITS},
    "season": (0, 9999),
    "density": (0.2, 200),
    "row": (0.05, 5),
    "direction": (0, 360),
    "latitude": (-66, 66),
    "day": (1, 365),
    "hour": (0, 23),
    "age": (0, 400),
    "panel_height": (0.5, 20),
    "panel_width": (0.1, 20),
    "panel_rows": (2, 24),
}


def _is_possible(name: str, value: Any) -> bool:
    if isinstance(value, bool):
        return True
    if isinstance(value, str):
        return value in ("season", "day", "hour")
    low, high = _RANGES[name]
    return low <= value <= high


def _date(base: Tables) -> datetime.date:
    dates = base["day"][0]["date"]
    return dates[0] if isinstance(dates, list) else dates


def seasons_of(tables: Tables, names: Mapping[str, str]) -> list[Tables]:
    """Returns the seasons over which a resolved campaign takes its objective at
    the site of `names`, each as the tables that cut_case() keeps of it; the
    one of `names` comes first. Other campaigns have one season."""
    if "climate" not in tables:
        return [{}]
    own, over = names["climate"], tables["objective"].get("over", [])
    is_over = "climate" in ([over] if isinstance(over, str) else over)
    others = [
        x["name"] for x in tables["climate"] if is_over and x["name"] != own
    ]
    return [
        {
            axis: entries[axis]
            for axis in ("climate", "weather")
            if axis in entries
        }
        for entries in (
            _choose_entries(tables, {**names, "climate": name})
            for name in (own, *others)
        )
    ]


def _choose_entries(tables: Tables, names: Mapping[str, str]) -> Tables:
    """Returns a resolved campaign with one entry of each axis, given by
    `names`, and the weather of these entries. Entries are not copied, since
    weather is large."""
    chosen = dict(tables)
    for axis in names:
        if entries := tables.get(axis):
            chosen[axis] = [e for e in entries if e["name"] == names[axis]]
    kept = {axis: chosen[axis][0]["name"] for axis in ("site", "climate")
            if axis in chosen}  # fmt: skip
    if "weather" in tables:
        chosen["weather"] = [
            weather
            for weather in tables["weather"]
            if all(weather[axis] == name for axis, name in kept.items())
        ]
    return chosen


def cut_case(tables: Tables, names: Mapping[str, str]) -> Tables:
    """Returns a resolved campaign that varies no keys, with one entry of each
    axis, given by `names`."""
    cut = copy.deepcopy(_choose_entries(tables, names))
    if "search" not in cut:
        # A sensitivity study: it has one generation and searches for nothing.
        for table in ("sensitivity", "stop"):
            cut.pop(table, None)
    cut.get("search", {}).pop("keys", None)
    # One entry needs no rule over scenarios.
    cut.pop("draw", None)
    for key in ("over", "scenarios", "scenario_tail", "scenario_threshold"):
        cut["objective"].pop(key, None)
    cut["replicates"] = 1
    return cut


def make_tables(base: Tables, original: Conditions, now: Conditions) -> Tables:
    """Returns a campaign with changed conditions."""
    changed = dict(base)
    if (original.density, original.row, original.direction) != (
        now.density, now.row, now.direction,
    ):  # fmt: skip
        changed["spacing"] = [
            {
                "row": now.row,
                "plant": 1 / (now.density * now.row),
                "row_direction": now.direction,
            }
        ]
    if "prices" in base:
        changed["prices"] = base["prices"] | now.prices
        if not now.panels:
            changed["prices"]["electricity"] = 0
    if now.when != "season":
        changed.pop("climate", None)
        changed.pop("weather", None)
        site = base["site"][0] | {"latitude": now.latitude}
        changed["site"] = [site]
        if (now.when, now.day) != (original.when, original.day):
            changed["day"] = [_make_day(base, now)]
    if now.panels:
        changed |= _panels(changed, now, original)
    else:
        changed.pop("panel", None)
    return changed


def _make_day(base: Tables, now: Conditions) -> dict[str, Any]:
    year = (
        base["climate"][0]["from"].year if "climate" in base
        else _date(base).year
    )  # fmt: skip
    date = datetime.date(year, 1, 1) + datetime.timedelta(now.day - 1)
    start, end = (now.hour, now.hour + 1) if now.when == "hour" else (0, 24)
    return {
        "name": "clear",
        "date": date,
        "start": datetime.time(start),
        "end": "24:00" if end == 24 else datetime.time(end),
        "step_minutes": 60,
    }


def _panels(base: Tables, now: Conditions, original: Conditions) -> Tables:
    """Returns the tables of rows of modules above the rows of plants."""
    pitch = now.panel_rows * now.row
    panel = base.get("panel", [{}])[0] | {
        "pitch": pitch,
        "height": now.panel_height,
        "width": now.panel_width,
    }
    if not original.panels:
        panel |= {"azimuth": (now.direction + 90) % 360, "tracks": True}
    elif original.direction != now.direction:
        turn = now.direction - original.direction
        panel["azimuth"] = (panel["azimuth"] + turn) % 360
    field = base["field"] | {"rows": now.panel_rows}
    return {"panel": [panel], "field": field}
