# SPDX-License-Identifier: Apache-2.0
"""Indices computed from the program's designs agree with the known indices of
test functions."""

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from SALib.analyze import morris as salib_morris

from ideotype.history.indices import _analyse, _Design

LEVELS = 6


def ishigami(x):
    a, b, c = (np.pi * (2 * x[:, i] - 1) for i in range(3))
    return np.sin(a) + 7 * np.sin(b) ** 2 + 0.1 * c**4 * np.sin(a)


ISHIGAMI_FIRST = (0.31390519114781146, 0.4424111447900409, 0.0)
ISHIGAMI_TOTAL = (0.5575888552099591, 0.4424111447900409, 0.24368366406214768)

G = np.array([0, 1, 4.5, 9, 99, 99, 99, 99])


def sobol_g(x):
    return np.prod((np.abs(4 * x - 2) + G) / (1 + G), axis=1)


PARTS = 1 / (3 * (1 + G) ** 2)
G_VARIANCE = np.prod(1 + PARTS) - 1
G_FIRST = PARTS / G_VARIANCE
G_TOTAL = PARTS * np.prod(1 + PARTS) / (1 + PARTS) / G_VARIANCE

CASES = [
    pytest.param(ishigami, 3, ISHIGAMI_FIRST, ISHIGAMI_TOTAL, id="ishigami"),
    pytest.param(sobol_g, 8, G_FIRST, G_TOTAL, id="sobol_g"),
]


def design(method, genes, together, samples):
    """Returns the rows of the program's design, in the order of histories."""
    build = Path(os.environ["IDEOTYPE_EXECUTABLE"]).parents[1]
    words = (method, genes, together, samples, LEVELS)
    run = subprocess.run(
        [build / "tests" / "search" / "replay_sensitivity", *map(str, words)],
        capture_output=True,
        text=True,
        check=True,
    )
    x = np.array([line.split() for line in run.stdout.splitlines()], float)
    groups = [f"g{i // together}" for i in range(genes)]
    factors = tuple(dict.fromkeys(groups))
    problem = {
        "num_vars": genes,
        "names": [f"x{i}" for i in range(genes)],
        "groups": groups,
        "bounds": [[0, 1]] * genes,
    }
    points = x.reshape(samples, -1, genes)
    return _Design(method == "sobol", LEVELS, factors, problem, points)


def analyse(made, function, spread=0.0, error=0.0):
    """Evaluates the function at the rows, with normal noise and stated
    standard errors, and returns the indices."""
    x = made.points.reshape(-1, made.points.shape[2])
    y = function(x) + spread * np.random.default_rng(5).normal(size=len(x))
    y = y.reshape(made.points.shape[:2])
    return _analyse("y", "1", made, y, np.full_like(y, error**2))


@pytest.mark.parametrize("function, genes, first, total", CASES)
def test_sobol_indices_agree_with_exact_values(function, genes, first, total):
    indices = analyse(design("sobol", genes, 1, 4096), function)
    for name, exact in (("first", first), ("total", total)):
        error = indices.standard_error[name]
        assert np.all(np.abs(indices.index[name] - exact) < 3 * error + 1e-6)
        assert np.max(error) < 0.03


def test_known_noise_is_subtracted_from_indices():
    made, spread = design("sobol", 3, 1, 16384), 2.6
    indices = analyse(made, ishigami, spread, spread)
    untold = analyse(made, ishigami, spread)
    assert indices.noise == pytest.approx(spread)
    variance = 13.844587940719254
    assert indices.standard_deviation == pytest.approx(variance**0.5, abs=0.1)
    for name, exact in (("first", ISHIGAMI_FIRST), ("total", ISHIGAMI_TOTAL)):
        error = indices.standard_error[name]
        assert np.all(np.abs(indices.index[name] - exact) < 3 * error)
        assert np.max(error) < 0.03
    noisy = variance + spread**2
    biased = (np.array(ISHIGAMI_TOTAL) * variance + spread**2) / noisy
    error = untold.standard_error["total"]
    assert np.all(np.abs(untold.index["total"] - biased) < 3 * error)
    assert np.all(untold.index["total"] > ISHIGAMI_TOTAL + 5 * error)


def test_the_index_of_a_group_is_that_of_its_genes_together():
    indices = analyse(design("sobol", 8, 4, 4096), sobol_g)
    first = np.prod(1 + PARTS[:4]) - 1
    error = indices.standard_error["first"][0]
    assert abs(indices.index["first"][0] - first / G_VARIANCE) < 3 * error
    assert error < 0.03


def test_elementary_effects_agree_with_exact_values():
    made, spread = design("morris", 3, 1, 8192), 1.0
    exact = analyse(made, ishigami)
    indices = analyse(made, ishigami, spread, spread)
    untold = analyse(made, ishigami, spread)
    x = made.points.reshape(-1, 3)
    published = salib_morris.analyze(
        {**made.problem, "groups": None}, x, ishigami(x), num_levels=LEVELS
    )
    for name in ("mu", "mu_star", "sigma"):
        np.testing.assert_allclose(
            exact.index[name],
            np.asarray(published[name], float),
            rtol=1e-10,
            atol=1e-10,
        )
    np.testing.assert_allclose(
        indices.index["sigma"], exact.index["sigma"], atol=0.1
    )
    step = LEVELS / (2 * (LEVELS - 1))
    of_noise = np.hypot(exact.index["sigma"], 2**0.5 * spread / step)
    np.testing.assert_allclose(untold.index["sigma"], of_noise, atol=0.1)
    alone = analyse(made, lambda x: np.zeros(len(x)), spread, spread)
    np.testing.assert_allclose(
        alone.index["mu_star"], alone.index["mu_star_of_noise"], rtol=0.03
    )


def test_samples_with_failed_rows_are_left_out():
    made = design("sobol", 3, 1, 64)
    y = ishigami(made.points.reshape(-1, 3)).reshape(64, -1)
    expected = _analyse("y", "1", made, y[:32], np.zeros_like(y[:32]))
    for i in range(32, 64):
        y[i, i % 5] = np.nan
    indices = _analyse("y", "1", made, y, np.zeros_like(y))
    assert indices.samples == 32
    for name in ("first", "total"):
        np.testing.assert_array_equal(
            indices.index[name], expected.index[name]
        )
    none = _analyse("y", "1", made, np.nan * y, np.zeros_like(y))
    assert none.samples == 0
    assert np.isnan(none.index["first"]).all()


def test_indices_of_constants_are_unknown():
    made = design("sobol", 3, 1, 64)
    found = analyse(made, lambda x: np.full(len(x), 0.1))
    assert np.isnan(found.index["first"]).all()
    assert found.standard_deviation == pytest.approx(0, abs=1e-12)
