# SPDX-License-Identifier: Apache-2.0
"""Draws and returns the azimuths of the leaves of plants."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from numpy.typing import NDArray

from ..history.case import Case
from ..history.file import HistoryError
from ..history.genes import curve
from ..history.layout import row_direction
from . import style
from .shape import COUNT, circular_mean_and_deviation, draw_plants, finish

_MEASURE = "leaf.azimuth"
_ARROW: dict[str, Any] = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0}
_RANK_LABEL: dict[str, Any] = {
    "ha": "center",
    "va": "center",
    "fontsize": 8,
    "zorder": 1.9,  # Lies above the circles and below the plants.
    "bbox": {"facecolor": "white", "edgecolor": "none", "pad": 0.5},
}


def compute_azimuths(case: Case, genomes: NDArray) -> NDArray[np.float64]:
    """Returns the azimuths of the leaves of plants, lowest first [plants,
    leaves], in [0, 360) [deg], with the effects of all traits that act on
    azimuths, free or fixed.

    Raises HistoryError if no trait acts on azimuths."""
    baseline = case.resolved.get("plant", {}).get("baseline", {})
    traits = baseline.get("trait")
    if traits is None:
        # In histories before crops declared traits, a gene is the azimuth
        # itself.
        columns = case.genes.columns("azimuth")
        if not len(columns):
            raise HistoryError("the plants have no azimuths")
        return genomes[:, columns]
    initial = np.array(
        [leaf["azimuth"] for leaf in baseline["leaf"]], dtype=float
    )
    values = np.tile(initial, (len(genomes), 1))
    acting = False
    for trait in traits:
        for effect in ("sets", "scales", "shifts"):
            if _MEASURE in trait.get(effect, []):
                numbers = _spread_over_leaves(
                    case, trait["name"], genomes, len(initial)
                )
                values = _act(effect, values, numbers)
                acting = True
    if not acting:
        raise HistoryError("no trait acts on azimuths")
    return np.mod(values, 360.0)


def _act(effect: str, values: NDArray, numbers: NDArray) -> NDArray:
    if effect == "sets":
        return numbers
    return values * numbers if effect == "scales" else values + numbers


def _spread_over_leaves(
    case: Case, trait: str, genomes: NDArray, leaves: int
) -> NDArray:
    """Returns the values of a trait at each leaf."""
    numbers = genomes[:, case.genes.columns(trait)]
    if case.genes.kind(trait) == "profile":
        return curve(numbers, np.linspace(0, 1, leaves))
    return np.broadcast_to(numbers, (len(genomes), leaves))


def draw_azimuths(case: Case) -> Figure:
    """Draws leaf azimuths from above, the lowest leaf innermost: the fittest
    plants, their circular mean and deviation, and the baseline."""
    plants = compute_azimuths(case, case.top(COUNT).genome)
    leaves = np.arange(plants.shape[1]) + 1
    figure = style.new_figure(style.WIDTH, 5.2)
    grid = figure.add_gridspec(1, 2, width_ratios=(1, 0.16))
    axes = cast(PolarAxes, figure.add_subplot(grid[0], projection="polar"))
    _draw_compass(figure.add_subplot(grid[1]), case)
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    _draw_arcs(axes, plants, leaves)
    draw_plants(
        axes,
        case,
        lambda genomes: np.deg2rad(compute_azimuths(case, genomes)),
        leaves,
    )
    for row in (0, np.pi):
        end = 1.1 * leaves.max()
        axes.plot([row, row], [0, end], color=style.QUIET, ls="--")
    axes.set_rlim(0, leaves.max() + 0.9)
    axes.grid(color="#CFCFCF")
    axes.set_rgrids(leaves, [])
    for leaf in leaves:
        axes.text(np.pi / 8, float(leaf), str(leaf), **_RANK_LABEL)
    axes.set_thetagrids(
        np.arange(0, 360, 45),
        ["0° along the row"] + [f"{a}°" for a in range(45, 360, 45)],
    )
    if case.pairs:
        both = compute_azimuths(
            case,
            np.vstack([p.row.genome for p in (case.best, case.baseline)]),
        )
        turn = np.abs((both[0] - both[1] + 180) % 360 - 180)
        style.set_answer(
            figure,
            f"The azimuths of the leaves of the best plant differ from the "
            f"baseline by {turn.mean():.0f}° on average.",
        )
    return finish(figure, axes)


def _draw_arcs(axes: Axes, values: NDArray, leaves: NDArray) -> None:
    """Draws circular mean and deviation by leaf, just outside the points."""
    mean, deviation = circular_mean_and_deviation(values)
    for center, width, leaf in zip(mean, deviation, leaves):
        arc = np.deg2rad(np.linspace(center - width, center + width, 60))
        axes.plot(
            arc, np.full(len(arc), leaf + 0.3), color=style.ACCENT, lw=1.2
        )
    axes.plot(
        np.deg2rad(mean), leaves + 0.3, "s", color=style.ACCENT, markersize=3,
        label="circular mean and deviation",
    )  # fmt: skip


def _draw_compass(axes: Axes, case: Case) -> None:
    """Draws north, the row, and the direction of increasing azimuth, for a
    view from above with azimuth 0 at the top. The compass fills the axes."""
    axes.set_axis_off()
    axes.set_aspect("equal")
    axes.set_anchor("N")
    axes.set(xlim=(-1.5, 1.5), ylim=(-2.4, 2.1))
    axes.plot([0, 0], [-1, 1], color=style.QUIET, linestyle="--")
    direction = row_direction(case)
    # The N of the arrow is at 1.12, where the end of the row may also be.
    cosine = 0.0 if direction is None else np.cos(np.deg2rad(direction))
    is_near, is_far = cosine > 0.7, cosine < -0.7
    axes.text(
        0, 1.55 if is_near else 1.1, "row, 0°", ha="center", va="bottom",
        fontsize=8, gid="row",
    )  # fmt: skip
    turn = np.deg2rad(np.linspace(10, 80, 30))
    x, y = 0.62 * np.sin(turn), 0.62 * np.cos(turn)
    axes.plot(x, y, color=style.QUIET)
    axes.annotate(
        "", (x[-1], y[-1]), (x[-4], y[-4]),
        arrowprops=_ARROW | {"color": style.QUIET},
    )  # fmt: skip
    axes.text(
        0, -1.55 if is_far else -1.1, "azimuths\nclockwise", ha="center",
        va="top", fontsize=8,
    )  # fmt: skip
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
