# SPDX-License-Identifier: Apache-2.0
"""Plants from above."""

from __future__ import annotations

from typing import cast

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import BoundaryNorm
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes

from .._geometry import Mesh
from . import style
from .azimuths import azimuths
from .case import Case
from .compass import draw_compass
from .shape import COUNT
from .stand import places

_BINS = 24


def draw_roses(case: Case) -> Figure:
    """How many leaves point where: the baseline, and the fittest plants of
    all seeds. The area of a wedge is the share of leaves."""
    top = case.top(COUNT)
    plants = {f"the {len(top)} fittest": azimuths(case, top.genome)}
    if case.pairs:
        baseline = azimuths(case, case.baseline.row.genome)
        plants = {"baseline": baseline} | plants
    count = len(plants)
    figure = style.new_figure(3.6 * count + 0.9, 4.2)
    grid = figure.add_gridspec(1, count + 1, width_ratios=(*[1] * count, 0.3))
    draw_compass(figure.add_subplot(grid[-1]), case)
    for i, (label, values) in enumerate(plants.items()):
        axes = cast(PolarAxes, figure.add_subplot(grid[i], projection="polar"))
        axes.set_theta_zero_location("N")
        axes.set_theta_direction(-1)
        edges = np.linspace(0, 360, _BINS + 1) - 180 / _BINS
        turned = (values.ravel() - edges[0]) % 360 + edges[0]
        counts, _ = np.histogram(turned, edges)
        axes.bar(
            np.deg2rad(edges[:-1] + 180 / _BINS),
            np.sqrt(counts / counts.sum()),
            width=2 * np.pi / _BINS,
            color=style.BASELINE if label == "baseline" else style.BEST,
            alpha=0.75,
            edgecolor="white",
            linewidth=0.5,
        )
        axes.set_yticklabels([])
        axes.set_thetagrids(
            np.arange(0, 360, 45),
            ["0° (row)"] + [f"{a}°" for a in range(45, 360, 45)],
        )
        axes.set_title(f"{label}, {values.size} leaves")
    figure.suptitle(case.name, fontsize=10)
    return figure


def draw_plan(case: Case, baseline: Mesh, best: Mesh) -> Figure:
    """Baseline and best plant from above among their neighbours, all turned
    alike; colours tell leaf ranks."""
    figure = style.new_figure(style.WIDTH, 3.3)
    grid = figure.add_gridspec(1, 3, width_ratios=(1, 1, 0.4))
    panels = [figure.add_subplot(grid[0])]
    panels.append(
        figure.add_subplot(grid[1], sharex=panels[0], sharey=panels[0])
    )
    panels[1].tick_params(labelleft=False)
    draw_compass(figure.add_subplot(grid[2]), case)
    ranks = sorted({g for g in best.groups if g.startswith("leaf")})
    norm = BoundaryNorm(np.arange(0.5, len(ranks) + 1), 256)
    for axes, mesh, label in zip(
        panels, (baseline, best), ("baseline", "best")
    ):
        _draw_field(axes, case, mesh, norm)
        axes.set_title(label)
        axes.set_xlabel("across the rows [m]")
    panels[0].set_ylabel("along the rows [m]")
    figure.colorbar(
        ScalarMappable(norm, colormaps["viridis"]),
        ax=panels,
        ticks=range(1, len(ranks) + 1),
        label="leaf rank (1 = lowest)",
        shrink=0.85,
    )
    figure.suptitle(case.name, fontsize=10)
    return figure


def _draw_field(
    axes: Axes, case: Case, mesh: Mesh, norm: BoundaryNorm
) -> None:
    around = places(case)
    # Upper leaves hide lower ones, as seen from the sun at its highest.
    height = [mesh.vertices[list(face), 2].mean() for face in mesh.faces]
    order = np.argsort(height)
    polygons, colors = [], []
    for i in order:
        outline = mesh.vertices[list(mesh.faces[i]), :2]
        group = mesh.groups[i]
        color = (
            colormaps["viridis"](norm(int(group[4:])))
            if group.startswith("leaf")
            else style.organ_color(group)
        )
        for place in around:
            polygons.append(outline + place)
            colors.append(color)
    axes.add_collection(
        # Edges close the seams between the faces of a leaf.
        PolyCollection(
            polygons, facecolors=colors, edgecolors="face", linewidths=0.4
        )
    )
    for x in sorted({place[0] for place in around}):
        axes.axvline(x, color=style.QUIET, linewidth=0.8, linestyle="--")
    axes.set_aspect("equal")
    axes.autoscale_view()
