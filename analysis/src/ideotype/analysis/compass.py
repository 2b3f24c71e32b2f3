# SPDX-License-Identifier: Apache-2.0
"""Which way a figure that looks down on plants is turned."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes

from . import style
from .case import Case
from .stand import row_direction

_ARROW: dict[str, Any] = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0}


def draw_compass(axes: Axes, case: Case) -> None:
    """North, the row, and which way azimuths count, for a view from above
    with azimuth 0 at the top. Takes the axes for itself."""
    axes.set_axis_off()
    axes.set_aspect("equal")
    axes.set_anchor("N")
    axes.set(xlim=(-1.5, 1.5), ylim=(-1.75, 1.5))
    axes.plot([0, 0], [-1, 1], color=style.QUIET, linestyle="--")
    axes.text(0, 1.1, "row, 0°", ha="center", va="bottom", fontsize=7)
    turn = np.deg2rad(np.linspace(10, 80, 30))
    x, y = 0.62 * np.sin(turn), 0.62 * np.cos(turn)
    axes.plot(x, y, color=style.QUIET)
    axes.annotate(
        "", (x[-1], y[-1]), (x[-4], y[-4]),
        arrowprops=_ARROW | {"color": style.QUIET},
    )  # fmt: skip
    axes.text(
        0, -1.1, "azimuths\nclockwise", ha="center", va="top", fontsize=7
    )
    direction = row_direction(case)
    if direction is None:
        return
    north = -np.deg2rad(direction)
    across, up = np.sin(north), np.cos(north)
    axes.annotate(
        "", (0.85 * across, 0.85 * up), (-0.4 * across, -0.4 * up),
        arrowprops=_ARROW | {"color": style.BASELINE, "linewidth": 1.5},
        gid="north",
    )  # fmt: skip
    axes.text(
        1.12 * across, 1.12 * up, "N", ha="center", va="center", fontsize=9,
        fontweight="bold", gid="north",
    )  # fmt: skip
