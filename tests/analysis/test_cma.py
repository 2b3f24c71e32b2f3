# SPDX-License-Identifier: Apache-2.0
"""CMA-ES against a published implementation that is told the same points."""

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from cmaes import CMA

GENERATIONS = 50


def ellipsoid(x, rng, noise):
    weights = 10.0 ** (3 * np.arange(len(x)) / (len(x) - 1))
    return float(weights @ x**2 + noise * rng.standard_normal())


def rosenbrock(x, rng, noise):
    return float(
        np.sum(100 * (x[1:] - x[:-1] ** 2) ** 2 + (1 - x[:-1]) ** 2)
        + noise * rng.standard_normal()
    )


@pytest.fixture(scope="module")
def replay():
    build = Path(os.environ["IDEOTYPE_EXECUTABLE"]).parents[1]
    return build / "tests" / "search" / "replay_cma"


@pytest.mark.parametrize("adapts", [False, True])
@pytest.mark.parametrize("function", [ellipsoid, rosenbrock])
@pytest.mark.parametrize(
    "dimension, population", [(2, 6), (10, 10), (40, 15), (40, 60)]
)
def test_same_points_give_the_same_distribution(
    replay, dimension, population, function, adapts
):
    rng = np.random.default_rng(dimension + population)
    published = CMA(
        mean=np.full(dimension, 0.5),
        sigma=0.2,
        seed=1,
        population_size=population,
        lr_adapt=adapts,
    )
    words = [dimension, population, GENERATIONS, 0.2, int(adapts)]
    words += [0.5] * dimension
    expected = []
    for _ in range(GENERATIONS):
        points = [published.ask() for _ in range(population)]
        told = [(x, function(x, rng, 0.01)) for x in points]
        ranked = sorted(told, key=lambda pair: pair[1])
        words += [repr(float(v)) for x, _ in ranked for v in x]
        published.tell(told)
        published._eigen_decomposition()
        expected.append(
            np.concatenate(
                [
                    published.mean.copy(),
                    [published._sigma],
                    published._C.ravel(),
                ]
            )
        )
    run = subprocess.run(
        [replay],
        input=" ".join(map(str, words)),
        capture_output=True,
        text=True,
        check=True,
    )
    ours = np.array([line.split() for line in run.stdout.splitlines()], float)
    assert ours.shape == (GENERATIONS, dimension + 1 + dimension**2)
    expected = np.array(expected)
    scale = np.maximum(1, np.abs(expected))
    assert np.max(np.abs(ours - expected) / scale) < 1e-10
