# SPDX-License-Identifier: Apache-2.0
"""Margins and objectives, and their values over environments."""

from __future__ import annotations

import numpy as np
import pytest

from ideotype.decision import Rule, Worth

PRICES = {"grain": 200, "seed": 0.003, "water": 0.4, "other": 700}


def test_a_margin_is_revenue_less_costs() -> None:
    worth = Worth.of_prices(PRICES | {"electricity": 0.05})
    assert worth.parts == (
        "grain_yield_moist", "seeds", "irrigation", "electricity"
    )  # fmt: skip
    # 12 t ha-1, 8 plants m-2, 150 mm = 1500 m3 ha-1, 3 kWh m-2
    parts = np.array([12.0, 8, 150, 3])
    margin = 12 * 200 - 80000 * 0.003 - 1500 * 0.4 + 30000 * 0.05 - 700
    assert worth.of(parts) == pytest.approx(margin)
    cheap = worth.of(parts, worth.at("water", 0.1))
    assert cheap == pytest.approx(margin + 1500 * 0.3)


def test_an_objective_has_no_prices() -> None:
    worth = Worth.of_objective("net_assimilation", "mol m-2 day-1")
    parts = np.array([[[1.5], [2.0]]])
    assert worth.of(parts) == pytest.approx(np.array([[1.5, 2.0]]))
    assert worth.swept_prices(parts) == []


@pytest.mark.parametrize(
    ("rule", "expected"),
    [
        (Rule(), 0.2 * 5 + 0.3 * 1 + 0.5 * 3),
        (Rule("worst"), 1),
        # The worst 40 % by weight: all of 1, and a tenth of the weight of 3.
        (Rule("cvar", 0.4), (0.3 * 1 + 0.1 * 3) / 0.4),
        (Rule("quantile", 0.4), 3),
        (Rule("quantile", 0.3), 1),
        (Rule("probability", threshold=3), 0.7),
    ],
)
def test_rules_over_environments(rule: Rule, expected: float) -> None:
    margins, weights = np.array([5.0, 1, 3]), np.array([0.2, 0.3, 0.5])
    assert rule.value(margins, weights) == pytest.approx(expected)
    # Of several plants at once.
    two = np.array([margins, margins[::-1] + 100])
    assert rule.value(two, weights)[0] == pytest.approx(expected)


def test_the_rule_is_that_of_the_objective_that_is_compared() -> None:
    objective = {
        "maximise": ["margin"],
        "scenarios": "cvar",
        "scenario_tail": 0.1,
    }
    worth = Worth.of_prices(PRICES)
    assert Rule.read({"objective": objective}, worth) == Rule("cvar", 0.1)
    grain = {"objective": objective | {"maximise": "grain_yield"}}
    assert Rule.read(grain, worth) == Rule()
    other = Worth.of_objective("grain_yield", "t ha-1")
    assert Rule.read(grain, other) == Rule("cvar", 0.1)
