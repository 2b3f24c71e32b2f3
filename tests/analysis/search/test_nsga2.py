# SPDX-License-Identifier: Apache-2.0
"""NSGA-II agrees with a published implementation."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from pymoo.algorithms.moo.nsga2 import NSGA2
from pymoo.indicators.hv import HV
from pymoo.operators.survival.rank_and_crowding.metrics import (
    calc_crowding_distance,
)
from pymoo.optimize import minimize
from pymoo.problems import get_problem
from pymoo.util.nds.non_dominated_sorting import NonDominatedSorting
from real_program import output_of, write_campaign

import ideotype
from ideotype.history import open_history


def replay(*words: object, text: str = "") -> NDArray[np.float64]:
    build = Path(os.environ["IDEOTYPE_EXECUTABLE"]).parents[1]
    done = subprocess.run(
        [build / "tests" / "search" / "replay_nsga2", *map(str, words)],
        input=text,
        capture_output=True,
        text=True,
        check=True,
    )
    return np.array([line.split() for line in done.stdout.splitlines()], float)


@pytest.mark.parametrize("objectives", [2, 3])
def test_fronts_and_crowding_distances_agree_with_pymoo(
    objectives: int,
) -> None:
    points = np.random.default_rng(objectives).random((150, objectives))
    numbers = " ".join(map(repr, points.ravel().tolist()))
    sorted_points = replay(
        "sort", text=f"{len(points)} {objectives} {numbers}"
    )
    for level, members in enumerate(NonDominatedSorting().do(points)):
        assert set(np.flatnonzero(sorted_points[:, 0] == level)) == set(
            members
        )
        if len(members) < 3:
            continue
        np.testing.assert_allclose(
            sorted_points[members, 1],
            calc_crowding_distance(points[members]),
            1e-12,
        )


@pytest.mark.parametrize("objectives", [2, 3, 4])
def test_hypervolumes_agree_with_pymoo(objectives: int) -> None:
    points = np.random.default_rng(objectives).random((40, objectives))
    reference = np.full(objectives, 0.9)
    values = [*points.ravel().tolist(), *reference.tolist()]
    numbers = " ".join(map(repr, values))
    found = replay("volume", text=f"41 {objectives} {numbers}")
    expected = HV(ref_point=reference)(points)
    assert found.item() == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    "problem, size", [("zdt1", 2), ("zdt2", 2), ("dtlz2", 3)]
)
def test_searches_reach_the_hypervolume_of_pymoo(
    problem: str, size: int
) -> None:
    generations, parents = 250, 60
    volume = HV(ref_point=np.full(size, 1.1))
    words = (problem, parents, generations)
    ours = [volume(replay("search", *words, seed)) for seed in (1, 2, 3)]
    published = [
        volume(
            minimize(
                get_problem(problem, n_var=12 if size == 3 else 30),
                NSGA2(pop_size=parents),
                ("n_gen", generations),
                seed=seed,
            ).F
        )
        for seed in (1, 2, 3)
    ]
    assert np.median(ours) > 0.99 * np.median(published)


def test_histories_have_the_hypervolume_of_each_generation(
    tmp_path: Path,
) -> None:
    campaign = write_campaign(tmp_path, 4)
    settings = ("search.optimizer=nsga2", "objective.minimise=lai")
    words = [word for each in settings for word in ("--set", each)]
    shown = output_of("run", campaign, "--out", tmp_path, *words)
    (path,) = (tmp_path / "tiny").glob("*.h5")
    with open_history(path) as history:
        volume = history.generations().hypervolume
    assert volume is not None
    costs = ideotype.open(path).objectives.values * [-1, 1]
    rows = len(costs) // 4
    of_front = HV(ref_point=costs[:rows].max(axis=0))
    expected = [of_front(costs[: rows * g]) for g in range(1, 5)]
    np.testing.assert_allclose(volume.values, expected, 1e-12)
    assert (volume.standard_error[1:] > 0).all()
    assert volume.unit == "MJ m-2 day-1 m2 m-2"
    assert shown.count(", hypervolume ") == 4 + 1
    last = f", hypervolume {volume.values[-1]:.3g}"[:-1]
    assert last in output_of("status", path)
