# SPDX-License-Identifier: Apache-2.0
"""The importance of a trait is the loss of the best plant if the trait is
changed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import ideotype
from ideotype.figures.importance import Change, draw_importance, get_answer
from ideotype.figures.season import choose_stages, sum_weeks
from ideotype.history.estimate import Estimate
from ideotype.report.importance import evaluate_changes


def test_changes_are_paired_and_of_one_trait(tiny_run: Path) -> None:
    with ideotype.open_study(tiny_run) as study:
        (case,) = study.cases()
        changes = evaluate_changes(case)
        genes = case.genes
        best, baseline = (x.row.genome[0] for x in (case.best, case.baseline))
        figure = draw_importance(case, changes)
    assert len(changes) == len({change.trait for change in changes}) > 1
    assert [x.back.mean for x in changes] == sorted(
        (x.back.mean for x in changes), reverse=True
    )
    # The first change is evaluated again in an independent stand.
    first = changes[0]
    plant = best.copy()
    columns = genes.columns(first.trait)
    plant[columns] = baseline[columns]
    stand = ideotype.Stand.from_history(tiny_run, same_isa=False)
    found = np.concatenate(
        [
            stand.evaluate(
                [best, plant, baseline], [], generation=1_000_000 + k
            ).objective_by_randomisation.values[:, 0]
            for k in range(16)
        ],
        axis=1,
    )
    loss = 100 * (found[0] - found[1]) / found[2].mean()
    assert first.back.mean == pytest.approx(loss.mean())
    error = loss.std(ddof=1) / np.sqrt(len(loss))
    assert first.back.standard_error == pytest.approx(error)
    apart = 100 * np.hypot(*found[:2].std(axis=1, ddof=1)) / found[2].mean()
    assert error < apart / np.sqrt(len(loss))
    ticks = figure.axes[0].get_yticklabels()
    assert ticks[0].get_text() == first.trait.replace("_", " ")


def test_the_sentence_claims_only_significant_effects() -> None:
    noise = Change("width", Estimate(0.3, 0.2), Estimate(0.1, 0.2))
    assert get_answer([noise]).startswith("No single trait")
    clear = Change("length", Estimate(2.0, 0.2), Estimate(0.5, 0.2))
    assert get_answer([clear, noise]).startswith(
        "Largest loss if one trait is set to the baseline: length (2.00 ± 0.39 "
        "percentage points). Length is the most sensitive trait: an error of "
        "10 % or 10° costs 0.50 ± 0.39 percentage points."
    )


def test_weeks_are_sums_of_days() -> None:
    days, rates = np.array([0.0, 10.0, 20.0]), np.array([0.0, 1.0, 1.0])
    weeks = sum_weeks(days, rates, 20.0)
    # The rate rises from 0 to 1 over ten days and then stays at 1 for ten
    # days.
    assert weeks.sum() == pytest.approx(15)
    assert weeks[0] == pytest.approx(0.5 * 7 * 0.7)
    assert weeks[2] == pytest.approx(6)
    assert choose_stages(10)[0] == 0 and choose_stages(10)[-1] == 9
    assert len(choose_stages(10)) == 8 and choose_stages(3) == [0, 1, 2]
