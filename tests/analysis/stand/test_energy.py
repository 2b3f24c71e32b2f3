# SPDX-License-Identifier: Apache-2.0
"""The energy balance of single leaves agrees with independent code."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ideotype

GIVEN = json.loads(
    (
        Path(__file__).parents[2] / "data/physiology/energy_given.json"
    ).read_text()
)
CASES = GIVEN["cases"]
NOON: dict[str, Any] = CASES[8]["input"]


@pytest.mark.parametrize("case", CASES, ids=lambda x: x["name"])
def test_an_energy_balance_agrees_with_the_reference(
    case: dict[str, Any],
) -> None:
    found = ideotype.leaf_energy_balance(GIVEN["defaults"] | case["input"])
    assert found == pytest.approx(case["expected"], rel=1e-8, abs=1e-9)


def test_balances_of_arrays_equal_those_of_their_points() -> None:
    light = np.linspace(0, 2500, 12).reshape(4, 3)
    stomata = np.array(["medlyn", "ball-berry", "medlyn"])
    inputs = NOON | {"ppfd": light, "stomata": stomata, "g1": [1, 2, 3]}
    balances = ideotype.leaf_energy_balance(inputs, roots=True)
    assert balances["net"].shape == (4, 3)
    assert balances["roots"].tolist() == [[1] * 3] * 4
    for i, j in np.ndindex(4, 3):
        one = NOON | {"ppfd": light[i, j], "stomata": str(stomata[j])}
        alone = ideotype.leaf_energy_balance(
            one | {"parameters": {"g1": j + 1}}
        )
        assert {k: balances[k][i, j] for k in alone} == alone


def test_a_c3_leaf_opens_wider_and_is_cooler() -> None:
    c4 = ideotype.leaf_energy_balance(NOON)
    c3 = ideotype.leaf_energy_balance(NOON | {"model": "farquhar"})
    assert c3["gs"] > 1.5 * c4["gs"]
    assert c3["leaf"] < c4["leaf"]
    assert c3["net_radiation"] == pytest.approx(c3["latent"] + c3["sensible"])
    enriched = ideotype.leaf_energy_balance(
        NOON | {"model": "farquhar", "co2": 550}
    )
    assert enriched["net"] > 1.1 * c3["net"]
    assert enriched["gs"] < c3["gs"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"emisivity": 1}, "'emisivity'; did you mean 'emissivity'"),
        ({"vcmax": 1}, "no input 'vcmax'"),
        ({"rh": 55}, "rh is 55, outside 0 to 1"),
        ({"air": np.nan}, "air is nan"),
        ({"wind": [1, 2], "width": [0.1, 0.1, 0.1]}, "shapes that do not fit"),
        ({"stomata": "jarvis"}, "stomata is 'jarvis'; use one of medlyn"),
        ({"model": "hyperbola"}, "model is 'hyperbola'; use one of collatz"),
        ({"parameters": {"emissivity": 2}}, "emissivity is 2"),
        ({"parameters": 2}, "parameters is no dict"),
    ],
)
def test_the_error_names_an_invalid_input(
    change: dict[str, Any], message: str
) -> None:
    with pytest.raises(ideotype.Error, match=message):
        ideotype.leaf_energy_balance(NOON | change)


def test_the_error_names_missing_inputs() -> None:
    with pytest.raises(ideotype.Error, match="lack nir, wind"):
        ideotype.leaf_energy_balance(
            {k: v for k, v in NOON.items() if k not in ("nir", "wind")}
        )
