# SPDX-License-Identifier: Apache-2.0
"""Trials: columns in many spellings, faults in one pass, BrAPI."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from ideotype import Error
from ideotype.selection import estimate, read_trial

LINES = [f"L{i}" for i in range(1, 7)]


def write(folder: Path, text: str, name: str = "trial.csv") -> Path:
    path = folder / name
    path.write_text(text)
    return path


def table(head: str, cells: list[str]) -> str:
    """Returns a trial of six lines with the same cells in each row."""
    rows = [",".join([line, *cells]) for line in LINES]
    return "\n".join([f"line,{head}", *rows]) + "\n"


@pytest.mark.parametrize(
    ("head", "cell", "name", "value"),
    [
        ("Leaf length [cm]", "73.6", "leaf length ear", 0.736),
        ("leaf_length_mm", "736", "leaf length ear", 0.736),
        ("LeafLength (inches)", "30", "leaf length ear", 0.762),
        ("blade width in cm", "8.5", "leaf width ear", 0.085),
        ("Upper leaf angle", "32", "leaf angle top-1", 32),
        ("Flag leaf angle (°)", "32", "leaf angle top", 32),
        ("leaf angle from horizontal [deg]", "62", "leaf angle ear", 28),
        ("Leaf angle (rad)", "0.5", "leaf angle ear", 28.6479),
        ("PH (CM)", "150", "plant height", 1.5),
        ("plant height [m]", "1.5", "plant height", 1.5),
        ("plant height", "150 cm", "plant height", 1.5),
        ("Middle leaf length, cm", "73.6", "leaf length ear", 0.736),
    ],
)
def test_columns_are_read_in_many_spellings(
    tmp_path: Path, head: str, cell: str, name: str, value: float
) -> None:
    quoted = f'"{head}"' if "," in head else head
    trial = read_trial(write(tmp_path, table(quoted, [cell])))
    assert trial.traits[0].name == name
    assert trial.table[name].to_numpy() == pytest.approx(value, rel=1e-4)
    assert trial.taken["taken_for"].tolist() == ["line", name]


def test_semicolons_come_with_decimal_commas(tmp_path: Path) -> None:
    rows = [f"{line};73,6" for line in LINES]
    text = "\n".join(["genotype;leaf length (cm)", *rows])
    trial = read_trial(write(tmp_path, text))
    assert trial.table["leaf length ear"][0] == pytest.approx(0.736)


def test_missing_values_and_other_columns_are_listed(tmp_path: Path) -> None:
    text = table("colour,plant height [cm],yield", ["green", "NA", "7.1"])
    text = text.replace("L1,green,NA", "L1,green,140")
    trial = read_trial(write(tmp_path, text))
    taken = trial.taken.set_index("column")
    assert taken.loc["plant height [cm]", ["values", "missing"]].tolist() == [
        1,
        5,
    ]
    assert taken.loc["colour", "taken_for"] == "not used"
    assert taken.loc["yield", "note"] == "no measure of plants"


def test_all_faults_are_reported_in_one_pass(tmp_path: Path) -> None:
    text = """line,rep,leaf lenght [cm],leaf width,upper leaf angle [kg],plant height [cm]
