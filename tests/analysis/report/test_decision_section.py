# SPDX-License-Identifier: Apache-2.0
"""The decision of a report, from a search to the printed page."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from real_program import CAMPAIGNS, output_of

from ideotype.common.compiled import _core
from ideotype.decision import Decision, Options, Worth, read_options
from ideotype.decision.evaluate import evaluate_parts
from ideotype.history import open_study
from ideotype.report.blocks import Table
from ideotype.report.decision_section import (
    decide_case,
    make_decision_section,
)
from ideotype.report.page import render
from ideotype.stand.plants import restore_stand

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
    assert options.worths() == pytest.approx(stored, abs=1e-6)
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


DRAWS = """
[[draw]]
name = "low"
keys = ["photosynthesis.amax"]
values = [40]

[[draw]]
name = "high"
keys = ["photosynthesis.amax"]
values = [60]
"""
OVER_DRAWS = (
    'objective={maximise="net_assimilation", over=["draw"]}',
    'photosynthesis={model="hyperbola", amax=50}',
    'search.keys=[{key="field.row_pattern", values=[[], [1, 3]]}]',
    'search.optimizer="ga"',
    "search.population=4",
    "stop.generations=2",
    "light={paths=32, randomisations=4}",
    "final={candidates=1, paths=32, randomisations=4}",
)


@pytest.fixture(scope="module")
def drawn_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Returns the folder of a search over two draws, without prices."""
    folder = tmp_path_factory.mktemp("drawn")
    text = (CAMPAIGNS / "ames_quick.toml").read_text(encoding="utf-8")
    path = folder / "drawn.toml"
    path.write_text(
        text.replace('"crops/', f'"{CAMPAIGNS}/crops/') + DRAWS,
        encoding="utf-8",
    )
    words = [x for setting in OVER_DRAWS for x in ("--set", setting)]
    output_of("run", path, "--out", folder, *words)
    return folder


def test_plants_are_decided_between_by_an_objective_over_draws(
    drawn_run: Path,
) -> None:
    with open_study(drawn_run) as study:
        (case,) = study.cases()
        options = read_options(case)
        decision = decide_case(case)
        row = case.histories[0].evaluations().done
    assert options.environments == ("low", "high")
    assert options.worth == Worth.of_objective(
        "net_assimilation", "mol m-2 day-1"
    )
    stored = row.quantities["net_assimilation_by_scenario"].values
    assert np.array_equal(options.worths(), stored)
    assert isinstance(decision, Decision)
    patterns = {x for keys in decision.keys for x in keys.values()}
    assert patterns <= {"[]", "[1, 3]"}
    # More capacity, more assimilation.
    worth = decision.worth_draws().mean(-1)
    assert np.all(worth[:, 1] > worth[:, 0])
    page = render("Decision", "", [make_decision_section([decision])])
    assert "Regret" in page and "per hectare" not in page


def test_one_evaluation_has_the_parts_of_all_environments(
    drawn_run: Path, priced_run: Path
) -> None:
    with open_study(drawn_run) as study:
        (case,) = study.cases()
        options = read_options(case)
        parts = evaluate_baseline(options)
        for environment in range(2):
            by_randomisation, _ = evaluate_under(options, environment)
            assert np.array_equal(parts[environment, :, 0], by_randomisation)
    with open_study(priced_run) as study:
        (case,) = study.cases()
        options = read_options(case)
        margins = options.worth.of(evaluate_baseline(options))
        _, by_scenario = evaluate_under(options, None)
        assert margins.mean(-1) == pytest.approx(by_scenario)


def evaluate_baseline(options: Options) -> np.ndarray:
    """Returns the parts of the first option with other random numbers
    [environments, randomisations, parts]."""
    count = len(options.environments)
    return evaluate_parts(
        options.histories[0], options.genomes[0], options.worth, count, 7
    )


def evaluate_under(
    options: Options, environment: int | None
) -> tuple[np.ndarray, np.ndarray]:
    """Returns the objective of the first option by randomisation, and its
    estimate in each scenario if there is more than one."""
    genome = np.ascontiguousarray(options.genomes[0])
    stand = restore_stand(options.histories[0], genome)
    plants = _core.grown_plants(stand, genome)
    under = _core.PlantStand(stand, plants, plants.reach, environment)
    _, draws, numbers, _ = under.evaluate(0, True, 7, None)
    sizes = {axis: len(at) for axis, _, _, at in under.axes}
    counts = {
        name: int(np.prod([sizes[axis] for axis in axes]))
        for name, _, _, axes, *_ in under.quantities
    }
    name = f"{under.objectives[0][0]}_by_scenario"
    before = dict(zip(counts, np.cumsum([0, *counts.values()])))
    begin = before.get(name, 0)
    return draws[0], numbers[begin : begin + counts.get(name, 0), 0]
