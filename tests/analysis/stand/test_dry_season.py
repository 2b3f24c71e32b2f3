# SPDX-License-Identifier: Apache-2.0
"""Days of a season with soil that dries, and who decides about them."""

from __future__ import annotations

import tomllib
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import ideotype
from ideotype import Stand

CAMPAIGNS = Path(__file__).parents[3] / "campaigns"


@pytest.fixture(scope="module")
def dry(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """A season of maize in sandy soil with 20 mm of rain every ten days."""
    tables = tomllib.loads((CAMPAIGNS / "growing_season.toml").read_text())
    climate = dict(tables["climate"][0])
    weather = pd.read_csv(CAMPAIGNS / climate["file"], dtype=str)
    day = pd.to_datetime(weather["time"].str[:10]).dt.day
    # One row of a day holds its rain; other entries are empty.
    falls = (day % 10 == 1) & weather["time"].str.contains("T12:00")
    weather["rain_mm"] = np.where(falls, "20", "")
    file = tmp_path_factory.mktemp("weather") / "dry.csv"
    weather.to_csv(file, index=False)
    climate |= {
        "file": str(file),
        "rain": ["rain_mm", "mm"],
        "from": date(2011, 5, 15),
        "to": date(2011, 9, 10),
    }
    del tables["objective"]["over"]
    return tables | {
        "climate": [climate],
        "water": {},
        "soil": {"texture": "sandy_loam"},
        "light": {"stages": 5, "paths": 256, "tolerance": 0},
    }


def test_days_close_the_water_balance(dry: dict[str, Any]) -> None:
    stand = Stand(dry, folder=CAMPAIGNS)
    days = stand.season(stand.baseline)
    assert len(days) == 119
    assert days["rain"].sum() == 280
    change = days["depletion"].diff().fillna(days["depletion"].iloc[0])
    closing = (
        days["rain"]
        + days["irrigation"]
        + change
        - days[["transpiration", "evaporation", "drainage", "runoff"]].sum(
            axis=1
        )
    )
    assert closing.abs().max() < 1e-9
    # The quantities of an evaluation are those of these days.
    found = stand.evaluate(stand.baseline).isel(plant=0)
    for name, column in {
        "water_use": "transpiration",
        "soil_evaporation": "evaporation",
        "drainage": "drainage",
        "rain": "rain",
    }.items():
        assert float(found[name]) == pytest.approx(
            days[column].sum(), rel=1e-4
        )
    assert 0.05 < float(found.water_stress) < 0.9


def test_a_function_decides_about_stress_and_irrigation(
    dry: dict[str, Any],
) -> None:
    stand = Stand(dry, folder=CAMPAIGNS)
    seen = []

    def decide(day: dict[str, Any]) -> dict[str, float] | None:
        seen.append(day)
        if day["date"] < "2011-07-01":
            return None
        return {"stress": 0.5, "irrigation": 30}

    plain = stand.season(stand.baseline).set_index("date")
    days = stand.season(stand.baseline, decide).set_index("date")
    assert [str(x.date()) for x in days.index] == [x["date"] for x in seen]
    pd.testing.assert_frame_equal(days[:"2011-06-30"], plain[:"2011-06-30"])
    later = days["2011-07-01":]
    assert (later["irrigation"] == 30).all()
    assert later["transpiration"].to_numpy() == pytest.approx(
        later["potential_transpiration"].to_numpy() / 2
    )


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        ({"stress": 2}, "stress is 2, outside 0 to 1"),
        ({"irrigation": -1}, "irrigation is -1, outside 0 to 10000"),
        ({"irigation": 1}, "'irigation'; did you mean 'irrigation'?"),
    ],
)
def test_impossible_decisions_are_refused(
    dry: dict[str, Any], answer: dict[str, float], message: str
) -> None:
    stand = Stand(dry, folder=CAMPAIGNS)
    with pytest.raises(ideotype.Error) as error:
        stand.season(stand.baseline, lambda day: answer)
    assert message in str(error.value)


def test_soil_needs_water_rain_and_growth(dry: dict[str, Any]) -> None:
    without = {k: v for k, v in dry.items() if k != "water"}
    with pytest.raises(ideotype.Error) as error:
        Stand(without, folder=CAMPAIGNS)
    assert "add [water]" in str(error.value)
    climate = {k: v for k, v in dry["climate"][0].items() if k != "rain"}
    with pytest.raises(ideotype.Error) as error:
        Stand(dry | {"climate": [climate]}, folder=CAMPAIGNS)
    assert 'rain = ["rain", "mm"]' in str(error.value)
    climate = {k: v for k, v in dry["climate"][0].items() if k != "emergence"}
    with pytest.raises(ideotype.Error) as error:
        Stand(
            dry | {"climate": [climate], "light": {"paths": 256}},
            folder=CAMPAIGNS,
        )
    assert "add emergence to [[climate]]" in str(error.value)
    wet = {k: v for k, v in dry.items() if k not in ("soil", "water")}
    stand = Stand(wet, folder=CAMPAIGNS)
    with pytest.raises(ideotype.Error) as error:
        stand.season(stand.baseline)
    assert "add [soil]" in str(error.value)


@pytest.mark.parametrize(
    ("soil", "irrigation"),
    [
        ({"depletion_fraction": 0}, {"depletion": 0}),
        ({"depletion_fraction": 1, "curve_number": 100}, {}),
        ({"total_evaporable": 0, "readily_evaporable": 0}, {}),
        ({"field_capacity": 0.1501, "wilting_point": 0.15}, {}),
        ({"root_depth": 0.1}, {"depletion": 0.5, "amount": 1000}),
        ({"root_depth": 10, "root_rate": 0.1}, {"depletion": 0.3}),
    ],
)
def test_extreme_soils_close_the_balance_without_nan(
    dry: dict[str, Any],
    soil: dict[str, float],
    irrigation: dict[str, float],
) -> None:
    stand = Stand(
        dry
        | {"soil": soil, "irrigation": irrigation}
        | {"light": {"stages": 3, "paths": 64, "tolerance": 0}},
        folder=CAMPAIGNS,
    )
    days = stand.season(stand.baseline)
    change = days["depletion"].diff().fillna(days["depletion"].iloc[0])
    lost = ["transpiration", "evaporation", "drainage", "runoff"]
    closing = (
        days["rain"] + days["irrigation"] + change - days[lost].sum(axis=1)
    )
    assert closing.abs().max() < 1e-9
    assert (days[lost] >= 0).all(axis=None)
    found = stand.evaluate(stand.baseline).isel(plant=0)
    assert -1e-12 <= float(found.water_stress) <= 1
    for name, values in found.data_vars.items():
        if values.dtype.kind == "f":
            assert np.isfinite(values).all(), name


def test_an_objective_of_grain_needs_no_table_of_photosynthesis(
    dry: dict[str, Any],
) -> None:
    tables = {
        name: table
        for name, table in dry.items()
        if name not in ("soil", "water", "photosynthesis")
    } | {"objective": {"maximise": "grain_yield"}}
    stand = Stand(tables, folder=CAMPAIGNS)
    found = stand.evaluate_one(stand.baseline)
    assert 2 < found.objectives[0, 0].mean() < 20
