# SPDX-License-Identifier: Apache-2.0
"""Prints the evaluations that functions of real numbers, integers and choices
take until their minimum is within 1e-8: `cma_es` and `auto`, and CatCMA with
margin (arXiv:2504.07884) of the package cmaes, which has the same start, first
step and population as `cma_es`. Numbers are medians of 11 seeds; a search that
ends in none of its evaluations counts as infinite.

Functions are those of Hamano et al. 2025: sphere or ellipsoid of real numbers
and integers, and the number of wrong choices (OneMax, OM) or of choices from the
first wrong one (LeadingOnes, LO)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from cmaes import CatCMAwM
from numpy.typing import NDArray

import ideotype

REAL, WHOLE = 5.0, 10
"""Bounds of real numbers and of integers, either way."""
ENTRIES = 5
TARGET = 1e-8
Numbers = NDArray[np.float64]


@dataclass(frozen=True)
class Function:
    """A function of real numbers, integers and choices."""

    name: str
    reals: int
    integers: int
    choices: int
    condition: float = 1
    is_leading: bool = False

    @property
    def size(self) -> int:
        """The number of genes."""
        return self.reals + self.integers + self.choices

    def __call__(self, x: Numbers, chosen: Numbers, best: Numbers) -> float:
        """Returns the value.

        x: real numbers and integers.
        chosen, best: entries of the choices, and those of the minimum."""
        power = np.linspace(0, 1, len(x)) if len(x) > 1 else np.zeros(len(x))
        right = chosen == best
        score = np.cumprod(right).sum() if self.is_leading else right.sum()
        return float(
            np.sum(self.condition**power * x**2) + self.choices - score
        )


FUNCTIONS = (
    Function("SphereInt", 5, 5, 0),
    Function("EllipsoidInt", 5, 5, 0, condition=1e4),
    Function("SphereOM", 5, 0, 5),
    Function("SphereLO", 5, 0, 5, is_leading=True),
    Function("SphereIntOM", 5, 5, 5),
    Function("EllipsoidIntLO", 5, 5, 5, condition=1e4, is_leading=True),
    Function("Int", 0, 10, 0),
    Function("OM", 0, 0, 10),
)


def best_choices(function: Function, seed: int) -> Numbers:
    """Returns the entries of the minimum, which differ between seeds."""
    rng = np.random.default_rng(seed)
    return rng.integers(ENTRIES, size=function.choices).astype(float)


def evaluations(
    function: Function, optimizer: str, seed: int, limit: int = 50_000
) -> float:
    """Returns the evaluations of an optimizer of this program."""
    reals, whole, choices = (
        function.reals,
        function.integers,
        function.choices,
    )
    lower = [-REAL] * reals + [-WHOLE] * whole + [0] * choices
    upper = [REAL] * reals + [WHOLE] * whole + [ENTRIES - 1] * choices
    search = ideotype.Search(
        lower,
        upper,
        start=[3] * reals + [7] * whole + [2] * choices,
        maximise=[False],
        optimizer=optimizer,
        population=4 + int(3 * np.log(function.size)),
        seed=seed,
        kinds=["real"] * reals + ["integer"] * whole + ["choice"] * choices,
    )
    best = best_choices(function, seed)
    numbers = reals + whole

    def values(points: Numbers) -> list[float]:
        return [function(x[:numbers], x[numbers:], best) for x in points]

    return _count(
        search.ask, values, lambda _, values: search.tell(values), limit
    )


def published_evaluations(
    function: Function, seed: int, limit: int = 50_000
) -> float:
    """Returns the evaluations of the package cmaes."""
    reals, whole = function.reals, function.integers
    steps = [0.2 * 2 * REAL] * reals + [0.2 * (2 * WHOLE + 1)] * whole
    search = CatCMAwM(
        x_space=[[-REAL, REAL]] * reals or None,
        z_space=[range(-WHOLE, WHOLE + 1)] * whole or None,
        c_space=[ENTRIES] * function.choices or None,
        mean=np.array([3.0] * reals + [7.0] * whole) if steps else None,
        cov=np.diag(np.square(steps)) if steps else None,
        population_size=4 + int(3 * np.log(function.size)),
        seed=seed,
    )
    best = best_choices(function, seed)

    def value(point: CatCMAwM.Solution) -> float:
        x = [part for part in (point.x, point.z) if part is not None]
        chosen = np.empty(0) if point.c is None else point.c.argmax(axis=1)
        return function(np.concatenate([*x, []]), chosen, best)

    return _count(
        lambda: [search.ask() for _ in range(search.population_size)],
        lambda points: [value(point) for point in points],
        lambda points, values: search.tell(list(zip(points, values))),
        limit,
    )


def _count(
    ask: Callable[[], Sequence],
    values_of: Callable[[Sequence], list[float]],
    tell: Callable[[Sequence, list[float]], None],
    limit: int,
) -> float:
    count = 0
    while count < limit:
        points = ask()
        values = values_of(points)
        count += len(values)
        if min(values) < TARGET:
            return count
        tell(points, values)
    return np.inf


def main() -> None:
    print(f"{'function':<16} {'cma_es':>8} {'auto':>8} {'cmaes':>8}")
    for function in FUNCTIONS:
        runs = (
            [evaluations(function, "cma_es", seed) for seed in range(1, 12)],
            [evaluations(function, "auto", seed) for seed in range(1, 12)],
            [published_evaluations(function, seed) for seed in range(1, 12)],
        )
        medians = " ".join(f"{np.median(run):8.0f}" for run in runs)
        print(f"{function.name:<16} {medians}")


if __name__ == "__main__":
    main()
