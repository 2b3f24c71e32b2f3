# SPDX-License-Identifier: Apache-2.0
"""Statistics of circles, errors and units are right."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from ideotype.figures.shape import circular_mean_and_deviation
from ideotype.history import Estimate
from ideotype.history.estimate import difference, relative_gain, with_interval


def test_angles_are_averaged_on_the_circle() -> None:
    angles = np.array([[359.0, 350.0, 77.0], [1.0, 20.0, 77.0]])
    mean, deviation = circular_mean_and_deviation(angles)
    assert (mean + 180) % 360 == pytest.approx([180.0, 185.0, 257.0])
    assert deviation[0] == pytest.approx(1.0, rel=1e-3)
    assert deviation[2] < 1e-5
    opposite = np.array([[90.0], [270.0]])
    assert circular_mean_and_deviation(opposite)[1] == 180.0


def test_a_circular_mean_is_below_360() -> None:
    angles = np.full((3, 4), 360.0 - 1e-14)
    means, _ = circular_mean_and_deviation(angles)
    assert np.all((means >= 0) & (means < 360))


@pytest.mark.parametrize(
    ("mean", "error", "text"),
    [
        (11.23456, 0.0123, "11.235 ± 0.024"),
        (11.23456, 0.5, "11.23 ± 0.98"),
        (1234.5, 20.0, "1234 ± 39"),
        (1.5, math.nan, "1.5"),
        (12.2, 0.0, "12.2"),
    ],
)
def test_the_error_determines_the_number_of_digits(
    mean: float, error: float, text: str
) -> None:
    assert Estimate(mean, error).interval_text() == text


@pytest.mark.parametrize(
    ("below", "above", "text"),
    [
        (0.0039, 0.0039, "1.2800 ± 0.0039"),
        (3e-8, 3e-8, "1.280000000 ± 0.000000030"),
        (0.0, 0.003, "1.2800 \N{MINUS SIGN}0.0000 +0.0030"),
        (0.0, 0.0, "1.28"),
        (25.0, 25.0, "1 ± 25"),
    ],
)
def test_no_error_is_rounded_to_zero(
    below: float, above: float, text: str
) -> None:
    assert with_interval(1.28, below, above) == text


def test_gains_of_independent_estimates_have_independent_errors() -> None:
    best, baseline = Estimate(11.5, 0.02, "x"), Estimate(11.0, 0.03, "x")
    draw = np.random.default_rng(1)
    sample = 100 * (
        draw.normal(11.5, 0.02, 400_000) / draw.normal(11.0, 0.03, 400_000) - 1
    )
    gain = relative_gain(best, baseline)
    assert gain.mean == pytest.approx(100 / 22)
    assert gain.standard_error == pytest.approx(sample.std(), rel=0.01)
    assert math.isnan(relative_gain(best, Estimate(0.0, 0.1, "x")).mean)


def test_estimates_with_common_noise_have_paired_errors() -> None:
    """Two plants with strong common noise are evaluated many times. The
    standard deviation of their difference, and of their gain, equals the
    standard error that a single evaluation states."""
    draw, runs, count = np.random.default_rng(2), 4000, 16
    common = draw.normal(0.0, 0.4, (runs, 1, count))
    draws = common + draw.normal(0.0, 0.1, (runs, 2, count))
    draws += np.array([11.5, 11.0])[:, None]
    intervals = {difference: [], relative_gain: []}
    for both in draws:
        error = both.std(1, ddof=1) / np.sqrt(count)
        plants = [
            Estimate(float(d.mean()), float(e), "x", d)
            for d, e in zip(both, error)
        ]
        for function, figures in intervals.items():
            alone = [replace(plant, draws=np.empty(0)) for plant in plants]
            figures.append((function(*plants), function(*alone)))
    for figures in intervals.values():
        scatter = np.std([paired.mean for paired, _ in figures])
        squares = np.array(
            [[each.standard_error**2 for each in both] for both in figures]
        )
        paired, unpaired = np.sqrt(squares.mean(0))
        # A standard deviation estimated from 4000 values is accurate to 1.1 %.
        assert paired == pytest.approx(scatter, rel=0.05)
        assert unpaired > 3 * paired
