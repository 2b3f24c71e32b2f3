# SPDX-License-Identifier: Apache-2.0
"""Pareto fronts consist of the right plants, and a reader can choose a plant
in the report."""

from __future__ import annotations

import json
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_front import AREA, KEPT, LAIS, LIGHT, make
from made_history import MadeHistory
from made_layout import seal
from made_numbers import (
    BASELINE,
    ERROR,
    LAI,
    POPULATION,
    absorbed,
    final_absorbed,
    hypervolume,
)
from pymoo.util.nds.non_dominated_sorting import NonDominatedSorting
from real_program import CAMPAIGNS

import ideotype
from ideotype.figures.case import figures_of
from ideotype.figures.front import draw_front, draw_hypervolume
from ideotype.figures.front_plants import draw_front_plants
from ideotype.figures.style import BEST, get_answer
from ideotype.history import open_history, open_study
from ideotype.history.front import non_dominated
from ideotype.report.scene import build_plants, make_scene


@pytest.fixture
def history(tmp_path: Path) -> Path:
    return make(tmp_path / "case_r1.h5")


@pytest.mark.parametrize("digits", [1, 6])
@pytest.mark.parametrize("signs", [(-1, -1), (1, -1), (1, -1, 1)])
def test_non_dominated_agrees_with_a_published_sorting(
    signs: tuple[int, ...], digits: int
) -> None:
    """With one digit, many rows have equal values in one objective or in
    all."""
    random = np.random.default_rng(len(signs))
    rows = random.random((120, len(signs))).round(digits)
    expected = NonDominatedSorting().do(
        -rows * signs, only_non_dominated_front=True
    )
    assert set(np.flatnonzero(non_dominated(rows, signs))) == set(expected)


def test_constraints_come_before_objectives() -> None:
    rows = [[1.0, 1.0], [3.0, 3.0], [2.0, 2.0], [0.0, 5.0]]
    masks = [
        non_dominated(rows, [1, 1], violation).tolist()
        for violation in ([0, 2, 1, 0], [3, 2, 2, 9])
    ]
    assert masks == [[True, False, False, True], [False, True, False, False]]


def test_members_dominated_after_the_search_are_reported(
    history: Path,
) -> None:
    with open_history(history) as opened:
        front = opened.front()
    assert front is not None and front.is_final
    assert front.is_kept.tolist() == KEPT
    assert [front.number(i) for i in range(3)] == [1, 2, 3]
    assert front.kept["lai"].values.tolist() == LAIS[1:3]
    gain = front.pair(0).gain_in("absorbed_par")
    assert gain.mean == pytest.approx(1.0)
    # The error is paired, because both plants share most of their noise.
    assert 0 < gain.standard_error < 0.5 * 100 * 2**0.5 * ERROR / 4 / 11
    area = front.pair(0).gain_in("lai")
    assert area.mean == pytest.approx(100 * (3.0 / LAI - 1))
    assert area.standard_error == 0
    # For quantities that are not objectives the plants count as independent.
    soil = front.pair(0).gain_in("soil_fraction")
    assert soil.mean == pytest.approx(100 * (1.2 - 0.11) / 1.2 - 100)
    assert soil.standard_error > gain.standard_error


