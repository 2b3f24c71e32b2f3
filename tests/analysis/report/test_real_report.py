# SPDX-License-Identifier: Apache-2.0
"""A report shows files that the program has written: a history, and a
cross-evaluation of its plants."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from browser import run_in_browser
from real_program import FACES, output_of

from ideotype.figures.cross import read_cross
from ideotype.history import open_history
from ideotype.tools.commands import report


@pytest.fixture(scope="module")
def cross(tiny_run: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides a cross-evaluation of the best plant and the baseline in the
    only case of the campaign."""
    campaign = tiny_run.parents[1] / "tiny.toml"
    path = tmp_path_factory.mktemp("cross") / "cross.json"
    path.write_text(
        output_of("compare", tiny_run, campaign, "--under", campaign, "--json")
    )
    return path


def test_a_comparison_is_read_from_json_or_csv(
    cross: Path, tiny_run: Path, tmp_path: Path
) -> None:
    campaign, table = tiny_run.parents[1] / "tiny.toml", tmp_path / "cross.csv"
    output_of(
        "compare", tiny_run, campaign, "--under", campaign, "--csv", table
    )
    from_json, from_csv = read_cross(cross), read_cross(table)
    assert from_json.plants == from_csv.plants
    assert len(from_json.plants) == 2
    assert from_json.cases == from_csv.cases
    np.testing.assert_array_equal(from_json.mean, from_csv.mean)
    np.testing.assert_array_equal(
        from_json.standard_error, from_csv.standard_error
    )


def test_a_browser_shows_the_report_of_a_real_run(
    tiny_run: Path, cross: Path, tmp_path: Path
) -> None:
    out = tmp_path / "report"
    arguments = [tiny_run, "-o", out, "--cross", cross]
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
    assert shown["faces"] == 2 * FACES and shown["turns"]
    figures = {path.stem for path in (out / "figures").glob("*.svg")}
    assert {"cross", "gains", "energy"} < figures
    # The figure for a paper is one further picture.
    assert len(shown["pictures"]) == len(figures) + 1
    assert min(shown["pictures"]) > 200
    words = re.sub(r"\s+", " ", shown["text"])
    with open_history(tiny_run) as history:
        has = history.attributes
        command = history.sessions()[0].command
    for attribute in ("seed", "isa", "program_version", "compiler"):
        assert str(has[attribute]) in words
    assert command in words and str(has["git_sha"])[:12] in words
    data = json.loads(cross.read_text())
    assert len(data["plants"]) == 2 and len(data["cases"]) == 1
