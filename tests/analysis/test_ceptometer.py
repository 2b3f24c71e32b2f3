# SPDX-License-Identifier: Apache-2.0
"""Measured light beside computed light: a table made by the program agrees, a
biased table is reported as biased, and bad tables are refused."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from real_program import CAMPAIGNS

import ideotype
from ideotype import ceptometer

QUICK = CAMPAIGNS / "ames_quick.toml"


@pytest.fixture(scope="module")
def stand() -> ideotype.Stand:
    return ideotype.Stand.from_campaign(QUICK)


def measured(stand: ideotype.Stand, folder: Path, factor: float = 1) -> Path:
    """Writes a table that was made from other fields, by more points."""
    heights, positions = [0.0, 0.4, 1.0, 3.0], [0.1, 0.38, 0.6, 0.2]
    found = stand.light_at(
        stand.baseline, heights, positions, fields=64, points=64
    )
    lines = ["# by hand", "height_cm,position_m,hour,below,above"]
    for s, (height, position) in enumerate(zip(heights, positions)):
        for i in (4, 12, 20):
            hour = found.hour[i].item()
            clock = f"{int(hour):02}:{round(60 * (hour % 1)):02}"
            below = 1000 * factor * found.fraction[s, i].item()
            lines.append(f"{100 * height},{position},{clock},{below},1000")
    table = folder / "light.csv"
    table.write_text("\n".join(lines) + "\n")
    return table


def test_own_light_agrees(
    stand: ideotype.Stand, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table, figure = measured(stand, tmp_path), tmp_path / "light.png"
    words = [str(QUICK), str(table), "--json", "--figure", str(figure)]
    assert ceptometer.main(words) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["rows"] == 12
    assert abs(told["bias"]) < 0.02
    assert told["rms"] < 0.03
    assert told["correlation"] > 0.99
    assert figure.stat().st_size > 10_000
    for row in told["table"]:
        assert abs(row["ours"] - row["measured"]) < 5 * row["error"] + 0.02


def test_bias_is_told(
    stand: ideotype.Stand, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = measured(stand, tmp_path, factor=0.8)
    assert ceptometer.main([str(QUICK), str(table)]) == 0
    last = capsys.readouterr().out.splitlines()[-1]
    assert float(last.split()[3]) > 0.03


def test_means_over_rows_and_day(
    stand: ideotype.Stand, tmp_path: Path
) -> None:
    path = tmp_path / "means.csv"
    path.write_text("height_m,percent\n0,5\n")
    found = ceptometer.compare(stand, ceptometer.read_table(path))
    at = stand.evaluate(stand.baseline, ["soil_fraction"], final=True)
    soil = at.soil_fraction.item() / (1 - 0.1)
    assert found.ours[0] == pytest.approx(soil, abs=0.02)
    assert np.isnan(found.hour[0])


@pytest.mark.parametrize(
    ("text", "words"),
    (
        ("depth,fraction\n1,0.5\n", "height_cm or height_m"),
        ("height_m\n1\n", "add fraction"),
        ("height_m,fraction\n1,x\n", "a number cannot be read"),
        ("height_m,fraction\n1,5\n", "row 1 of the table"),
        ("height_m,hour,fraction\n1,3:00,0.5\n", "not in the day"),
        ("", "bad.csv:1: this file is empty; begin with a line of"),
    ),
)
def test_bad_tables_are_refused(
    text: str, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = tmp_path / "bad.csv"
    table.write_text(text)
    assert ceptometer.main([str(QUICK), str(table)]) == 3
    assert words in capsys.readouterr().err
