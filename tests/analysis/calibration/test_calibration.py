# SPDX-License-Identifier: Apache-2.0
"""Small calibrations of a field: the truth is found again, files are complete,
and an interrupted calibration has the same bits."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import ideotype
from ideotype.calibration import (
    Evaluations,
    Model,
    Parameter,
    calibrate,
    format_draws,
    make_observations,
    predict,
    read_observations,
)
from ideotype.tools.calibrate import main
from ideotype.validation import Measurement, shipped_facts

FIELD = shipped_facts().parent / "field.toml"
FAST = {"light.tolerance": 0, "light.paths": 64, "light.randomisations": 4,
        "field.rows": 1, "field.plants": 1, "field.variation": {},
        "plant.cells_along": 6, "day.step_minutes": 60}  # fmt: skip
SIZES = [
    Parameter("leaf.all.length", 0.8, 1.2, is_factor=True),
    Parameter("leaf.all.insertion_angle", 0.6, 1.4, is_factor=True),
]
PRIORS = """
[[parameter]]
key = "leaf.all.length"
factor = true
range = [0.8, 1.2]
"""
TABLE = """quantity,leaves,value,error,unit
lai,,4.6,0.1,m2 m-2
lai,,4.5,0.1,m2 m-2
inclination,upper,,2,deg
"""


def rows(*values: float) -> list[Measurement]:
    lai, angle = values or (1.0, 1.0)
    return [
        Measurement("lai", "m2 m-2", lai, lai, 0.05),
        Measurement("inclination", "deg", angle, angle, 1.0),
    ]


def test_the_truth_of_made_data_is_found() -> None:
    truth = np.array([[1.1, 0.8]])
    model = Model(
        make_observations(rows(), FIELD, keys=FAST), SIZES, Evaluations(None)
    )
    made = make_observations(rows(*model.evaluate(truth)[0]), FIELD, keys=FAST)
    result = calibrate(made, SIZES, design=20, has_discrepancy=False)
    summary = result.summary()
    assert result.samples.has_converged
    assert summary["mode"].to_numpy() == pytest.approx(truth[0], abs=0.02)
    assert np.all((summary.low < truth[0]) & (truth[0] < summary.high))
    assert summary.shrinkage.min() > 0.5
    errors = predict(result).errors()
    assert np.all(errors.after < errors.before / 3)


@pytest.mark.long
def test_without_an_emulator_the_posterior_is_the_same() -> None:
    made = make_observations(rows(4.5, 50), FIELD, keys=FAST)
    direct, emulated = (
        calibrate(
            made, SIZES, emulates=emulates, design=20, most_steps=steps,
            has_discrepancy=False,
        )
        for emulates, steps in ((False, 300), (True, 3000))
    )  # fmt: skip
    assert direct.emulator is None
    assert direct.mode == pytest.approx(emulated.mode, abs=0.02)
    deviation = emulated.values.std(axis=0)
    size = direct.samples.effective_size
    assert np.all(
        np.abs(direct.values.mean(axis=0) - emulated.values.mean(axis=0))
        < 4 * deviation / np.sqrt(size)
    )


def test_an_interrupted_calibration_has_the_same_bits(tmp_path: Path) -> None:
    observations = make_observations(rows(4.5, 50), FIELD, keys=FAST)
    path, other = tmp_path / "a.csv", tmp_path / "b.csv"

    def run(path: Path) -> pd.DataFrame:
        return calibrate(
            observations, SIZES, evaluations=path, design=20,
            most_steps=500,
        ).table()  # fmt: skip

    whole = run(path)
    lines = path.read_text().splitlines(keepends=True)
    other.write_text("".join(lines[:10]) + lines[10][:30])
    assert run(other).equals(whole)
    # Other threads may end first, so lines differ in their order.
    assert len(other.read_text().splitlines()) == len(lines)
    with pytest.raises(ideotype.Error, match="another calibration"):
        calibrate(observations, SIZES[:1], evaluations=path)


def test_all_problems_of_rows_are_reported(tmp_path: Path) -> None:
    table = tmp_path / "bad.csv"
    table.write_text(
        "date,hour,quantity,leaves,value,error,unit\n"
        ",,inclination,17,50,2,deg\n"
        ",,incination,,50,2,deg\n"
        ",,lai,,4,0.1,kg\n"
        ",,lai,,4,0,m2 m-2\n"
        ",,grain,,4,1,t ha-1\n"
        ",,lai,,,,\n"
        ",,transpiration,,4,1,mm day-1\n"
        ",,lai,,four,1,m2 m-2\n"
    )
    with pytest.raises(ideotype.Error) as caught:
        read_observations(table, FIELD)
    found = str(caught.value).splitlines()
    for line, words in (
        (2, "the plant has 11 leaves"),
        (3, "did you mean 'inclination'?"),
        (4, "unit 'm2 m-2' cannot be read as 'kg'"),
        (5, "error is 0"),
        (6, "computes no grain"),
        (7, "neither a value nor an error"),
        (8, "no quantity 'transpiration'"),
        (9, "value is 'four'"),
    ):
        assert any(
            x.startswith(f"{table}:{line}: ") and words in x for x in found
        ), words


def test_rows_are_held_out_by_quantity() -> None:
    many = [Measurement("lai", "m2 m-2", x, x, 0.1) for x in range(1, 9)]
    chosen = [
        make_observations(many, FIELD, hold_out=0.25, seed=seed).is_held_out
        for seed in (1, 1, 2)
    ]
    assert [x.sum() for x in chosen] == [2, 2, 2]
    assert np.array_equal(chosen[0], chosen[1])
    assert not np.array_equal(chosen[0], chosen[2])


def test_draws_are_tables_of_a_campaign(tmp_path: Path) -> None:
    parameters = [
        Parameter("photosynthesis.rate_2000", 40, 60),
        Parameter("crop.stalk.base_diameter", 0.01, 0.03),
        Parameter("leaf.all.length", 0.8, 1.2, is_factor=True),
        Parameter("crop.response.2.slope", -0.2, -0.1),
    ]
    values = np.array([[42.0, 0.02, 1.1, -0.15], [58.0, 0.025, 0.9, -0.1]])
    text, left_out = format_draws(parameters, values)
    assert left_out == ["leaf.all.length", "crop.response.2.slope"]
    path = FIELD.parent / "crops"
    campaign = tmp_path / "robust.toml"
    campaign.write_text(
        FIELD.read_text().replace('"crops/', f'"{path}/') + "\n" + text
    )
    keys = FAST | {
        "objective.maximise": "net_assimilation",
        "objective.over": ["draw"],
    }
    stand = ideotype.Stand.from_campaign(campaign, settings=keys)
    found = stand.evaluate_one(stand.start)
    (by_draw,) = [
        stand.evaluate([stand.start], [name])[name].values[0]
        for name in ("net_assimilation_by_scenario",)
    ]
    assert by_draw.shape == (2,) and by_draw[0] < by_draw[1]
    assert found.objectives[0, 0] == pytest.approx(by_draw.mean())
    # Factors and leaves alone make no draws of a campaign.
    assert format_draws(parameters[2:], values[:, 2:])[0] == ""


def test_the_command_writes_its_files(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    data, priors = tmp_path / "data.csv", tmp_path / "priors.toml"
    data.write_text(TABLE)
    priors.write_text(PRIORS)
    out = tmp_path / "out"
    fast = [x for k, v in FAST.items() if k != "field.variation"
            for x in ("--set", f"{k}={v}")]  # fmt: skip
    words = [
        str(FIELD), "--data", str(data), "--priors", str(priors), "-o",
        str(out), "--design", "12", "--draws", "3",
        "--decision", str(FIELD.parents[0] / "crops/maize_hybrid.toml"),
        "--steps", "500", *fast,
    ]  # fmt: skip
    assert main(words) in (0, 1)
    page = capsys.readouterr().out
    assert "## What the data determine" in page and "inclination" in page
    assert {x.name for x in out.iterdir()} == {
        "calibration.md", "draws", "draws.csv", "evaluations.csv",
        "parameters.csv", "parameters.png", "posterior.csv", "predicted.csv",
        "predicted.png",
    }  # fmt: skip
    drawn = pd.read_csv(out / "draws.csv")["leaf.all.length"]
    first = ideotype.Crop.from_file(out / "draws/draw001.toml")
    assert len(list((out / "draws").iterdir())) == len(drawn) == 3
    assert first.silking > 0
    # Another table is not added to the same folder, nor another file's folder.
    data.write_text(TABLE.replace("upper", "lower"))
    assert main(words) == 3
    assert "another calibration" in capsys.readouterr().err
    (tmp_path / "other").mkdir()
    (tmp_path / "other/notes.txt").write_text("mine")
    assert main([*words[:6], str(tmp_path / "other")]) == 4
