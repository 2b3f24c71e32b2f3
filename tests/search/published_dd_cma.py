# SPDX-License-Identifier: Apache-2.0
"""Writes tests/data/dd_cma.txt: the result of the dd-CMA-ES of the package
pypop7 0.0.82 for the points of test_dd_cma.cpp. Each case has a line with
dimension, population, generations and mean, then for each generation a line
with its points, best first, and at the end lines with the mean, the standard
deviations and the correlations."""

import sys

import numpy as np
from pypop7.optimizers.es.ddcma import DDCMA

CASES = [(2, 6, 40), (6, 9, 40), (10, 24, 30)]


def rosenbrock(x):
    return np.sum(100 * (x[1:] - x[:-1] ** 2) ** 2 + (1 - x[:-1]) ** 2)


def line(numbers):
    return " ".join(f"{x:.17g}" for x in np.ravel(numbers))


for dimension, population, generations in CASES:
    rng = np.random.default_rng(dimension)
    problem = {
        "fitness_function": rosenbrock,
        "ndim_problem": dimension,
        "lower_boundary": np.full(dimension, -5),
        "upper_boundary": np.full(dimension, 5),
    }
    options = {
        "mean": np.full(dimension, 0.5),
        "sigma": 0.2,
        "n_individuals": population,
        "seed_rng": 1,
    }
    search = DDCMA(problem, options)
    (mean, d, root, inverse, z, cz, x, y, *state) = search.initialize()
    # In the package, this accumulated change of correlations begins at one.
    state[3][:] = 0
    print(dimension, population, generations, line(mean))
    for _ in range(generations):
        search._n_generations += 1
        for k in range(population):
            x[k] = mean + search.sigma * d * (
                root @ rng.standard_normal(dimension)
            )
            x[k] = np.round(x[k], 6)
            cz[k] = (x[k] - mean) / (search.sigma * d)
            z[k] = inverse @ cz[k]
            y[k] = rosenbrock(x[k])
        print(" ".join(f"{value:.6f}" for value in x[np.argsort(y)].ravel()))
        mean, d, root, inverse, cz, *state = search._update_distribution(
            mean, d, root, inverse, z, cz, x, y, *state
        )
    print(line(mean))
    print(line(search.sigma * d))
    print(line(root @ root))
    print(f"{dimension} is done", file=sys.stderr)
