# SPDX-License-Identifier: Apache-2.0
"""The density, the sampler and the emulator are compared with linear models,
which have a known posterior."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import ideotype
from ideotype.calibration import (
    Calibration,
    Emulator,
    Evaluations,
    Model,
    Observations,
    Parameter,
    Posterior,
    combinations,
    find_mode,
    next_measurements,
    pairs,
    sample,
)
from ideotype.validation.comparison import Conditions
from ideotype.validation.table import Measurement

QUICK = Path(__file__).parents[3] / "campaigns/ames_quick.toml"
STANDARD = [Parameter(f"a.{x}", -math.inf, math.inf, 0, 1) for x in "xy"]


def observe(
    values: list[float], errors: list[float], high: list[float] | None = None
) -> Observations:
    """Returns measurements of a linear model; NaN: none."""
    rows = [
        Measurement("lai", "1", value, top, error)
        for value, top, error in zip(values, high or values, errors)
    ]
    measured = np.array([row.is_measured for row in rows])
    conditions = Conditions(QUICK, 2, False)
    return Observations(rows, conditions, [], measured)


def density(
    observations: Observations, slopes: NDArray[np.float64], **options: bool
) -> Posterior:
    return Posterior(
        STANDARD, observations, lambda x: x @ slopes.T,
        np.zeros(len(observations.rows)),
        **{"has_discrepancy": False, **options},
    )  # fmt: skip


def calibrated(posterior: Posterior) -> Calibration:
    samples = sample(posterior, posterior.size, 1, most=4000)
    model = Model(posterior.observations, STANDARD, Evaluations(None))
    return Calibration(
        posterior.observations, STANDARD, model, posterior, np.zeros(2),
        samples, np.zeros(len(posterior.observations.rows)), None,
    )  # fmt: skip


def test_without_data_the_prior_is_returned() -> None:
    observations = observe([math.nan], [1.0])
    posterior = density(observations, np.ones((1, 2)))
    found = sample(posterior, 2, 1, most=4000)
    size = found.effective_size
    assert found.has_converged and size > 500
    assert np.abs(found.z.mean(axis=0)).max() < 4 / math.sqrt(size)
    assert np.abs(found.z.var(axis=0) - 1).max() < 4 * math.sqrt(2 / size)


def test_a_linear_model_has_its_known_posterior() -> None:
    slopes = np.array([[1.0, 0.5], [0.0, 2.0]])
    values, errors = np.array([1.0, -1.0]), np.array([0.5, 1.0])
    posterior = density(observe(list(values), list(errors)), slopes)
    weights = slopes.T / errors**2
    covariance = np.linalg.inv(weights @ slopes + np.eye(2))
    mean = covariance @ weights @ values
    assert find_mode(posterior, 2, 1) == pytest.approx(mean, abs=1e-3)
    found = sample(posterior, 2, 1, most=4000)
    size = found.effective_size
    deviation = np.sqrt(np.diag(covariance))
    assert np.all(
        np.abs(found.z.mean(axis=0) - mean) < 4 * deviation / math.sqrt(size)
    )
    assert found.z.std(axis=0) == pytest.approx(
        deviation, rel=4 / math.sqrt(2 * size)
    )


def test_a_density_that_is_nowhere_is_an_error() -> None:
    def nowhere(z: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.full(len(z), -math.inf)

    for find in (find_mode, sample):
        with pytest.raises(ideotype.Error, match="no point of the prior"):
            find(nowhere, 2, 1)


def test_samples_have_the_same_bits_for_the_same_seed() -> None:
    posterior = density(observe([1.0], [0.5]), np.ones((1, 2)))
    first, second, other = (
        sample(posterior, 2, seed, block=50, most=50).z for seed in (1, 1, 2)
    )
    assert np.array_equal(first, second) and not np.array_equal(first, other)


def test_a_range_has_the_probability_of_its_values() -> None:
    posterior = density(
        observe([0.5], [0.0], [math.inf]), np.array([[1, 0.0]])
    )
    z = np.array([[0.0, 0.0], [1.0, 0.0]])
    # An error of 0 leaves a step at the end of the range.
    assert posterior.log_likelihood(z)[1] == pytest.approx(0)
    posterior = density(observe([0.5], [1.0], [1.5]), np.array([[1, 0.0]]))
    # Phi(1.5) - Phi(0.5), and Phi(0.5) - Phi(-0.5).
    assert np.exp(posterior.log_likelihood(z)) == pytest.approx(
        [0.2417303, 0.3829249], rel=1e-5
    )


def test_the_discrepancy_of_a_wrong_model_is_estimated() -> None:
    scatter = [3.0, -3.0] * 10
    slopes = np.ones((20, 2))
    posterior = density(
        observe([10 + x for x in scatter], [0.1] * 20), slopes,
        has_discrepancy=True,
    )  # fmt: skip
    found = sample(posterior, posterior.size, 1, most=3000)
    assert posterior.size == 3
    assert 2 < np.median(posterior.discrepancies(found.z)) < 8


def test_parameters_that_only_act_together_are_named() -> None:
    result = calibrated(density(observe([1.0], [0.05]), np.ones((1, 2))))
    (pair,) = pairs(result).itertuples()
    assert (pair.first, pair.second) == ("a.x", "a.y")
    assert pair.correlation < -0.9
    assert pair.deviation_if_known < 0.2 < 0.5 < pair.deviation
    first = combinations(result).iloc[0]
    assert first.variance < 0.02
    assert first["a.x"] == pytest.approx(0.5, abs=0.05)


def test_parameters_that_data_separate_are_not_named() -> None:
    result = calibrated(density(observe([1.0, 1.0], [0.1, 0.1]), np.eye(2)))
    assert not len(pairs(result))


def test_the_measurement_of_what_decides_comes_first() -> None:
    observations = observe([math.nan] * 3, [0.1, 0.1, 10.0])
    slopes = np.array([[0.0, 1.0], [1.0, 0.0], [1.0, 0.0]])
    result = calibrated(density(observations, slopes))
    values = result.draws(200)
    table = next_measurements(result, values, 3 * values[:, 0])
    assert list(table.error) == [0.1, 10.0, 0.1]
    # 1 / (1 + e^2) of the variance, as the prior is standard normal.
    assert table.shrinkage[0] == pytest.approx(0.99, abs=0.02)
    assert table.shrinkage[1] == pytest.approx(0.01, abs=0.01)
    assert table.shrinkage[2] < 0.05


def test_an_emulator_reproduces_a_quadratic() -> None:
    random = np.random.default_rng(1)
    x = random.uniform(-1, 1, (40, 3))
    new = random.uniform(-1, 1, (50, 3))

    def truth(x: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.stack([1 + x[:, 0] * x[:, 1], x[:, 2] ** 2], axis=1)

    emulator = Emulator.make(x, truth(x))
    assert np.abs(emulator(new) - truth(new)).max() < 1e-6
    assert emulator.error.max() < 1e-6


def test_the_error_of_an_emulator_is_that_at_new_points() -> None:
    random = np.random.default_rng(1)
    x = random.uniform(-1, 1, (60, 2))
    new = random.uniform(-1, 1, (400, 2))

    def truth(x: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.sin(4 * x[:, :1]) * np.exp(x[:, 1:])

    emulator = Emulator.make(x, truth(x))
    error = np.sqrt(((emulator(new) - truth(new)) ** 2).mean())
    assert 0.4 < error / emulator.error[0] < 2.5
    # The process explains what the polynomial does not.
    assert error < 0.2 * truth(new).std()
