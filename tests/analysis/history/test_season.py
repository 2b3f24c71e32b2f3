# SPDX-License-Identifier: Apache-2.0
"""The program writes a season of weather, and figures show it."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import h5py
import numpy as np
import pytest
from drawn import bars
from made_layout import header_checksum
from real_program import CAMPAIGNS, executable, output_of, write_campaign

import ideotype
from ideotype.figures.days import draw_days
from ideotype.figures.profiles import draw_hours
from ideotype.figures.shares import draw_parts
from ideotype.figures.style import get_answer
from ideotype.history import open_arrays, open_history, open_study

_CLIMATE = Path(__file__).parents[2] / "data" / "campaign" / "july.toml"
_WEATHER = "weather/bondville_2011_0721_0920.csv"


@pytest.fixture(scope="module")
def campaign(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides the tiny campaign with ten days of weather at Bondville."""
    folder = tmp_path_factory.mktemp("season")
    path = write_campaign(folder, 3)
    text = path.read_text()
    begin, end = text.index("[[day]]"), text.index("[[spacing]]")
    text = text[:begin] + _CLIMATE.read_text() + text[end:]
    for was, now in (("42.0", "40.05"), ("-93.6", "-88.37"), ("-5", "-6")):
        text = text.replace(was, now, 1)
    path.write_text(text)
    shutil.copytree(CAMPAIGNS / "weather", folder / "weather")
    return path


@pytest.fixture(scope="module")
def season(campaign: Path) -> Path:
    output_of("run", campaign, "--out", campaign.parent)
    (path,) = (campaign.parent / "tiny").glob("*.h5")
    return path


def test_hours_and_days_sum_to_the_mean_day(season: Path) -> None:
    with open_history(season) as history:
        best = history.best()
    assert best is not None
    days = best.profile("absorbed_by_day")
    assert list(days.labels) == [f"2011-07-{day}" for day in range(21, 31)]
    assert days.values.mean() == pytest.approx(best.objective.mean, rel=1e-9)
    hours = best.profile("absorbed_by_hour")
    assert set(range(6, 19)) <= set(hours.labels)
    mean = 3600 * hours.values.sum() / 1e6
    assert mean == pytest.approx(best.objective.mean, rel=1e-9)
    # The expected number follows from the light in the weather file.
    weather = season.parents[1] / _WEATHER
    table = np.genfromtxt(weather, delimiter=",", skip_header=1, max_rows=240)
    mol = table[:, 1].sum() * 3600 / 10 / 1e6
    assert best.estimate("incident").mean == pytest.approx(
        mol / 4.57, rel=1e-9
    )


def test_hours_are_on_the_clock_of_the_site(
    campaign: Path, season: Path, tmp_path: Path
) -> None:
    """Both the weather file of this campaign and its site are in UTC-6."""
    late = campaign.with_name("late.toml")
    late.write_text(
        campaign.read_text()
        .replace("utc_offset = -6", "utc_offset = -4.5", 1)
        .replace("[[climate]]", "[[climate]]\nutc_offset = -6", 1)
    )
    output_of("run", late, "--out", tmp_path)
    (new,) = (tmp_path / "tiny").glob("*.h5")
    # Version 0.2.0 wrote the hours on the clock of the weather file.
    old = Path(shutil.copy(new, tmp_path / "old.h5"))
    with h5py.File(old, "r+") as file:
        for group in ("evaluations", "final"):
            hour = file[group]["hour"]
            hour[:] = hour[:] - 1.5
            hour.attrs["long_name"] = "local clock"
        file.attrs["checksum"] = header_checksum(file)
    name = "time on the clock of the site, UTC-4:30"
    stand = ideotype.Stand.from_campaign(late)
    made = stand.evaluate([stand.baseline])
    with open_history(season) as history:
        same = history.finalists().quantities["absorbed_by_hour"]
    assert same.axis is not None
    assert same.axis.meaning == "time on the clock of the site, UTC-6"
    for path in (new, old):
        arrays = open_arrays(path, "final")
        assert arrays.hour.attrs["long_name"] == name
        assert list(arrays.hour) == list(made.hour)
        with open_study(path) as study:
            (case,) = study.cases()
            hours = draw_hours(case).axes[-1]
            best = case.best.profile("absorbed_by_hour")
        assert hours.get_xlabel() == f"{name} [h]"
        assert list(best.labels) == [hour + 1.5 for hour in same.axis.labels]
    assert made.hour.attrs["long_name"] == name
    printed = output_of("evaluate", late)
    assert re.search("(?m)^clock +UTC-4:30$", printed), printed


def test_a_season_is_drawn_by_hour_and_by_day(season: Path) -> None:
    with open_study(season) as study:
        (case,) = study.cases()
        hours, days = draw_hours(case), draw_days(case)
        parts = draw_parts(case)
    assert get_answer(hours)
    shown, _ = bars(days.axes[0], "best")
    assert len(shown) == 10
    assert shown.mean() == pytest.approx(case.best.objective.mean)
    assert sum(len(axes.get_yticks()) for axes in parts.axes) == 5


def test_a_row_is_reproduced_without_the_weather_file(
    season: Path, tmp_path: Path
) -> None:
    alone = shutil.copy(season, tmp_path)
    assert "bit for bit" in output_of("evaluate", alone, "--best")


def test_a_run_is_not_resumed_with_other_weather(
    season: Path, campaign: Path
) -> None:
    weather = campaign.parent / _WEATHER
    text = weather.read_text()
    weather.write_text(text.replace(",25.1,", ",25.2,", 1))
    try:
        done = subprocess.run(
            [
                executable(),
                "run",
                campaign,
                "--out",
                campaign.parent,
                "--resume",
            ],
            capture_output=True,
            text=True,
            check=False,
        )
    finally:
        weather.write_text(text)
    assert done.returncode == 4
    assert "weather[0].sha256 was " in done.stderr
    output_of("run", campaign, "--out", campaign.parent, "--resume")
