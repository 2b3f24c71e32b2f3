# SPDX-License-Identifier: Apache-2.0
"""The expected value of the best plant of a generation agrees with known
values and with the program."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from made_history import MadeHistory
from real_program import executable, write_campaign

from ideotype.history import open_history
from ideotype.history.rows import Rows
from ideotype.history.shrinkage import shrunken
from ideotype.live.runs import summarise_case

DRAWS = 8


@pytest.fixture(scope="module")
def rows(tmp_path_factory: pytest.TempPathFactory) -> Rows:
    """Provides twelve rows of a generation, with values that tests replace."""
    path = tmp_path_factory.mktemp("made") / "a.h5"
    made = MadeHistory(path)
    made.evolve(1)
    made.close()
    with open_history(path) as history:
        return history.evaluations(0).done


def noisy(
    rows: Rows, random: np.random.Generator, noise: float, shared: float
) -> np.ndarray:
    """Sets the values of rows to known values plus partly shared noise, and
    returns the known values."""
    n = len(rows)
    values = 10 + random.normal(size=n)
    scale = np.sqrt(DRAWS)
    draws = (
        values[:, None]
        + shared * scale * random.normal(size=DRAWS)
        + noise * scale * random.normal(size=(n, DRAWS))
    )
    rows.objectives[:, 0] = draws.mean(axis=1)
    rows.objectives_standard_error[:, 0] = draws.std(axis=1, ddof=1) / scale
    object.__setattr__(rows, "randomisations", draws[:, None, :])
    return values


@pytest.mark.parametrize("noise", [0.3, 1.0])
@pytest.mark.parametrize("shared", [0.0, 0.5])
def test_shrinkage_removes_the_bias_of_the_best(
    rows: Rows, noise: float, shared: float
) -> None:
    random = np.random.default_rng(7)
    raw, expected, errors = [], [], []
    for _ in range(1500):
        values = noisy(rows, random, noise, shared)
        best = int(rows.objectives[:, 0].argmax())
        estimate = shrunken(rows, best)
        raw.append(rows.objectives[best, 0] - values[best])
        expected.append(estimate.mean - values[best])
        errors.append(estimate.standard_error)
    assert np.mean(raw) > 0.3 * noise
    assert abs(np.mean(expected)) < 0.2 * np.mean(raw)
    covered = np.mean(np.abs(expected) < 2 * np.array(errors))
    assert covered == pytest.approx(0.96, abs=0.035)


def test_shrinkage_ignores_plants_that_violate_constraints(rows: Rows) -> None:
    noisy(rows, np.random.default_rng(1), 1.0, 0.0)
    fewer = rows.take(np.arange(1, len(rows)))
    expected = shrunken(fewer, 3)
    rows.violation[0] = 1.0
    rows.objectives[0, 0] = 1e6
    assert shrunken(rows, 4) == expected
    rows.violation[0] = 0.0


def test_exact_rows_are_not_shrunken_and_few_rows_have_their_mean(
    rows: Rows,
) -> None:
    noisy(rows, np.random.default_rng(1), 0.0, 0.0)
    assert shrunken(rows, 2).mean == pytest.approx(rows.objectives[2, 0])
    noisy(rows, np.random.default_rng(1), 1.0, 0.0)
    three = rows.take(np.arange(3))
    found = shrunken(three, 1)
    assert found.mean == pytest.approx(three.objectives[:, 0].mean())
    assert found.standard_error > 0.3


def test_the_gain_of_a_running_case_is_shrunken(tmp_path: Path) -> None:
    """A running case shows the expected gain, marked as provisional; a
    finished case shows the gain of the finalists."""
    made = MadeHistory(tmp_path / "a.h5")
    made.evolve(3)
    with open_history(tmp_path / "a.h5") as history:
        status, pair = summarise_case(history), history.comparison()
    assert pair and not status["is_final"]
    assert status["best"][0] < pair.best.objective.mean
    assert status["gain"][0] < pair.gain.mean
    made.finish()
    made.close()
    with open_history(tmp_path / "a.h5") as history:
        status, pair = summarise_case(history), history.comparison()
    assert pair and status["is_final"]
    assert status["gain"][0] == pair.gain.mean
    assert status["gain"][1] == pytest.approx(1.96 * pair.gain.standard_error)


def test_program_and_package_shrink_alike(tmp_path: Path) -> None:
    campaign = write_campaign(tmp_path, 4000)
    done = subprocess.run(
        [executable(), "run", campaign, "--out", tmp_path, "--wall-time", "1"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 5, done.stdout + done.stderr
    assert "best about " in done.stdout
    (path,) = (tmp_path / "tiny").glob("*.h5")
    status = subprocess.run(
        [executable(), "status", path, "--json"],
        capture_output=True,
        text=True,
        check=False,
    )
    (case,) = json.loads(status.stdout)["histories"]
    with open_history(path) as history:
        rows = history.latest().done
        estimate = shrunken(rows, int(rows.ranking(1)[0]))
        shown = summarise_case(history)
    assert case["best"]["mean"] == pytest.approx(estimate.mean, rel=1e-9)
    error = case["best"]["standard_error"]
    assert error == pytest.approx(estimate.standard_error, rel=1e-9)
    assert shown["best"] == pytest.approx([estimate.mean, error])
    assert not shown["is_final"]
