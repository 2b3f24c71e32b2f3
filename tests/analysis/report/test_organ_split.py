# SPDX-License-Identifier: Apache-2.0
"""The gain of an optimised plant is split by evaluations without other
organs."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from real_program import output_of, run_with, write_campaign

import ideotype
from ideotype.history import open_study
from ideotype.report import organ_split
from ideotype.report.blocks import Note, Table
from ideotype.report.organ_split import (
    AS_SHIPPED,
    LEAVES_ALONE,
    Split,
    Variant,
    columns_of,
    describe_splits,
    make_variants,
    split_case,
    split_cases,
    split_gain,
    tabulate_splits,
)
from ideotype.tools.commands import report, summary

DEAD = Variant("dead_organs", "with dead organs", {}, "carbon of other organs")


def made(gain: float, count: int, noise: float, seed: int = 1) -> np.ndarray:
    """Returns the objective of baseline and plant with common noise [2,
    count]."""
    draw = np.random.default_rng(seed)
    common = draw.normal(0, 0.1, count)
    return np.array(
        [
            level + common + draw.normal(0, noise, count)
            for level in (1, 1 + gain)
        ]
    )


def test_the_gain_of_leaves_is_that_of_plants_without_other_organs(
    tiny_run: Path,
) -> None:
    with open_study(tiny_run) as study:
        (case,) = study.cases()
        found = split_case(case)
        gain = case.best_pair.gain
        plants = [x.row.genome[0] for x in (case.baseline, case.best)]
    assert isinstance(found, Split)
    first, dead, last = found.variants
    assert (first, last) == (AS_SHIPPED, LEAVES_ALONE)
    assert dead.name == "dead_organs"
    whole, same_light, alone = found.gains
    # The evaluation with all organs repeats that of the search.
    assert whole.mean == pytest.approx(gain.mean, rel=1e-4)
    assert whole.standard_error == pytest.approx(gain.standard_error, rel=1e-3)
    stand = ideotype.Stand.from_campaign(
        tiny_run.parents[1] / "tiny.toml", settings={"plant.organs": []}
    )
    seen = stand.evaluate(plants, ["stalk_fraction"], final=True)
    assert (seen.stalk_fraction == 0).all()
    values = seen.objective_by_randomisation.values[:, 0]
    whole_stand = ideotype.Stand.from_campaign(
        tiny_run.parents[1] / "tiny.toml"
    )
    reference = whole_stand.evaluate(plants[:1], [], final=True)
    assert alone.mean == pytest.approx(
        100
        * (values[1].mean() - values[0].mean())
        / reference.objective_by_randomisation.values[0, 0].mean(),
        rel=1e-4,
    )
    # The light absorbed by leaves does not depend on the carbon of other
    # organs.
    assert same_light.mean == pytest.approx(whole.mean, rel=1e-4)
    assert found.parts[1].mean == pytest.approx(same_light.mean - alone.mean)


def test_rows_with_keys_of_a_search_are_split_with_their_keys(
    tmp_path: Path,
) -> None:
    keys = '[[search.keys]]\nkey = "spacing.row"\nrange = [0.5, 1.0]\n'
    path = run_with(tmp_path, keys)
    with open_study(path) as study:
        (case,) = study.cases()
        found = split_case(case)
        gain = case.best_pair.gain
        genomes = [x.row.genome[0] for x in (case.baseline, case.best)]
    assert isinstance(found, Split)
    assert found.gains[0].mean == pytest.approx(gain.mean, rel=1e-4)
    stand = ideotype.Stand.from_history(
        path, settings=LEAVES_ALONE.settings, same_isa=False
    )
    seen = stand.evaluate(genomes, ["stalk_fraction", "lai"])
    assert (seen.stalk_fraction == 0).all()
    bare = stand.evaluate(np.array(genomes)[:, :-1], ["lai"])
    assert genomes[1][-1] != pytest.approx(0.762)
    assert seen.lai[1] != pytest.approx(bare.lai[1].item())


def test_the_history_has_the_settings_of_its_stand(tiny_run: Path) -> None:
    settings = {"plant.organs": ["stalk"], "final.randomisations": 3}
    stand = ideotype.Stand.from_history(
        tiny_run, settings=settings, same_isa=False
    )
    assert 'organs = ["stalk"]' in stand.campaign
    found = stand.evaluate(stand.baseline, [], final=True)
    assert found.sizes["randomisation"] == 3
    with pytest.raises(ideotype.InputError, match=r"plant\.organs"):
        ideotype.Stand.from_history(
            tiny_run, settings={"plant.organs": ["wing"]}
        )


def test_95_of_100_intervals_of_a_part_contain_the_truth() -> None:
    runs, hits = 2000, 0
    for seed in range(runs):
        values = [
            made(0.06, 64, 0.02, 2 * seed),
            made(0.01, 64, 0.02, 2 * seed + 1),
        ]
        (part,) = split_gain([AS_SHIPPED, LEAVES_ALONE], values, "mol").parts
        hits += abs(part.mean - 5) < 1.96 * part.standard_error
    # The tolerance is four standard errors of a frequency of 0.95; it also
    # covers the bias of ratios.
    assert abs(hits / runs - 0.95) < 4 * np.sqrt(0.95 * 0.05 / runs)


def test_common_noise_leaves_the_difference() -> None:
    one = made(0.06, 64, 0.02)
    (part,) = split_gain([AS_SHIPPED, LEAVES_ALONE], [one, one], "mol").parts
    assert (part.mean, part.standard_error) == (0, 0)
    other = made(0.06, 64, 0.02, 2)
    apart = split_gain([AS_SHIPPED, LEAVES_ALONE], [one, other], "mol")
    errors = [x.standard_error for x in apart.gains]
    assert apart.parts[0].standard_error == pytest.approx(
        np.hypot(*errors), rel=0.3
    )


def test_parts_of_all_variants_add_up_to_the_gain() -> None:
    values = [made(gain, 64, 0.01) for gain in (0.06, 0.05, 0.01)]
    found = split_gain([AS_SHIPPED, DEAD, LEAVES_ALONE], values, "mol")
    first, *_, last = found.gains
    assert sum(x.mean for x in found.parts) == pytest.approx(
        first.mean - last.mean
    )
    two = split_gain([AS_SHIPPED, LEAVES_ALONE], values[::2], "mol")
    table, note = tabulate_splits(
        {"b": two, "a": found, "c": Note("The gain of c is not split.")}
    )
    assert isinstance(table, Table) and isinstance(note, Note)
    assert table.header == (
        "case",
        "gain with all organs [%]",
        "gain with dead organs [%]",
        "gain with leaves alone [%]",
        "by carbon of other organs [percentage points]",
        "by light of other organs [percentage points]",
    )
    assert [bool(cell) for cell in table.rows[0]] == [
        *(True, True, False, True, False, True),
    ]  # fmt: skip
    splits = {"a": found, "b": Note("not known")}
    (columns,) = columns_of(splits).values()
    assert columns["gain_by_light_of_other_organs"] == found.parts[1].mean
    assert (
        columns["gain_dead_organs_standard_error"]
        == found.gains[1].standard_error
    )


def test_organs_that_assimilate_are_also_evaluated_without() -> None:
    crop = {
        "stalk": {"height": 2.0, "capacity": 0.1, "density": 0},
        "sheath": {"length": 0.2},
        "organ": [
            {"name": "ear", "capacity": 0.1, "density": 90.0},
            {"name": "tassel", "density": 0},
        ],
    }
    plant = {"organs": ["stalk", "ear"], "baseline": crop}
    first, dead, last = make_variants({"plant": plant})
    assert (first, last) == (AS_SHIPPED, LEAVES_ALONE)
    assert dead.settings == {
        "plant.baseline.stalk.capacity": 0,
        "plant.baseline.organ": [
            {"name": "ear", "capacity": 0, "density": 0},
            {"name": "tassel", "density": 0},
        ],
    }
    crop["stalk"]["capacity"] = 0
    del crop["organ"]
    assert make_variants({"plant": plant}) == [AS_SHIPPED, LEAVES_ALONE]
    assert make_variants({"plant": {"organs": []}}) == make_variants({}) == []


def test_a_gain_over_a_loss_has_the_unit_of_the_objective() -> None:
    values = [made(0.06, 64, 0.02) - 1, made(0.01, 64, 0.02)]
    found = split_gain([AS_SHIPPED, LEAVES_ALONE], values, "mol m-2 day-1")
    assert found.unit == "mol m-2 day-1"
    assert found.gains[1].mean == pytest.approx(0.01, abs=0.02)
    assert "mol m-2 day-1" in tabulate_splits({"a": found})[0].rows[0][
        1
    ].replace("\N{NO-BREAK SPACE}", " ").replace("\N{MINUS SIGN}", "-")
    facts = {fact.name: fact.value for fact in describe_splits([found])}
    assert facts["gain by light of other organs"].endswith(" mol m-2 day-1")
    assert facts["gain with leaves alone"].endswith(" % of the gain")


def test_summary_and_report_show_the_split(
    tiny_run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with open_study(tiny_run) as study:
        splits = split_cases(study.cases())
    ((name, found),) = splits.items()
    assert isinstance(found, Split)
    cells = [x.interval_text() for x in (*found.gains, *found.parts)]
    assert summary([str(tiny_run)]) == 0
    printed = capsys.readouterr().out
    (row,) = (
        x for x in printed.splitlines() if x.count("|") == 7 and name in x
    )
    assert [
        x.strip().replace("\N{MINUS SIGN}", "-") for x in row.split("|")[2:7]
    ] == cells
    assert summary([str(tiny_run), "--no-split"]) == 0
    assert printed.splitlines()[0] in (bare := capsys.readouterr().out)
    assert "leaves alone" in printed and "leaves alone" not in bare

    assert summary([str(tiny_run), "--csv"]) == 0
    table = pd.read_csv(io.StringIO(capsys.readouterr().out))
    assert report([str(tiny_run), "-o", str(tmp_path), "--figures", name]) == 0
    for line in (table, pd.read_csv(tmp_path / "results.csv")):
        assert line.gain_leaves_alone[0] == pytest.approx(found.gains[2].mean)
        assert line.gain_by_light_of_other_organs_standard_error[
            0
        ] == pytest.approx(found.parts[1].standard_error)
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "<dt>gain with leaves alone</dt>" in page
    assert "by light of other organs [percentage points]" in page


@pytest.mark.parametrize(
    "settings",
    [
        ["objective.maximise=plant_height"],
        ["objective.maximise=[]", "objective.minimise=absorbed_par"],
        ["plant.organs=[]"],
    ],
)
def test_other_objectives_and_plants_without_organs_are_not_split(
    settings: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = [x for each in settings for x in ("--set", each)]
    output_of("run", write_campaign(tmp_path, 2), "--out", tmp_path, *words)
    assert summary([str(tmp_path), "--csv"]) == 0
    assert "leaves_alone" not in capsys.readouterr().out
    assert summary([str(tmp_path)]) == 0
    assert "leaves alone" not in capsys.readouterr().out


def test_a_search_that_has_not_ended_is_not_split(drained: Path) -> None:
    with open_study(drained) as study:
        assert split_cases(study.cases()) == {}


def test_a_plant_that_cannot_be_evaluated_again_is_named(
    tiny_run: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = Variant("broken", "with wings", {"plant.organs": ["wing"]}, "air")
    monkeypatch.setattr(
        organ_split, "make_variants", lambda _: [AS_SHIPPED, broken]
    )
    with open_study(tiny_run) as study:
        (case,) = study.cases()
        found = split_case(case)
    assert isinstance(found, Note)
    assert f"The gain of {case.name} is not split" in found.text
    assert 'plant.organs has "wing"' in found.text
