# SPDX-License-Identifier: Apache-2.0
"""Searches by other packages, which evaluate plants through the Python
module."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from shared import Numbers, search_by_package

import ideotype
from ideotype import Stand


class Function:
    """A function that a library minimises; its arguments are free genes scaled
    from 0 to 1. Each generation uses other fields and random numbers."""

    def __init__(self, stand: Stand) -> None:
        genes = stand.genes
        self._stand, self._free = stand, np.asarray(stand.free)
        self._lower = genes.lower.to_numpy()[self._free]
        self._range = genes.upper.to_numpy()[self._free] - self._lower
        self.start = self.shares(stand.baseline)
        self.evaluations = self._generation = 0

    def shares(self, plant: Numbers) -> Numbers:
        return (plant[self._free] - self._lower) / self._range

    def plants(self, points: ArrayLike) -> Numbers:
        shares = np.atleast_2d(np.asarray(points, float))
        plants = np.tile(self._stand.baseline, (len(shares), 1))
        plants[:, self._free] = self._lower + self._range * shares
        return plants

    def __call__(
        self, points: ArrayLike, *, repeats: bool = False
    ) -> list[float]:
        """Returns the values of points; `repeats`: with the random numbers of
        the last call. A plant that cannot be evaluated counts as the worst of
        the call, since libraries do not accept NaN."""
        self._generation += not repeats
        plants = self.plants(points)
        self.evaluations += len(plants)
        found = self._stand.evaluate(plants, [], generation=self._generation)
        draws = np.asarray(found.objective_by_randomisation[:, 0])
        values = draws.mean(axis=1)
        has_failed = np.isnan(values)
        if has_failed.all():
            raise ideotype.Error(str(found.message.values[0]))
        values[has_failed] = np.nanmin(values)
        return [-x for x in values.tolist()]


def options_of_cma(seed: int, count: int) -> dict[str, Any]:
    """Returns the options of searches by the package cma."""
    return {
        "bounds": [0, 1],
        "seed": seed,
        "maxfevals": count,
        "verbose": -9,
        "verb_log": 0,
    }


def by_bipop(stand: Stand, seed: int, count: int) -> Numbers:
    """Searches by BIPOP-CMA-ES in the package cma (Hansen 2009,
    doi:10.1145/1570256.1570333)."""
    import cma

    function = Function(stand)
    _, search = cma.fmin2(
        None,
        function.start.clip(0.02, 0.98),
        0.2,
        options_of_cma(seed, count),
        restarts=9,
        bipop=True,
        parallel_objective=function,
    )
    return function.plants(search.result.xfavorite)[0]


def by_lq(stand: Stand, seed: int, count: int) -> Numbers:
    """Searches by lq-CMA-ES in the package cma, which replaces evaluations by a
    linear or quadratic model where that ranks plants well (Hansen 2019,
    doi:10.1145/3321707.3321842)."""
    import cma

    function = Function(stand)
    _, search = cma.fmin_lq_surr(
        lambda point: function([point])[0],
        function.start.clip(0.02, 0.98),
        0.2,
        options_of_cma(seed, count),
    )
    return function.plants(search.result.xfavorite)[0]


def by_turbo(stand: Stand, seed: int, count: int) -> Numbers:
    """Searches by TuRBO-1 (Eriksson et al. 2019, arXiv:1910.01739): a Gaussian
    process of scikit-learn with a length scale of each gene, and batches of ten
    plants by Thompson sampling in a trust region. The baseline is one of the
    first plants. Returns the evaluated plant with the best expectation."""
    from scipy.stats import qmc
    from sklearn.gaussian_process import GaussianProcessRegressor, kernels

    batch, tried, success, longest, shortest = 10, 2048, 3, 1.6, 0.5**7
    function = Function(stand)
    genes = len(function.start)
    random = np.random.default_rng(seed)
    points = qmc.LatinHypercube(genes, rng=random).random(2 * genes)
    points[0] = function.start
    points = points[:count]
    values = np.array(function(points))
    failure = -(-genes // batch)
    length, good, bad = 0.8, 0, 0
    kernel = kernels.ConstantKernel() * kernels.Matern(
        np.full(genes, 0.5), (0.05, 100), nu=2.5
    ) + kernels.WhiteKernel(0.1)
    while True:
        model = GaussianProcessRegressor(kernel, normalize_y=True)
        with warnings.catch_warnings():
            # Length scales without effect are at their bound.
            warnings.simplefilter("ignore")
            model.fit(points, values)
        kernel = model.kernel_
        expected = model.predict(points)
        best = points[expected.argmin()]
        if len(points) >= count:
            return function.plants(best)[0]
        # The region is longer where the value depends less on a gene.
        scales = kernel.k1.k2.length_scale
        sides = length * scales / np.exp(np.log(scales).mean())
        low, high = (
            (best - sides / 2).clip(0),
            (best + sides / 2).clip(None, 1),
        )
        new = qmc.Sobol(genes, rng=random).random(tried) * (high - low) + low
        new = np.where(random.random(new.shape) < 20 / genes, new, best)
        draws = model.sample_y(new, batch, random_state=seed + len(points))
        chosen = np.unique(draws.argmin(axis=0))[: count - len(points)]
        found = np.array(function(new[chosen]))
        is_better = found.min() < values.min() - 1e-3 * abs(values.min())
        good, bad = (good + 1, 0) if is_better else (0, bad + 1)
        if good == success:
            length, good = min(2 * length, longest), 0
        if bad == failure:
            length, bad = max(length / 2, shortest), 0
        points = np.vstack([points, new[chosen]])
        values = np.append(values, found)


def by_gradient(stand: Stand, seed: int, count: int) -> Numbers:
    """Searches by `auto` with half of the evaluations, then by L-BFGS-B of
    SciPy from its plant. Slopes are differences of plants that share their
    random numbers, with a step of a twentieth of each gene's range."""
    from scipy.optimize import minimize

    step = 0.05
    function = Function(stand)
    genes = len(function.start)
    points, _ = search_by_package(stand, seed, [count // 2])
    found = np.array(points[0][2])
    function([function.start])

    def slopes(point: Numbers) -> tuple[float, Numbers]:
        steps = np.where(point + step <= 1, step, -step)
        moved = np.vstack([point, point + np.diag(steps)])
        values = np.array(function(moved, repeats=True))
        return values[0], (values[1:] - values[0]) / steps

    result = minimize(
        slopes,
        function.shares(found),
        jac=True,
        method="L-BFGS-B",
        bounds=[(0, 1)] * genes,
        options={"maxfun": max(1, (count - count // 2) // (genes + 1))},
    )
    return function.plants(result.x)[0]


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


LIBRARIES = {
    "bipop": by_bipop,
    "pymoo": by_pymoo,
    "lq_cma": by_lq,
    "turbo": by_turbo,
    "gradient": by_gradient,
}
