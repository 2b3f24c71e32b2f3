# SPDX-License-Identifier: Apache-2.0
"""The cost of accuracy is measured within a given time, printed, drawn, and
the result can be pasted into a campaign."""

from __future__ import annotations

import json
import os
import random
import re
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import pytest
from real_program import CAMPAIGNS, executable, output_of, write_campaign

from ideotype import Stand
from ideotype.figures.fidelity import draw_fidelity
from ideotype.tools import fidelity
from ideotype.tools.survey import (
    OWN,
    Draw,
    Setting,
    Survey,
    ladder,
    pareto,
    summarize,
)

KEYS = [
    {"key": "plant.cells", "value": 12, "values": [4, 8, 16]},
    {"key": "light.tolerance", "value": 0.01, "values": [0.02, 0.005]},
]


class Fake:
    """Evaluations with known errors; their long durations pass on a fake
    clock."""

    def __init__(self, second: float = 1.0) -> None:
        self.now = 0.0
        self.second = second
        self.calls: list[Setting] = []

    def clock(self) -> float:
        return self.now

    def __call__(self, setting: Setting, number: int) -> Draw:
        given = dict(setting)
        cells = given.get("plant.cells", 12)
        noise = given.get("light.tolerance", 0.01)
        self.calls.append(setting)
        seconds = self.second * (cells / 12 + (0.01 / noise) ** 2)
        self.now += 2 * seconds
        field = random.Random(number)
        value = 9 * (1 - 0.5 / cells**2) + 9 * noise * field.gauss()
        return Draw(value, 0.1 + noise * field.gauss(), seconds)


@pytest.mark.parametrize("seconds", (20, 100, 500, 3000))
def test_no_evaluation_begins_that_would_end_late(seconds: float) -> None:
    fake = Fake()
    survey = Survey(KEYS, fake, seconds, fake.clock)
    survey.run(0.008)
    assert 0.5 * seconds < fake.now <= seconds
    assert sum(map(len, survey.draws.values())) == len(fake.calls)


def test_settings_that_take_too_long_are_left_out_and_reported() -> None:
    fake = Fake()
    survey = Survey(KEYS, fake, 170, fake.clock)
    survey.run(0.008)
    assert list(survey.left_out) == [
        "plant.cells=16",
        "light.tolerance=0.005",
    ]
    assert (("light.tolerance", 0.005),) not in survey.draws
    # Of the remaining settings, that of the campaign is the most accurate.
    assert survey.ladders[0][-1] == OWN


def test_biases_and_noise_are_estimated() -> None:
    fake = Fake(1e-3)
    survey = Survey(KEYS, fake, 100, fake.clock)
    survey.run(0.008)
    results = summarize(survey, 0.008)
    cells, tolerances = results["keys"]
    assert [row["settings"] for row in cells] == [
        {"plant.cells": 4},
        {"plant.cells": 8},
        {},
        {"plant.cells": 16},
    ]
    for row, n in zip(cells, (4, 8, 12, 16), strict=True):
        # All draws have common random numbers, so that only the bias remains.
        wanted = 0.5 / 16**2 - 0.5 / n**2
        assert row["value"]["bias"].mean == pytest.approx(wanted, abs=1e-4)
        assert row["value"]["bias"].standard_error < 1e-4
    for row, noise in zip(tolerances, (0.02, 0.01, 0.005), strict=True):
        mean, error = row["value"]["noise"]
        assert abs(mean - noise) < 4 * error < noise
    chosen = results["chosen"]
    assert results["is_met"] and chosen["value"]["error"].mean <= 0.008
    assert chosen["settings"]["light.tolerance"] == 0.005
    assert chosen["is_on_front"]


def test_ladders_end_with_the_most_accurate() -> None:
    assert ladder("a.b", 12, [4, 8]) == [(("a.b", 4),), (("a.b", 8),), OWN]
    assert ladder("a.b", 3, [9, 1]) == [(("a.b", 9),), OWN, (("a.b", 1),)]


def test_each_member_of_a_front_is_more_accurate_than_all_cheaper() -> None:
    points = [(3, 1, "c"), (1, 5, "a"), (2, 5, "no"), (2, 4, "b"), (4, 2, "")]
    assert [name for _, _, name in pareto(points)] == ["a", "b", "c"]


