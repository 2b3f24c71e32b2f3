# SPDX-License-Identifier: Apache-2.0
"""Programmes: exact results of quantitative genetics."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import norm

from ideotype import Error
from ideotype.selection import (
    Method,
    Plan,
    World,
    intensity,
    read_lines,
    response,
    simulate,
    smith_hazel,
)
from ideotype.selection.genome import (
    Founders,
    GeneticMap,
    draw_founders,
    read_founders,
)
from ideotype.selection.reach import cycles_to

TOP = Path(__file__).parents[3]
PANEL = TOP / "campaigns/lines/maize_panel.toml"


def linear_world(
    founders: Founders, weights: np.ndarray, error: np.ndarray,
    genetic: np.ndarray, heritability: float = 0.5,
) -> World:  # fmt: skip
    return World(
        founders,
        genetic,
        error,
        lambda values, draw: values @ weights,
        heritability,
        lambda mean, cycle: weights,
    )


def panel_worlds(count: int, lines: int) -> tuple[list[World], np.ndarray]:
    panel = read_lines(PANEL)
    weights = np.array([1.0, -0.5, 0.2, -1.0, -0.4, 0.1, 0]) / panel.deviation
    return [
        linear_world(
            draw_founders(panel, lines, np.random.default_rng([k, 3])),
            weights, panel.error, panel.genetic,
        )
        for k in range(count)
    ], weights  # fmt: skip


def within(
    name: str, values: np.ndarray, expected: float, errors: float = 2
) -> bool:
    """Returns whether a mean is as expected, within standard errors. `pytest
    -s` shows the numbers."""
    error = np.std(values, ddof=1) / math.sqrt(len(values))
    mean = np.mean(values)
    print(
        f"\n{name}: {mean:.4g}, standard error {error:.2g}, exact {expected:.4g}"
    )
    return bool(abs(mean - expected) < errors * error)


def test_founders_have_exactly_the_means_and_covariances() -> None:
    panel = read_lines(PANEL)
    founders = draw_founders(panel, 60, np.random.default_rng(1))
    values = founders.values(founders.alleles)
    scale = np.outer(panel.deviation, panel.deviation)
    assert values.mean(axis=0) == pytest.approx(panel.mean)
    assert np.cov(values.T) / scale == pytest.approx(
        panel.genetic / scale, abs=1e-6
    )


def test_response_of_a_linear_objective_obeys_the_breeders_equation() -> None:
    panel = read_lines(PANEL)
    worlds, weights = panel_worlds(40, 120)
    plan = Plan(cycles=1, lines=120, parents=12, crosses=12, plots=2)
    gains = []
    responses = []
    for seed, world in enumerate(worlds):
        run = simulate(world, plan, Method.smith_hazel, seed)
        gains.append(run.gain[1])
        names = [str(i) for i in range(7)]
        apart = run.loc[1, names] - run.loc[0, names]
        responses.append(apart.to_numpy(float))
    phenotypic = panel.phenotypic(2)
    index = smith_hazel(panel.genetic, phenotypic, weights)
    strength = intensity(12, 120)
    expected = response(panel.genetic, phenotypic, index, strength)
    assert within(
        "breeder's equation", np.array(gains), float(weights @ expected)
    )
    moved = np.array(responses)
    inside = [
        within(f"trait {i}", moved[:, i], expected[i], 3) for i in range(7)
    ]
    assert all(inside)
    # b = P^-1 G a: the response of the objective is i sqrt(b' P b).
    assert weights @ expected == pytest.approx(
        strength * math.sqrt(index @ phenotypic @ index)
    )


def test_selection_changes_the_frequency_of_one_locus_as_by_hand() -> None:
    """p' = p (1 - F((t - a) / s)) / selected share, with the threshold t of
    the mixture of two normal distributions."""
    effect, noise, lines, parents = 0.5, 1.0, 400, 40
    share = parents / lines
    low, high = -5.0, 5.0
    for _ in range(80):
        middle = (low + high) / 2
        kept = 0.5 * (
            norm.sf((middle - effect) / noise)
            + norm.sf((middle + effect) / noise)
        )
        low, high = (middle, high) if kept > share else (low, middle)
    expected = 0.5 * norm.sf((low - effect) / noise) / share
    alleles = np.repeat([[0], [1]], lines // 2, axis=0).astype(np.int8)
    founders = Founders(
        tuple(map(str, range(lines))), alleles, np.array([[effect]]),
        np.zeros(1), GeneticMap(np.array([0.5])),
    )  # fmt: skip
    world = linear_world(
        founders, np.ones(1), np.array([[noise**2]]),
        np.array([[effect**2]]),
    )  # fmt: skip
    plan = Plan(cycles=1, lines=lines, parents=parents, crosses=20, plots=1)
    after = [
        simulate(world, plan, Method.smith_hazel, seed).loc[1, "0"]
        for seed in range(60)
    ]
    frequency = (np.array(after) / effect + 1) / 2
    assert within("one locus", frequency, expected)


def test_nothing_is_gained_without_heritability() -> None:
    worlds, _ = panel_worlds(40, 60)
    plan = Plan(cycles=2, lines=60, parents=6, crosses=6)
    gains = []
    for seed, world in enumerate(worlds):
        blind = linear_world(
            world.founders, world.slope(np.zeros(7), 0),
            world.error, world.genetic, heritability=0,
        )  # fmt: skip
        gains.append(simulate(blind, plan, Method.objective, seed).gain[2])
    assert within("no heritability", np.array(gains), 0)
    # Traits without variance do not respond at all.
    flat = worlds[0].founders
    same = Founders(
        flat.names, flat.alleles, 0 * flat.effects, flat.origin, flat.map
    )
    world = linear_world(
        same, worlds[0].slope(np.zeros(7), 0), worlds[0].error,
        0 * worlds[0].genetic,
    )  # fmt: skip
    for method in Method:
        assert simulate(world, plan, method, 1).gain.abs().max() < 1e-9


@pytest.mark.parametrize("method", list(Method))
def test_responses_stay_below_the_sum_of_favourable_alleles(
    method: Method,
) -> None:
    (world,), weights = panel_worlds(1, 60)
    plan = Plan(cycles=15, lines=60, parents=4, crosses=4)
    run = simulate(world, plan, method, 1)
    founders = world.founders
    effects = founders.effects @ weights
    best = np.abs(effects).sum() + founders.origin @ weights
    start = (founders.values(founders.alleles) @ weights).mean()
    assert 0 < run.gain.max() < best - start
    assert 0.5 < run.inbreeding.iloc[-1] <= 1
    assert run.variance.iloc[-1] < 0.3 * run.variance[0]


def test_selection_reduces_variance_as_bulmer_expects() -> None:
    """Doubled haploids of parents that are the best tenth by their own value:
    half of the variance is between parents, where selection removes k =
    i (i - x) of it; the rest is that of gametes, less the inbreeding of ten
    founders."""
    worlds, _ = panel_worlds(20, 100)
    plan = Plan(cycles=1, lines=300, parents=10, crosses=60, plots=100)
    apart = []
    strength = intensity(10, 100)
    lost = strength * (strength - norm.ppf(0.9))
    for seed, world in enumerate(worlds):
        run = simulate(world, plan, Method.smith_hazel, seed)
        expected = (1 - lost) / 2 + (1 - run.inbreeding[1]) / 2
        apart.append(run.variance[1] / run.variance[0] - expected)
    assert within("Bulmer", np.array(apart), 0, 3)
    assert np.std(apart) < 0.3


def test_same_seed_gives_the_same_bits() -> None:
    (world,), _ = panel_worlds(1, 40)
    plan = Plan(cycles=2, lines=40, parents=4, crosses=4, untested=40)
    first, again, other = (
        simulate(world, plan, Method.genomic, seed) for seed in (1, 1, 2)
    )
    assert first.equals(again) and not first.equals(other)


def test_linked_loci_recombine_by_haldane() -> None:
    random = np.random.default_rng(1)
    genetic_map = GeneticMap.from_positions([1, 1, 2], np.array([0, 0.3, 0]))
    lines = genetic_map.doubled_haploids(
        np.zeros(3, np.int8), np.ones(3, np.int8), 4000, random
    )
    apart = np.mean(lines[:, 0] != lines[:, 1])
    assert apart == pytest.approx((1 - math.exp(-0.6)) / 2, abs=0.02)
    assert np.mean(lines[:, 1] != lines[:, 2]) == pytest.approx(0.5, abs=0.03)


def test_intensities_equal_tables() -> None:
    assert intensity(100, 1000) == pytest.approx(1.755, abs=0.003)
    assert intensity(1, 2) == pytest.approx(0.564, abs=0.05)
    assert intensity(5, 5) == 0
    with pytest.raises(Error, match="cannot be selected"):
        intensity(6, 5)


def test_cycles_to_a_gain_are_interpolated() -> None:
    assert cycles_to([0, 2, 6], 4) == 1.5
    assert cycles_to([0, 2, 6], 7) == math.inf
    assert math.isnan(cycles_to([0, 1], math.nan))


def test_impossible_plans_are_refused() -> None:
    with pytest.raises(Error, match="10 parents of 10 lines"):
        Plan(lines=10, parents=10)


def write_markers(folder: Path, genotypes: str, effect: str) -> list[Path]:
    """Writes files of two markers on a chromosome and of their effects on the
    height."""
    markers, effects = folder / "markers.csv", folder / "effects.csv"
    markers.write_text(
        "marker,chromosome,position_cM,A,B,C\n"
        f"m2,1,60,{genotypes}\nm1,1,10,0,2,2\n"
    )
    effects.write_text(f"marker,plant height\nm1,3\nm2,{effect}\n")
    return [markers, effects]


def test_own_markers_and_effects_give_the_values_of_lines(
    tmp_path: Path,
) -> None:
    height = read_lines(PANEL).select([4])
    founders = read_founders(*write_markers(tmp_path, "2,2,0", "-5"), height)
    assert founders.names == ("A", "B", "C")
    values = founders.values(founders.alleles)[:, 0]
    assert values.mean() == pytest.approx(height.mean[0])
    # Effects are half of the differences between homozygotes, in cm.
    assert values - values[0] == pytest.approx([0, 0.06, 0.16])
    apart = (1 - math.exp(-2 * 0.5)) / 2
    assert founders.map.recombination == pytest.approx([0.5, apart])


def test_faults_of_markers_and_effects_are_listed(tmp_path: Path) -> None:
    height = read_lines(PANEL).select([4])
    with pytest.raises(Error) as failure:
        read_founders(*write_markers(tmp_path, "1,2,", "-"), height)
    message = str(failure.value)
    assert "lines are inbred; write 0 or 2" in message
    assert "plant height must be finite numbers" in message
    with pytest.raises(Error, match="no column 'leaf length ear'"):
        read_founders(
            *write_markers(tmp_path, "0,2,2", "1"),
            read_lines(PANEL).select([0]),
        )
