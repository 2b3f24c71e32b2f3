# SPDX-License-Identifier: Apache-2.0
"""The defaults stated in documents and in the schema are the defaults of
campaigns: stating a default explicitly changes nothing."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path
from typing import Any

import pytest

import ideotype

SMALL = Path(__file__).parents[2] / "fuzz/campaigns/small.toml"
WHOLE = json.loads(
    (
        Path(ideotype.__file__).parent / "schemas/campaign.schema.json"
    ).read_text()
)
SCHEMA = {
    # A table that is used at several positions is defined once.
    table: WHOLE["$defs"][schema["$ref"].rpartition("/")[2]]
    if "$ref" in schema
    else schema
    for table, schema in WHOLE["properties"].items()
}
STATED = re.compile(r'; default: (-?[\d.]+(?:e[-+]?\d+)?|true|false|"\w+")')


def tables() -> dict[str, Any]:
    """Returns a campaign of assimilation with as few keys as possible."""
    return tomllib.loads(SMALL.read_text()) | {
        "light": {},
        "search": {"optimizer": "ga"},
        "objective": {"maximise": "carbon_balance"},
    }


def test_left_out_keys_have_the_stated_defaults() -> None:
    campaign = tables()
    resolved = tomllib.loads(ideotype.Stand(campaign).campaign)
    compared = 0
    for table, schema in SCHEMA.items():
        place, given = resolved.get(table), campaign.get(table, {})
        if isinstance(place, list):
            place = place[0]
        if isinstance(given, list):
            given = given[0]
        if not isinstance(place, dict):
            continue
        for key, each in schema.get("properties", {}).items():
            stated = STATED.search(each.get("description", ""))
            if stated and key in place and key not in given:
                expected = json.loads(stated[1])
                assert place[key] == expected, f"{table}.{key}"
                compared += 1
    assert compared > 40


RATES = {
    "hyperbola": ["phi", "theta", "amax", "rd"],
    "collatz": ["theta", "rd", "vmax", "alpha", "beta", "k"],
    "farquhar": ["theta", "rd", "beta", "vcmax", "jmax", "tpu", "g1"],
}
"""The rates of each model of leaves, which resolved campaigns leave out."""


def stated_rate(key: str, model: str) -> float:
    """Returns the default of a rate as its description states it."""
    about = SCHEMA["photosynthesis"]["properties"][key]["description"]
    text = about.split("; default: ")[1]
    match = re.search(rf"([\d.]+) (?:of the|by) {model}", text, re.IGNORECASE)
    if match:
        return float(match[1])
    number = float(text.split()[0].rstrip(","))
    # The respiration of the hyperbola is stated as a share of amax.
    share = stated_rate("amax", model) if "amax" in text else 1
    return number * share


@pytest.mark.parametrize("model", RATES)
def test_leaves_have_the_stated_rates(model: str) -> None:
    def assimilation(**more: float) -> float:
        campaign = tables() | {"photosynthesis": {"model": model, **more}}
        campaign["light"] = {"paths": 16, "randomisations": 4}
        stand = ideotype.Stand(campaign)
        found = stand.evaluate(stand.baseline, ["gross_co2", "net_co2"])
        return (found.gross_co2 + 2 * found.net_co2).item()

    usual = assimilation()
    for key in RATES[model]:
        rate = stated_rate(key, model)
        assert assimilation(**{key: rate}) == pytest.approx(usual, 1e-12), key
        assert assimilation(**{key: 0.99 * rate}) != pytest.approx(usual, 1e-9)
