# SPDX-License-Identifier: Apache-2.0
"""Evaluations as numpy arrays, and quantities with units."""

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
    """The progress of an evaluation; values as in the file."""

    EMPTY = 0
    PROPOSED = 1
    DONE = 2
    FAILED = 3


class Origin(IntEnum):
    """The origin of a genome; values as in the file."""

    NONE = 0
    BASELINE = 1
    RANDOM = 2
    ELITE = 3
    CHILD = 4
    SAMPLE = 5


@dataclass(frozen=True)
class Rows:
    """Complete evaluations, done or failed; results of failed evaluations are
    NaN.

    rows["absorbed_par"] returns a quantity, objective or gene by name."""

    genes: Genes
    goals: tuple[Objective, ...]
    quantities: dict[str, Quantity]
    row: Integers
    """The row number in /evaluations, or for finalists in /final."""
    generation: Integers
    """The number of the generation; -1 for finalists."""
    slot: Integers
    """The slot in the generation; for finalists the row number."""
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
    last dimension is 0 if the file has none. Rows of one generation, and all
    finalists, have common random numbers in each randomisation."""
    violation: Floats
    """The violation of the constraints; 0 if all are met."""
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
        """Returns the quantities along the given axis."""
        quantities = self.quantities.values()
        return [q for q in quantities if q.axis and q.axis.name == axis]

    def take(self, index: NDArray) -> Rows:
        """Returns the rows given by a mask or row numbers."""
        quantities = {n: q.take(index) for n, q in self.quantities.items()}
        arrays = {name: getattr(self, name)[index] for name in _ARRAYS}
        return replace(self, quantities=quantities, **arrays)

    @property
    def done(self) -> Rows:
        """The rows that did not fail."""
        return self.take(self.status == Status.DONE)

    @property
    def failed(self) -> Rows:
        """The failed rows; `message` states the reasons."""
        return self.take(self.status == Status.FAILED)

    def ranking(self, count: int) -> Integers:
        """Returns the row numbers of the best `count` different genomes, best
        first; the best row represents equal genomes. Rows that violate
        constraints come last, by increasing violation. The result is shorter
        if there are fewer different genomes."""
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
        """Returns one row as an evaluation; negative indices count from the
        end."""
        return Evaluation(self.take(np.array([index])), is_final)


_ARRAYS = [f.name for f in fields(Rows)][3:]


def join(parts: Sequence[Rows]) -> Rows:
    """Concatenates the rows of several histories, with the quantities and the
    number of randomisations that all have.

    Raises HistoryError if the genes or objectives of histories differ."""
    first = parts[0]
    for part in parts:
        if part.genes.names != first.genes.names or part.goals != first.goals:
            raise HistoryError(
                "histories of one case differ in genes or objectives"
            )

    def quantity(name: str) -> Quantity:
        quantities = [part.quantities[name] for part in parts]
        values = np.concatenate([q.values for q in quantities])
        error = np.concatenate([q.standard_error for q in quantities])
        return replace(quantities[0], values=values, standard_error=error)

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
    """Whether this is the re-evaluation of a finalist, with independent random
    numbers."""

    @property
    def objective(self) -> Estimate:
        """The estimate of the first objective, with its value in each
        randomisation of the light."""
        return self._goal(0)

    def _goal(self, k: int) -> Estimate:
        return Estimate(
            float(self.row.objectives[0, k]),
            float(self.row.objectives_standard_error[0, k]),
            self.row.goals[k].unit,
            self.row.randomisations[0, k],
        )

    def estimate(self, name: str) -> Estimate:
        """Returns an objective with its randomisations, a quantity without
        axes or a gene, by name.

        Raises HistoryError for unknown names."""
        for k, objective in enumerate(self.row.goals):
            if name == objective.name:
                return self._goal(k)
        try:
            quantity = self.row[name]
        except KeyError as error:
            raise HistoryError(
                f"the history has no {name}"
                + did_you_mean(name, self.row.names)
            ) from error
        return Estimate(
            float(quantity.values[0]),
            float(quantity.standard_error[0]),
            quantity.unit,
        )

    @property
    def per_leaf_area(self) -> Estimate:
        """The absorbed PAR per one-sided leaf area. It has randomisations if
        absorbed PAR is the objective, since leaf area is exact.

        Raises HistoryError if the history lacks the quantity."""
        name, objective = "absorbed_par_per_leaf_area", self.row.goals[0].name
        if objective == name:
            return self.objective
        light = self.estimate(name)
        if objective != "absorbed_par" or self.row.with_axis("scenario"):
            return light
        scale = light.mean / self.objective.mean
        return replace(light, draws=scale * self.objective.draws)

    def profile(self, name: str) -> Profile:
        """Returns a quantity along its axis.

        Raises HistoryError for unknown names."""
        quantity = self.row.quantities.get(name)
        if quantity is None or quantity.axis is None:
            known = [n for n, q in self.row.quantities.items() if q.axis]
            raise HistoryError(
                f"the history has no {name}" + did_you_mean(name, known)
            )
        values, error = quantity.values[0], quantity.standard_error[0]
        axis = quantity.axis
        return Profile(axis.labels, quantity.unit, values, error, axis.meaning)
