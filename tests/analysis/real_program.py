"""The program itself, and a campaign that takes it a second."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

_PLANT = Path(__file__).parents[2] / "campaigns" / "plants" / "b73_v01.toml"

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
baseline = "b73_v01.toml"

[light]
paths = 64
randomisations = 4

[search]
population = 6

[stop]
generations = {generations}

[final]
candidates = 2
paths = 256
randomisations = 4
"""


def executable() -> str:
    """The program that IDEOTYPE_EXECUTABLE names."""
    found = os.environ.get("IDEOTYPE_EXECUTABLE")
    if not found:
        if "IDEOTYPE_SAMPLE_HISTORY" in os.environ:
            pytest.skip("IDEOTYPE_EXECUTABLE is not set")
        pytest.fail(
            "set IDEOTYPE_EXECUTABLE to the built program, or "
            "IDEOTYPE_SAMPLE_HISTORY to a finished history"
        )
    return os.path.abspath(found)


def write_campaign(folder: Path, generations: int) -> Path:
    """tiny.toml with its plant, of so many generations."""
    shutil.copy(_PLANT, folder)
    campaign = folder / "tiny.toml"
    campaign.write_text(_CAMPAIGN.format(generations=generations))
    return campaign


def start(folder: Path, generations: int) -> subprocess.Popen[str]:
    """Begins to evolve the tiny campaign."""
    campaign = write_campaign(folder, generations)
    return subprocess.Popen(
        [executable(), "run", campaign, "--out", folder],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def output_of(*arguments: object) -> str:
    """What the program prints; it has to succeed."""
    done = subprocess.run(
        [executable(), *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
