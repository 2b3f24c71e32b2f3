# SPDX-License-Identifier: Apache-2.0
"""Representative years of a record."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from ideotype import Error
from ideotype.environments import (
    Features,
    choose_representatives,
    read_features,
)
from ideotype.tools.environments import main

CAMPAIGNS = Path(__file__).parents[3] / "campaigns"
TEXT = """
name = "years"
[[site]]
name = "bondville"
latitude = 40.05
longitude = -88.37
utc_offset = -6
[[climate]]
file = "{folder}/bondville_{{year}}_0501_0930.csv"
from = 2011-05-01
to = 2011-09-30
emergence = 2011-05-15
years = [2011, 2012]
time = ["time"]
stamp = "middle"
global = ["ppfd_umol", "umol/m2/s"]
temperature = ["temp_c", "C"]
humidity = ["rh", "1"]
[[spacing]]
row = 0.762
density = 7.5
[plant]
baseline = "{crop}"
[objective]
over = ["climate"]
[stop]
generations = 5
"""


@pytest.fixture
def campaign(tmp_path: Path) -> Path:
    path = tmp_path / "years.toml"
    path.write_text(
        TEXT.format(
            folder=CAMPAIGNS / "weather",
            crop=CAMPAIGNS / "crops" / "maize_hybrid.toml",
        )
    )
    return path


def made_features(groups: int = 3, size: int = 8) -> Features:
    """Returns groups of similar climates."""
    draw = np.random.default_rng(1)
    middles = draw.normal(0, 10, (groups, 5))
    values = np.repeat(middles, size, 0) + draw.normal(
        0, 0.3, (groups * size, 5)
    )
    names = [f"y_{1990 + i}" for i in range(len(values))]
    return Features(pd.DataFrame(values, names, list("abcde")))


def test_each_group_of_similar_years_has_a_representative() -> None:
    chosen = choose_representatives(made_features(), 3)
    groups = {(int(name[2:]) - 1990) // 8 for name in chosen.names}
    assert groups == {0, 1, 2}
    assert chosen.weights == pytest.approx([1 / 3] * 3)
    assert chosen.kept > 0.99
    # With equal weights of equal groups little is lost.
    assert chosen.loss["shift"].abs().max() < 0.05


def test_more_representatives_keep_more() -> None:
    features = made_features(groups=10, size=3)
    kept = [choose_representatives(features, k).kept for k in (1, 3, 8, 30)]
    assert kept == sorted(kept)
    assert kept[-1] == pytest.approx(1)
    everything = choose_representatives(features, 30)
    assert everything.loss["shift"].abs().max() < 1e-9


def test_impossible_numbers_are_refused() -> None:
    with pytest.raises(Error, match="from 1 to 24"):
        choose_representatives(made_features(), 25)


def test_features_are_those_of_the_weather(campaign: Path) -> None:
    features = read_features(campaign)
    assert list(features.values.index) == ["2011", "2012"]
    assert features.missing == ("rain",)
    # The mean of the file over the days from emergence to maturity.
    table = pd.read_csv(CAMPAIGNS / "weather" / "bondville_2012_0501_0930.csv")
    days = table.groupby(table["time"].str[:10])["ppfd_umol"].mean()
    phases = [
        features.values.loc["2012", f"PAR [MJ m-2 d-1], {phase}"]
        for phase in ("before flowering", "flowering", "filling")
    ]
    # 1 J of PAR is about 4.57 umol.
    usual = days["2012-05-15":"2012-09-01"].mean() * 86400 / 4.57e6
    assert np.mean(phases) == pytest.approx(usual, rel=0.1)
    hot = "temperature [deg C], flowering"
    assert features.values.loc["2012", hot] > features.values.loc["2011", hot]


def test_a_campaign_of_the_chosen_years_is_written(
    campaign: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    written = campaign.with_name("some.toml")
    arguments = [str(campaign), "--count", "1", "--to", str(written)]
    assert main(arguments) == 0
    text = capsys.readouterr().out
    climate = tomllib.loads(written.read_text())["climate"][0]
    assert climate["weights"] == [1]
    assert f"years = {climate['years']}" in text
    assert list(read_features(written).values.index) == [
        str(climate["years"][0])
    ]
    # Nothing is overwritten.
    assert main(arguments) == 4
    assert "exists" in capsys.readouterr().err
    assert main([str(campaign), "--count", "2", "--json"]) == 0
    chosen = json.loads(capsys.readouterr().out)
    assert chosen["weights"] == [0.5, 0.5]
    assert chosen["kept_variance"] == pytest.approx(1)
    assert main([str(campaign), "--count", "3"]) == 3
