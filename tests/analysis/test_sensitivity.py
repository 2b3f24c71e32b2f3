# SPDX-License-Identifier: Apache-2.0
"""Which traits matter."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from made_numbers import LEAVES

from ideotype.analysis import HistoryError, open_history
from ideotype.analysis.correlation import (
    draw_correlation,
    rank_correlation,
)
from ideotype.analysis.sensitivity import (
    Predictor,
    Sensitivity,
    centred,
    contradicted,
    draw_sensitivity,
    evaluated,
    predictors,
    regress,
    sensitivity,
)
from ideotype.analysis.study import open_study

PLANTS = 2000
NOISE = 0.5
STRAIGHT = [Predictor(gene) for gene in (0, 4, 9)]
COLUMNS = [*STRAIGHT, Predictor(3, "cos"), Predictor(3, "sin")]


@pytest.fixture(scope="module")
def plants() -> tuple[np.ndarray, np.ndarray]:
    """Traits and an objective that is 2 length_1 - length_2 plus a wave that
    is highest at an azimuth of 30 deg; the width does nothing."""
    draw = np.random.default_rng(7)
    x = draw.normal(size=(PLANTS, 3))
    azimuth = draw.uniform(0, 2 * np.pi, PLANTS)
    y = 2 * x[:, 0] - x[:, 1] + np.cos(azimuth - np.pi / 6)
    y += NOISE * draw.normal(size=PLANTS)
    angles = np.array([np.cos(azimuth), np.sin(azimuth)]).T
    return np.hstack([x, angles]), 40 + 3 * y


def test_effects_are_found_with_their_errors(
    plants: tuple[np.ndarray, np.ndarray],
) -> None:
    found = regress(COLUMNS, *plants)
    assert list(found.genes) == [0, 4, 9, 3]
    variance = 4 + 1 + 0.5 + NOISE**2
    expected = np.array([2, -1, 0, np.sqrt(0.5)]) / np.sqrt(variance)
    assert np.all(np.abs(found.effect - expected) < 4 * found.standard_error)
    error = NOISE / np.sqrt(variance * PLANTS)
    assert found.standard_error[:3] == pytest.approx([error] * 3, rel=0.1)
    assert found.explained == pytest.approx(1 - NOISE**2 / variance, abs=0.01)
    assert found.plants == PLANTS


def test_the_unit_of_a_trait_does_not_matter(
    plants: tuple[np.ndarray, np.ndarray],
) -> None:
    x, y = plants
    in_millimetres = x * np.array([1000, 1000, 1000, 1, 1])
    found = regress(COLUMNS, in_millimetres, y)
    assert found.effect == pytest.approx(regress(COLUMNS, x, y).effect)


def test_too_few_or_equal_plants_are_refused(
    plants: tuple[np.ndarray, np.ndarray],
) -> None:
    x, y = plants
    with pytest.raises(HistoryError, match="11 evaluated plants are too few"):
        regress(COLUMNS, x[:11], y[:11])
    with pytest.raises(HistoryError, match="absorb the same"):
        regress(COLUMNS, x, 0 * y)


def test_azimuths_enter_as_cosine_and_sine(finished: Path) -> None:
    with open_history(finished) as history:
        rows = history.evaluations().done
        columns, x = predictors(history.genes, rows)
    assert len(columns) == x.shape[1] == LEAVES * 5
    at = columns.index(Predictor(3, "cos"))
    assert columns[at + 1] == Predictor(3, "sin")
    azimuth = np.deg2rad(rows["leaf01_azimuth"].values)
    assert x[:, at] == pytest.approx(np.cos(azimuth))
    assert x[:, at + 1] == pytest.approx(np.sin(azimuth))
    assert x[:, 0] == pytest.approx(rows["leaf01_length"].values)


def test_independent_columns_of_many_ties_are_not_correlated() -> None:
    draw = np.random.default_rng(1)
    x, z = draw.random((2, PLANTS, 2))
    x[z < 0.9] = 0.0
    # four standard errors of a correlation of independent columns
    assert abs(rank_correlation(x)[0, 1]) < 4 / np.sqrt(PLANTS)
    # by hand: ranks 1.5 1.5 3 4 and 1 2.5 2.5 4
    tied = rank_correlation(np.array([[0, 1], [0, 2], [5, 2], [7, 9]]))
    assert tied[0, 1] == pytest.approx(3.75 / 4.5)


def test_traits_that_go_together_have_no_effect_of_their_own(
    plants: tuple[np.ndarray, np.ndarray],
) -> None:
    x, y = plants
    apart = regress(COLUMNS, x, y)
    assert apart.is_clear.all()
    assert apart.inflation == pytest.approx([1] * 4, abs=0.02)
    draw = np.random.default_rng(8)
    # variance inflation 1 / (1 - R2) = 1 + 1 / 0.2^2
    x[:, 1] = x[:, 0] + 0.2 * draw.normal(size=PLANTS)
    close = regress(COLUMNS, x, y)
    assert close.inflation[:2] == pytest.approx([26, 26], rel=0.1)
    assert list(close.is_clear) == [False, False, True, True]
    x[:, 1] = x[:, 0]
    same = regress(COLUMNS, x, y)
    assert list(same.is_clear) == [False, False, True, True]
    assert min(same.standard_error[:2]) > 1e3


def test_a_trait_at_its_bound_has_no_effect_away_from_it(
    finished: Path,
) -> None:
    """The fittest hold leaf 1's length at its upper bound; a regression that
    has it fall there is wrong about it."""
    with open_history(finished) as history:
        genes, top = history.genes, history.latest().top(10)
    found = regress_of([-1.0, 1.0, -1.0, 1.0])
    top.genome[:, 0] = genes.upper[0]
    top.genome[:, 1] = genes.upper[1]
    top.genome[:, 2] = genes.lower[2]
    top.genome[:, 3] = genes.upper[3]
    against = contradicted(found, genes, top)
    assert list(against) == [True, False, False, False]
    against = contradicted(replace(found, effect=-found.effect), genes, top)
    assert list(against) == [False, True, True, False]


def regress_of(effects: list[float]) -> Sensitivity:
    size = len(effects)
    return Sensitivity(
        np.arange(size), np.array(effects), np.full(size, 0.1), 0.9, 100,
        np.ones(size), np.ones(size, dtype=bool),
    )  # fmt: skip


def test_only_clear_effects_are_drawn(
    sweep: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with open_study(sweep) as study:
        case = study.cases()[0]
        found = sensitivity(case)
        strongest = int(np.argmax(np.abs(found.effect)))
        is_clear = found.is_clear.copy()
        is_clear[strongest] = False
        hidden = replace(found, is_clear=is_clear)
        module = "ideotype.analysis.sensitivity.sensitivity"
        monkeypatch.setattr(module, lambda _: hidden)
        left, right, _ = draw_sensitivity(case).axes
        listed = [label.get_text() for label in left.get_yticklabels()]
        assert case.genes.words(found.genes[strongest]) not in listed
        table = right.images[0].get_array().filled(np.nan)
        assert np.isnan(table).sum() == table.size - is_clear.sum()
        assert right.patch.get_hatch()
        none = replace(found, is_clear=np.zeros_like(is_clear))
        monkeypatch.setattr(module, lambda _: none)
        with pytest.raises(HistoryError, match="together too closely"):
            draw_sensitivity(case)


def test_every_row_of_the_correlation_has_its_leaf(sweep: Path) -> None:
    with open_study(sweep) as study:
        case = study.cases()[0]
        columns, _ = predictors(case.genes, evaluated(case)[0])
        figure = draw_correlation(case)
    figure.draw_without_rendering()
    axes = figure.axes[0]
    for axis in (axes.xaxis, axes.yaxis):
        shown = [t.label1.get_text() for t in axis.get_minor_ticks()]
        assert len(shown) == len(columns) > 40
        assert shown == [str(n) for n in range(1, LEAVES + 1)] * 5
        kinds = [t.label1.get_text() for t in axis.get_major_ticks()]
        assert kinds == [
            *("length", "width", "insertion angle"),
            *("cos azimuth", "sin azimuth"),
        ]


def test_differences_between_seeds_are_no_effects() -> None:
    """Seeds with longer leaves absorb more, though within a seed longer
    leaves absorb less."""
    draw = np.random.default_rng(3)
    seed = np.repeat([0, 1, 2], 100)
    length = draw.normal(size=300)
    absorbed = -length + 0.1 * draw.normal(size=300)
    length, absorbed = length + 10 * seed, absorbed + 30 * seed
    x = length[:, None]
    pooled = regress([Predictor(0)], x, absorbed)
    apart = regress([Predictor(0)], centred(x, seed), centred(absorbed, seed))
    assert pooled.effect[0] > 0.9 and apart.effect[0] < -0.9
    both = np.array([length, absorbed]).T
    assert rank_correlation(both)[0, 1] > 0.5
    assert rank_correlation(centred(both, seed))[0, 1] < -0.9
