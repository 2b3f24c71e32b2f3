# SPDX-License-Identifier: Apache-2.0
"""The decision of a report, from a search to the printed page."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from real_program import CAMPAIGNS, output_of

from ideotype.decision import Decision, read_options
from ideotype.history import open_study
from ideotype.report.blocks import Table
from ideotype.report.decision_section import (
    decide_case,
    make_decision_section,
)
from ideotype.report.page import render

SETTINGS = (
    'site=[{name="ames", latitude=42.0, longitude=-93.6, utc_offset=-5, '
    'weather="weather/maize_belt/ames.csv"}]',
    'search.optimizer="ga"',
    "search.population=4",
    "stop.generations=2",
    "light={paths=32, randomisations=4, stages=4, dates=1}",
    "final={candidates=1, paths=32, randomisations=4}",
)


@pytest.fixture(scope="module")
def priced_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Returns the folder of a search for the margin of three years."""
    folder = tmp_path_factory.mktemp("priced")
    words = [x for setting in SETTINGS for x in ("--set", setting)]
    campaign = CAMPAIGNS / "maize_belt.toml"
    output_of("run", campaign, "--out", folder, *words)
    return folder


def test_parts_of_rows_make_up_their_margins(priced_run: Path) -> None:
    with open_study(priced_run) as study:
        (case,) = study.cases()
        options = read_options(case)
        rows = case.histories[0].evaluations().done
    assert options.environments == ("made_2084", "made_2090", "made_2094")
    stored = rows.quantities["margin_by_scenario"].values
    assert options.margins() == pytest.approx(stored, abs=1e-6)
    values = rows.quantities["margin"].values
    assert options.values() == pytest.approx(values, abs=1e-6)
    assert np.count_nonzero(options.is_baseline) == 1
    assert list(options.keys(0)) == ["spacing.row", "spacing.density"]


def test_a_decision_is_reproducible_and_fits_a_page(priced_run: Path) -> None:
    with open_study(priced_run) as study:
        (case,) = study.cases()
        first, again = decide_case(case), decide_case(case)
    assert isinstance(first, Decision) and isinstance(again, Decision)
    assert np.array_equal(first.draws, again.draws)
    section = make_decision_section([first])
    tables = [x for x in section.blocks if isinstance(x, Table)]
    assert len(tables[0].rows) == len(first.names)
    assert [row[0] for row in tables[1].rows] == list(first.environments)
    page = render("Decision", "", [section])
    assert "margin per hectare" in page and "spacing.density" in page
