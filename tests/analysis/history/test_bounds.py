# SPDX-License-Identifier: Apache-2.0
"""Program and package agree on the traits at a bound."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from made_history import MadeHistory
from real_program import executable, output_of, write_campaign

from ideotype.history import open_study
from ideotype.history.bounds import MARGIN, bounds_in_words, sides
from ideotype.history.genes import Genes
from ideotype.report.answer import make_answer
from ideotype.tools.commands import summary

_TRAITS = """
[plant]
baseline = "maize.toml"
bounds = "breedable"

[[traits]]
name = "some"
free = ["height", "length_profile", "leaf_plane", "azimuth"]

[objective]
maximise = "plant_height"
"""
REPLICATES = 3


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides the histories of three searches for tall plants, and the output
    of the program."""
    folder = tmp_path_factory.mktemp("bounds")
    path = write_campaign(folder, 12)
    text = path.read_text().replace(
        '[plant]\nbaseline = "maize.toml"\n', _TRAITS, 1
    )
    path.write_text(f"replicates = {REPLICATES}\n{text}")
    printed = output_of("run", path, "--out", folder)
    (folder / "told.txt").write_text(printed)
    return folder


def make_genes(**changes: Any) -> Genes:
    """Returns two genes, height and azimuth."""
    count = 2
    return Genes(
        names=("height", "azimuth"),
        traits=("height", "azimuth"),
        leaves=np.zeros(count, dtype=int),
        units=("1", "deg"),
        lower=np.array([0.7, 0.0]),
        upper=np.array([1.3, 360.0]),
        is_circular=np.array([False, True]),
        is_free=changes.get("is_free", np.array([True, True])),
    )


@pytest.mark.parametrize(
    ("height", "side"),
    [(0.7, -1), (0.713, -1), (0.726, -1), (0.731, 0), (1.269, 0), (1.271, 1)],
)
def test_values_within_a_twentieth_of_the_range_are_at_the_bound(
    height: float, side: int
) -> None:
    genome = np.array([height, 0.0])
    assert list(sides(make_genes(), genome)) == [side, 0]
    kept = make_genes(is_free=np.array([False, False]))
    assert not sides(kept, genome).any()
    assert MARGIN == 0.05


def test_program_and_package_agree_on_traits_at_bounds(folder: Path) -> None:
    document = json.loads(
        subprocess.run(
            [executable(), "status", folder, "--json"],
            capture_output=True,
            text=True,
            check=True,
        ).stdout
    )
    assert len(document["histories"]) == REPLICATES
    names = {-1: "lower", 1: "upper"}
    count = 0
    with open_study(folder) as study:
        (case,) = study.cases()
        for history, pair in case.known:
            row = pair.best.row
            side = sides(row.genes, row.genome[0])
            expected = [
                (row.genes.names[i], names[int(side[i])], row.genome[0, i])
                for i in np.flatnonzero(side)
            ]
            (one,) = (
                entry
                for entry in document["histories"]
                if Path(entry["path"]).name == history.path.name
            )
            reported = [
                (gene["gene"], gene["bound"], gene["value"])
                for gene in one["at_bounds"]
            ]
            assert reported == expected
            count += len(reported)
    assert count > 0


def test_run_status_summary_and_report_agree_on_traits_at_bounds(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with open_study(folder) as study:
        cases = study.cases()
        clause = bounds_in_words(cases)
        limits = make_answer(cases).limits
    assert clause.startswith("height is at its upper bound in ")
    assert " of 3 searches" in clause
    assert clause.endswith(("by the bound", "by these bounds"))
    lines = (folder / "told.txt").read_text().splitlines()
    # Each line of the log begins with the time.
    assert clause in lines[-3:]
    assert clause in output_of("status", folder).splitlines()
    sentence = f"{clause[:1].upper()}{clause[1:]}."
    assert summary([str(folder)]) == 0
    assert sentence in capsys.readouterr().out
    assert sentence in limits


def test_unfinished_searches_do_not_count_for_bounds(tmp_path: Path) -> None:
    made = MadeHistory(tmp_path / "case.h5")
    made.evolve(6)
    with open_study(tmp_path) as study:
        (case,) = study.cases()
        assert case.pairs and bounds_in_words([case]) == ""
    made.finish()
    made.close()
    with open_study(tmp_path) as study:
        assert "bound" in bounds_in_words(study.cases())
