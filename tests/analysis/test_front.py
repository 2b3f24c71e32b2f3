"""Fronts of several objectives: which plants are in them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from ideotype_analysis import open_history, open_study
from ideotype_analysis.case_figures import figures_of
from ideotype_analysis.front import non_dominated
from ideotype_analysis.front_figures import draw_front, draw_hypervolume
from ideotype_analysis.style import BEST
from made_history import MadeHistory
from made_layout import seal
from made_numbers import (
    ERROR,
    LAI,
    POPULATION,
    absorbed,
    hypervolume,
)
from pymoo.util.nds.non_dominated_sorting import NonDominatedSorting

LIGHT, AREA = ("absorbed_par", "maximise"), ("lai", "minimise")
LEAVES = ("absorbed_par_per_leaf_area", "maximise")
LAIS = [LAI, 3.0, 3.5, 3.2]
"""Of the finalists: another has more light than the last on fewer leaves."""
KEPT = [True, True, False]


def make(
    path: Path,
    objectives: Sequence[tuple[str, str]] = (LIGHT, AREA),
    **options: Any,
) -> Path:
    """A finished history whose finalists have LAIS."""
    made = MadeHistory(path, objectives=objectives, **options)
    made.evolve(5)
    made.finish()
    made.close()
    with h5py.File(path, "r+") as file:
        file["final/lai"][:] = LAIS
        if AREA in objectives:
            k = objectives.index(AREA)
            file["final/objectives"][:, k] = LAIS
            draws = file["final/objectives_by_randomisation"]
            draws[:, k] = np.repeat(LAIS, draws.shape[2]).reshape(4, -1)
        seal(file)
    return path


@pytest.fixture
def history(tmp_path: Path) -> Path:
    return make(tmp_path / "case_r1.h5")


@pytest.mark.parametrize("digits", [1, 6])
@pytest.mark.parametrize("signs", [(-1, -1), (1, -1), (1, -1, 1)])
def test_the_same_rows_as_a_published_sorting(
    signs: tuple[int, ...], digits: int
) -> None:
    """With one digit many rows are equal in an objective, or in all."""
    random = np.random.default_rng(len(signs))
    rows = random.random((120, len(signs))).round(digits)
    expected = NonDominatedSorting().do(
        -rows * signs, only_non_dominated_front=True
    )
    assert set(np.flatnonzero(non_dominated(rows, signs))) == set(expected)


def test_constraints_come_before_objectives() -> None:
    rows = [[1.0, 1.0], [3.0, 3.0], [2.0, 2.0], [0.0, 5.0]]
    found = [
        non_dominated(rows, [1, 1], violation).tolist()
        for violation in ([0, 2, 1, 0], [3, 2, 2, 9])
    ]
    assert found == [[True, False, False, True], [False, True, False, False]]


def test_members_that_fall_off_are_told(history: Path) -> None:
    with open_history(history) as opened:
        front = opened.front()
    assert front is not None and front.is_final
    assert front.is_kept.tolist() == KEPT
    assert [front.number(i) for i in range(3)] == [1, 2, 3]
    assert front.kept["lai"].values.tolist() == LAIS[1:3]
    gain = front.pair(0).gain_in("absorbed_par")
    assert gain.mean == pytest.approx(1.0)
    # paired: most of the noise is shared
    assert 0 < gain.standard_error < 0.5 * 100 * 2**0.5 * ERROR / 4 / 11
    area = front.pair(0).gain_in("lai")
    assert area.mean == pytest.approx(100 * (3.0 / LAI - 1))
    assert area.standard_error == 0
    # of what is no objective as of independent figures
    soil = front.pair(0).gain_in("soil_fraction")
    assert soil.mean == pytest.approx(100 * (1.2 - 0.11) / 1.2 - 100)
    assert soil.standard_error > gain.standard_error


def test_before_the_finals_it_is_that_of_the_last_generation(
    tmp_path: Path,
) -> None:
    fronts = []
    for generations in (0, 2):
        path = tmp_path / f"{generations}.h5"
        made = MadeHistory(path, objectives=[LIGHT, AREA])
        made.evolve(generations)
        made.close()
        with open_history(path) as opened:
            fronts.append(opened.front())
    assert fronts[0] is None
    front = fronts[1]
    assert front is not None and not front.is_final
    # all have the same leaf area
    assert front.members["absorbed_par"].values == [absorbed(1, POPULATION - 1)]
    assert front.is_kept.tolist() == [True] and front.number(0) == 1


def test_one_objective_has_no_front(finished: Path) -> None:
    with open_study(finished) as study:
        (case,) = study.cases()
        assert study[0].front() is None and case.fronts == ()
        assert study[0].generations().hypervolume is None
        assert not {"front", "hypervolume"} & figures_of(case).keys()


def test_figures_of_fronts(tmp_path: Path) -> None:
    for seed in (1, 2):
        make(tmp_path / f"case_r{seed}.h5", attributes={"case": f"a_r{seed}"})
    with open_study(tmp_path) as study:
        (case,) = study.cases()
        assert [*figures_of(case)][:2] == ["front", "hypervolume"]
        (axes,) = draw_front(case).axes
        (growth,) = draw_hypervolume(case).axes
    assert axes.get_xlabel() == "LAI [m² m⁻²], minimised"
    assert axes.get_ylabel().endswith("of ground], maximised")
    handles = dict(zip(*axes.get_legend_handles_labels()[::-1]))
    assert {f"fallen off of seed {seed}" for seed in (1, 2)} < handles.keys()
    points, _, (across, up) = handles["front of seed 1"]
    assert points.get_color() == BEST
    assert points.get_xdata().tolist() == LAIS[1:3]
    lengths = [np.diff(segment[:, 1])[0] for segment in up.get_segments()]
    assert lengths == pytest.approx([2 * ERROR / 4] * 2)
    lines = [line.get_ydata() for line in growth.lines]
    assert np.allclose(lines, [[hypervolume(g) for g in range(5)]] * 2)
    bands = [band.get_paths()[0].vertices[:, 1] for band in growth.collections]
    assert len(bands) == 2
    for band in bands:
        assert band.max() == pytest.approx(hypervolume(4) + ERROR)


def test_histories_without_a_hypervolume_lack_its_figure(tmp_path: Path) -> None:
    make(tmp_path / "old.h5", without="generations/hypervolume")
    with open_study(tmp_path) as study:
        names = figures_of(study.cases()[0]).keys()
    assert "front" in names and "hypervolume" not in names

