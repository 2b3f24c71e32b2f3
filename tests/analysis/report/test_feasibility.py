# SPDX-License-Identifier: Apache-2.0
"""The report states the distance of an optimised plant from measured lines."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from real_program import CAMPAIGNS, output_of

import ideotype
from ideotype.tools import compare
from ideotype.tools.commands import summary

FEW = ["light.tolerance=0", "light.paths=256", "final.paths=256"]
"""Settings that change no distance: distances are those of plants alone."""


@pytest.mark.parametrize("fronts", [False, True])
def test_bred_plants_name_their_nearest_line(
    fronts: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    settings = [
        'feasibility.lines="lines/maize_panel.toml"',
        "feasibility.limit=2.5",
        "stop.generations=2",
        *FEW,
    ]
    if fronts:
        settings += ["objective.minimise=lai", "search.optimizer=nsga2"]
    words = [word for each in settings for word in ("--set", each)]
    output_of("run", CAMPAIGNS / "ames_quick.toml", *words, "--out", tmp_path)
    assert summary([str(tmp_path), "--all"]) == 0
    shown = capsys.readouterr().out
    distances = re.findall(
        r"(\d\.\d\d) from the mean of measured lines and (\d\.\d\d) from the "
        "nearest, B73",
        shown,
    )
    assert len(distances) == 2 or fronts
    assert distances
    assert fronts or all(0 < float(mean) < 2.5 for mean, _ in distances)
    assert "Distance in standard deviations: best plant" in shown


def test_the_nearest_line_is_a_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    campaign = CAMPAIGNS / "ames_quick.toml"
    few = "--set", "final.paths=256"
    lines = "--set", 'feasibility.lines="lines/maize_panel.toml"'
    text = output_of("evaluate", campaign, *lines, *few)
    assert re.search(r"^ +nearest_line +B73$", text, re.MULTILINE)
    data = json.loads(output_of("evaluate", campaign, *lines, *few, "--json"))
    nearest = data["quantities"]["nearest_line"]
    assert nearest["name"] == "B73" and nearest["mean"] >= 1
    stand = ideotype.Stand.from_campaign(campaign, settings=lines[1:])
    found = stand.evaluate(stand.baseline, ["nearest_line"]).nearest_line
    assert found.attrs["names"][int(found.item()) - 1] == "B73"
    maize = CAMPAIGNS / "crops" / "maize.toml"
    words = [maize, maize, "--under", campaign, *lines, *few]
    assert compare.main([*map(str, words), "--all"]) == 0
    assert re.search(
        r"^nearest line +B73 +B73 +–$", capsys.readouterr().out, re.MULTILINE
    )
    assert compare.main([*map(str, words), "--json"]) == 0
    shown = json.loads(capsys.readouterr().out)["quantities"]["nearest_line"]
    assert shown["names"][int(shown["mean"][0][0]) - 1] == "B73"
