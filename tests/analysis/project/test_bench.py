# SPDX-License-Identifier: Apache-2.0
"""Tests the check that a release is not slower than the last: `.ci/bench`."""

from __future__ import annotations

import importlib.machinery
import importlib.util
import math
import random
from pathlib import Path
from types import ModuleType

import pytest


def script() -> ModuleType:
    path = str(Path(__file__).parents[3] / ".ci/bench")
    loader = importlib.machinery.SourceFileLoader("bench", path)
    spec = importlib.util.spec_from_loader("bench", loader)
    assert spec
    found = importlib.util.module_from_spec(spec)
    loader.exec_module(found)
    return found


bench = script()


def test_the_interval_of_the_ratio_is_that_of_the_sign_test() -> None:
    # The interval may exclude one ratio on each side if its coverage remains
    # 95 %: with 8 pairs it would miss 2 * 9/256 = 7 %, with 9 pairs 2 * 10/512
    # = 4 %.
    ranks = {5: -1, 6: 0, 8: 0, 9: 1, 11: 1, 12: 2, 15: 3, 20: 5}
    assert {x: bench.rank_of_interval(x) for x in ranks} == ranks


def test_a_change_is_the_median_ratio_of_pairs() -> None:
    before = [1.0, 2, 4, 1, 1, 1, 1, 1, 1]
    now = [1.0, 4, 2, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6]
    # The sorted ratios are 0.5 1 1.1 1.2 1.3 1.4 1.5 1.6 2; the interval
    # excludes one on each side.
    found = bench.change(before, now)
    assert found == pytest.approx((1.3, 1, 1.6))
    assert not found.is_slower


def test_load_on_both_runs_of_a_pair_does_not_change_the_ratio() -> None:
    loads = [1, 3, 1.5, 1, 2, 1, 1, 4, 1, 1]
    now = [1.25 * x for x in loads]
    assert bench.change(loads, now).is_slower
    now[3] = 0.1
    assert bench.change(loads, now).is_slower
    now[4] = 0.1
    assert not bench.change(loads, now).is_slower


def test_a_slowdown_below_the_limit_passes() -> None:
    assert not bench.change([1.0] * 10, [bench.LIMIT] * 10).is_slower
    assert bench.change([1.0] * 10, [bench.LIMIT + 0.001] * 10).is_slower
    assert not bench.change([1.0] * 10, [0.5] * 10).is_slower


def test_intervals_of_the_ratio_have_their_coverage() -> None:
    draw = random.Random(1)
    trials, inside = 2000, 0
    for _ in range(trials):
        before, now = (
            [median * draw.lognormvariate(0, 0.2) for _ in range(10)]
            for median in (1.0, 1.1)
        )
        found = bench.change(before, now)
        inside += found.low <= 1.1 <= found.high
    # By the sign test, the coverage with ten pairs is 97.9 %.
    expected = 1 - 2 * 11 / 2**10
    error = math.sqrt(expected * (1 - expected) / trials)
    assert abs(inside / trials - expected) < 4 * error


@pytest.mark.parametrize(
    ("before", "now"),
    [
        ([1.0] * 5, [1.0] * 5),
        ([1.0] * 6, [1.0] * 7),
        ([0.0] * 6, [1.0] * 6),
        ([1.0] * 6, [math.nan] * 6),
    ],
)
def test_invalid_times_are_refused(
    before: list[float], now: list[float]
) -> None:
    with pytest.raises(ValueError, match="pairs|positive"):
        bench.change(before, now)


def test_times_are_those_of_items() -> None:
    row = {"cpu_time": 640.0, "time_unit": "us"}
    assert bench.time_of(row) == pytest.approx(640e-6)
    assert bench.time_of(row | {"items_per_second": 1e5}) == 1e-5
