# SPDX-License-Identifier: Apache-2.0
"""Genetic parameters: simulated trials with known covariances."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from ideotype import Error
from ideotype.selection import (
    estimate,
    make_trial,
    read_lines,
    read_trial,
)
from ideotype.selection.covariances import (
    draw_covariances,
    make_semidefinite,
    mean_products,
)

TOP = Path(__file__).parents[3]
PANEL = TOP / "campaigns/lines/maize_panel.toml"
G = np.array([[1, 0.5, -0.4], [0.5, 1, 0.1], [-0.4, 0.1, 1]])
E = np.diag([0.8, 1.2, 2.0])


def simulated(
    random: np.random.Generator, lines: int, plots: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns values, lines and blocks of plots of a trial in complete
    blocks."""
    values = np.repeat(
        random.multivariate_normal(np.zeros(3), G, lines), plots, axis=0
    )
    values = values + random.multivariate_normal(np.zeros(3), E, lines * plots)
    line = np.repeat(np.arange(lines), plots)
    block = np.tile(np.arange(plots), lines)
    return values + block[:, None], line, block


def test_mean_products_equal_analysis_of_variance_by_hand() -> None:
    values, line, block = simulated(np.random.default_rng(1), 30, 2)
    parts = mean_products(values, line, block)
    cells = values.reshape(30, 2, 3)
    centred = cells - cells.mean(axis=0)
    means = centred.mean(axis=1)
    rest = (centred - means[:, None]).reshape(60, 3)
    between = 2 * means.T @ means / 29
    within = rest.T @ rest / 29
    assert parts.between == pytest.approx(between)
    assert parts.within == pytest.approx(within)
    assert parts.genetic == pytest.approx((between - within) / 2)


def covered(trials: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Returns how many 95 % intervals of each element of G include it, by
    draws of mean products and by a bootstrap of lines (percentiles)."""
    random = np.random.default_rng(seed)
    upper = np.triu_indices(3)
    drawn, resampled = np.zeros((2, 6))
    for _ in range(trials):
        values, line, block = simulated(random, 40, 2)
        parts = mean_products(values, line, block)
        draws, _ = draw_covariances(parts, 400, random)
        plots = values.reshape(40, 2, 3)
        again = []
        for _ in range(200):
            some = plots[random.integers(0, 40, 40)].reshape(80, 3)
            again.append(mean_products(some, line, block).genetic)
        for count, sample in ((drawn, draws), (resampled, np.array(again))):
            low, high = np.quantile(sample, [0.025, 0.975], axis=0)
            count += ((low <= G) & (high >= G))[upper]
    return drawn, resampled


def test_intervals_of_g_cover_the_truth() -> None:
    """30 trials of 40 lines, six elements: 95 % of 180 are 171; three standard
    errors of dependent elements are some 18."""
    drawn, _ = covered(30, 2)
    assert 153 <= drawn.sum() <= 180


@pytest.mark.long
def test_intervals_of_g_cover_the_truth_in_90_to_99_of_100_trials() -> None:
    """A bootstrap of lines, the usual alternative, is too narrow."""
    drawn, resampled = covered(100, 3)
    print(
        "\nof 100 intervals of each element of G, those that include it: "
        f"draws {drawn}, bootstrap of lines {resampled}"
    )
    assert drawn.min() >= 90 and drawn.max() <= 99
    assert resampled.min() < 90 and resampled.sum() < drawn.sum()


def test_semidefinite_g_is_unchanged_and_other_g_is_not_negative() -> None:
    assert make_semidefinite(G, G + E) == pytest.approx(G)
    wrong = np.array([[1, 1.5, 0], [1.5, 1, 0], [0, 0, 1]])
    fixed = make_semidefinite(wrong, wrong + 2 * np.eye(3))
    assert np.linalg.eigvalsh(fixed).min() > -1e-12
    assert fixed[2] == pytest.approx(wrong[2])


def test_the_shipped_trial_is_drawn_by_its_seed() -> None:
    panel = read_lines(PANEL).select(range(5))
    text = make_trial(panel, 40, 2, 1).to_csv(index=False)
    shipped = (TOP / "campaigns/lines/made_trial.csv").read_text()
    rows = [x for x in shipped.splitlines() if not x.startswith("#")]
    assert "\n".join(rows) + "\n" == text


@pytest.fixture(scope="module")
def trial_path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("trial") / "trial.csv"
    make_trial(read_lines(PANEL), 60, 2, 5).to_csv(path, index=False)
    return path


def test_reml_equals_analysis_of_variance_in_complete_blocks(
    trial_path: Path,
) -> None:
    trial = read_trial(trial_path)
    found = estimate(trial, draws=100)
    names = [trait.name for trait in trial.traits]
    lines = trial.lines
    parts = mean_products(
        trial.table[names].to_numpy(),
        np.array([lines.index(x) for x in trial.table["line"]]),
        trial.table["replicate"].astype(int).to_numpy(),
    )
    between, within = np.diag(parts.genetic), np.diag(parts.within)
    assert (between > 0).all()
    assert found.heritability[0] == pytest.approx(
        between / (between + within / 2), abs=0.005
    )
    assert found.plots == pytest.approx(2)
    assert (found.heritability_standard_error > 0.01).all()


def test_missing_plots_change_estimates_little(trial_path: Path) -> None:
    whole = estimate(read_trial(trial_path), draws=20)
    rows = trial_path.read_text().splitlines()
    for i in (5, 40, 77):
        cells = rows[i].split(",")
        rows[i] = ",".join([*cells[:3], "NA", *cells[4:]])
    path = trial_path.with_name("holes.csv")
    path.write_text("\n".join(rows))
    holes = estimate(read_trial(path), draws=20)
    error = whole.genetic_standard_error
    assert (np.abs(holes.genetic - whole.genetic) < error).all()
    assert not np.array_equal(holes.genetic, whole.genetic)


def test_means_of_lines_take_heritabilities_from_the_literature(
    trial_path: Path,
) -> None:
    rows = trial_path.read_text().splitlines()
    path = trial_path.with_name("means.csv")
    path.write_text("\n".join(rows[:61]))
    found = estimate(read_trial(path), draws=50)
    assert found.is_heritability_assumed
    assert found.heritability[0, 4] == 0.90
    assert "assumed" in found.notes[0]


def test_too_few_lines_for_the_traits_are_refused(trial_path: Path) -> None:
    rows = trial_path.read_text().splitlines()
    few = [r for r in rows if r.startswith(("line", "made00", "made01"))]
    few = [r for r in few if r[:7] < "made007"]
    path = trial_path.with_name("few.csv")
    path.write_text("\n".join(few))
    with pytest.raises(Error, match="too few for 7 traits"):
        estimate(read_trial(path))


def test_files_of_lines_give_their_covariances() -> None:
    found = read_lines(PANEL, count=281, draws=50)
    assert found.deviation[3] == pytest.approx(13.1, rel=1e-3)
    both = found.deviation[0] * found.deviation[1]
    assert found.genetic[0, 1] / both == pytest.approx(0.51, abs=0.01)
    assert found.lines == ("B73",)
    assert np.isfinite(found.genetic_standard_error).all()
    unknown = read_lines(PANEL)
    assert np.isnan(unknown.genetic_standard_error).all()
    with pytest.raises(Error, match="no file of lines"):
        read_lines(TOP / "campaigns/quickstart.toml")
