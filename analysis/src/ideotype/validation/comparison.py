# SPDX-License-Identifier: Apache-2.0
"""Evaluates facts under their conditions, and determines whether the computed
values agree with the measured ones.

A point agrees if the difference is at most z combined standard errors of both
values. z is the normal quantile at 1 - 0.025 / points (Bonferroni, two-sided
95 % over all points of the fact), so a correct program misses one fact in
twenty. For a value without an error 5 % is assumed (E; the tolerance of a
single point is then 10 %). A fact passes if all of its points agree."""

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
from ..common.settings import format_settings
from ..errors import Error, InputError
from ..stand.stand import Stand
from .facts import Fact, Verdict
from .quantities import Seen, find_quantity
from .table import THIRDS, Measurement, factor_to, find_third

UNKNOWN_ERROR = 0.05
"""The relative standard error assumed for values without an error (E: field
measurements of light and leaf area have 0.03 to 0.10)."""

LEAF, CROP = "leaf.", "crop."
"""The prefixes of keys that change the baseline: leaf.PART.MEASURE, where PART
is all or the lower, middle or upper third of the leaves by rank, and
crop.TABLE.KEY, or crop.TABLE.NUMBER.KEY for [[TABLE]], from 1; each takes a
value or {times = FACTOR}."""


def changed(
    crop: dict[str, Any], changes: Mapping[str, Any]
) -> dict[str, Any]:
    """Returns the tables of a crop after changes by keys leaf.* and crop.*.

    Raises Error for an unknown part, measure or key."""
    crop = deepcopy(crop)
    leaves = crop["leaf"]
    for key, value in changes.items():
        if key.startswith(CROP):
            tables, _, name = key.removeprefix(CROP).rpartition(".")
            _change_key(_find_table(crop, tables, name, key), name, value)
            continue
        part, _, measure = key.removeprefix(LEAF).partition(".")
        if part not in ("all", *THIRDS) or measure not in leaves[0]:
            raise Error(
                f"there is no key '{key}'; use leaf.PART.MEASURE with all, "
                f"lower, middle or upper, and {', '.join(leaves[0])}"
            )
        for rank, leaf in enumerate(leaves, 1):
            if part == "all" or find_third(rank, len(leaves)) == THIRDS[part]:
                _change_key(leaf, measure, value)
    return crop


def change_settings(
    keys: Mapping[str, Any], crop: dict[str, Any]
) -> dict[str, Any]:
    """Returns keys of a campaign, with those that change the baseline applied
    to its crop. Raises Error like changed()."""
    settings, changes = _split(keys)
    if changes:
        settings["plant.baseline"] = changed(crop, changes)
    return settings


