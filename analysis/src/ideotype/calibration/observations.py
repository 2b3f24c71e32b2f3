# SPDX-License-Identifier: Apache-2.0
"""Measurements of a calibration, grouped by the conditions under which they are
computed."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.csv_rows import Problems
from ..errors import Error, InputError
from ..validation.comparison import Conditions, effective_error
from ..validation.quantities import Seen, find_quantity
from ..validation.table import Measurement, collect_table, factor_to

Numbers = NDArray[np.float64]


@dataclass(frozen=True)
class Observations:
    """The rows of a table and the campaign of their field."""

    rows: list[Measurement]
    conditions: Conditions
    groups: list[tuple[dict[str, Any], list[int]]]
    """The keys of each condition, and the indices of its rows."""
    is_fitted: NDArray[np.bool_]
    """Whether the row is in the likelihood [rows]: it has a value and is not
    held out."""
    keys: Mapping[str, Any] = field(default_factory=dict)
    """Keys that all conditions have in common."""

    @property
    def is_held_out(self) -> NDArray[np.bool_]:
        """Whether the row has a value that is not in the likelihood
        [rows]."""
        measured = np.array([row.is_measured for row in self.rows], bool)
        return measured & ~self.is_fitted

    @property
    def is_candidate(self) -> NDArray[np.bool_]:
        """Whether the row is a measurement that could be made: it has an error
        and no value [rows]."""
        return np.array([not row.is_measured for row in self.rows], bool)

    @property
    def low(self) -> Numbers:
        """The value or smallest measured value of each row."""
        return np.array([row.low for row in self.rows], float)

    @property
    def high(self) -> Numbers:
        """The value or largest measured value of each row."""
        return np.array([row.high for row in self.rows], float)

    @property
    def value(self) -> Numbers:
        """The value of each row, or the middle of its range."""
        return np.array([row.value for row in self.rows], float)

    @property
    def error(self) -> Numbers:
        """The standard error of each row."""
        return np.array([effective_error(row) for row in self.rows], float)

    @property
    def quantities(self) -> list[str]:
        """The quantities of the rows in the likelihood, in their order."""
        names = [r.quantity for r, x in zip(self.rows, self.is_fitted) if x]
        return list(dict.fromkeys(names))


def read_observations(
    table: Path,
    campaign: Path,
    *,
    hold_out: float = 0.0,
    seed: int = 1,
    keys: Mapping[str, Any] | None = None,
) -> Observations:
    """Reads a table of measurements of the field of a campaign.

    hold_out: fraction of the rows of each quantity that are not in the
        likelihood, chosen by the seed.
    keys: keys of the campaign that all conditions have in common.

    Raises Error with all problems of the table: of its cells, and of rows that
    the campaign cannot compute."""
    problems = Problems()
    rows = collect_table(table, problems)
    if not rows and not problems.texts:
        problems.add(str(table), "there is no row of measurements; add one")
    return _observations(
        rows, campaign, problems, hold_out=hold_out, seed=seed, keys=keys
    )


def make_observations(
    rows: list[Measurement],
    campaign: Path,
    *,
    hold_out: float = 0.0,
    seed: int = 1,
    keys: Mapping[str, Any] | None = None,
) -> Observations:
    """Groups rows by their conditions; the arguments are those of
    `read_observations`. Raises Error with the problems of all rows."""
    return _observations(
        rows, campaign, Problems(), hold_out=hold_out, seed=seed, keys=keys
    )


def _observations(
    rows: list[Measurement],
    campaign: Path,
    problems: Problems,
    *,
    hold_out: float,
    seed: int,
    keys: Mapping[str, Any] | None,
) -> Observations:
    conditions = Conditions(campaign, 2, False)
    common = dict(keys or {})
    groups: dict[str, tuple[dict[str, Any], list[int]]] = {}
    for index, row in enumerate(rows):
        if not row.is_measured and math.isnan(row.error):
            problems.add(
                row.where,
                "there is neither a value nor an error; give the value, or for "
                "a measurement to plan its standard error",
            )
            continue
        if row.error == 0 and row.low == row.high:
            problems.add(
                row.where, "error is 0; give the standard error of the value"
            )
        try:
            row_keys = {**common, **conditions.keys(row)}
        except Error as error:
            problems.texts.append(str(error))
            continue
        groups.setdefault(repr(row_keys), (row_keys, []))[1].append(index)
    _check_groups(rows, conditions, list(groups.values()), problems)
    problems.raise_any()
    measured = np.array([row.is_measured for row in rows], bool)
    fitted = measured & ~_held_out(rows, measured, hold_out, seed)
    return Observations(
        rows, conditions, list(groups.values()), fitted, common
    )


def _check_groups(
    rows: Sequence[Measurement],
    conditions: Conditions,
    groups: Sequence[tuple[dict[str, Any], list[int]]],
    problems: Problems,
) -> None:
    """Adds the problems of rows that the campaign cannot compute: keys,
    dates, quantities and units."""
    for keys, indices in groups:
        try:
            seen = Seen(conditions.stand(conditions.settings(keys), seed=1))
        except (Error, InputError) as error:
            problems.add(rows[indices[0]].where, str(error))
            continue
        for index in indices:
            row = rows[index]
            try:
                quantity = find_quantity(seen, row.quantity)
                factor_to(quantity.unit, row.unit)
                if quantity.check:
                    quantity.check(seen, row)
            except Error as error:
                problems.add(row.where, str(error))


def _held_out(
    rows: Sequence[Measurement],
    measured: NDArray[np.bool_],
    fraction: float,
    seed: int,
) -> NDArray[np.bool_]:
    """Chooses the given fraction of the measured rows of each quantity."""
    chosen = np.zeros(len(rows), bool)
    random = np.random.default_rng(seed)
    for name in dict.fromkeys(row.quantity for row in rows):
        places = np.array(
            [
                i
                for i, r in enumerate(rows)
                if r.quantity == name and measured[i]
            ],
            int,
        )
        count = math.floor(fraction * len(places) + 0.5)
        chosen[random.permutation(places)[:count]] = True
    return chosen
