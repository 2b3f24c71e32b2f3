# SPDX-License-Identifier: Apache-2.0
"""Plants are compared in the same light: values, paired differences, profiles,
measured plants and error messages."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas
import pytest
from real_program import CAMPAIGNS, output_of, write_campaign
from schemas import validator

import ideotype
from ideotype.tools import compare

MAIZE = CAMPAIGNS / "crops" / "maize.toml"
ELITE = CAMPAIGNS / "plants" / "elite.toml"
MEASURED = """\
leaf,length_cm,width_cm,insertion_angle_from_horizontal_deg,curvature_deg,\
azimuth_from_row_clockwise_deg,insertion_height_cm
1,40,4.5,40,60,90,20
2,60,6.5,45,60,270,45
3,75,8,50,60,90,70
4,80,8.5,55,50,270,95
"""


@pytest.fixture
def under(tmp_path: Path) -> Path:
    return write_campaign(tmp_path, 2)


def run(*words: object) -> int:
    return compare.main([str(word) for word in words])


def compare_to_table(folder: Path, *words: object) -> pandas.DataFrame:
    """Returns the CSV of a comparison."""
    path = folder / f"{len([*folder.glob('*.csv')])}.csv"
    assert run(*words, "--csv", path) == 0
    return pandas.read_csv(path)


def entry(
    table: pandas.DataFrame, plant: str, quantity: str, leaf: int = 0
) -> pandas.Series:
    rows = table[(table.plant == plant) & (table.quantity == quantity)]
    if leaf:
        rows = rows[rows.leaf == leaf]
    assert len(rows) == 1
    return rows.iloc[0]


def test_differences_have_paired_standard_errors(
    under: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = compare_to_table(tmp_path, MAIZE, ELITE, "--under", under)
    text = capsys.readouterr().out
    # The text fits on one screen.
    assert len(text.splitlines()) < 24
    assert max(map(len, text.splitlines())) <= 100
    assert "elite compared with b73" in text and "absorbed PAR" in text
    for quantity, leaf in (("absorbed_par", 0), ("absorbed_by_leaf", 9)):
        a, b = (entry(table, x, quantity, leaf) for x in ("b73", "elite"))
        assert b.difference == pytest.approx(b["mean"] - a["mean"], abs=1e-12)
        apart = np.hypot(a.standard_error, b.standard_error)
        assert 0 < b.difference_standard_error < 1.5 * apart
    assert entry(table, "elite", "lai").difference_standard_error == 0
    first = table.iloc[0]
    assert (first.plant, first.quantity) == ("b73", "absorbed_par")
    assert (
        run(MAIZE, ELITE, "--under", under, "--csv", tmp_path / "0.csv") == 4
    )
    assert "exists already and is not overwritten" in capsys.readouterr().err


def test_a_comparison_depends_only_on_plants_campaign_and_seed(
    under: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def printed(*words: object) -> str:
        assert run(MAIZE, ELITE, "--under", under, "--json", *words) == 0
        return capsys.readouterr().out

    output = printed()
    assert printed("--threads", 1) == printed("--threads", 3) == output
    nine = printed("--seed", 9)
    assert nine == printed("--set", "seed=9") != output
    report = json.loads(
        output_of("evaluate", under, "--set", "seed=9", "--json")
    )
    mean = report["quantities"]["absorbed_par"]["mean"]
    assert json.loads(nine)["mean"][0][0] == mean


def test_a_smaller_tolerance_takes_more_paths(
    under: Path, tmp_path: Path
) -> None:
    usual = compare_to_table(tmp_path, MAIZE, "--under", under)
    exact = compare_to_table(
        tmp_path, MAIZE, "--under", under, "--tolerance", 0.003
    )
    light = entry(exact, "b73", "absorbed_par")
    assert light.standard_error < 0.0045 * light["mean"]
    paths = (entry(x, "b73", "paths")["mean"] for x in (exact, usual))
    assert np.divide(*paths) > 2


def test_leaves_are_matched_from_the_top_for_other_leaf_counts(
    under: Path, tmp_path: Path
) -> None:
    field = tmp_path / "field.csv"
    field.write_text(MEASURED)
    table = compare_to_table(tmp_path, MAIZE, MAIZE, field, "--under", under)
    assert {*table.plant} == {"b73", "b73 (2)", "field"}
    again = table[table.plant == "b73 (2)"]
    assert (again.difference == 0).all()
    leaves = table[table.quantity == "absorbed_by_leaf"]
    own, other = (leaves[leaves.plant == x] for x in ("field", "b73"))
    assert [*own.leaf] == [1, 2, 3, 4] and len(other) == 10
    for leaf in own.itertuples():
        (match,) = other[
            other.leaf_from_top == leaf.leaf_from_top
        ].itertuples()
        assert match.leaf == leaf.leaf + 6
        assert leaf.difference == pytest.approx(leaf.mean - match.mean)


def test_plants_of_a_history_and_of_exported_files_are_equal(
    tiny_run: Path, tmp_path: Path
) -> None:
    campaign = tiny_run.parents[1] / "tiny.toml"
    files = [tmp_path / f"best.{end}" for end in ("toml", "csv")]
    for file in files:
        output_of("export", tiny_run, "--best", "--to", file)
    table = compare_to_table(tmp_path, tiny_run, *files, "--under", campaign)
    assert table.plant.nunique() == 3
    # Crop files contain all digits; the table of measured leaves contains
    # rounded values.
    rounded = table.plant == table.plant.unique()[2]
    assert (table.difference[~rounded].abs() < 1e-12).all()
    assert (table.difference_standard_error[~rounded] < 1e-12).all()
    scale = np.maximum(table["mean"].abs(), 1)
    assert (table.difference.abs() < 1e-3 * scale).all()
    digits = re.findall(r"\d+(?:\.\d+)?", files[1].read_text())
    assert (
        max(len(number.replace(".", "").lstrip("0")) for number in digits) == 6
    )


def test_weights_of_components_enter_the_objective(
    under: Path, tmp_path: Path
) -> None:
    shutil.copytree(CAMPAIGNS / "crops", tmp_path / "crops")
    beside = 'component=[{name="other",crop="crops/maize.toml",rows=[2]}]'
    light = []
    for weights in ([1, 0], [0, 1], [1, 1]):
        table = compare_to_table(
            tmp_path, MAIZE, ELITE, "--under", under, "--set", beside,
            "--set", f"objective.weights={weights}",
        )  # fmt: skip
        name = table.quantity[0]
        light.append(entry(table, "elite", name)["mean"])
    assert light[0] > 0 and light[1] > 0
    assert light[0] + light[1] == pytest.approx(light[2])


@pytest.mark.long
def test_growing_plants_are_compared_over_their_stages(
    tmp_path: Path,
) -> None:
    campaigns = shutil.copytree(CAMPAIGNS, tmp_path / "campaigns")
    campaign = campaigns / "growing_season.toml"
    settings = [
        word
        for key in (
            *("light.stages=4", "light.paths=256", "final.paths=256"),
            *("light.randomisations=4", "final.randomisations=4"),
            *("search.optimizer=ga", "search.population=6"),
            *("search.elites=2", "stop.generations=1"),
        )
        for word in ("--set", key)
    ]
    output_of("run", campaign, "--out", tmp_path, *settings)
    (history,) = (tmp_path / "growing_season").glob("*.h5")
    table = compare_to_table(
        tmp_path, campaign, history, "--under", campaign, *settings
    )
    assert table.case.nunique() == 2
    for name in ("carbon_balance", "absorbed_par", "lai"):
        for _, both in table[table.quantity == name].groupby("case"):
            a, b = (both.iloc[k] for k in (0, 1))
            assert b.difference == pytest.approx(b["mean"] - a["mean"])
            assert np.isfinite(b.difference_standard_error)


def test_several_cases_fit_on_one_screen(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    campaign = write_campaign(tmp_path, 2)
    spacings = "".join(
        f"\n[[spacing]]\nrow = 0.7{k}\nplant = 0.2\n" for k in range(5)
    )
    campaign.write_text(campaign.read_text() + spacings)
    assert run(MAIZE, ELITE, "--under", campaign) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) < 14
    assert sum("±" in line and "ames_0807" in line for line in lines) == 6
    assert run(MAIZE, ELITE, "--under", campaign, "--all") == 0
    every = capsys.readouterr().out
    assert len(every.splitlines()) > 60 and "balance error" in every


def lines_of_maize(folder: Path, count: int, step: float = 0.05) -> Path:
    """Writes a table of plants with different leaf lengths."""
    rows = [
        f"DH{k:03},{leaf},{(40 + 4 * leaf) * (0.8 + step * k):.2f}"
        for k in range(count)
        for leaf in range(1, 11)
    ]
    table = folder / "trial.csv"
    table.write_text("\n".join(["line,leaf,length_cm", *rows]) + "\n")
    return table


def ranked(text: str) -> list[str]:
    """Returns the names of plants in the order of the printed lines."""
    return re.findall(r"(?m)^(DH\d+) ", text)


def test_plants_of_a_table_are_ranked_with_a_line_each(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    campaign = write_campaign(tmp_path, 2)
    campaign.write_text(
        campaign.read_text() + "\n[[spacing]]\nrow = 0.5\nplant = 0.2\n"
    )
    table = lines_of_maize(tmp_path, 8)
    words = [table, "--under", campaign, "--tolerance", 0.004]
    assert run(*words) == 0
    text = capsys.readouterr().out
    assert max(map(len, text.splitlines())) <= 105
    names = [f"DH{k:03}" for k in range(8)]
    # Longer leaves absorb more.
    assert ranked(text) == names[::-1]
    assert "7 plants compared with DH000" in text
    assert "Reference: DH000, the first; --reference NAME." in text
    (first,) = (x for x in text.splitlines() if x.startswith("DH007"))
    assert first.count("±") == 4 and first.split().count("1") == 2
    assert "reference" in text.split("DH000 ")[-1].splitlines()[0]
    (correlation,) = re.findall(r"\(Spearman\): (\S+)\.\n", text)
    assert float(correlation) > 0.9
    assert text.count("no significant difference from DH007 in ") == 2
    # Plants may be sorted by any quantity or case, and any plant may be the
    # reference.
    assert run(*words, "--sort", "soil_fraction", "--reference", "DH003") == 0
    text = capsys.readouterr().out
    assert ranked(text) == names
    assert "compared with DH003" in text and "soil fraction" in text
    cases = [name for name, *_ in compare.make_stands(campaign, [])]
    assert run(*words, "--sort", cases[1]) == 0
    assert f"largest in {cases[1]} first" in capsys.readouterr().out
    assert run(*words, "--reference", "DH003", "--json") == 0
    report = json.loads(capsys.readouterr().out)
    validator("compare").validate(report)
    assert report["reference"] == "DH003"
    assert report["difference"]["mean"][3] == [0, 0]
    assert [row[0] for row in report["rank"]] == [8, 7, 6, 5, 4, 3, 2, 1]


def test_the_recommended_tolerance_gives_a_reliable_ranking(
    under: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = lines_of_maize(tmp_path, 6, step=0.02)

    def printed(tolerance: object) -> str:
        assert run(table, "--under", under, "--tolerance", tolerance) == 0
        return capsys.readouterr().out

    def repeatability(text: str) -> float:
        return float(re.findall(r": repeatability (\d\.\d\d);", text)[0])

    coarse = printed(0.03)
    (advice,) = re.findall(r"about --tolerance (\S+)\.\n", coarse)
    fine = printed(advice)
    assert repeatability(coarse) < 0.9 < repeatability(fine)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--sort", "absorbed_parr"), "did you mean 'absorbed_par'?"),
        (("--reference", "b37"), "there is no plant b37 to compare with"),
    ],
)
def test_the_error_names_an_unknown_plant_or_case(
    words: Sequence[str],
    message: str,
    under: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run(MAIZE, ELITE, *words, "--under", under) == 1
    assert message in capsys.readouterr().err


def test_equal_names_get_the_part_in_which_their_paths_differ(
    under: Path, tmp_path: Path
) -> None:
    for name in ("results", "long"):
        (tmp_path / name).mkdir()
        shutil.copy(MAIZE, tmp_path / name)
    files = [tmp_path / name / MAIZE.name for name in ("results", "long")]
    table = compare_to_table(tmp_path, *files, "--under", under)
    assert [*table.plant.unique()] == ["b73 (results)", "b73 (long)"]


@pytest.mark.parametrize(
    "words",
    [
        (),
        ("--seed", "-1"),
        ("--seed", "1e3"),
        ("--tolerance", "2"),
        ("--threads", "0"),
    ],
)
def test_wrong_use_is_refused(
    words: Sequence[str], under: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    given = [str(MAIZE), *words, *(("--under", str(under)) if words else ())]
    with pytest.raises(SystemExit) as ended:
        compare.main(given)
    assert ended.value.code == 2
    message = capsys.readouterr().err
    if words:
        assert f"{words[1]} (expected: " in message


def test_the_error_names_the_line_of_a_wrong_table(
    under: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    field = tmp_path / "field.csv"
    lines = MEASURED.replace("azimuth_from", "azimut_from").splitlines()
    field.write_text("\n".join(lines).replace("60,6.5", "60,65"))
    assert run(field, "--under", under) == 3
    message = capsys.readouterr().err
    assert "field.csv:3:6: width_cm is 65 (expected: 0.1 .. 50)" in message
    assert "did you mean 'azimuth" in message


def test_a_damaged_history_is_refused(
    tiny_run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    campaign = tiny_run.parents[1] / "tiny.toml"
    copy = tmp_path / "damaged.h5"
    data = bytearray(tiny_run.read_bytes())
    with ideotype.open_history(tiny_run) as history:
        genome = history.finalists().genome[1].tobytes()
    at = data.index(genome)
    data[at + 3] ^= 0x55
    copy.write_bytes(data)
    assert run(copy, "--under", campaign) == 4
    assert "does not have its checksum" in capsys.readouterr().err


def test_python_compares_genomes_and_files(under: Path) -> None:
    stand = ideotype.Stand.from_campaign(under)
    longer = stand.baseline
    longer[0] *= 1.2
    comparison = stand.compare(stand.baseline, longer, ELITE)
    assert comparison.plants == ("baseline", "plant 2", "elite")
    both = stand.evaluate([stand.baseline, longer], final=True)
    draws = both.objective_by_randomisation.values[:, 0]
    by = draws[1] - draws[0]
    row = comparison.table[
        (comparison.table.plant == "plant 2")
        & (comparison.table.quantity == "absorbed_par")
    ].iloc[0]
    assert row.difference == pytest.approx(by.mean())
    assert row.difference_standard_error == pytest.approx(
        by.std(ddof=1) / np.sqrt(len(by))
    )
    percent = 100 * by.mean() / draws[0].mean()
    assert row.percent == pytest.approx(percent)
    assert "plant 2, elite compared with baseline" in repr(comparison)
    assert comparison._repr_html_().count("<table>") == 1
    with pytest.raises(ideotype.Error, match="at least one plant"):
        stand.compare()


def test_a_stand_has_a_repr_and_draws_its_plants(under: Path) -> None:
    stand = ideotype.Stand.from_campaign(under)
    assert "maximise absorbed_par" in repr(stand)
    assert "b73, 10 leaves" in stand._repr_html_()
    leaves = stand.leaves(stand.baseline)
    assert len(leaves) == 10 and leaves.attrs["units"]["length"] == "m"
    assert leaves.length[1] == pytest.approx(0.651)
    assert len(stand.draw().axes) == 2
    assert len(stand.draw(stand.baseline, stand.baseline).axes) == 4
    assert len(stand.draw_field().axes) == 2
