# SPDX-License-Identifier: Apache-2.0
"""Evaluates the conditions of facts, and judges whether ours agrees.

A point agrees if ours lies within the tolerance of what was measured: z standard
errors of theirs and of ours together, where z is the two-sided 95 % quantile of
the normal distribution for as many points as the fact has (Bonferroni: 1 -
0.025 / points), so that a true program misses one fact in twenty. A value without
an error is granted one of 5 % (E; so 10 % for a single point). A fact passes if
all of its points agree."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from statistics import NormalDist, fmean, stdev
from typing import Any

from ..common.compiled import _core
from ..common.processors import processors
from ..common.settings import words_of
from ..errors import Error, InputError
from ..stand.stand import Stand
from .facts import Fact, Verdict
from .quantities import Seen, quantity_of
from .table import THIRDS, Measurement, factor_to, third_of

UNKNOWN_ERROR = 0.05
"""The standard error of values without an error, over the value (E: field
measurements of light and leaf area have 0.03 to 0.10)."""


LEAF, CROP = "leaf.", "crop."
"""The beginnings of keys that change the baseline: leaf.PART.MEASURE, where PART
is all or the lower, middle or upper third of the leaves by rank, and crop.TABLE.KEY,
each with a value or {times = FACTOR}."""


def changed(
    crop: dict[str, Any], changes: Mapping[str, Any]
) -> dict[str, Any]:
    """Returns the tables of a crop with changes of its leaves.

    Raises Error for an unknown part or measure."""
    crop = deepcopy(crop)
    leaves = crop["leaf"]
    for key, value in changes.items():
        if key.startswith(CROP):
            table, _, name = key.removeprefix(CROP).partition(".")
            if name not in crop.get(table, {}):
                raise Error(
                    f"there is no key '{key}'; use crop.TABLE.KEY of the crop"
                )
            _change_key(crop[table], name, value)
            continue
        part, _, measure = key.removeprefix(LEAF).partition(".")
        if part not in ("all", *THIRDS) or measure not in leaves[0]:
            raise Error(
                f"there is no key '{key}'; use leaf.PART.MEASURE with all, "
                f"lower, middle or upper, and {', '.join(leaves[0])}"
            )
        for rank, leaf in enumerate(leaves, 1):
            if part == "all" or third_of(rank, len(leaves)) == THIRDS[part]:
                _change_key(leaf, measure, value)
    return crop


def _change_key(table: dict[str, Any], key: str, value: Any) -> None:
    is_factor = isinstance(value, Mapping)
    table[key] = table[key] * value["times"] if is_factor else value


@dataclass(frozen=True)
class Point:
    """A measurement beside ours, both in its unit."""

    measurement: Measurement
    ours: float
    standard_error: float
    tolerance: float
    """The largest distance of ours from the range that was measured with which
    it agrees."""

    @property
    def apart(self) -> float:
        """The distance of ours from the range that was measured, negative
        below it."""
        low, high = self.measurement.low, self.measurement.high
        return self.ours - min(max(self.ours, low), high)

    @property
    def agrees(self) -> bool:
        """Whether ours is within the tolerance, or nothing was measured."""
        return not self.measurement.is_measured or (
            abs(self.apart) <= self.tolerance
        )


@dataclass(frozen=True)
class Result:
    """A fact with ours at each of its points."""

    fact: Fact
    points: list[Point]

    @property
    def verdict(self) -> Verdict:
        if not any(point.measurement.is_measured for point in self.points):
            return Verdict.none
        agree = all(point.agrees for point in self.points)
        return Verdict.passes if agree else Verdict.misses


def error_of(row: Measurement) -> float:
    """Returns the standard error of a measurement, or that which is granted
    where it is unknown; a range has none besides."""
    if not math.isnan(row.error):
        return row.error
    return UNKNOWN_ERROR * abs(row.value) if row.low == row.high else 0.0


class Conditions:
    """Evaluates measurements of a campaign with several seeds."""

    def __init__(self, campaign: Path, seeds: int, is_relative: bool) -> None:
        self.campaign, self.seeds = campaign, seeds
        self._is_relative = is_relative
        try:
            tables = tomllib.loads(campaign.read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise Error(f"{campaign}: {error}") from None
        self._has_days = "day" in tables
        climates = tables.get("climate", [{}])
        self._grows = "emergence" in climates[0]

    def keys(self, row: Measurement) -> dict[str, Any]:
        """Returns the keys of the campaign that a row sets."""
        keys = dict(row.keys)
        if row.hours:
            if not self._has_days:
                raise Error(
                    f"{row.where}: {self.campaign} has no [[day]], which rows "
                    "with an hour need; add one, or drop the hour"
                )
            keys |= {"day.start": row.hours[0], "day.end": row.hours[1]}
        if row.date and self._has_days:
            keys["day.date"] = row.date
        elif row.date and not self._grows:
            keys |= {"climate.from": row.date, "climate.to": row.date}
        elif row.date and row.quantity == "shoot":
            keys["climate.to"] = row.date
        return keys

    def settings(self, keys: Mapping[str, Any]) -> list[str]:
        """Returns the settings of the campaign that keys mean, in which
        changes of the baseline are a crop."""
        changes = {k: v for k, v in keys.items() if k.startswith((LEAF, CROP))}
        plain = {k: v for k, v in keys.items() if k not in changes}
        settings = words_of(plain)
        names = _core.case_names(str(self.campaign), settings)
        if len({name for name, _ in names}) > 1:
            raise Error(
                f"{self.campaign} has {len(names)} cases; measurements belong "
                "to one: leave one site, spacing and light in it"
            )
        if changes:
            stand = Stand.from_campaign(self.campaign, settings=settings)
            crop = tomllib.loads(stand.crop_file(stand.baseline))
            settings += words_of({"plant.baseline": changed(crop, changes)})
        return settings

    def values(
        self, settings: Sequence[str], rows: Sequence[Measurement], seed: int
    ) -> list[float]:
        """Returns the values of rows that share all settings, in their units;
        of changes from a control in the units of the program."""
        seen = Seen(
            Stand.from_campaign(
                self.campaign, settings=[*settings, *words_of({"seed": seed})]
            )
        )
        found = []
        for row in rows:
            quantity = quantity_of(seen, row.quantity)
            value = quantity.value(seen, row)
            if not self._is_relative:
                value *= factor_to(quantity.unit, row.unit)
            if not math.isfinite(value):
                raise Error(f"{row.where}: {row.quantity} is {value}")
            found.append(value)
        return found

    def evaluate(
        self, jobs: Sequence[tuple[Mapping[str, Any], Sequence[Measurement]]]
    ) -> list[list[list[float]]]:
        """Returns for each job, keys with the rows that have them, the values
        [seed, row]."""

        def located(rows: Sequence[Measurement], call: Any) -> Any:
            """Calls a function whose errors then name a row."""
            try:
                return call()
            except (InputError, Error) as error:
                text = str(error)
                where = rows[0].where
                raise Error(
                    text if where and where in text else f"{where}: {text}"
                ) from None

        known = [
            located(rows, partial(self.settings, keys)) for keys, rows in jobs
        ]
        with ThreadPoolExecutor(processors()) as pool:
            found = [
                [
                    pool.submit(
                        located, rows, partial(self.values, own, rows, seed)
                    )
                    for seed in range(1, self.seeds + 1)
                ]
                for own, (_, rows) in zip(known, jobs)
            ]
            return [[each.result() for each in job] for job in found]


def compare(
    fact: Fact, seeds: int = 8, keys: Mapping[str, Any] | None = None
) -> Result:
    """Evaluates the conditions of a fact.

    seeds: number of seeds (2 or more) whose scatter is the standard error of
        ours; a treatment and its control share them.
    keys: further keys of the campaign, such as another plant.

    Raises Error if a row or a key is impossible."""
    rows = fact.measurements
    if fact.cannot or not rows:
        return Result(fact, [])
    conditions = Conditions(fact.campaign, seeds, fact.than is not None)
    common = {**fact.keys, **(keys or {})}
    groups: dict[str, tuple[dict[str, Any], list[Measurement]]] = {}
    for row in rows:
        own = {**common, **conditions.keys(row)}
        groups.setdefault(repr(own), (own, []))[1].append(row)
    jobs = list(groups.values())
    found = conditions.evaluate(jobs)
    if fact.than is not None:
        controls = conditions.evaluate(
            [
                ({**_without(own, fact.keys), **fact.than}, own_rows)
                for own, own_rows in jobs
            ]
        )
        found = [
            [
                [_change(x, y, row) for x, y, row in zip(*both, job[1])]
                for both in zip(treated, control)
            ]
            for treated, control, job in zip(found, controls, jobs)
        ]
    points = {}
    measured = sum(row.is_measured for row in rows)
    quantile = NormalDist().inv_cdf(1 - 0.025 / max(measured, 1))
    for (_, own_rows), by_seed in zip(jobs, found):
        for row, values in zip(own_rows, zip(*by_seed)):
            error = stdev(values) / math.sqrt(len(values))
            together = math.hypot(error, error_of(row))
            points[id(row)] = Point(
                row, fmean(values), error, quantile * together
            )
    return Result(fact, [points[id(row)] for row in rows])


def _without(
    keys: Mapping[str, Any], others: Mapping[str, Any]
) -> dict[str, Any]:
    return {k: v for k, v in keys.items() if k not in others}


def _change(treated: float, control: float, row: Measurement) -> float:
    return (treated / control - 1) * factor_to("1", row.unit)
