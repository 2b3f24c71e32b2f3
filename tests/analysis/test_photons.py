# SPDX-License-Identifier: Apache-2.0
"""Axes of light tell energy and photons."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ideotype.analysis.case import Case
from ideotype.analysis.convergence import draw_convergence
from ideotype.analysis.places import draw_latitudes
from ideotype.analysis.profiles import (
    draw_hours,
    draw_layers,
    draw_leaves,
    draw_parts,
)
from ideotype.analysis.study import open_study
from ideotype.analysis.style import axis_label

MOL_PER_MJ = 4.57


def test_axes_tell_ground_from_leaf() -> None:
    unit = "MJ m-2 day-1"
    assert axis_label("absorbed_par", unit) == (
        "absorbed PAR [MJ m⁻² day⁻¹ of ground]"
    )
    assert axis_label("absorbed_par_per_leaf_area", unit) == (
        "absorbed PAR per leaf area [MJ m⁻² day⁻¹ of leaf]"
    )
    assert axis_label("length", "m") == "length [m]"


@pytest.mark.parametrize(
    ("draw", "axis", "energy", "photons"),
    [
        (draw_convergence, "y", "MJ m⁻² day⁻¹", "mol m⁻² day⁻¹"),
        (draw_leaves, "x", "MJ m⁻² day⁻¹", "mol m⁻² day⁻¹"),
        (draw_layers, "x", "MJ m⁻² day⁻¹", "mol m⁻² day⁻¹"),
        (draw_parts, "x", "MJ m⁻² day⁻¹", "mol m⁻² day⁻¹"),
        (draw_hours, "y", "W m⁻²", "µmol m⁻² s⁻¹"),
    ],
)
def test_photons_are_beside_energy(
    sweep: Path,
    draw: Callable[[Case], Figure],
    axis: str,
    energy: str,
    photons: str,
) -> None:
    with open_study(sweep) as study:
        figure = draw(study.cases()[0])
    check(figure, figure.axes[0], axis, energy, photons)


def test_latitudes_have_photons_too(sweep: Path) -> None:
    with open_study(sweep) as study:
        figure = draw_latitudes(study.cases())
    check(figure, figure.axes[0], "y", "MJ m⁻² day⁻¹", "mol m⁻² day⁻¹")


def check(
    figure: Figure, axes: Axes, axis: str, energy: str, photons: str
) -> None:
    figure.draw_without_rendering()
    (other,) = axes.child_axes
    label = getattr(axes, f"get_{axis}label")()
    assert label == f"absorbed PAR [{energy} of ground]"
    assert getattr(other, f"get_{axis}label")() == f"photons [{photons}]"
    limits = getattr(axes, f"get_{axis}lim")()
    expected = [MOL_PER_MJ * limit for limit in limits]
    assert getattr(other, f"get_{axis}lim")() == pytest.approx(expected)
