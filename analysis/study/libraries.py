# SPDX-License-Identifier: Apache-2.0
"""Searches by other packages, which evaluate plants through the Python
module."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from shared import Numbers

from ideotype import Stand


class Function:
    """A function that a library minimises; its arguments are free genes scaled
    from 0 to 1. Each generation uses other fields and random numbers."""

    def __init__(self, stand: Stand) -> None:
        genes = stand.genes
        self._stand, self._free = stand, np.asarray(stand.free)
        self._lower = genes.lower.to_numpy()[self._free]
        self._range = genes.upper.to_numpy()[self._free] - self._lower
        self.start = (stand.baseline[self._free] - self._lower) / self._range
        self.evaluations = self._generation = 0

    def plants(self, points: ArrayLike) -> Numbers:
        shares = np.atleast_2d(np.asarray(points, float))
        plants = np.tile(self._stand.baseline, (len(shares), 1))
        plants[:, self._free] = self._lower + self._range * shares
        return plants

    def __call__(self, points: ArrayLike) -> list[float]:
        self._generation += 1
        plants = self.plants(points)
        self.evaluations += len(plants)
        found = self._stand.evaluate(plants, [], generation=self._generation)
        values = np.asarray(found.objective_by_randomisation[:, 0])
        return [-x for x in values.mean(axis=1).tolist()]


def by_bipop(stand: Stand, seed: int, count: int) -> Numbers:
    """Searches by BIPOP-CMA-ES in the package cma (Hansen 2009,
    doi:10.1145/1570256.1570333)."""
    import cma

    function = Function(stand)
    options = {
        "bounds": [0, 1],
        "seed": seed,
        "maxfevals": count,
        "verbose": -9,
        "verb_log": 0,
    }
    _, search = cma.fmin2(
        None,
        function.start.clip(0.02, 0.98),
        0.2,
        options,
        restarts=9,
        bipop=True,
        parallel_objective=function,
    )
    return function.plants(search.result.xfavorite)[0]


def by_pymoo(stand: Stand, seed: int, count: int) -> Numbers:
    """Searches by differential evolution in the package pymoo."""
    from pymoo.algorithms.soo.nonconvex.de import DE
    from pymoo.core.problem import Problem
    from pymoo.problems.static import StaticProblem

    function = Function(stand)
    genes = len(function.start)
    problem = Problem(n_var=genes, n_obj=1, xl=0.0, xu=1.0)
    search = DE(pop_size=50)
    search.setup(problem, termination=("n_eval", count), seed=seed)
    while search.has_next():
        asked = search.ask()
        values = np.array(function(asked.get("X")))[:, None]
        search.evaluator.eval(StaticProblem(problem, F=values), asked)
        search.tell(infills=asked)
    return function.plants(search.result().X)[0]


LIBRARIES = {"bipop": by_bipop, "pymoo": by_pymoo}