def test_before_the_finals_the_front_is_that_of_the_last_generation(
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
    # All plants have the same leaf area.
    assert front.members["absorbed_par"].values == [
        absorbed(1, POPULATION - 1)
    ]
    assert front.is_kept.tolist() == [True] and front.number(0) == 1


def test_a_single_objective_has_no_front(finished: Path) -> None:
    with open_study(finished) as study:
        (case,) = study.cases()
        assert study[0].front() is None and case.fronts == ()
        assert study[0].generations().hypervolume is None
        assert not {"front", "hypervolume"} & figures_of(case).keys()


def test_plants_along_the_front_are_drawn(history: Path) -> None:
    with open_study(history) as study:
        (case,) = study.cases()
        plants = build_plants(case)
        figure = draw_front_plants(case, plants.baseline, plants.members)
    titles = [axes.get_title() for axes in figure.axes if axes.get_title()]
    # Plants are in the order of the first objective; dominated plants are left
    # out.
    light = [BASELINE, *sorted(final_absorbed(i + 1) for i in (0, 1))]
    area = [LAIS[0], *LAIS[1:3]]
    error = ERROR / 4
    assert titles == [
        f"{name}\n{mean:.4f} ± {1.96 * error:.4f}\n{lai:.4g}"
        for name, mean, lai in zip(
            ("baseline", "plant 1", "plant 2"), light, area
        )
    ]
    for axes, mesh in zip(figure.axes, (plants.baseline, *plants.members[:2])):
        (faces,) = axes.collections
        assert len(faces.get_paths()) == len(mesh.faces)
    answer = get_answer(figure)
    assert "absorbed PAR [MJ m⁻² day⁻¹ of ground], LAI [m² m⁻²" in answer


def test_a_front_member_has_the_same_number_everywhere(tmp_path: Path) -> None:
    """Plants in the figure are ordered by the first objective, finalists by
    their last generation; the numbers of plants must agree nevertheless."""
    for seed in (1, 2):
        path = tmp_path / f"case_r{seed}.h5"
        make(path, attributes={"case": f"a_r{seed}"})
        with h5py.File(path, "r+") as file:
            for name in ("objectives", "objectives_by_randomisation"):
                rows = file[f"final/{name}"]
                rows[1:3] = rows[1:3][::-1]
            file["final/lai"][1:3] = LAIS[1:3][::-1]
            seal(file)
    stand = ideotype.Stand.from_campaign(CAMPAIGNS / "ames_quick.toml")
    mesh = stand.mesh(stand.baseline)
    with open_study(tmp_path) as study:
        (case,) = study.cases()
        figure = draw_front_plants(case, mesh, [mesh] * 6)
        (shown,) = json.loads(make_scene([(case, None)]))["cases"]
        known = {
            f"plant {front.number(i)} of seed {seed}": (
                front.one(i).objective.mean
            )
            for seed, (_, front) in enumerate(case.fronts, start=1)
            for i in range(len(front.members))
        }
    assert {
        member["title"]: member["objectives"][0][0]
        for member in shown["front"]["members"]
    } == pytest.approx(known)
    titles = [
        axes.get_title().split("\n")
        for axes in figure.axes
        if axes.collections
    ]
    drawn = {name: light.split()[0] for name, light, *_ in titles}
    assert list(drawn) == [
        *("baseline", "plant 2 of seed 1", "plant 2 of seed 2"),
        *("plant 1 of seed 1", "plant 1 of seed 2"),
    ]
    for name, light in list(drawn.items())[1:]:
        assert light == f"{known[name]:.4f}"


def test_fronts_have_their_figures(tmp_path: Path) -> None:
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
    assert {
        f"dominated after re-evaluation of seed {seed}" for seed in (1, 2)
    } < handles.keys()
    points, _, (_, up) = handles["Pareto front of seed 1"]
    assert points.get_color() == BEST
    assert points.get_xdata().tolist() == LAIS[1:3]
    lengths = [np.diff(segment[:, 1])[0] for segment in up.get_segments()]
    assert lengths == pytest.approx([1.96 * 2 * ERROR / 4] * 2)
    lines = [line.get_ydata() for line in growth.lines]
    assert np.allclose(lines, [[hypervolume(g) for g in range(5)]] * 2)
    bands = [band.get_paths()[0].vertices[:, 1] for band in growth.collections]
    assert len(bands) == 2
    for band in bands:
        assert band.max() == pytest.approx(hypervolume(4) + 1.96 * ERROR)


def test_histories_without_a_hypervolume_lack_its_figure(
    tmp_path: Path,
) -> None:
    make(tmp_path / "old.h5", without="generations/hypervolume")
    with open_study(tmp_path) as study:
        names = figures_of(study.cases()[0]).keys()
    assert "front" in names and "hypervolume" not in names
