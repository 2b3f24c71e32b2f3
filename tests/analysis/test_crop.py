# SPDX-License-Identifier: Apache-2.0
"""Crops that grow agree with references and measured seasons."""

from __future__ import annotations

import csv
import json
from datetime import date, timedelta
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import ideotype

ROOT = Path(__file__).parents[2]
DATA = ROOT / "tests/data/growth"
HYBRID = ROOT / "campaigns/crops/maize_hybrid.toml"


def read(name: str) -> list[list[str]]:
    lines = (DATA / name).read_text().splitlines()
    return list(csv.reader(x for x in lines if not x.startswith("#")))[1:]


def hours(largest: float, smallest: float) -> NDArray[np.float64]:
    """Returns the temperature of each hour of a day: half a wave about the
    mean."""
    wave = np.sin(np.pi * np.arange(24) / 12)
    return (largest + smallest) / 2 + (largest - smallest) / 2 * wave


def test_a_hybrid_has_the_areas_of_the_reference() -> None:
    crop = ideotype.Crop.from_file(HYBRID)
    given = json.loads((DATA / "growth_given.json").read_text())
    assert crop.silking == given["silking"]
    assert crop.maturity == given["maturity"]
    for case in given["cases"]:
        plant = crop.at(case["tau"])
        green = plant.green_area.sum().item()
        assert green == pytest.approx(case["green_area"], abs=1e-6)
        assert (plant.tip <= case["tau"]).sum() == case["tips"]
        assert (plant.collar <= case["tau"]).sum() == case["collars"]
    assert plant.sizes == {"rank": 19}
    assert plant.dead_area.sum() > 0.6
    assert plant.collar_height[-1].item() == pytest.approx(2.35)


def test_a_stand_has_silking_and_maturity_of_gainesville_1982() -> None:
    """Both were measured, on days 132 and 185 of the year."""
    crop = ideotype.Crop.from_file(HYBRID)
    weather = {
        x[0]: (float(x[2]), float(x[3]))
        for x in read("ufga1982_weather_daily.csv")
    }
    # The stand was sown 7 cm deep on 26 February: 45 + 6 x 7 deg C d to
    # emergence (CERES).
    day, sum_to_emergence = date(1982, 2, 26), 0.0
    while sum_to_emergence < 45 + 6 * 7:
        day += timedelta(1)
        sum_to_emergence += float(
            np.mean(np.clip(hours(*weather[day.isoformat()]), 8, 34) - 8)
        )
    emergence = day + timedelta(1)
    temperatures = np.concatenate(
        [
            hours(*weather[x])
            for x in sorted(weather)
            if x >= emergence.isoformat()
        ]
    )
    season = crop.season(emergence, temperatures, 7.2)
    day_of_year = season.day.dt.dayofyear.values
    time = season.thermal_time.values
    assert abs(day_of_year[np.argmax(time >= crop.silking)] - 132) <= 4
    assert abs(day_of_year[np.argmax(time >= crop.maturity)] - 185) <= 4
    assert 4 < season.leaf_area_index.max() < 4.6


def test_leaf_area_follows_bondville_1999() -> None:
    crop = ideotype.Crop.from_file(HYBRID)
    hourly = [
        float(x[1])
        for x in read("bondville_1999_temperature.csv")
        if x[0] >= "1999-05-10"
    ]
    found = crop.season("1999-05-10", hourly, 7).leaf_area_index
    errors = [
        found.sel(day=x[1]).item() - float(x[2])
        for x in read("bondville_1999_maize_lai.csv")
    ]
    assert len(errors) == 15
    assert np.sqrt(np.mean(np.square(errors))) < 0.35


def test_impossible_numbers_are_errors(tmp_path: Path) -> None:
    crop = ideotype.Crop.from_file(HYBRID)
    with pytest.raises(ideotype.Error, match="24 hours"):
        crop.season("1999-05-10", [20.0] * 25, 7)
    with pytest.raises(ideotype.Error, match="fill gaps"):
        crop.season("1999-05-10", [20.0] * 23 + [np.nan], 7)
    with pytest.raises(ideotype.Error, match="must be positive"):
        crop.season("1999-05-10", [20.0] * 24, 0)
    with pytest.raises(ideotype.Error, match="must be finite"):
        crop.at(np.nan)
    with pytest.raises(ideotype.Error, match=r"has no \[growth\]"):
        ideotype.Crop.from_file(ROOT / "campaigns/crops/maize.toml")
    wrong = tmp_path / "wrong.toml"
    text = HYBRID.read_text()
    wrong.write_text(
        text.replace("[growth]\nleaves = 19", "[growth]\nleaves = 9")
    )
    with pytest.raises(ideotype.InputError, match="growth.leaves is 9"):
        ideotype.Crop.from_file(wrong)
