"""Evaluations as numpy arrays whose columns know their units."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from .estimate import Estimate

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


class Status(IntEnum):
    """How far an evaluation has come, as in the file."""

    EMPTY = 0
    PROPOSED = 1
    DONE = 2
    FAILED = 3


class Origin(IntEnum):
    """Where a genome came from, as in the file."""

    NONE = 0
    BASELINE = 1
    RANDOM = 2
    ELITE = 3
    CHILD = 4


@dataclass(frozen=True)
class Quantity:
    """One column: a value per row, NaN where it is not known."""

    name: str
    unit: str
    values: Floats
    standard_error: Floats


@dataclass(frozen=True)
class HourProfile:
    """A diagnostic of one plant by local clock time [h]."""

    hours: Floats
    unit: str
    values: Floats
    standard_error: Floats


@dataclass(frozen=True)
class LeafProfile:
    """Something of one plant by leaf rank; leaf 1 is the lowest."""

    leaves: Integers
    unit: str
    values: Floats
    standard_error: Floats


@dataclass(frozen=True)
class Table:
    """Columns of the same rows; values and standard errors are
    [rows, columns]."""

    names: tuple[str, ...]
    units: tuple[str, ...]
    values: Floats
    standard_error: Floats

    def __contains__(self, name: str) -> bool:
        return name in self.names

    def __getitem__(self, name: str) -> Quantity:
        i = self.names.index(name)
        return Quantity(
            name, self.units[i], self.values[:, i], self.standard_error[:, i]
        )

    def take(self, index: NDArray) -> Table:
        """The rows of a mask or of row numbers."""
        return Table(
            self.names,
            self.units,
            self.values[index],
            self.standard_error[index],
        )

    def matching(self, pattern: str) -> list[tuple[re.Match[str], int]]:
        """Columns whose whole name matches, with their numbers."""
        found = [re.fullmatch(pattern, name) for name in self.names]
        return [(match, i) for i, match in enumerate(found) if match]


@dataclass(frozen=True)
class Rows:
    """Complete evaluations, done or failed. Outcomes of failed ones are NaN
    and their fitness is -infinity.

    rows["absorbed_par"] is an objective, diagnostic or trait by its name."""

    generation: Integers
    """-1 for finalists."""
    slot: Integers
    status: Integers
    origin: Integers
    parents: Integers
    """[rows, 2], slots of the generation before; -1: none."""
    traits: Table
    """The genomes; exact, their standard errors are 0."""
    objectives: Table
    diagnostics: Table
    fitness: Quantity
    attempt: Integers
    seconds: Quantity
    worker: Integers
    message: NDArray[np.str_]

    def __len__(self) -> int:
        return len(self.status)

    def __getitem__(self, name: str) -> Quantity:
        for table in (self.objectives, self.diagnostics, self.traits):
            if name in table:
                return table[name]
        raise KeyError(f"no objective, diagnostic or trait is called {name}")

    def take(self, index: NDArray) -> Rows:
        """The rows of a mask or of row numbers."""
        return Rows(
            self.generation[index],
            self.slot[index],
            self.status[index],
            self.origin[index],
            self.parents[index],
            self.traits.take(index),
            self.objectives.take(index),
            self.diagnostics.take(index),
            _take(self.fitness, index),
            self.attempt[index],
            _take(self.seconds, index),
            self.worker[index],
            self.message[index],
        )

    @property
    def done(self) -> Rows:
        """Without the failed ones."""
        return self.take(self.status == Status.DONE)

    @property
    def failed(self) -> Rows:
        """Only the failed ones; their message says why."""
        return self.take(self.status == Status.FAILED)

    def top(self, count: int) -> Rows:
        """The fittest with different genomes, best first; of equal genomes
        the fittest. Fewer if there are not as many."""
        done = self.done
        order = np.argsort(-done.fitness.values, kind="stable")
        _, first = np.unique(
            done.traits.values[order], axis=0, return_index=True
        )
        return done.take(order[np.sort(first)[:count]])

    def one(self, index: int, is_final: bool) -> Evaluation:
        """A single row; negative numbers count from the end."""
        return Evaluation(self.take(np.array([index])), is_final)


def _take(quantity: Quantity, index: NDArray) -> Quantity:
    return Quantity(
        quantity.name,
        quantity.unit,
        quantity.values[index],
        quantity.standard_error[index],
    )


@dataclass(frozen=True)
class Evaluation:
    """One row."""

    row: Rows
    is_final: bool
    """Evaluated anew at the end, with fresh random numbers."""

    @property
    def objective(self) -> Estimate:
        """The first objective: what the case maximises."""
        return self.estimate(self.row.objectives.names[0])

    def estimate(self, name: str) -> Estimate:
        """An objective, diagnostic or trait by name."""
        found = self.row[name]
        return Estimate(
            float(found.values[0]), float(found.standard_error[0]), found.unit
        )

    def by_hour(self, what: str = "absorbed") -> HourProfile:
        """Diagnostics named <what>_hour_HH_MM, by time; absorbed PAR comes
        in [W m-2] of ground."""
        table = self.row.diagnostics
        found = table.matching(rf"{re.escape(what)}_hour_(\d\d)_(\d\d)")
        hours = [int(m[1]) + int(m[2]) / 60 for m, _ in found]
        order = np.argsort(hours)
        columns = np.array([i for _, i in found], dtype=int)[order]
        return HourProfile(
            np.array(hours, dtype=float)[order], *_profile(table, columns)
        )

    def by_leaf(self, what: str = "absorbed") -> LeafProfile:
        """Diagnostics named <what>_leafNN, or for length, width, inclination
        and azimuth the trait, lowest leaf first; absorbed PAR comes in
        [MJ m-2 day-1] of ground."""
        name = re.escape(what)
        for table, pattern in (
            (self.row.traits, rf"leaf(\d+)_{name}"),
            (self.row.diagnostics, rf"{name}_leaf(\d+)"),
        ):
            if found := table.matching(pattern):
                break
        leaves = np.array([int(m[1]) for m, _ in found], dtype=int)
        order = np.argsort(leaves)
        columns = np.array([i for _, i in found], dtype=int)[order]
        return LeafProfile(leaves[order], *_profile(table, columns))


def _profile(table: Table, columns: NDArray) -> tuple[str, Floats, Floats]:
    unit = table.units[columns[0]] if len(columns) else "1"
    return unit, table.values[0, columns], table.standard_error[0, columns]
