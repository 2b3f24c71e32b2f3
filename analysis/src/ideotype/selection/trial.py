# SPDX-License-Identifier: Apache-2.0
"""Trials of lines: what each column stands for, and the values of plots."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..common.csv_rows import Problems
from ..errors import Error
from .traits import (
    Column,
    Trait,
    find_factor,
    find_trait,
    is_unit,
    read_unit,
    trait_of_measure,
)
from .trial_file import FACTORS, Cells, read_cells

_MISSING = frozenset(
    {"", "na", "n/a", "nan", "null", "none", "missing", ".", "-", "*", "--"}
)

FEWEST_LINES = 5
"""The smallest number of lines of a trial."""

_CELL = re.compile(r"\s*([-+]?[\d.,]+(?:[eE][-+]?\d+)?)\s*([A-Za-z°%].*)?\s*")


@dataclass(frozen=True)
class Trial:
    """The plots, or the means of lines, of a trial."""

    traits: tuple[Trait, ...]
    table: pd.DataFrame
    """One row for each plot: `FACTORS` as text, "" where the trial lacks them,
    and the traits by their names in the units of their measures; NaN:
    missing."""
    taken: pd.DataFrame
    """What each column was taken for: column, taken_for, unit, values,
    missing, note."""

    @property
    def lines(self) -> list[str]:
        """The names of the lines, in the order of the trial."""
        return list(dict.fromkeys(self.table["line"]))

    @property
    def has_replicates(self) -> bool:
        """Whether any line has several plots."""
        return len(self.table) > len(self.lines)


def read_trial(path: str | Path, columns: Mapping[str, str] = {}) -> Trial:
    """Reads a trial: a CSV file, separated by commas, semicolons or tabs, or a
    JSON file of observations or observation units of BrAPI 2.

    columns: measures of columns that are not recognised by their names, as
        {"LL7": "leaf.length@ear, cm"}: measure, leaf and unit.

    Raises Error with all problems of the file and their lines."""
    problems = Problems()
    cells = read_cells(Path(path), problems)
    factors, traits, unused = _find_columns(
        str(path), cells, columns, problems
    )
    table = _read_values(cells, factors, traits, problems)
    if "line" in factors:
        _check_design(str(path), table, factors, problems)
    problems.raise_any()
    meanings = {
        **{name: (factor, "", "") for factor, name in factors.items()},
        **{
            name: (c.trait.name, c.unit, _note(c))
            for name, c in traits.items()
        },
        **dict.fromkeys(unused, ("not used", "", "")),
    }
    taken = pd.DataFrame(
        [_taken(name, *meanings[name], cells) for name in cells.names]
    )
    return Trial(
        tuple(column.trait for column in traits.values()),
        table.drop(columns="where"),
        taken,
    )


def _find_columns(
    path: str, cells: Cells, columns: Mapping[str, str], problems: Problems
) -> tuple[dict[str, str], dict[str, Column], list[str]]:
    """Returns the columns of factors by factor, the traits by column, and the
    columns that are neither."""
    factors: dict[str, str] = {}
    traits: dict[str, Column] = {}
    unused = []
    for name in columns:
        if name not in cells.names:
            problems.add(
                path, f"there is no column '{name}', which --trait names"
            )
    for name in cells.names:
        factor = "" if name in columns else find_factor(name)
        if factor:
            if factor in factors:
                problems.add(
                    path,
                    f"'{factors[factor]}' and '{name}' are both the {factor}; "
                    "remove or rename one",
                )
            factors.setdefault(factor, name)
            continue
        column = _find_column(path, name, columns, problems)
        if column is None:
            unused.append(name)
            continue
        twins = [x for x, c in traits.items() if c.trait == column.trait]
        if twins:
            problems.add(
                path,
                f"'{twins[0]}' and '{name}' are both {column.trait.name}; "
                "name the leaf in one of them, as in 'upper leaf angle'",
            )
        traits[name] = column
    if "line" not in factors:
        problems.add(
            path, "there is no column of lines; name it line or genotype"
        )
    if not any(c.trait.measure for c in traits.values()):
        problems.add(
            path,
            "no column is a measure of plants; name one such as 'leaf length "
            "[cm]', or assign it with --trait COLUMN=leaf.length@ear,cm",
        )
    return factors, traits, unused


def _find_column(
    path: str, name: str, columns: Mapping[str, str], problems: Problems
) -> Column | None:
    try:
        column = (
            _assigned(columns[name]) if name in columns else find_trait(name)
        )
    except Error as error:
        problems.add(path, f"{error} (--trait assigns columns)")
        return None
    if column is None or not column.trait.measure:
        return column
    trait = column.trait
    unit = column.unit or ("deg" if trait.unit == "deg" else "")
    if unit and not is_unit(unit, trait.unit):
        problems.add(
            path,
            f"the unit '{unit}' of '{name}' is none of {trait.name}; write it "
            f"as {trait.show}",
        )
    return Column(trait, unit, column.is_from_horizontal)


def _assigned(text: str) -> Column:
    """Returns the column that "leaf.length@ear, cm" describes."""
    place, _, unit = text.partition(",")
    measure, _, leaf = place.strip().partition("@")
    return Column(
        trait_of_measure(measure.strip(), leaf.strip()), unit.strip()
    )


def _taken(
    name: str, meaning: str, unit: str, note: str, cells: Cells
) -> dict[str, Any]:
    missing = sum(_is_missing(row.get(name, "")) for _, row in cells.rows)
    return {
        "column": name,
        "taken_for": meaning,
        "unit": unit,
        "values": len(cells.rows) - missing,
        "missing": missing,
        "note": note,
    }


def _note(column: Column) -> str:
    measure = column.trait.measure
    if not measure:
        return "no measure of plants"
    place = f" of the leaf {column.trait.leaf}" if column.trait.leaf else ""
    if column.is_from_horizontal:
        return f"{measure}{place}, 90 deg less the angle from the horizontal"
    if measure == "leaf.insertion_angle":
        return f"{measure}{place}, taken as the angle from the stalk"
    if measure == "stalk.height":
        return f"{measure}, taken as the height of the highest collar"
    return f"{measure}{place}"


def _is_missing(cell: str) -> bool:
    return cell.lower() in _MISSING


def _read_values(
    cells: Cells,
    factors: Mapping[str, str],
    traits: Mapping[str, Column],
    problems: Problems,
) -> pd.DataFrame:
    """Returns the factors and traits of all rows, with the column `where`."""
    records = [
        {
            "where": where,
            **{
                factor: "" if _is_missing(cell) else cell
                for factor in FACTORS
                for cell in [row.get(factors.get(factor, ""), "")]
            },
        }
        for where, row in cells.rows
    ]
    table = pd.DataFrame(records, columns=["where", *FACTORS])
    for name, column in traits.items():
        reader = _ValueReader(name, column, cells.has_decimal_commas, problems)
        table[column.trait.name] = [
            reader.read(where, row[name]) for where, row in cells.rows
        ]
    return table


@dataclass
class _ValueReader:
    """Reads the cells of a trait in the unit of its measure."""

    name: str
    column: Column
    has_decimal_commas: bool
    problems: Problems
    has_unit: bool = True
    """False after a cell without a unit, which is reported once."""

    def read(self, where: str, cell: str) -> float:
        """Returns a value; NaN if it is missing or wrong, which is added to
        the problems."""
        if _is_missing(cell):
            return math.nan
        match = _CELL.fullmatch(cell)
        number = match[1] if match else ""
        if self.has_decimal_commas and number.count(",") == 1:
            number = number.replace(",", ".")
        try:
            value = float(number)
        except ValueError:
            value = math.nan
        if match is None or not math.isfinite(value):
            self.problems.add(
                where,
                f"{self.name} is '{cell}'; give a number with a decimal "
                "point, or NA",
            )
            return math.nan
        if not self.column.trait.measure:
            return value
        return self._convert(where, cell, value, (match[2] or "").strip())

    def _convert(
        self, where: str, cell: str, value: float, own_unit: str
    ) -> float:
        """Returns a value in the unit of the measure; NaN as above."""
        trait = self.column.trait
        unit = own_unit or self.column.unit
        if not unit:
            if self.has_unit:
                self.problems.add(
                    where,
                    f"the column '{self.name}' has no unit; name it "
                    f"'{self.name} [{trait.show}]'",
                )
            self.has_unit = False
            return math.nan
        if not is_unit(unit, trait.unit):
            if own_unit:
                self.problems.add(
                    where, f"{self.name} is '{cell}', with an unknown unit"
                )
            return math.nan
        value *= read_unit(unit, trait.unit)
        if self.column.is_from_horizontal:
            value = 90 - value
        low, high = trait.limits
        if not low <= value <= high:
            self.problems.add(
                where,
                f"{self.name} is '{cell}', {value:g} {trait.unit}, outside "
                f"{low:g} to {high:g}; check its unit, or write NA",
            )
            return math.nan
        return value


def _check_design(
    path: str,
    table: pd.DataFrame,
    factors: Mapping[str, str],
    problems: Problems,
) -> None:
    """Finds rows without a line, lines with two spellings, and rows of the
    same plot."""
    for where in table["where"][table["line"] == ""]:
        problems.add(where, "the line is missing; name it, or remove the row")
    spellings: dict[str, str] = {}
    for where, line in zip(table["where"], table["line"]):
        plain = re.sub(r"[\W_]+", "-", line).strip("-").lower()
        first = spellings.setdefault(plain, line)
        if first != line:
            problems.add(
                where,
                f"the line '{line}' is elsewhere '{first}'; use one name",
            )
    keys = [x for x in FACTORS if x in factors]
    if {"replicate", "plot"} & factors.keys():
        plots: dict[tuple[str, ...], str] = {}
        for where, *key in table[["where", *keys]].itertuples(index=False):
            first = plots.setdefault(tuple(key), where)
            if first != where:
                words = ", ".join(f"{k} {v}" for k, v in zip(keys, key) if v)
                problems.add(
                    where,
                    f"{words} is already in {first.rpartition('/')[2]}; remove "
                    "one, or correct its replicate or plot",
                )
    count = len(spellings.keys() - {""})
    if count < FEWEST_LINES:
        problems.add(
            path,
            f"the trial has {count} lines; give {FEWEST_LINES} or more",
        )


def blocks_of_plots(trial: Trial) -> NDArray[np.int64]:
    """Returns the index of the smallest unit of the design that holds each
    plot: block, replicate or environment [plots]."""
    table = trial.table
    keys = table["environment"] + "|" + table["replicate"]
    keys = keys + "|" + table["block"]
    return np.unique(keys, return_inverse=True)[1]
