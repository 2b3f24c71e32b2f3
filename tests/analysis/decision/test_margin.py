# SPDX-License-Identifier: Apache-2.0
"""Margins at any price, and their values over environments."""

from __future__ import annotations

import numpy as np
import pytest

from ideotype.decision import Rule, weights_of_prices
from ideotype.decision.margin import PARTS

PRICES = {"grain": 200, "seed": 0.003, "water": 0.4, "other": 700}


def test_a_margin_is_revenue_less_costs() -> None:
    factors, fixed = weights_of_prices(PRICES | {"electricity": 0.05})
    # 12 t ha-1, 8 plants m-2, 150 mm = 1500 m3 ha-1, 3 kWh m-2
    margin = np.array([12, 8, 150, 3]) @ factors + fixed
    assert list(PARTS) == ["grain", "seed", "water", "electricity"]
    assert margin == pytest.approx(
        12 * 200 - 80000 * 0.003 - 1500 * 0.4 + 30000 * 0.05 - 700
    )


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


def test_the_rule_is_that_of_a_margin_as_objective() -> None:
    objective = {
        "maximise": ["margin"],
        "scenarios": "cvar",
        "scenario_tail": 0.1,
    }
    assert Rule.read({"objective": objective}) == Rule("cvar", 0.1)
    grain = {"objective": objective | {"maximise": "grain_yield"}}
    assert Rule.read(grain) == Rule()
