# SPDX-License-Identifier: Apache-2.0
"""The water balance of soil agrees with independent cases, and it closes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ideotype

GIVEN = json.loads(
    (Path(__file__).parents[2] / "data/physiology/soil_given.json").read_text()
)


@pytest.mark.parametrize("case", GIVEN, ids=lambda x: x["name"])
def test_a_water_balance_agrees_with_the_reference(
    case: dict[str, Any],
) -> None:
    found = ideotype.soil_water_balance(case)
    assert found.keys() == case["expected"].keys()
    for name, expected in case["expected"].items():
        assert found[name] == pytest.approx(expected, rel=0, abs=1e-9), name


def make_season(random: np.random.Generator) -> dict[str, Any]:
    """Returns a random season, with soils at the edge of what is possible."""
    days = int(random.integers(1, 60))
    tew = random.choice([0.0, 9.0, random.uniform(0, 60)])
    theta_wp = random.uniform(0, 0.3)
    rain = random.exponential(30, days) * (random.random(days) < 0.2)
    return {
        "soil": {
            "theta_fc": theta_wp + random.uniform(1e-6, 0.3),
            "theta_wp": theta_wp,
            "tew": tew,
            "rew": tew * random.choice([0.0, 0.4, 1.0]),
            "p": random.choice([0.0, 0.55, 1.0]),
            "initial_depletion": random.choice([0.0, 50.0]),
            "initial_evaporable_depletion": random.choice([0.0, tew]),
        },
        "potential_transpiration": random.uniform(0, 12, days),
        "potential_evaporation": random.uniform(0, 12, days),
        "rain": rain,
        "irrigation": 20 * (random.random(days) < 0.1),
        "root_depth": np.sort(random.uniform(0, 1.5, days)),
    }


def test_balances_of_random_seasons_close() -> None:
    random = np.random.default_rng(7)
    for _ in range(10_000):
        season = make_season(random)
        found = ideotype.soil_water_balance(season)
        for name, values in found.items():
            assert np.isfinite(values).all() and (values >= 0).all(), name
        assert (
            found["transpiration"] <= season["potential_transpiration"]
        ).all()
        assert (found["evaporation"] <= season["potential_evaporation"]).all()
        taken = found["transpiration"] + found["evaporation"]
        stored = np.diff(
            found["depletion"], prepend=season["soil"]["initial_depletion"]
        )
        wetting = season["rain"] + season["irrigation"]
        assert taken + found["drainage"] - wetting == pytest.approx(
            stored, abs=1e-9
        )


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        ({"soil": None}, "lack the dictionary soil"),
        ({"rain": [1.0]}, "differ in number"),
        ({"rain": 3.0}, "give one number for each day"),
        ({"root_depth": [-1.0] * 40}, "root_depth is -1"),
        ({"rain": [np.nan] * 40}, "rain is nan"),
    ],
)
def test_impossible_inputs_are_refused(
    change: dict[str, Any], problem: str
) -> None:
    with pytest.raises(ideotype.Error, match=problem):
        ideotype.soil_water_balance(GIVEN[0] | change)


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        ({"theta": 0.3}, "no parameter 'theta'"),
        ({"theta_wp": 0.4}, "field capacity must be wetter"),
        ({"rew": 30.0}, "more than tew"),
        ({"p": 1.5}, "p is 1.5"),
    ],
)
def test_impossible_soils_are_refused(
    change: dict[str, Any], problem: str
) -> None:
    soil = GIVEN[0]["soil"] | change
    with pytest.raises(ideotype.Error, match=problem):
        ideotype.soil_water_balance(GIVEN[0] | {"soil": soil})
