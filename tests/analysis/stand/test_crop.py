# SPDX-License-Identifier: Apache-2.0
"""Growing crops agree with references and measured seasons."""

from __future__ import annotations

import csv
import json
from datetime import date, timedelta
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import ideotype

ROOT = Path(__file__).parents[3]
DATA = ROOT / "tests/data/growth"
HYBRID = ROOT / "campaigns/crops/maize_hybrid.toml"
#: The hybrid of the period of the measured seasons, 1982 and 1999.
FORMER = ROOT / "campaigns/plants/maize_hybrid_1980s.toml"


def read(name: str) -> list[list[str]]:
    lines = (DATA / name).read_text().splitlines()
    return list(csv.reader(x for x in lines if not x.startswith("#")))[1:]


def hours(largest: float, smallest: float) -> NDArray[np.float64]:
    """Returns the temperature of each hour of a day, a sine wave around the
    mean."""
    wave = np.sin(np.pi * np.arange(24) / 12)
    return (largest + smallest) / 2 + (largest - smallest) / 2 * wave


def test_leaf_areas_agree_with_the_reference_model() -> None:
    crop = ideotype.Crop.from_file(FORMER)
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
    """Both were observed, on days 132 and 185 of the year."""
    crop = ideotype.Crop.from_file(FORMER)
    weather = {
        x[0]: (float(x[2]), float(x[3]))
        for x in read("ufga1982_weather_daily.csv")
    }
    # The stand was sown on 26 February at a depth of 7 cm, so that emergence
    # takes 45 + 6 x 7 deg C d (CERES).
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
    crop = ideotype.Crop.from_file(FORMER)
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


def test_a_modern_hybrid_has_larger_leaves_than_a_former_one() -> None:
    now, before = (ideotype.Crop.from_file(x) for x in (HYBRID, FORMER))
    assert now.silking == before.silking
    ratio = now.at(900).green_area / before.at(900).green_area
    np.testing.assert_allclose(ratio.dropna("rank"), 0.0784 / 0.07)


def test_the_mesh_of_a_growing_plant_has_its_green_area() -> None:
    crop = ideotype.Crop.from_file(HYBRID)
    young, grown = (crop.mesh(x).vertices[:, 2].max() for x in (400, 1000))
    assert 0.3 < young < 0.7 * grown
    names = set(crop.mesh(1500).groups)
    assert {"leaf09", "leaf19", "stalk_dead_leaves"} <= names
    assert "stalk_dead_leaves" not in crop.mesh(150).groups
    assert "leaf01" not in names


def test_sorghum_grows_to_the_area_of_its_leaves() -> None:
    crop = ideotype.Crop.from_file(ROOT / "campaigns/crops/sorghum.toml")
    assert crop.silking == 16 * 41 + 20
    # The total area of the leaves in the crop file is 0.40 m2; the lowest of
    # them are dead.
    plant = crop.at(crop.silking)
    both = (plant.green_area + plant.dead_area).sum().item()
    assert both == pytest.approx(0.40, rel=0.05)
    assert 0 < plant.dead_area.sum() < 0.1


def make_season(**light: float) -> ideotype.Stand:
    return ideotype.Stand.from_campaign(
        ROOT / "campaigns/growing_season.toml",
        settings={
            "objective.over": [],
            "objective.maximise": "gross_assimilation",
            "field.variation.missing": 0,
            "field.variation.late": 0,
            **{f"light.{key}": value for key, value in light.items()},
        },
    )


def test_ten_growth_stages_give_the_carbon_of_twenty() -> None:
    results = []
    for stages in (10, 20):
        stand = make_season(stages=stages, paths=8192, dates=20)
        one = stand.evaluate(stand.baseline)
        carbon = float(one.gross_assimilation[0])
        error = float(one.gross_assimilation_standard_error[0])
        results.append((carbon, error))
        assert one.sizes["stage"] == stages
        # Growing plants have additional leaves below those of the crop file,
        # with areas that follow from these.
        assert one.lai_by_stage.max() == pytest.approx(5.05, rel=0.05)
        assert one.dead_area_index_by_stage[0, -1] > 1
    (ten, ten_error), (twenty, twenty_error) = results
    spread = 3 * np.hypot(ten_error, twenty_error)
    # New fields are sampled for each stage.
    assert abs(ten - twenty) < spread + 0.02 * twenty


def test_results_of_a_season_do_not_depend_on_threads() -> None:
    stand = make_season(paths=256)
    plants = np.array([stand.baseline] * 3)
    one, several = (
        stand.evaluate(plants, ["gross_assimilation"], threads=n)
        for n in (1, 3)
    )
    assert one.identical(several)


def test_invalid_arguments_of_a_crop_are_errors(tmp_path: Path) -> None:
    crop = ideotype.Crop.from_file(HYBRID)
    with pytest.raises(ideotype.Error, match="24 hours"):
        crop.season("1999-05-10", [20.0] * 25, 7)
    with pytest.raises(ideotype.Error, match="fill gaps"):
        crop.season("1999-05-10", [20.0] * 23 + [np.nan], 7)
    with pytest.raises(ideotype.Error, match="must be positive"):
        crop.season("1999-05-10", [20.0] * 24, 0)
    for impossible in (np.nan, [100.0, 200.0], "late"):
        for grow in crop.at, crop.mesh:
            with pytest.raises(ideotype.Error, match="thermal_time"):
                grow(impossible)  # type: ignore[arg-type]
    with pytest.raises(ideotype.Error, match="give a date such as"):
        crop.season("2011-02-30", np.full(24, 20.0), 7.5)
    for other in "crops/maize.toml", "quickstart.toml":
        with pytest.raises(
            ideotype.Error, match=r"no crop file with \[growth"
        ):
            ideotype.Crop.from_file(ROOT / "campaigns" / other)
    wrong = tmp_path / "wrong.toml"
    text = HYBRID.read_text()
    wrong.write_text(
        text.replace("[growth]\nleaves = 19", "[growth]\nleaves = 9")
    )
    with pytest.raises(ideotype.InputError, match="growth.leaves is 9"):
        ideotype.Crop.from_file(wrong)
