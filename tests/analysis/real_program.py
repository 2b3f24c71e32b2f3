# SPDX-License-Identifier: Apache-2.0
"""Runs the program with a campaign that takes about a second."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

CAMPAIGNS = Path(__file__).parents[2] / "campaigns"
SAMPLE = Path(__file__).parents[1] / "data" / "history" / "format_2_0.h5"
"""A history that version 0.2.0 wrote."""
FACES = 10 * 24 + 16 + (10 + 3) * 8 + 2 * 12 + 8 + 7 * 6
"""The number of faces of a plant: leaves of 12 x 2 cells, stalk, sheaths,
peduncle and ear, spike, and seven branches of three sides, each of which has a
cover of as many faces as sides."""
_PLANT = CAMPAIGNS / "crops" / "maize.toml"

_CAMPAIGN = """
name = "tiny"

[[site]]
name = "ames"
latitude = 42.0
longitude = -93.6
utc_offset = -5

[[day]]
date = 2025-08-07
start = 07:00:00
end = 20:00:00
step_minutes = 60

[[spacing]]
row = 0.762
plant = 0.1524

[field]
rows = 2
plants = 2

[plant]
baseline = "maize.toml"

[search]
optimizer = "ga"
population = 6

[stop]
generations = {generations}
"""

_FAST = """
[light]
paths = 64
randomisations = 4

[final]
candidates = 2
paths = 256
randomisations = 4
"""


def executable() -> str:
    """Returns the program that IDEOTYPE_EXECUTABLE names."""
    named = os.environ.get("IDEOTYPE_EXECUTABLE")
    if not named:
        if "IDEOTYPE_SAMPLE_HISTORY" in os.environ:
            pytest.skip("IDEOTYPE_EXECUTABLE is not set")
        pytest.fail(
            "set IDEOTYPE_EXECUTABLE to the built program, or "
            "IDEOTYPE_SAMPLE_HISTORY to a finished history"
        )
    return os.path.abspath(named)


def write_campaign(folder: Path, generations: int) -> Path:
    """Writes tiny.toml with its plant and the given number of generations."""
    shutil.copy(_PLANT, folder)
    campaign = folder / "tiny.toml"
    campaign.write_text(_CAMPAIGN.format(generations=generations) + _FAST)
    return campaign


def run_with(folder: Path, tables: str, command: str = "run") -> Path:
    """Runs the tiny campaign for two generations with additional tables, by
    `ideotype run` or another command, and returns the finished history."""
    campaign = write_campaign(folder, 2)
    campaign.write_text(campaign.read_text() + tables)
    output_of(command, campaign, "--out", folder)
    (path,) = (folder / "tiny").glob("*.h5")
    return path


def run_crop(folder: Path, crop: str, free: list[str]) -> Path:
    """Runs a crop of campaigns/crops for two generations in the stand of the
    tiny campaign, with the given traits free, and returns the finished
    history."""
    campaign = write_campaign(folder, 2)
    baseline = json.dumps(str(CAMPAIGNS / "crops" / f"{crop}.toml"))
    text = campaign.read_text().replace('"maize.toml"', baseline)
    traits = f'\n[[traits]]\nname = "some"\nfree = {json.dumps(free)}\n'
    campaign.write_text(text + traits)
    output_of("run", campaign, "--out", folder)
    (path,) = (folder / "tiny").glob("*.h5")
    return path


def run_shortened(folder: Path, name: str) -> list[Path]:
    """Runs campaigns/NAME.toml with three generations of eight plants and few
    light paths, and returns the finished histories."""
    light = _FAST.replace("paths = 64", "paths = 256")
    text = (CAMPAIGNS / f"{name}.toml").read_text() + light
    for key, value in (("population", 8), ("generations", 3)):
        text, count = re.subn(rf"(?m)^{key} = \d+$", f"{key} = {value}", text)
        assert count == 1, key
    campaign = (
        shutil.copytree(CAMPAIGNS, folder / "campaigns") / f"{name}.toml"
    )
    campaign.write_text(text)
    output_of("run", campaign, "--out", folder)
    return sorted((folder / name).glob("*.h5"))


def start(folder: Path, generations: int) -> subprocess.Popen[str]:
    """Starts a run of the tiny campaign."""
    campaign = write_campaign(folder, generations)
    return subprocess.Popen(
        [executable(), "run", campaign, "--out", folder],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def output_of(*arguments: object) -> str:
    """Returns the output of the program, which must succeed."""
    done = subprocess.run(
        [executable(), *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
