# SPDX-License-Identifier: Apache-2.0
"""NURBS surfaces are computed exactly."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from ideotype.stand.measured.nurbs import _nurbs


def test_a_quarter_of_a_cylinder_is_round(tmp_path: Path) -> None:
    """With three control points and a middle weight of cos 45 deg the curve is
    an arc of 90 deg (Piegl and Tiller 1997, The NURBS Book, section 7.3)."""
    lines = ["3", "2 1", "3 2", "0 0 0 1 1 1", "0 0 1 1"]
    for z in (0.0, 5.0):
        for x, y, weight in ((1, 0, 1), (1, 1, np.sqrt(0.5)), (0, 1, 1)):
            lines.append(f"{x} {y} {z} {weight:.17g}")
    path = tmp_path / "arc.dat"
    path.write_text("\n".join(lines))
    (blade,) = _nurbs(path)
    assert blade.points is not None and len(blade.points) == 13 * 61
    radius = np.hypot(blade.points[:, 0], blade.points[:, 1])
    assert radius == pytest.approx(1, abs=1e-14)
    assert np.ptp(blade.points[:, 2]) == pytest.approx(5)
    # Facets are chords over equal parameter steps.
    assert blade.area == pytest.approx(5 * np.pi / 2, rel=1e-3)
