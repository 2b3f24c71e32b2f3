# SPDX-License-Identifier: Apache-2.0
"""The report tells the distance of a bred plant from measured lines."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from real_program import CAMPAIGNS, output_of

from ideotype.analysis.commands import summary


@pytest.mark.parametrize("fronts", [False, True])
def test_bred_plants_name_their_nearest_line(
    fronts: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    settings = [
        'feasibility.lines="lines/maize_panel.toml"',
        "feasibility.limit=2.5",
        "stop.generations=2",
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
    assert "the bred plant is" in shown