def measure(campaign: Path, *options: object) -> str:
    # As for users, the program passes the command to Python, and then
    # evaluates plants for it.
    done = subprocess.run(
        [executable(), "fidelity", campaign, *map(str, options)],
        env=os.environ | {"IDEOTYPE_PYTHON": sys.executable},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def pasted(campaign: Path, printed: str) -> Path:
    """Returns the campaign with its tables replaced by those in the output."""
    block = printed.split("\n# ")[1].split("\n", 1)[1]
    headers = re.findall(r"^\[.*", block, re.MULTILINE)
    # If the setting of the campaign is the cheapest, the output contains no
    # tables.
    assert len(headers) == len(set(headers))
    changed = {name.split(".")[0] for name in tomllib.loads(block)}
    head, *tables = re.split(
        r"^(?=\[)", campaign.read_text(), flags=re.MULTILINE
    )
    kept = [t for t in tables if re.split(r"\W+", t)[1] not in changed]
    path = campaign.with_name("pasted.toml")
    path.write_text("".join([head, *kept]) + "\n" + block)
    return path


def of_a_day(folder: Path) -> Path:
    return write_campaign(folder, 1)


def of_a_season(folder: Path) -> Path:
    """Writes a version of bondville.toml with four days."""
    text = (CAMPAIGNS / "bondville.toml").read_text()
    text = text.replace("to = 2011-09-20", "to = 2011-07-24")
    for name in ("weather", "crops"):
        text = text.replace(f'"{name}/', f'"{CAMPAIGNS}/{name}/')
    campaign = folder / "season.toml"
    text += "\n[light]\npaths = 256\nrandomisations = 4\n"
    campaign.write_text(text + "[field.variation]\nlength = 0.05\n")
    return campaign


@pytest.mark.parametrize("made", (of_a_day, of_a_season))
def test_printed_keys_are_valid_and_the_time_is_kept(
    made, tmp_path: Path
) -> None:
    campaign, file = made(tmp_path), tmp_path / "fidelity.json"
    began = time.monotonic()
    options = ("--seconds", 12, "--tolerance", 1e-4, "--json", file)
    output = measure(campaign, *options, "--figure", tmp_path / "fidelity.png")
    # The time includes the start and the drawing of the figure.
    assert time.monotonic() - began < 60
    results = json.loads(file.read_text())
    rows = [row for rows in results["keys"] for row in rows]
    rows += results["settings"]
    unique = {str(r["settings"]): 2 * r["draws"] * r["seconds"] for r in rows}
    assert 1 < sum(unique.values()) < 12.5
    keys = {key for row in rows for key in row["settings"]}
    assert keys
    # On a busy machine some settings cannot be measured; the output names
    # them.
    keys |= {
        word.split("=")[0]
        for setting, why in results["left_out"].items()
        for word in setting.split()
        if "takes too long" in why
    }
    assert {"plant.cells_along", "field.rows"} <= keys
    assert ("light.dates" in keys) == (made is of_a_season)
    assert ("day.step_minutes" in keys) == (made is of_a_day)
    assert "there is none; the most accurate" in output
    resolved = json.loads(
        output_of("check", pasted(campaign, output), "--json")
    )
    assert resolved["is_valid"]
    text = (tmp_path / "pasted.toml").read_text()
    for key, value in results["chosen"]["settings"].items():
        table, name = key.split(".")
        entry = tomllib.loads(text)[table]
        assert (entry[0] if table == "day" else entry)[name] == value
    assert (tmp_path / "fidelity.png").stat().st_size > 10_000


def test_ctrl_c_prints_the_measurements_so_far(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "ideotype.tools.fidelity"]
    command += [of_a_day(tmp_path), "--seconds", "600"]
    with subprocess.Popen(
        ["bash", "-c", "trap '' INT; exec \"$@\"", "bash", *command],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        process_group=0,
    ) as process:
        time.sleep(8)
        os.killpg(process.pid, signal.SIGINT)
        output, errors = process.communicate(timeout=10)
    assert (process.returncode, errors) == (5, "")
    assert output.startswith("stopped before the end")
    assert "keys together" in output and "the campaign" in output


def test_errors_are_reported_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    campaign = of_a_day(tmp_path)
    assert fidelity.main([str(campaign), "--set", "light.path=3"]) == 3
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("ideotype fidelity: ") and "light.path" in line
    assert fidelity.main([str(campaign), "--case", "99"]) == 1
    assert "99" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        fidelity.main([str(campaign), "--seconds", "-1"])
    assert "-1 (expected: 1 .. 1e+06)" in capsys.readouterr().err


def test_the_evaluator_agrees_with_the_program(tmp_path: Path) -> None:
    campaign = of_a_day(tmp_path)
    evaluator = fidelity.Evaluator(campaign, 0, ["light.paths=256"])
    draw = evaluator.draw((("field.rows", 1.0),), 7)
    settings = ["--set", "light.paths=256", "--set", "field.rows=1"]
    baseline = Stand.from_campaign(campaign).baseline
    request = {"genome": baseline.tolist(), "seed": 7, "generation": 1 << 30}
    done = subprocess.run(
        [executable(), "serve", campaign, "--quiet", *settings],
        input=json.dumps(request) + "\n",
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    hello, answer = map(json.loads, done.stdout.splitlines())
    keys = [x for x in hello["accuracy"] if x["key"] != "field.rows"]
    assert keys == [x for x in evaluator.accuracy if x["key"] != "field.rows"]
    served = answer["objectives"][evaluator.objective]["mean"]
    assert draw.value == served and draw.seconds > 0


def test_both_panels_have_all_settings() -> None:
    fake = Fake(1e-3)
    survey = Survey(KEYS, fake, 30, fake.clock)
    survey.run(0.008)
    results = {
        "case": "ames",
        "objective": "light",
        **summarize(survey, 0.008),
    }
    for axes in draw_fidelity(results).axes:
        counts = [len(each[0].get_xdata()) for each in axes.containers]
        assert counts == [7, len(results["settings"]) - 1, 1]
