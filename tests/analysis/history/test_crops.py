# SPDX-License-Identifier: Apache-2.0
"""Crops with traits of any kind are read as the program evolves them."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest
from real_program import output_of, run_crop

from ideotype.figures.azimuths import compute_azimuths
from ideotype.figures.shape import (
    draw_plant_traits,
    draw_profiles,
    draw_traits,
)
from ideotype.history import HistoryError
from ideotype.history.case import Case
from ideotype.history.genes import curve
from ideotype.history.study import open_study

FREE = ["azimuth_deviation", "leaf_plane", "height", "length_profile"]


@pytest.fixture(scope="module")
def maize(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides a history of maize with these free traits: one of single
    leaves, two of the whole plant, and a profile."""
    return run_crop(tmp_path_factory.mktemp("maize"), "maize", FREE)


def export_leaves(history: Path, folder: Path) -> dict[str, np.ndarray]:
    """Returns the measures of the leaves of the best plant from the
    program, with all digits."""
    path = folder / "leaves.toml"
    output_of("export", history, "--best", "--to", path)
    rows = tomllib.loads(path.read_text())["leaf"]
    return {name: np.array([row[name] for row in rows]) for name in rows[0]}


def interpolate_profile(case: Case, trait: str, leaves: int) -> np.ndarray:
    """Returns the values that a trait of the best plant has at its leaves."""
    points = case.best.row.genome[0, case.genes.columns(trait)]
    return curve(points, np.linspace(0, 1, leaves))


def test_azimuths_agree_with_the_exported_plant(
    maize: Path, tmp_path: Path
) -> None:
    exported = export_leaves(maize, tmp_path)["azimuth"] % 360
    with open_study(maize) as study:
        (case,) = study.cases()
        (drawn,) = compute_azimuths(case, case.best.row.genome)
        (baseline,) = compute_azimuths(case, case.baseline.row.genome)
    assert drawn == pytest.approx(exported)
    # Two traits change azimuths; neither is named azimuth.
    assert np.ptp(drawn - baseline) > 0.1
    assert list(baseline) == [90, 270] * 5


def test_scaling_profiles_agree_with_the_exported_plant(
    maize: Path, tmp_path: Path
) -> None:
    exported = export_leaves(maize, tmp_path)["length"]
    with open_study(maize) as study:
        (case,) = study.cases()
        base = case.baseline.row.genome[0, case.genes.columns("length")]
        factors = interpolate_profile(case, "length_profile", 10)
    assert np.ptp(factors) > 0.01
    assert exported == pytest.approx(base * factors)


def test_shifting_profiles_agree_with_the_exported_plant(
    sorghum: list[Path], tmp_path: Path
) -> None:
    exported = export_leaves(sorghum[1], tmp_path)["insertion_angle"]
    with open_study(sorghum[1]) as study:
        (case,) = study.cases()
        at = case.genes.columns("insertion_angle")
        base = case.baseline.row.genome[0, at]
        shifts = interpolate_profile(case, "insertion_angle_profile", 16)
    assert np.ptp(shifts) > 0.1
    assert exported == pytest.approx(np.clip(base + shifts, 0, 90))


def test_only_varied_traits_have_panels(
    maize: Path, sorghum: list[Path]
) -> None:
    with open_study(maize) as study:
        (case,) = study.cases()
        leaves, plants = draw_traits(case), draw_plant_traits(case)
        (profiles,) = draw_profiles(case).axes
    assert [a.get_xlabel() for a in leaves.axes] == ["azimuth deviation [°]"]
    assert [a.get_xlabel() for a in plants.axes] == [
        *("leaf plane [°]", "height [1]"),
    ]
    assert profiles.get_xlabel() == "length profile [1]"
    with open_study(sorghum[0]) as study:
        (case,) = study.cases()
        figure = draw_traits(case)
        with pytest.raises(HistoryError, match="no profile over leaf"):
            draw_profiles(case)
        with pytest.raises(HistoryError, match="no trait of the whole plant"):
            draw_plant_traits(case)
    shown = {axes.get_xlabel() for axes in figure.axes}
    assert shown == {
        *("length [m]", "width [m]", "insertion angle [°]", "azimuth [°]"),
    }
    assert list(figure.axes[0].get_yticks()) == list(range(1, 17))


def test_a_profile_is_a_curve_through_its_points(maize: Path) -> None:
    with open_study(maize) as study:
        (case,) = study.cases()
        (axes,) = draw_profiles(case).axes
        fittest = case.top(1).genome[0, case.genes.columns("length_profile")]
    curves = [line for line in axes.lines if len(line.get_xdata()) == 101]
    # The last curve is that of the baseline, which is 1 everywhere.
    *bred, baseline = [line.get_xdata() for line in curves]
    assert baseline == pytest.approx(np.ones(101))
    at = np.searchsorted(np.linspace(0, 1, 101), [0, 1]), [0, -1]
    assert bred[-1][at[0]] == pytest.approx(fittest[at[1]])