A,1,70,8,30,140
A,1,71,8,31,141
a,2,72,8,30,140
B,1,70,8,30,"1,40"
C,1,70,8,30,14000
D,1,70,8,30
,1,70,8,30,140
"""
    with pytest.raises(Error) as failure:
        read_trial(write(tmp_path, text))
    message = str(failure.value)
    for words in (
        "'leaf lenght [cm]'; did you mean 'leaf length'?",
        "'leaf width' has no unit; name it 'leaf width [cm]'",
        "'kg' of 'upper leaf angle [kg]' is none of leaf angle",
        ":3: line A, replicate 1 is already in trial.csv:2",
        ":4: the line 'a' is elsewhere 'A'",
        ":5: plant height [cm] is '1,40'; give a number",
        ":6: plant height [cm] is '14000', 140 m, outside 0.05 to 6",
        ":7: this row has 5 cells and the table 6 columns",
        ":8: the line is missing",
        "the trial has 3 lines; give 5 or more",
    ):
        assert words in message


def test_unknown_names_can_be_assigned(tmp_path: Path) -> None:
    path = write(tmp_path, table("LL7", ["73.6"]))
    with pytest.raises(Error, match="no column is a measure"):
        read_trial(path)
    trial = read_trial(path, {"LL7": "leaf.length@ear+1,cm"})
    assert trial.traits[0].leaf == "ear+1"
    assert trial.table["leaf length ear+1"][0] == pytest.approx(0.736)
    with pytest.raises(Error, match="no measure 'leaf.lenght'; did you mean"):
        read_trial(path, {"LL7": "leaf.lenght,cm"})


def test_long_tables_of_field_book_equal_wide_ones(tmp_path: Path) -> None:
    rows = [
        f"{i},{line},{trait},{value}"
        for i, line in enumerate(LINES)
        for trait, value in (
            ("leaf length cm", 70 + i),
            ("plant height cm", 140 + i),
        )
    ]
    text = "\n".join(["plot_id,genotype,trait,value", *rows])
    trial = read_trial(write(tmp_path, text))
    assert trial.table["leaf length ear"].tolist() == pytest.approx(
        [0.70 + i / 100 for i in range(6)]
    )
    assert trial.table["plant height"].iloc[5] == pytest.approx(1.45)


def brapi(line: str, rep: int, name: str, value: object) -> dict[str, object]:
    """Returns an observation unit with one observation (BrAPI 2.1)."""
    return {
        "observationUnitDbId": f"{line}-{rep}",
        "observationUnitName": f"plot {line} {rep}",
        "germplasmName": line,
        "studyName": "2025",
        "observationUnitPosition": {
            "observationLevelRelationships": [
                {"levelName": "rep", "levelCode": str(rep)}
            ]
        },
        "observations": [
            {"observationVariableName": name, "value": value},
            {"observationVariableName": "Plant height cm", "value": "150"},
        ],
    }


def test_observation_units_of_brapi_become_plots(tmp_path: Path) -> None:
    data = [
        brapi(line, rep, "Leaf length (cm)", None if rep == 2 else "70.5")
        for line in LINES
        for rep in (1, 2)
    ]
    text = json.dumps({"metadata": {}, "result": {"data": data}})
    trial = read_trial(write(tmp_path, text, "trial.json"))
    assert len(trial.table) == 12 and trial.has_replicates
    assert trial.table["replicate"].tolist()[:2] == ["1", "2"]
    assert trial.table["plant height"].tolist() == pytest.approx([1.5] * 12)
    assert np.isnan(trial.table["leaf length ear"][1])


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        (5, "no response of BrAPI 2"),
        ({"result": {"data": None}}, "no response of BrAPI 2"),
        ({"result": {"data": [{}]}}, "lacks observationVariableName"),
        ({"result": {"data": [{"observations": [3]}]}}, "this is no object"),
    ],
)
def test_other_json_is_refused(
    tmp_path: Path, answer: object, words: str
) -> None:
    with pytest.raises(Error, match=words):
        read_trial(write(tmp_path, json.dumps(answer), "trial.json"))
    with pytest.raises(Error, match="no response of BrAPI 2"):
        read_trial(write(tmp_path, "{", "trial.json"))


@pytest.mark.parametrize("cell", ["NA", "70"])
def test_traits_that_do_not_vary_are_refused(
    tmp_path: Path, cell: str
) -> None:
    trial = read_trial(write(tmp_path, table("leaf length [cm]", [cell])))
    with pytest.raises(Error, match="all plots have the same leaf length ear"):
        estimate(trial)


def test_traits_that_are_never_measured_together_are_named(
    tmp_path: Path,
) -> None:
    rows = [
        f"{line},{rep},{length},{height}"
        for i, line in enumerate(LINES)
        for rep, length, height in ((1, 70 + i, "NA"), (2, "NA", 140 + i))
    ]
    text = "\n".join(["line,rep,leaf length [cm],plant height [cm]", *rows])
    with pytest.raises(Error) as failure:
        estimate(read_trial(write(tmp_path, text)))
    assert "with leaf length ear and plant height" in str(failure.value)
    assert "two plots with plant height; remove" in str(failure.value)
