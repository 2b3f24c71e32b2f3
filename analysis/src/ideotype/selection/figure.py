# SPDX-License-Identifier: Apache-2.0
"""The figure of a selection: gain against cycle."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure

from ..figures import style
from .selection import Selection


def draw_reach(selection: Selection) -> Figure:
    """Draws the gain of each method against the cycle, with the gain of the
    ideotype as ceiling."""
    figure = style.new_figure(style.WIDTH, 3.4)
    axes = figure.subplots()
    for number, (method, reach) in enumerate(selection.reaches.items()):
        color, marker = style.series(number)
        axes.errorbar(
            np.arange(len(reach.curve)),
            reach.curve,
            style.half_width(np.nan_to_num(reach.curve_standard_error)),
            color=color,
            marker=marker,
            label=method,
        )
    (reach, *_) = selection.reaches.values()
    if not math.isnan(reach.ceiling):
        axes.axhline(reach.ceiling, color=style.QUIET, label="ideotype")
    axes.set_xlabel("cycle of selection")
    axes.set_xticks(range(len(reach.curve)))
    axes.set_ylabel(
        f"gain in {style.words(selection.objective)} over the lines [%]"
    )
    axes.legend()
    return figure
