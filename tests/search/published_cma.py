# SPDX-License-Identifier: Apache-2.0
"""Counts the evaluations that the package cma needs: the bounds of
test_cma_es.cpp."""

import warnings

import cma
import numpy as np

warnings.simplefilter("ignore")


def sphere(x):
    return np.sum(x**2)


def ellipsoid(x):
    return np.sum(1e6 ** (np.arange(len(x)) / (len(x) - 1)) * x**2)


def rosenbrock(x):
    return np.sum(100 * (x[:-1] ** 2 - x[1:]) ** 2 + (x[:-1] - 1) ** 2)


def evaluations(function, dimension, seed):
    options = {"verbose": -9, "seed": seed, "ftarget": 1e-8}
    search = cma.CMAEvolutionStrategy(dimension * [3.0], 2.0, options)
    search.optimize(lambda x: function(np.asarray(x)))
    return search.result.evaluations


for function, dimension in [
    (sphere, 10),
    (ellipsoid, 10),
    (rosenbrock, 10),
    (sphere, 40),
]:
    counts = [evaluations(function, dimension, seed) for seed in range(1, 8)]
    print(function.__name__, dimension, int(np.median(counts)))
