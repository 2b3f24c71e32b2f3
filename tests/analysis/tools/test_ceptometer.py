# SPDX-License-Identifier: Apache-2.0
"""Measured light beside computed light: a table made by the program agrees, a
biased table is reported as biased, and bad tables are refused."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from real_program import CAMPAIGNS

import ideotype
from ideotype.tools import ceptometer

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
        apart = abs(row["model"] - row["measured"])
        assert apart < 5 * row["model_standard_error"] + 0.02
    assert told["days"] == 1


def test_bias_is_told(
    stand: ideotype.Stand, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = measured(stand, tmp_path, factor=0.8)
    assert ceptometer.main([str(QUICK), str(table)]) == 0
    text = capsys.readouterr().out
    head = text.splitlines()[0].split("  ")
    assert [word for word in map(str.strip, head) if word] == [
        "height [m]", "position [m]", "time", "measured", "model",
    ]  # fmt: skip
    (bias,) = re.findall(r"model − measured: (\S+) ± 0\.\d+, root", text)
    assert float(bias) > 0.03
    assert re.search(r"0\.40 +0\.38 +\d+:\d\d +0\.\d{3} +0\.\d{3} ± ", text)


def test_one_row_has_no_interval(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = tmp_path / "one.csv"
    table.write_text("height_m,percent\n0,5\n")
    assert ceptometer.main([str(QUICK), str(table)]) == 0
    text = capsys.readouterr().out
    assert "nan" not in text and "1 row\n" in text and "whole day" in text
    assert ceptometer.main([str(QUICK), str(table), "--json"]) == 0
    told = json.loads(capsys.readouterr().out, parse_constant=pytest.fail)
    assert told["correlation"] is None and told["bias_standard_error"] is None


def test_a_mean_of_many_days_is_announced(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = tmp_path / "noon.csv"
    table.write_text("height_m,hour,percent\n0,12:00,5\n0,13:00,5\n")
    season = str(CAMPAIGNS / "bondville.toml")
    words = [season, str(table), "--set", "climate.from=2011-07-25", "--set"]
    assert ceptometer.main([*words, "climate.to=2011-08-03"]) == 0
    text = capsys.readouterr().out
    assert "mean light of 10 days" in text
    assert "--set climate.from=DATE --set climate.to=DATE" in text
    # The settings that the message names choose the day.
    assert ceptometer.main([*words, "climate.to=2011-07-25"]) == 0
    assert "days" not in capsys.readouterr().out


def test_means_over_rows_and_day(
    stand: ideotype.Stand, tmp_path: Path
) -> None:
    path = tmp_path / "means.csv"
    path.write_text("height_m,percent\n0,5\n")
    found = ceptometer.compare(stand, ceptometer.read_table(path))
    at = stand.evaluate(stand.baseline, ["soil_fraction"], final=True)
    soil = at.soil_fraction.item() / (1 - 0.1)
    assert found.model[0] == pytest.approx(soil, abs=0.02)
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


def test_devices_are_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert ceptometer.main([str(QUICK), "/dev/zero"]) == 3
    told = capsys.readouterr().err
    assert "/dev/zero: this is no regular file" in told
