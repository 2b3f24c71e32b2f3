"""Evaluations as numpy arrays whose columns know their units."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import Field, dataclass, fields
from enum import IntEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .estimate import Estimate
from .file import HistoryError
from .table import Floats, Integers, Quantity, Table


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
class LayerProfile:
    """Something of one plant by layer of height above the soil [m]."""

    lower: Floats
    upper: Floats
    unit: str
    values: Floats
    standard_error: Floats


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
            self.fitness.take(index),
            self.attempt[index],
            self.seconds.take(index),
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

    def ranking(self, count: int) -> Integers:
        """Row numbers of the fittest with different genomes, best first; of
        equal genomes the fittest. Fewer if there are not as many."""
        done = np.flatnonzero(self.status == Status.DONE)
        fittest = np.argsort(-self.fitness.values[done], kind="stable")
        order = done[fittest]
        _, first = np.unique(
            self.traits.values[order], axis=0, return_index=True
        )
        return order[np.sort(first)[:count]]

    def top(self, count: int) -> Rows:
        """The rows of ranking()."""
        return self.take(self.ranking(count))

    def one(self, index: int, is_final: bool) -> Evaluation:
        """A single row; negative numbers count from the end."""
        return Evaluation(self.take(np.array([index])), is_final)


def join(parts: Sequence[Rows]) -> Rows:
    """Rows of several histories of the same columns, one after the other.

    Raises HistoryError if their columns differ."""

    def table(name: str) -> Table:
        tables = [getattr(part, name) for part in parts]
        first = tables[0]
        if any(t.names != first.names for t in tables):
            raise HistoryError(f"histories of one case differ in {name}")
        return Table(
            first.names,
            first.units,
            np.concatenate([t.values for t in tables]),
            np.concatenate([t.standard_error for t in tables]),
        )

    def quantity(name: str) -> Quantity:
        columns = [getattr(part, name) for part in parts]
        return Quantity(
            columns[0].name,
            columns[0].unit,
            np.concatenate([c.values for c in columns]),
            np.concatenate([c.standard_error for c in columns]),
        )

    def joined(field: Field) -> Any:
        values = [getattr(part, field.name) for part in parts]
        if isinstance(values[0], Table):
            return table(field.name)
        if isinstance(values[0], Quantity):
            return quantity(field.name)
        return np.concatenate(values)

    return Rows(**{field.name: joined(field) for field in fields(Rows)})


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

    @property
    def per_leaf_area(self) -> Estimate:
        """Absorbed PAR per one-sided leaf area. The leaf area is exact, so
        that the relative error is that of the light.

        Raises HistoryError if the history does not tell it."""
        if "absorbed_par_per_leaf_area" in self.row.objectives:
            return self.estimate("absorbed_par_per_leaf_area")
        try:
            absorbed, lai = self.estimate("absorbed_par"), self.estimate("lai")
        except KeyError as error:
            raise HistoryError(str(error.args[0])) from error
        if not lai.mean > 0:
            raise HistoryError("the plant has no leaf area")
        return absorbed.scaled(1 / lai.mean, absorbed.unit)

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
        """Diagnostics named <what>_leafNN, or for length, width, insertion_angle
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

    def by_layer(self, what: str = "absorbed") -> LayerProfile:
        """Diagnostics named <what>_layer_LLL_UUUcm, lowest layer first."""
        table = self.row.diagnostics
        found = table.matching(rf"{re.escape(what)}_layer_(\d+)_(\d+)cm")
        edges = np.array([(int(m[1]), int(m[2])) for m, _ in found]) / 100
        edges = edges.reshape(-1, 2)
        order = np.argsort(edges[:, 0])
        columns = np.array([i for _, i in found], dtype=int)[order]
        lower, upper = edges[order].T
        return LayerProfile(lower, upper, *_profile(table, columns))


def _profile(table: Table, columns: NDArray) -> tuple[str, Floats, Floats]:
    unit = table.units[columns[0]] if len(columns) else "1"
    return unit, table.values[0, columns], table.standard_error[0, columns]
