# SPDX-License-Identifier: Apache-2.0
"""Tables of measured leaves are converted to crop files: units and
conventions, heights, stalks, ranks, several plants, and error messages."""

from __future__ import annotations

import json
import math
import tomllib
from pathlib import Path
from typing import Any

import pytest
from real_program import CAMPAIGNS

from ideotype import Error, InputError, Stand
from ideotype.stand.measured.leaf_tables import measured_crops
from ideotype.tools import fit

CROP = """\
name = "two_leaves"
[stalk]
height = 0.5
base_diameter = 0.02
[blade]
curvature_exponent = 1
[[leaf]]
length = 0.5
width = 0.05
insertion_angle = 40
curvature = 60
azimuth = 90
insertion_height = 0.2
[[leaf]]
length = 0.6
width = 0.06
insertion_angle = 30
curvature = 50
azimuth = 270
insertion_height = 0.4
[[organ]]
name = "ear"
leaf = 2
length = 0.2
base_diameter = 0.05
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "two.toml").write_text(CROP)
    return tmp_path


def crops(folder: Path, text: str, **more: Any) -> list[dict[str, Any]]:
    table = folder / "field.csv"
    table.write_text(text)
    more.setdefault("otherwise", tomllib.loads(CROP))
    return [each.tables for each in measured_crops(table, **more)]


def crop(folder: Path, text: str, **more: Any) -> dict[str, Any]:
    (found,) = crops(folder, text, **more)
    return found


def problems(folder: Path, text: str, **more: Any) -> list[str]:
    """Returns the lines of the error message, without the folder."""
    with pytest.raises(InputError) as raised:
        crops(folder, text, **more)
    assert len(raised.value.problems) == len(str(raised.value).splitlines())
    return str(raised.value).replace(f"{folder}/", "").splitlines()


def test_columns_have_units_and_conventions(folder: Path) -> None:
    tables = crop(
        folder,
        "# row_direction: 100\n"
        "leaf,length_cm,width_mm,insertion_angle_from_horizontal_deg,"
        "azimuth_from_north_deg,insertion_height_m\n"
        '2,70.5,65,60,20,0.9\n1,"35",45,50,190,0.25\n',
    )
    assert tables["name"] == "field"
    low, high = tables["leaf"]
    # Curvatures are taken from the crop.
    assert low == {
        "length": 0.35, "width": 0.045, "insertion_angle": 40, "azimuth": 90,
        "insertion_height": 0.25, "curvature": 60,
    }  # fmt: skip
    assert (high["length"], high["azimuth"]) == (0.705, 280)
    assert (high["insertion_angle"], high["curvature"]) == (30, 50)
    turned = crop(folder, "azimuth_from_row_counterclockwise_deg\n30\n-360\n")
    assert [leaf["azimuth"] for leaf in turned["leaf"]] == [330, 0]
    assert problems(folder, "azimuth_deg\n-30\n390\n") == [
        "field.csv:3:1: azimuth_deg is 390 (expected: -360 .. 360); check the "
        "unit and the convention of the column"
    ]


def test_heights_determine_the_curvature(folder: Path) -> None:
    # With an exponent of 1 the midrib is an arc of a circle.
    bend, first = 100, 40
    radius = 0.5 / math.radians(bend)
    sine = math.sin(math.radians(first))
    tip = 0.2 + radius * (math.sin(math.radians(first + bend)) - sine)
    for column, height in (("tip", tip), ("top", 0.2 + radius * (1 - sine))):
        found = crop(folder, f"{column}_height_mm\n{1000 * height:.6f}\n900\n")
        curvature = found["leaf"][0]["curvature"]
        assert curvature == pytest.approx(bend, abs=0.02)
    assert problems(folder, "top_height_cm\n300\n60\n")[0] == (
        "field.csv:2:1: the highest point of the leaf is at 3 m (a leaf of "
        "0.5 m that leaves the stalk at 0.2 m by 40 deg has it at 0.2569 .. "
        "0.583 m); correct one of these"
    )
    assert problems(folder, "curvature_deg,tip_height_cm\n9,50\n9,60\n") == [
        "field.csv:1:15: tip_height_cm is given twice (curvature_deg too); "
        "remove one of the columns"
    ]


def test_the_stalk_and_its_organs_move_with_the_highest_leaf(
    folder: Path,
) -> None:
    head = (
        "length_cm,width_cm,insertion_angle_deg,curvature_deg,azimuth_deg,"
        "insertion_height_cm\n"
    )
    leaf = "50,5,40,60,90,"
    tables = crop(folder, f"{head}{leaf}20\n{leaf}40\n{leaf}160\n")
    assert tables["stalk"]["height"] == pytest.approx(1.7, abs=1e-12)
    assert tables["organ"][0]["leaf"] == 3
    assert crop(folder, f"{head}{leaf}20\n")["organ"][0]["leaf"] == 1
    tables = crop(folder, "internode_cm\n30\n50\n")
    assert tables["leaf"][1]["insertion_height"] == 0.8
    assert tables["stalk"]["height"] == pytest.approx(0.9)


def test_measured_heights_and_internodes_of_soybean_agree(
    folder: Path,
) -> None:
    soybean = tomllib.loads((CAMPAIGNS / "crops" / "soybean.toml").read_text())
    for column, growth in (("insertion_height_cm", 5), ("internode_cm", 0)):
        rows = "".join(f"{5 + growth * i}\n" for i in range(12))
        tables = crop(folder, f"# crop: soybean\n{column}\n{rows}")
        leaves = tables["leaf"]
        assert leaves[11]["insertion_height"] == pytest.approx(0.6)
        assert leaves[5]["internode"] == pytest.approx(0.05)
        petiole = soybean["leaf"][5]["petiole_length"]
        assert leaves[5]["petiole_length"] == petiole
        assert "height" not in tables["stalk"]


def test_a_height_bends_a_leaf_with_a_digitised_midrib(folder: Path) -> None:
    iowa = CAMPAIGNS / "plants" / "iowa_T8.toml"
    head = f"# crop: {iowa}\n"
    lengths = crop(folder, f"{head}length_cm\n" + 10 * "60\n")
    assert all("midrib" in leaf for leaf in lengths["leaf"])
    messages = problems(folder, f"{head}tip_height_cm\n" + 10 * "60\n")
    assert messages == [
        "field.csv:2:1: there is no column for the insertion_angle of leaves "
        "(needed where digitised leaves of the crop are replaced); add "
        "insertion_angle_deg"
    ]
    angles = crop(
        folder,
        f"{head}insertion_angle_deg,curvature_deg\n" + 10 * "30,60\n",
    )
    assert all("midrib" not in leaf for leaf in angles["leaf"])


def test_all_problems_are_reported_in_one_pass(folder: Path) -> None:
    assert problems(
        folder,
        "leaf,lenght_cm,width,insertion_angle_deg,azimuth_from_north_deg,"
        "azimuth_deg\n1,30,4,200,1,30\n3,50,6,x,1,3\n3,50,6,x,1\n",
    ) == [
        "field.csv:1:6: there is no column 'lenght_cm'; did you mean "
        "'length_cm'?",
        "field.csv:1:16: column 'width' has no unit; name it width_cm",
        "field.csv:1:42: azimuth_from_north_deg needs the direction of the "
        "rows in which the plants stood (0 .. 360 deg clockwise from north); "
        "write a line such as # row_direction: 90",
        "field.csv:1:65: azimuth_deg is given twice (azimuth_from_north_deg "
        "too); remove one of the columns",
        "field.csv:2:8: insertion_angle_deg is 200 (expected: 0 .. 90); check "
        "the unit and the convention of the column",
        "field.csv:3:1: leaf 2 is missing (the lowest is 1, and ranks have no "
        "gaps); add it or renumber the leaves",
        'field.csv:3:8: insertion_angle_deg is "x" (which is no number); '
        "write one with a decimal point, or leave the column out",
        "field.csv:4:1: there are 5 entries (the table has 6 columns); give "
        "each column one",
    ]
    for text, position in (
        ("leaf;length_cm\n1;20\n", "1:1: columns are not separated by commas"),
        ("", "1:1: there are no leaves"),
        ("leaf,length_cm\n1,20\n1,30\n", "3:1: leaf 1 is given twice"),
        ("length_cm\nnan\n2_0\n", '2:1: length_cm is "nan"'),
    ):
        assert problems(folder, text)[0].startswith(f"field.csv:{position}")


def test_leaves_of_tables_are_checked_like_crop_files(folder: Path) -> None:
    assert problems(
        folder, "length_cm,width_cm,insertion_height_cm\n30,40,40\n50,5,20\n"
    ) == [
        "field.csv:2:4: leaf.width is 0.4 m (wider than its length of 0.3 m); "
        "check the units: both are in m",
        "field.csv:3:6: leaf.insertion_height is 0.2 m (below the leaf before "
        "it, at 0.4 m); list the lowest leaf first",
    ]


def test_tables_with_other_leaf_counts_need_all_measures(folder: Path) -> None:
    messages = problems(folder, "length_cm,width_cm,azimuth_deg\n30,4,90\n")
    reason = "(needed where plants do not have the 2 leaves of the crop); add "
    assert messages == [
        f"field.csv:1:1: there is no column for the {measure} of leaves "
        f"{reason}{columns}"
        for measure, columns in {
            "insertion_angle": "insertion_angle_deg",
            "curvature": "curvature_deg or tip_height_cm or top_height_cm",
            "insertion_height": "insertion_height_cm",
        }.items()
    ]


def test_unknown_columns_are_listed_once_with_the_known_ones(
    folder: Path,
) -> None:
    (problem,) = problems(
        folder, "name,height,length_cm,biomass,yield\n1,2,30,1,9\n"
    )
    assert problem.startswith(
        "field.csv:1:1: there are no columns 'name', 'height', 'biomass', "
        "'yield' (a table has one line for each leaf of a plant); columns are "
        "leaf, plant or line, length_cm/_m/_mm, width_cm/_m/_mm, "
        "insertion_angle_deg, "
    )


def test_ranks_may_begin_above_1(folder: Path) -> None:
    table = folder / "field.csv"
    table.write_text("leaf,length_cm\n6,50\n5,40\n")
    (found,) = measured_crops(table, otherwise=tomllib.loads(CROP))
    assert [leaf["length"] for leaf in found.tables["leaf"]] == [0.4, 0.5]
    assert found.remark.startswith("leaves 5 .. 6 of the table are leaves 1")
    assert problems(folder, "leaf,length_cm\n5,40\n7,50\n") == [
        "field.csv:3:1: leaf 6 is missing (the lowest is 5, and ranks have no "
        "gaps); add it or renumber the leaves"
    ]


def test_a_leaf_table_may_have_several_plants(folder: Path) -> None:
    table = "line,leaf,length_cm\nDH 1,1,40\nDH 1,2,50\nDH 2,2,70\nDH 2,1,60\n"
    first, second = crops(folder, table)
    assert (first["name"], first["leaf"][1]["length"]) == ("DH_1", 0.5)
    assert (second["name"], second["leaf"][0]["length"]) == ("DH_2", 0.6)
    assert crop(folder, table, plant="DH 1") == first
    assert crop(folder, f"# plant: DH 2\n{table}") == second
    assert problems(folder, f"# plant: DH 10\n{table}") == [
        "field.csv:2:1: there is no plant 'DH 10' (the table has DH 1, DH 2); "
        "did you mean 'DH 1'?"
    ]
    # Problems of one plant do not hide those of another.
    listed = problems(
        folder,
        "plant,leaf,length_cm,width_cm\na,1,40,x\na,2,40,5\nb,1,40,50\n"
        "b,2,40,50\nc,1,40,70\n",
    )
    assert [line.split(":")[1] for line in listed] == list("2456")


def test_a_leaf_table_may_name_its_crop(folder: Path) -> None:
    ten = "length_cm\n" + "".join(f"{50 + i}\n" for i in range(1, 11))
    tables = crop(folder, f'"# crop: maize",,\n{ten}', otherwise=None)
    maize = tomllib.loads((CAMPAIGNS / "crops" / "maize.toml").read_text())
    assert tables["organ"] == maize["organ"]
    assert tables["leaf"][9]["length"] == 0.6
    # The path of a crop file is relative to the table; the command line takes
    # precedence.
    two = "length_cm\n30\n40\n"
    named = f"# crop: two.toml\n{two}"
    assert crop(folder, named, otherwise=None)["organ"][0]["leaf"] == 2
    assert problems(folder, named, crop="maize")
    (problem,) = problems(folder, f"# crop: tow.toml\n{two}")
    assert problem.startswith("field.csv:1:9: ")
    assert problem.endswith("did you mean 'two.toml'? (named by # crop)")
    (problem,) = problems(folder, f"# crop: field.csv\n{two}")
    assert "a table of leaves is no crop" in problem
    # A problem in the crop file is reported at its line in that file.
    (folder / "two.toml").write_text(CROP.replace("0.05\n", "0.05\nx = 1\n"))
    (problem, *_) = problems(folder, named)
    assert problem.startswith("two.toml:")
    problem = "\n".join(problems(folder, f"{two}x\n", otherwise=None))
    assert "1:1: the table names no crop" in problem
    assert '4:1: length_cm is "x"' in problem


def run(*words: object) -> int:
    return fit.main([str(word) for word in words])


def test_fit_writes_a_crop_file_of_each_plant(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    trial = folder / "trial.csv"
    trial.write_text(
        "# Measured in a test.\nplant,leaf,length_cm\n"
        "A,1,40\nA,2,50\nB,1,45\nB,2,55\n"
    )
    two = folder / "two.toml"
    assert run(trial, "--crop", two, "--plant", "B", "--to", folder) == 0
    assert capsys.readouterr().out == f"2 leaves are in {folder / 'B.toml'}\n"
    # If one of the output files exists, no plant is written.
    assert run(trial, "--crop", two) == 4
    assert not (folder / "A.toml").exists()
    capsys.readouterr()
    new = folder / "new"
    assert run(trial, "--crop", two, "--to", new, "--json") == 0
    plants = json.loads(capsys.readouterr().out)
    assert [each["plant"] for each in plants] == ["A", "B"]
    text = (new / "A.toml").read_text()
    assert text.startswith(
        "# Leaves of plant A of trial.csv, by ideotype fit trial.csv --crop "
    )
    assert "\n# Measured in a test.\n" in text
    assert tomllib.loads(text)["leaf"][0]["length"] == 0.4
    assert run(trial, "--crop", two, "--to", folder / "both.toml") == 3
    assert "the table has 2 plants" in capsys.readouterr().err
    trial.write_text("plant,length_cm\nA b,40\nA b,50\nA_b,40\nA_b,50\n")
    assert run(trial, "--crop", two) == 3
    assert "2 plants have the name A_b" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        run(trial, "--crop", two, "--unit", "cm")


@pytest.mark.parametrize("name", ["Dea_2008", "F331_S1"])
def test_the_tables_of_the_project_are_baselines_of_campaigns(
    name: str, tmp_path: Path
) -> None:
    to = tmp_path / "mine.toml"
    assert run(CAMPAIGNS / "plants" / f"{name}.csv", "--to", to) == 0
    campaign = tomllib.loads((CAMPAIGNS / "ames_quick.toml").read_text())
    campaign["plant"] = {"baseline": str(to)}
    stand = Stand(campaign, folder=CAMPAIGNS)
    assert len(stand.leaves(stand.baseline)) == 11
    assert tomllib.loads(stand.campaign)["plant"]["baseline"]["name"] == name


def test_a_leaf_table_is_refused_as_baseline(tmp_path: Path) -> None:
    table = CAMPAIGNS / "plants" / "Dea_2008.csv"
    campaign = tomllib.loads((CAMPAIGNS / "ames_quick.toml").read_text())
    campaign["plant"] = {"baseline": str(table)}
    with pytest.raises(Error, match="make a crop file of it: ideotype fit"):
        Stand(campaign, folder=CAMPAIGNS)
