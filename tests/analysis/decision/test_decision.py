# SPDX-License-Identifier: Apache-2.0
"""Candidates, switching points and regret from stored and re-evaluated
parts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from ideotype.decision import Options, Rule, Worth
from ideotype.decision.decision import (
    Decision,
    choose_candidates,
    find_switches,
    mean_over_environments,
)

PRICES = {"grain": 200.0, "seed": 0.0, "water": 0.2, "other": 900.0}


def made_options(parts: np.ndarray) -> Options:
    """Returns options with equal environments [plants, environments, parts];
    the first plant is the baseline."""
    plants, count, _ = parts.shape
    return Options(
        "made",
        tuple(f"year {e}" for e in range(count)),
        np.full(count, 1 / count),
        Worth.of_prices(PRICES),
        Rule(),
        tuple(np.array([float(i)]) for i in range(plants)),
        (None,) * plants,  # type: ignore[arg-type]
        parts,
        np.arange(plants) == 0,
    )


def made_decision(parts: np.ndarray, noise: float = 0.0) -> Decision:
    """Returns a decision between plants with common and own noise of
    grain."""
    draw = np.random.default_rng(1)
    draws = np.repeat(parts[:, :, None], 16, axis=2)
    draws[..., 0] += draw.normal(0, 1, 16)  # common: it cancels
    draws[..., 0] += noise * draw.normal(0, 1, draws[..., 0].shape)
    options = made_options(parts)
    return Decision(
        "made",
        ("baseline", *(f"plant {i}" for i in range(1, len(parts)))),
        0,
        ("",) * len(parts),
        options.genomes,
        ({},) * len(parts),
        options.environments,
        options.weights,
        options.worth,
        Rule(),
        draws,
    )


# Grain [t ha-1], seeds, irrigation [mm], electricity in two years.
BASE = [[10, 8, 100, 0], [8, 8, 200, 0]]
THIRSTY = [[14, 8, 300, 0], [12, 8, 400, 0]]
FRUGAL = [[12, 8, 50, 0], [11, 8, 100, 0]]


def test_the_switch_is_where_margins_are_equal() -> None:
    decision = made_decision(np.array([BASE, THIRSTY, FRUGAL], float), 0.01)
    (switch,) = find_switches(decision, "water")
    # 1.5 t more grain for 275 mm more water: 300 / 2750 per m3.
    assert switch.at == pytest.approx(300 / 2750, rel=0.02)
    assert (switch.below, switch.above) == (1, 2)
    error = switch.at_standard_error
    assert 0 < error < 0.01
    assert abs(switch.at - 300 / 2750) < 4 * error
    # The other half of the randomisations confirms the switch.
    assert switch.difference.mean == pytest.approx(30, abs=1)
    assert len(switch.difference.draws) == 8
    assert decision.best == 2


def test_regret_is_paired() -> None:
    decision = made_decision(np.array([BASE, THIRSTY, FRUGAL], float), 0.01)
    regret = decision.regret(1, 0)
    # Margins of year 0: thirsty 2800 - 600, frugal 2400 - 100.
    assert regret.mean == pytest.approx(100, abs=4 * regret.standard_error)
    # The common noise of 200 per ha cancels.
    assert regret.standard_error < 5
    assert decision.regret(2, 0).mean == 0
    mean, largest = decision.regret_over_environments(1)
    assert largest >= mean.mean > 0
    assert decision.wins(2, 0) == 1


def test_candidates_are_best_somewhere() -> None:
    worse = [[9, 8, 300, 0], [7, 8, 400, 0]]
    options = made_options(np.array([BASE, worse, THIRSTY, FRUGAL], float))
    chosen = choose_candidates(options)
    # The thirsty plant is best with expensive grain or cheap water.
    assert set(chosen) == {0, 2, 3}
    assert options.values().argmax() == 3
    cheap = options.values({**PRICES, "water": 0.0})
    assert cheap.argmax() == 2


def test_plants_within_the_noise_are_listed_as_equal() -> None:
    close = [[12, 8, 50, 0], [11.01, 8, 100, 0]]
    parts = np.array([BASE, FRUGAL, close], float)
    precise = made_decision(parts, 1e-4)
    assert precise.best == 2
    assert precise.equals() == []
    noisy = made_decision(parts, 0.1)
    assert noisy.equals() == [3 - noisy.best]


def test_true_ties_are_rarely_declared_different() -> None:
    # Five equal plants: with Holm's correction some test is wrong in few of
    # the repetitions, although the best is chosen after the fact.
    parts = np.repeat([FRUGAL], 3, 0).astype(float)
    rng = np.random.default_rng(3)
    wrong = 0
    for _ in range(200):
        made = made_decision(parts)
        draws = made.draws.copy()
        draws[..., 0] += rng.normal(0, 0.1, draws[..., 0].shape)
        wrong += len(replace(made, draws=draws).equals()) < 2
    assert wrong < 40


def test_the_error_over_environments_is_that_of_a_sample() -> None:
    values = np.random.default_rng(2).normal(5, 2, 30)
    mean, error = mean_over_environments(values, np.full(30, 1 / 30))
    assert mean == pytest.approx(values.mean())
    assert error == pytest.approx(values.std(ddof=1) / 30**0.5)
    assert np.isnan(mean_over_environments(values[:1], np.ones(1))[1])
