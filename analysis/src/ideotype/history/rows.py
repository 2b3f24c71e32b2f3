# SPDX-License-Identifier: Apache-2.0
"""Evaluations as numpy arrays, and quantities that know their units."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from enum import IntEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import did_you_mean
from .estimate import Estimate
from .file import HistoryError
from .genes import Genes
from .quantity import Floats, Integers, Objective, Profile, Quantity


class Status(IntEnum):
    """The progress of an evaluation, as numbered in the file."""

    EMPTY = 0
    PROPOSED = 1
    DONE = 2
    FAILED = 3


class Origin(IntEnum):
    """The origin of a genome, as numbered in the file."""

    NONE = 0
    BASELINE = 1
    RANDOM = 2
    ELITE = 3
    CHILD = 4
    SAMPLE = 5


@dataclass(frozen=True)
class Rows:
    """Complete evaluations, done or failed; outcomes of failed evaluations are
    NaN.

    rows["absorbed_par"] is a quantity, objective or gene by its name."""

    genes: Genes
    goals: tuple[Objective, ...]
    quantities: dict[str, Quantity]
    row: Integers
    """The number of the row in /evaluations, or for finalists in /final."""
    generation: Integers
    """The generation, -1 for finalists."""
    slot: Integers
    """The slot in the generation; for finalists the number of the row."""
    status: Integers
    origin: Integers
    parents: Integers
    """The rows of /evaluations of both parents [rows, 2]; -1: none."""
    genome: Floats
    """The genomes [rows, genes]."""
    objectives: Floats
    """The objectives [rows, objectives]."""
    objectives_standard_error: Floats
    randomisations: Floats
    """The objectives by randomisation [rows, objectives, randomisations]; the
    number of randomisations is 0 if the file has none. Rows of one generation,
    and all finalists, share random numbers in the same randomisation."""
    violation: Floats
    """The violation of constraints, 0 if all constraints are met."""
    attempt: Integers
    seconds: Floats
    worker: Integers
    message: NDArray[np.str_]

    def __len__(self) -> int:
        return len(self.status)

    def __getitem__(self, name: str) -> Quantity:
        if name in self.quantities:
            return self.quantities[name]
        for k, objective in enumerate(self.goals):
            if name == objective.name:
                error = self.objectives_standard_error[:, k]
                return Quantity(
                    name, objective.unit, self.objectives[:, k], error
                )
        if name in self.genes.names:
            i = self.genes.names.index(name)
            values = self.genome[:, i]
            unit = self.genes.units[i]
            return Quantity(name, unit, values, np.zeros_like(values))
        raise KeyError(
            f"no quantity, objective or gene is called {name}"
            + did_you_mean(name, self.names)
        )

    @property
    def names(self) -> list[str]:
        """The names of quantities, objectives and genes."""
        names = (objective.name for objective in self.goals)
        return [*self.quantities, *names, *self.genes.names]

    def with_axis(self, axis: str) -> list[Quantity]:
        """Returns the quantities that have the given axis."""
        found = self.quantities.values()
        return [q for q in found if q.axis and q.axis.name == axis]

    def take(self, index: NDArray) -> Rows:
        """Returns the rows of a mask or of row numbers."""
        quantities = {n: q.take(index) for n, q in self.quantities.items()}
        arrays = {name: getattr(self, name)[index] for name in _ARRAYS}
        return replace(self, quantities=quantities, **arrays)

    @property
    def done(self) -> Rows:
        """The rows without the failed ones."""
        return self.take(self.status == Status.DONE)

    @property
    def failed(self) -> Rows:
        """The failed rows alone; their message says why."""
        return self.take(self.status == Status.FAILED)

    def ranking(self, count: int) -> Integers:
        """Returns row numbers of the best with different genomes, best first;
        equal genomes are represented by their best row. Rows that violate
        constraints come last, in the order of their violation. The result is
        shorter if there are fewer different genomes than wanted."""
        done = np.flatnonzero(self.status == Status.DONE)
        worse = -self.goals[0].sign * self.objectives[done, 0]
        violation = self.violation[done]
        worse = np.where(violation > 0, 0.0, worse)
        order = done[np.lexsort((worse, violation))]
        _, first = np.unique(self.genome[order], axis=0, return_index=True)
        return order[np.sort(first)[:count]]

    def top(self, count: int) -> Rows:
        """Returns the rows of ranking()."""
        return self.take(self.ranking(count))

    def one(self, index: int, is_final: bool) -> Evaluation:
        """Returns one row as an evaluation; negative numbers count from the
        end."""
        return Evaluation(self.take(np.array([index])), is_final)


_ARRAYS = [f.name for f in fields(Rows)][3:]


def join(parts: Sequence[Rows]) -> Rows:
    """Returns rows of several histories, one after the other, with the
    quantities and the number of randomisations that all histories have.

    Raises HistoryError if the genes or objectives of histories differ."""
    first = parts[0]
    for part in parts:
        if part.genes.names != first.genes.names or part.goals != first.goals:
            raise HistoryError(
                "histories of one case differ in genes or objectives"
            )

    def quantity(name: str) -> Quantity:
        each = [part.quantities[name] for part in parts]
        values = np.concatenate([q.values for q in each])
        error = np.concatenate([q.standard_error for q in each])
        return replace(each[0], values=values, standard_error=error)

    shared = [
        name
        for name, q in first.quantities.items()
        if all(
            name in part.quantities and part.quantities[name].axis == q.axis
            for part in parts
        )
    ]
    draws = min(part.randomisations.shape[2] for part in parts)
    parts = [
        replace(part, randomisations=part.randomisations[..., :draws])
        for part in parts
    ]
    arrays: dict[str, Any] = {
        name: np.concatenate([getattr(part, name) for part in parts])
        for name in _ARRAYS
    }
    return replace(
        first, quantities={n: quantity(n) for n in shared}, **arrays
    )


@dataclass(frozen=True)
class Evaluation:
    """One row of evaluations."""

    row: Rows
    is_final: bool
    """Whether the row is a final evaluation, with new random numbers."""

    @property
    def objective(self) -> Estimate:
        """The first objective, with its randomisations."""
        return self._goal(0)

    def _goal(self, k: int) -> Estimate:
        return Estimate(
            float(self.row.objectives[0, k]),
            float(self.row.objectives_standard_error[0, k]),
            self.row.goals[k].unit,
            self.row.randomisations[0, k],
        )

    def estimate(self, name: str) -> Estimate:
        """Returns by name an objective with its randomisations, a quantity
        without axes, or a gene.

        Raises HistoryError if there is none."""
        for k, objective in enumerate(self.row.goals):
            if name == objective.name:
                return self._goal(k)
        try:
            found = self.row[name]
        except KeyError as error:
            raise HistoryError(
                f"the history has no {name}"
                + did_you_mean(name, self.row.names)
            ) from error
        return Estimate(
            float(found.values[0]), float(found.standard_error[0]), found.unit
        )

    @property
    def per_leaf_area(self) -> Estimate:
        """The absorbed PAR per one-sided leaf area, with randomisations if the
        objective is the same light with randomisations: the leaf area is
        exact.

        Raises HistoryError if the history lacks one of both quantities."""
        name, objective = "absorbed_par_per_leaf_area", self.row.goals[0].name
        if objective == name:
            return self.objective
        found = self.estimate(name)
        if objective != "absorbed_par" or self.row.with_axis("scenario"):
            return found
        scale = found.mean / self.objective.mean
        return replace(found, draws=scale * self.objective.draws)

    def profile(self, name: str) -> Profile:
        """Returns a quantity along its axis.

        Raises HistoryError if there is none."""
        found = self.row.quantities.get(name)
        if found is None or found.axis is None:
            known = [n for n, q in self.row.quantities.items() if q.axis]
            raise HistoryError(
                f"the history has no {name}" + did_you_mean(name, known)
            )
        values, error = found.values[0], found.standard_error[0]
        axis = found.axis
        return Profile(axis.labels, found.unit, values, error, axis.meaning)
