# SPDX-License-Identifier: Apache-2.0
"""Measures the importance of the traits of the best plant by changing one
trait at a time."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..figures.importance import Change
from ..history.case import Case
from ..history.estimate import Estimate
from ..history.genes import Genes

_GENERATIONS = 16
"""The number of generations with fields for comparing plants; their random
numbers are independent of the search."""

_OF_GROWING = 4
"""The number of generations for plants that grow, which have separate fields
at each stage."""

_FIRST = 1_000_000
"""The number of the first generation in which plants are compared."""

_STEP = 0.1
"""The relative change of a trait that is no angle."""

_TURN = 10.0
"""The change of an angle [deg]."""


def evaluate_changes(case: Case, threads: int = 1) -> list[Change]:
    """Evaluates the best plant of a case with each free trait changed, in the
    fields and the light of the best plant and the baseline. Returns the traits
    in decreasing order of the loss that occurs if the trait is set to its
    baseline value; standard errors are paired.

    Raises Error if there is no compiled module, or if the module cannot use
    the history."""
    best = case.best.row.genome[0]
    baseline = case.baseline.row.genome[0]
    genes = case.genes
    traits = [
        trait
        for kind in ("leaf", "profile", "plant")
        for trait in genes.bred(kind)
    ]
    plants = [baseline, best]
    for trait in traits:
        columns = genes.columns(trait)
        plants += [
            _with(best, columns, baseline[columns]),
            *(
                _with(best, columns, _moved(genes, columns, best, sign))
                for sign in (1, -1)
            ),
        ]
    grows = "day_of_stage" in case.best.row.quantities
    values = _evaluate(
        case.best_history.path,
        np.array(plants),
        _OF_GROWING if grows else _GENERATIONS,
        threads,
    )
    sign = case.best.row.goals[0].sign
    scale = 100 / abs(values[0].mean())
    losses = sign * scale * (values[1] - values)
    changes = []
    for k, trait in enumerate(traits):
        back, *moved = (_mean(each) for each in losses[2 + 3 * k : 5 + 3 * k])
        changes.append(Change(trait, back, max(moved, key=lambda x: x.mean)))
    return sorted(changes, key=lambda each: -each.back.mean)


def _with(
    genome: NDArray[np.float64],
    columns: NDArray[np.int64],
    numbers: NDArray[np.float64],
) -> NDArray[np.float64]:
    changed = genome.copy()
    changed[columns] = numbers
    return changed


def _moved(
    genes: Genes,
    columns: NDArray[np.int64],
    genome: NDArray[np.float64],
    sign: int,
) -> NDArray[np.float64]:
    """Returns genes changed by 10 deg, by 10 %, or to the next whole number or
    choice. The percentage refers to the
    larger of the value and half the range, because a value that is added to a
    measure may be 0."""
    values = genome[columns]
    lower, upper = genes.lower[columns], genes.upper[columns]
    if genes.is_discrete(columns[0]):
        count = upper - lower + 1
        return lower + np.mod(values + sign - lower, count)
    if genes.units[columns[0]] == "deg":
        step = np.full(len(columns), _TURN)
    else:
        half = (genes.upper - genes.lower)[columns] / 2
        step = _STEP * np.maximum(np.abs(values), half)
    moved = values + sign * step
    if genes.is_circular[columns].all():
        moved = np.mod(moved, 360.0)
    return moved


def _evaluate(
    path: Path,
    plants: NDArray[np.float64],
    generations: int,
    threads: int,
) -> NDArray[np.float64]:
    """Returns the first objective by randomisation [plants,
    randomisations]."""
    from ..stand.stand import Stand

    stand = Stand.from_history(path, same_isa=False)
    generations_values = [
        stand.evaluate(
            plants, [], generation=_FIRST + k, threads=threads
        ).objective_by_randomisation.values[:, 0]
        for k in range(generations)
    ]
    return np.concatenate(generations_values, axis=1)


def _mean(values: NDArray[np.float64]) -> Estimate:
    error = float(values.std(ddof=1)) / np.sqrt(len(values))
    return Estimate(float(values.mean()), error, "%")
