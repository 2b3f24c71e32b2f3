# SPDX-License-Identifier: Apache-2.0
"""Sensitivity indices against SALib, which is told the same rows."""

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from SALib.analyze import morris as salib_morris
from SALib.analyze import sobol as salib_sobol

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


def replay(*words, values=()):
    build = Path(os.environ["IDEOTYPE_EXECUTABLE"]).parents[1]
    run = subprocess.run(
        [build / "tests" / "search" / "replay_sensitivity", *map(str, words)],
        input=" ".join(repr(float(v)) for v in values),
        capture_output=True,
        text=True,
        check=True,
    )
    return np.array([line.split() for line in run.stdout.splitlines()], float)


def problem(genes, together=1):
    found = {
        "num_vars": genes,
        "names": [f"x{i}" for i in range(genes)],
        "bounds": [[0, 1]] * genes,
    }
    if together > 1:
        found["groups"] = [f"g{i // together}" for i in range(genes)]
    return found


@pytest.mark.parametrize("function, genes, first, total", CASES)
def test_sobol_indices(function, genes, first, total):
    words = ("sobol", genes, 1, 4096, 4)
    y = function(replay(*words))
    ours = replay(*words, values=y)
    published = salib_sobol.analyze(
        problem(genes), y, calc_second_order=False, seed=1
    )
    for row, name, exact in ((0, "S1", first), (1, "ST", total)):
        index, error = ours[row, ::2], ours[row, 1::2]
        np.testing.assert_allclose(index, published[name], atol=1e-10, rtol=0)
        # Both by bootstrap, with other draws.
        width = published[f"{name}_conf"] / 1.96
        np.testing.assert_allclose(error, width, rtol=0.5, atol=1e-6)
        assert np.all(np.abs(index - exact) < 3 * error + 1e-6)
        assert np.max(error) < 0.03


@pytest.mark.parametrize("together", [2, 4])
def test_sobol_indices_of_groups(together):
    words = ("sobol", 8, together, 1024, 4)
    y = sobol_g(replay(*words))
    ours = replay(*words, values=y)
    published = salib_sobol.analyze(
        problem(8, together), y, calc_second_order=False, seed=1
    )
    for row, name in ((0, "S1"), (1, "ST")):
        np.testing.assert_allclose(
            ours[row, ::2], published[name], atol=1e-10, rtol=0
        )


@pytest.mark.parametrize("function, genes, first, total", CASES)
def test_elementary_effects(function, genes, first, total):
    words = ("morris", genes, 1, 200, LEVELS)
    x = replay(*words)
    y = function(x)
    ours = replay(*words, values=y)
    published = salib_morris.analyze(
        problem(genes), x, y, num_levels=LEVELS, seed=1
    )
    for row, name in enumerate(("mu", "mu_star", "sigma")):
        np.testing.assert_allclose(
            ours[row, ::2],
            np.asarray(published[name], float),
            rtol=1e-10,
            atol=1e-10,
        )
    width = np.asarray(published["mu_star_conf"], float) / 1.96
    np.testing.assert_allclose(ours[1, 1::2], width, rtol=0.3, atol=1e-6)


def test_elementary_effects_of_groups():
    words = ("morris", 8, 4, 200, LEVELS)
    x = replay(*words)
    y = sobol_g(x)
    ours = replay(*words, values=y)
    published = salib_morris.analyze(
        problem(8, 4), x, y, num_levels=LEVELS, seed=1
    )
    np.testing.assert_allclose(
        ours[1, ::2], np.asarray(published["mu_star"], float), rtol=1e-10
    )
    assert np.all(np.isnan(ours[0]))