def _split(keys: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Returns the keys of a campaign, and those that change the baseline."""
    changes = {k: v for k, v in keys.items() if k.startswith((LEAF, CROP))}
    return {k: v for k, v in keys.items() if k not in changes}, changes


def _find_table(
    crop: dict[str, Any], name: str, wanted: str, key: str
) -> dict[str, Any]:
    """Returns the table of a crop, NAME or NAME.NUMBER, that has the wanted
    key. Raises Error if there is none."""
    table, _, number = name.partition(".")
    found = crop.get(table, {})
    if isinstance(found, list):
        places = number.isdecimal() and 0 < int(number) <= len(found)
        found = found[int(number) - 1] if places else {}
    if wanted not in found:
        raise Error(
            f"there is no key '{key}'; use crop.TABLE.KEY of the crop, or "
            "crop.TABLE.NUMBER.KEY for [[TABLE]]"
        )
    return found


def _change_key(table: dict[str, Any], key: str, value: Any) -> None:
    is_factor = isinstance(value, Mapping)
    table[key] = table[key] * value["times"] if is_factor else value


@dataclass(frozen=True)
class Point:
    """A measured and the computed value, in the unit of the measurement."""

    measurement: Measurement
    computed: float
    """The computed value."""
    standard_error: float
    """The standard error of the computed value over seeds."""
    tolerance: float
    """The largest distance of `computed` from the measured range at which they
    agree."""

    @property
    def apart(self) -> float:
        """The distance of `computed` from the measured range, negative below
        it."""
        low, high = self.measurement.low, self.measurement.high
        return self.computed - min(max(self.computed, low), high)

    @property
    def agrees(self) -> bool:
        """Whether `computed` is within the tolerance, or nothing was measured."""
        return not self.measurement.is_measured or (
            abs(self.apart) <= self.tolerance
        )


@dataclass(frozen=True)
class Result:
    """A fact with the computed value of each of its points."""

    fact: Fact
    points: list[Point]

    @property
    def verdict(self) -> Verdict:
        """Whether all measured points agree; none without measured points."""
        if not any(point.measurement.is_measured for point in self.points):
            return Verdict.none
        agree = all(point.agrees for point in self.points)
        return Verdict.passes if agree else Verdict.misses


def effective_error(row: Measurement) -> float:
    """Returns the standard error of a measurement. If it is unknown,
    UNKNOWN_ERROR times the value is assumed; for a range it is 0."""
    if not math.isnan(row.error):
        return row.error
    return UNKNOWN_ERROR * abs(row.value) if row.low == row.high else 0.0


class Conditions:
    """Evaluates a campaign under the conditions of measurements, with several
    seeds."""

    def __init__(self, campaign: Path, seeds: int, is_relative: bool) -> None:
        self.campaign, self.seeds = campaign, seeds
        self._is_relative = is_relative
        try:
            tables = tomllib.loads(campaign.read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise Error(f"{campaign}: {error}") from None
        self._has_days = "day" in tables
        climates = tables.get("climate", [{}])
        self.grows = "emergence" in climates[0]
        """Whether plants grow."""

    def keys(self, row: Measurement) -> dict[str, Any]:
        """Returns the keys of the campaign that a row sets, with its date and
        hours."""
        keys = dict(row.keys)
        if row.hours:
            if not self._has_days:
                raise Error(
                    f"{row.where}: {self.campaign} has no [[day]], which rows "
                    "with an hour need; add one, or remove the hour"
                )
            keys |= {"day.start": row.hours[0], "day.end": row.hours[1]}
        if row.date and self._has_days:
            keys["day.date"] = row.date
        elif row.date and not self.grows:
            keys |= {"climate.from": row.date, "climate.to": row.date}
        elif row.date and row.quantity == "shoot":
            keys["climate.to"] = row.date
        return keys

    def settings(self, keys: Mapping[str, Any]) -> list[str]:
        """Returns the settings of the campaign for the given keys. Changes of
        the baseline are applied to its crop."""
        plain, changes = _split(keys)
        settings = format_settings(plain)
        names = _core.case_names(str(self.campaign), settings)
        if len({name for name, _ in names}) > 1:
            raise Error(
                f"{self.campaign} has {len(names)} cases, but measurements "
                "belong to one; keep one site, spacing and light"
            )
        if changes:
            stand = Stand.from_campaign(self.campaign, settings=settings)
            crop = tomllib.loads(stand.crop_file(stand.baseline))
            settings += format_settings(
                {"plant.baseline": changed(crop, changes)}
            )
        return settings

    def stand(self, settings: Sequence[str], seed: int) -> Stand:
        """Returns the stand with the given settings and seed."""
        return Stand.from_campaign(
            self.campaign,
            settings=[*settings, *format_settings({"seed": seed})],
        )

    def values(
        self, settings: Sequence[str], rows: Sequence[Measurement], seed: int
    ) -> list[float]:
        """Returns the computed values of rows with common settings, in their
        units; for changes from a control in the units of the program."""
        seen = Seen(self.stand(settings, seed))
        numbers = []
        for row in rows:
            quantity = find_quantity(seen, row.quantity)
            value = quantity.value(seen, row)
            if not self._is_relative:
                value *= factor_to(quantity.unit, row.unit)
            if not math.isfinite(value):
                raise Error(f"{row.where}: {row.quantity} is {value}")
            numbers.append(value)
        return numbers

    def evaluate(
        self, jobs: Sequence[tuple[Mapping[str, Any], Sequence[Measurement]]]
    ) -> list[list[list[float]]]:
        """Returns the computed values [seed, row] of each job, which has keys
        and the rows with these keys."""

        def locate_errors(rows: Sequence[Measurement], call: Any) -> Any:
            """Calls a function and adds the row to its errors."""
            try:
                return call()
            except (InputError, Error) as error:
                text = str(error)
                where = rows[0].where
                raise Error(
                    text if where and where in text else f"{where}: {text}"
                ) from None

        known = [
            locate_errors(rows, partial(self.settings, keys))
            for keys, rows in jobs
        ]
        with ThreadPoolExecutor(processors()) as pool:
            futures = [
                [
                    pool.submit(
                        locate_errors,
                        rows,
                        partial(self.values, settings, rows, seed),
                    )
                    for seed in range(1, self.seeds + 1)
                ]
                for settings, (_, rows) in zip(known, jobs)
            ]
            return [[future.result() for future in job] for job in futures]


def compare(
    fact: Fact, seeds: int = 8, keys: Mapping[str, Any] | None = None
) -> Result:
    """Evaluates a fact under its conditions.

    seeds: number of seeds (2 or more), from which the standard error of
        computed values is estimated. A treatment and its control have common
        random numbers.
    keys: additional keys of the campaign, such as another plant.

    Raises Error if a row or a key is invalid."""
    rows = fact.measurements
    if fact.cannot or not rows:
        return Result(fact, [])
    conditions = Conditions(fact.campaign, seeds, fact.than is not None)
    common = {**fact.keys, **(keys or {})}
    groups: dict[str, tuple[dict[str, Any], list[Measurement]]] = {}
    for row in rows:
        row_keys = {**common, **conditions.keys(row)}
        groups.setdefault(repr(row_keys), (row_keys, []))[1].append(row)
    jobs = list(groups.values())
    computed = conditions.evaluate(jobs)
    if fact.than is not None:
        controls = conditions.evaluate(
            [
                ({**_without(job_keys, fact.keys), **fact.than}, job_rows)
                for job_keys, job_rows in jobs
            ]
        )
        computed = [
            [
                [_change(x, y, row) for x, y, row in zip(*both, job[1])]
                for both in zip(treated, control)
            ]
            for treated, control, job in zip(computed, controls, jobs)
        ]
    points = {}
    measured = sum(row.is_measured for row in rows)
    quantile = NormalDist().inv_cdf(1 - 0.025 / max(measured, 1))
    for (_, job_rows), by_seed in zip(jobs, computed):
        for row, values in zip(job_rows, zip(*by_seed)):
            error = stdev(values) / math.sqrt(len(values))
            combined = math.hypot(error, effective_error(row))
            points[id(row)] = Point(
                row, fmean(values), error, quantile * combined
            )
    return Result(fact, [points[id(row)] for row in rows])


def _without(
    keys: Mapping[str, Any], others: Mapping[str, Any]
) -> dict[str, Any]:
    return {k: v for k, v in keys.items() if k not in others}


def _change(treated: float, control: float, row: Measurement) -> float:
    return (treated / control - 1) * factor_to("1", row.unit)
