# SPDX-License-Identifier: Apache-2.0
"""A report of what the program itself has written: a history, its accuracy
measured, its plants under each other's light."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from browser import run_in_browser
from real_program import output_of, write_campaign

from ideotype.analysis import open_history
from ideotype.analysis.commands import report
from ideotype.analysis.cross import read_cross
from ideotype.analysis.fidelity import read_fidelity


@pytest.fixture(scope="module")
def fidelity(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Measured on a plant of two leaves and a day of three hours, for as
    little time as the program allows."""
    folder = tmp_path_factory.mktemp("fidelity")
    campaign = write_campaign(folder, 1)
    text = campaign.read_text()
    text = text.replace("[plant]", "[plant]\norgans = []")
    text = text.replace("start = 07", "start = 11")
    campaign.write_text(text.replace("end = 20", "end = 13"))
    plant = folder / "maize.toml"
    text = plant.read_text().replace("\nleaf = 6", "\nleaf = 2")
    head, *leaves = text.split("[[leaf]]")
    plant.write_text("[[leaf]]".join([head, leaves[3], leaves[7]]))
    path = folder / "fidelity.json"
    options = ("--seconds", 0, "--tolerance", 1e-5, "--json", path)
    path.with_suffix(".txt").write_text(
        output_of("fidelity", campaign, *options)
    )
    return path


@pytest.fixture(scope="module")
def cross(own: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The best plant and the baseline under the campaign's one case."""
    campaign = own.parents[1] / "tiny.toml"
    path = tmp_path_factory.mktemp("cross") / "cross.json"
    path.write_text(
        output_of("compare", own, campaign, "--under", campaign, "--json")
    )
    return path


def test_a_comparison_is_read_from_json_or_csv(
    cross: Path, own: Path, tmp_path: Path
) -> None:
    campaign, table = own.parents[1] / "tiny.toml", tmp_path / "cross.csv"
    output_of("compare", own, campaign, "--under", campaign, "--csv", table)
    from_json, from_csv = read_cross(cross), read_cross(table)
    assert from_json.plants == from_csv.plants
    assert len(from_json.plants) == 2
    assert from_json.cases == from_csv.cases
    np.testing.assert_array_equal(from_json.mean, from_csv.mean)
    np.testing.assert_array_equal(
        from_json.standard_error, from_csv.standard_error
    )


def test_keys_to_paste_are_told_also_where_none_is_so_accurate(
    fidelity: Path,
) -> None:
    told = fidelity.with_suffix(".txt").read_text()
    value, difference = told.split("\n# ")[1:]
    assert value.startswith("value to 0.001 % is not met")
    assert difference.startswith("difference to 0.001 % is not met")
    assert re.search(r"^\[light\]\npaths = \d+$", value, re.MULTILINE)
    unmet = [
        c
        for c in json.loads(fidelity.read_text())["choices"]
        if not c["is_met"]
    ]
    assert {choice["tolerance"] for choice in unmet} >= {1e-5}
    for choice in unmet:
        assert "check" not in choice
        assert choice["combination"]["error"] > choice["tolerance"]


def test_what_the_program_measures_is_what_is_drawn(fidelity: Path) -> None:
    found = read_fidelity(fidelity)
    assert found.case == "ames_0807_762x152_all_r1"
    goals = {(front.goal, front.fields) for front in found.fronts}
    assert goals == {
        (goal, fields)
        for goal in ("value", "difference")
        for fields in ("one", "each")
    }
    for front in found.fronts:
        assert len(front.error) > 3
        assert list(front.milliseconds) == sorted(front.milliseconds)
        assert list(front.error) == sorted(front.error, reverse=True)
    for check in found.checks:
        assert 0 < check.error < 0.1 and check.milliseconds > 0


def test_a_browser_shows_the_report_of_a_real_run(
    own: Path, fidelity: Path, cross: Path, tmp_path: Path
) -> None:
    out = tmp_path / "report"
    arguments = [own, "-o", out]
    arguments += ["--fidelity", fidelity, "--cross", cross]
    assert report([str(argument) for argument in arguments]) == 0
    script = """
      for (const part of document.querySelectorAll("details"))
        part.open = true;
      const view = document.getElementById("view");
      const first = view.toDataURL();
      view.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
      return {
        faces: Number(view.dataset.faces),
        turns: view.toDataURL() !== first,
        pictures: [...document.images].map((image) => image.naturalWidth),
        text: document.body.innerText,
      };
    """
    shown, errors = run_in_browser(out / "report.html", script, tmp_path)
    assert errors == []
    # two plants: leaves of 12 x 2 faces, nine octagonal organs with a cover
    assert shown["faces"] == 2 * (10 * 24 + 9 * 16) and shown["turns"]
    figures = {path.stem for path in (out / "figures").glob("*.png")}
    assert {"fidelity", "cross", "gains", "energy"} < figures
    assert len(shown["pictures"]) == len(figures)
    assert min(shown["pictures"]) > 200
    words = re.sub(r"\s+", " ", shown["text"])
    assert "Speed for accuracy in ames_0807_762x152_all_r1" in words
    with open_history(own) as history:
        has = history.attributes
        command = history.sessions()[0].command
    for told in ("seed", "isa", "program_version", "compiler"):
        assert str(has[told]) in words
    assert command in words and str(has["git_sha"])[:12] in words
    data = json.loads(cross.read_text())
    assert len(data["plants"]) == 2 and len(data["cases"]) == 1
