# SPDX-License-Identifier: Apache-2.0
"""The command line prints objectives of single components."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from real_program import executable

CAMPAIGN = str(Path(__file__).parents[3] / "campaigns/intercrop.toml")


def run(*words: str) -> str:
    return subprocess.run(
        [executable(), *words], check=True, capture_output=True, text=True
    ).stdout


def test_objectives_of_components_are_reported_by_name() -> None:
    names = ["b73.net_assimilation", "soybean.net_assimilation"]
    checked = run("check", CAMPAIGN)
    report = json.loads(run("evaluate", CAMPAIGN, "--json"))
    assert list(report["objectives"]) == names
    both = [report["objectives"][name]["mean"] for name in names]
    assert both[0] > 2 * both[1] > 0
    total = report["quantities"]["net_assimilation"]["mean"]
    assert sum(both) == pytest.approx(total, rel=1e-9)
    for name in names:
        assert f"maximise {name}" in checked
