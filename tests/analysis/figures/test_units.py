# SPDX-License-Identifier: Apache-2.0
"""All axes of light have the same unit and state whether it is per ground or
per leaf area."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from matplotlib.figure import Figure

from ideotype.figures.convergence import draw_convergence
from ideotype.figures.profiles import draw_hours, draw_layers, draw_leaves
from ideotype.figures.shares import draw_parts
from ideotype.figures.style import axis_label
from ideotype.history.case import Case
from ideotype.history.study import open_study


def test_axes_distinguish_ground_area_from_leaf_area() -> None:
    unit = "MJ m-2 day-1"
    assert axis_label("absorbed_par", unit) == (
        "absorbed PAR [MJ m⁻² day⁻¹ of ground]"
    )
    assert axis_label("absorbed_par_per_leaf_area", unit) == (
        "absorbed PAR per leaf area [MJ m⁻² day⁻¹ of leaf]"
    )
    assert axis_label("length", "m") == "length [m]"


@pytest.mark.parametrize(
    ("draw", "axis", "unit"),
    [
        (draw_convergence, "y", "MJ m⁻² day⁻¹"),
        (draw_leaves, "x", "MJ m⁻² day⁻¹"),
        (draw_layers, "x", "MJ m⁻² day⁻¹"),
        (draw_parts, "x", "MJ m⁻² day⁻¹"),
        (draw_hours, "y", "W m⁻²"),
    ],
)
def test_each_axis_has_one_unit(
    sweep: Path, draw: Callable[[Case], Figure], axis: str, unit: str
) -> None:
    with open_study(sweep) as study:
        figure = draw(study.cases()[0])
    first = figure.axes[0]
    label = getattr(first, f"get_{axis}label")()
    assert " ".join(label.split()).endswith(f"[{unit} of ground]")
    assert not first.child_axes
