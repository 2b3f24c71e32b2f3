# SPDX-License-Identifier: Apache-2.0
"""A search counts as converged only if the data exclude a relevant further
gain."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from made_history import MadeHistory
from numpy.typing import NDArray

from ideotype.figures.convergence import draw_convergence, judge_convergence
from ideotype.figures.style import get_answer
from ideotype.history import Estimate, open_study
from ideotype.history.study import Study
from ideotype.history.trend import (
    End,
    FurtherGain,
    further_gain,
    searches_differ,
    verdict,
)


def means(
    count: int, noise: float, rise: float = 0.0, seed: int = 1
) -> NDArray[np.float64]:
    """Returns population means around 11 that rise linearly."""
    draw = np.random.default_rng(seed)
    return 11 + rise * np.arange(count) + draw.normal(0, noise, count)


def find_end(
    runs: list[NDArray[np.float64]], sign: int = 1, matters: float = 0.5
) -> End:
    found = further_gain(runs, sign)
    assert found is not None
    percent = [100 * x / 11 for x in (found.mean, found.low, found.high)]
    return verdict(FurtherGain(*percent), matters)


def test_a_short_noisy_search_cannot_be_judged() -> None:
    for seed in range(20):
        assert find_end([means(13, 0.1, seed=seed)]) is not End.YES
    assert find_end([means(13, 0.1, seed=s) for s in (1, 2, 3)]) is End.UNKNOWN


def test_a_long_flat_search_has_converged() -> None:
    assert find_end([means(400, 0.02)]) is End.YES
    assert find_end([means(400, 0.02, seed=s) for s in (1, 2, 3)]) is End.YES


def test_a_rising_search_has_not_converged() -> None:
    assert find_end([means(60, 0.01, rise=0.01)]) is End.NO
    assert find_end([means(60, 0.01, rise=-0.01)], sign=-1) is End.NO


def test_a_significant_but_irrelevant_rise_has_converged() -> None:
    """As many generations again (200) would gain 0.04 of 11, or 0.36 %."""
    runs = [means(200, 1e-3, rise=2e-4)]
    found = further_gain(runs, 1)
    assert found is not None and found.low > 0
    assert find_end(runs) is End.YES
    assert find_end(runs, matters=0.3) is End.NO


def test_a_search_with_falling_means_has_not_converged() -> None:
    assert find_end([means(60, 0.01, rise=-0.01)]) is End.UNKNOWN


def test_intervals_of_the_further_gain_include_the_truth() -> None:
    """The 95 % intervals of 400 simulated searches are compared with the known
    trend."""
    count, rise = 60, 0.003
    held = 0
    for seed in range(400):
        found = further_gain([means(count, 0.05, rise, seed)], 1)
        assert found is not None
        held += found.low <= count * rise <= found.high
    assert 0.93 <= held / 400 <= 0.995


def test_correlated_residuals_widen_the_interval() -> None:
    draw = np.random.default_rng(5)
    held = 0
    count = 200
    for _ in range(200):
        values = np.zeros(count)
        for i in range(1, count):
            values[i] = 0.6 * values[i - 1] + draw.normal(0, 0.05)
        found = further_gain([values], 1)
        assert found is not None
        held += found.low <= 0 <= found.high
    assert held / 200 >= 0.9


def test_too_few_generations_have_no_trend() -> None:
    assert further_gain([means(6, 0.01)], 1) is None
    assert further_gain([], 1) is None
    assert further_gain([means(7, 0.0)], 1) is not None


def test_searches_differ_only_beyond_their_errors() -> None:
    gains = [Estimate(x, 0.5, "%") for x in (5.3, 6.9, 7.4)]
    assert searches_differ(gains, 0.65)
    assert not searches_differ(gains, 2.5)
    assert not searches_differ([Estimate(6, 1.5), Estimate(7.4, 1.5)], 0.65)
    assert not searches_differ(gains[:1], 0.5)


def summarise_case(
    folder: Path,
    optimizer: str,
    shifts: tuple[float, ...],
    baseline_shift: float = 0.0,
) -> Study:
    """Returns a study of finished searches; their gain increases by 3 % for
    each third of a unit of `shift`."""
    for k, shift in enumerate(shifts, start=1):
        made = MadeHistory(
            folder / f"made_r{k}.h5",
            attributes={"case": f"made_r{k}", "replicate": k},
            resolved=f'name = "made"\n[search]\noptimizer = "{optimizer}"',
            shift=shift,
            baseline_shift=baseline_shift,
        )
        made.evolve(4)
        made.finish()
        made.close()
    return open_study(folder)


def sentence(
    folder: Path,
    runs: list[NDArray[np.float64]],
    optimizer: str = "ga",
    shifts: tuple[float, ...] = (0.0,),
    baseline_shift: float = 0.0,
) -> str:
    """Returns the verdict on searches with the given population means."""
    with summarise_case(folder, optimizer, shifts, baseline_shift) as study:
        (case,) = study.cases()
        first = case.histories[0].generations()
        made = [
            replace(
                first,
                best_row=np.arange(len(values)),
                evaluations=np.full(len(values), 20),
                mean=replace(first.mean, values=values),
            )
            for values in runs
        ]
        return str(judge_convergence(case, made))


def test_the_verdict_states_the_possible_gain(tmp_path: Path) -> None:
    text = sentence(tmp_path, [means(13, 0.1)])
    match = re.fullmatch(
        r"Unknown: by the trend of the population mean, as many further "
        r"generations \(13\) would gain (\S+) to (\S+) % more \(95 % confidence "
        r"interval\)\.",
        text,
    )
    assert match, text
    low, high = (float(x.replace("\u2212", "-")) for x in match.groups())
    further = further_gain([means(13, 0.1)], 1)
    assert further is not None
    assert [low, high] == pytest.approx(
        [100 * further.low / 11, 100 * further.high / 11], abs=0.05
    )


@pytest.mark.parametrize(
    ("count", "noise", "rise", "begin"),
    [
        (13, 0.1, 0.0, "Unknown: by the trend"),
        (400, 0.02, 0.0, "Yes: by the trend"),
        (60, 0.01, 0.01, "No: by the trend"),
        (6, 0.01, 0.01, "Unknown: 6 generations are too few"),
    ],
)
def test_the_verdict_follows_the_evidence(
    tmp_path: Path, count: int, noise: float, rise: float, begin: str
) -> None:
    text = sentence(tmp_path, [means(count, noise, rise)])
    assert text.startswith(begin) and text.endswith(".")
    assert "-0" not in text and "nan" not in text


def test_the_default_search_states_a_tested_bound(tmp_path: Path) -> None:
    """The bound is the rise since half of the evaluations, 1.02 times."""
    few = sentence(tmp_path, [means(12, 0.1)], "auto")
    assert few.startswith("Unknown: after so few evaluations")
    rising = np.linspace(11, 11.4, 40)
    folder = tmp_path / "rising"
    folder.mkdir()
    text = sentence(folder, [rising], "auto")
    # The last fifth of 40 generations rises above that of the first 20.
    bound = 1.02 * (rising[32:].mean() - rising[16:20].mean()) / 11
    assert text == (
        "No: as many further evaluations (800) gain at most "
        f"{100 * bound:.1f} % more, in 90 % of searches."
    )
    flat = tmp_path / "flat"
    flat.mkdir()
    text = sentence(flat, [means(40, 0.02)], "auto")
    assert text.startswith("Yes: as many further evaluations (800) gain")


def test_a_baseline_near_zero_is_no_unit_of_the_bound(tmp_path: Path) -> None:
    """The bound then refers to the last populations."""
    rising = np.linspace(11, 11.4, 40)
    text = sentence(tmp_path, [rising], "auto", baseline_shift=-10.9999)
    bound = 1.02 * (rising[32:].mean() - rising[16:20].mean()) / 11.4
    assert f"gain at most {100 * bound:.1f} % more" in text


def test_searches_with_different_gains_have_not_converged(
    tmp_path: Path,
) -> None:
    flat = [means(400, 0.02, seed=s) for s in (1, 2, 3)]
    text = sentence(tmp_path, flat, shifts=(0.0, 0.1, 0.4))
    assert text.startswith("Unknown: the searches gained ")
    assert "differ by more than their errors" in text
    same = tmp_path / "same"
    same.mkdir()
    assert sentence(same, flat, shifts=(0.0, 0.0, 0.0)).startswith("Yes: ")


def test_a_random_search_has_no_trend(tmp_path: Path) -> None:
    text = sentence(tmp_path, [means(400, 0.02)], "random")
    assert text.startswith("Unknown: this search samples plants without")


def test_the_figure_has_the_sentence(tmp_path: Path) -> None:
    with summarise_case(tmp_path, "ga", (0.0,)) as study:
        assert get_answer(draw_convergence(study.cases()[0])) == (
            "Unknown: 4 generations are too few; at least 7 are needed."
        )
