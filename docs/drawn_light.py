# SPDX-License-Identifier: Apache-2.0
"""Draws light and photosynthesis for the manual."""

from __future__ import annotations

from datetime import time
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import matplotlib
import numpy as np
from draw_plants import TURN, draw
from drawn_plants import INK, MARK, PLANT, ROW, Shapes, bare
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from plant_shapes import drawn
from shared import campaign_of

from ideotype import Stand, mesh
from ideotype.figures.style import new_figure


def light(shapes: Shapes) -> Figure:
    """Draws the light absorbed by each face of a plant in a dense stand, from
    the sun and from a uniform sky."""
    plant = shapes.maize()
    surfaces = mesh(plant.vertices, plant.faces, groups=plant.groups)
    figure = new_figure(4.6, 4.4)
    grid = figure.subplots(1, 2, sharex=True, sharey=True)
    absorbed = [
        surfaces.evaluate(
            period=(ROW, PLANT), by_face=True, paths=1 << 18, **source
        ).absorbed_by_face.values
        for source in ({"sun": (60, 180)}, {"sky": "uniform"})
    ]
    brightest = np.quantile(absorbed[0], 0.98)
    colors = matplotlib.colormaps["viridis"]
    for axes, title, values in zip(
        grid, ("sun at 60°, from the south", "diffuse light"), absorbed
    ):
        draw(axes, plant, is_side=True)
        (faces,) = axes.collections
        x, y, _ = plant.vertices.T
        depth = np.sin(TURN) * x - np.cos(TURN) * y
        order = np.argsort([depth[list(face)].mean() for face in plant.faces])
        faces.set_facecolor(colors(values[order] / brightest))
        axes.set_title(title, fontsize=9)
        bare(axes)
    grid[0].set(xlim=(-0.72, 0.72), ylim=(0, 2.2))
    scale = matplotlib.cm.ScalarMappable(
        matplotlib.colors.Normalize(0, brightest), colors
    )
    figure.colorbar(
        scale, ax=grid, location="bottom", shrink=0.7, aspect=30,
        label="absorbed, per area of leaf\n(light on level ground = 1)",
    )  # fmt: skip
    return figure


def response(_: Shapes) -> Figure:
    """Draws why the same light on more area is worth more."""
    phi, theta, amax = 0.06, 0.7, 50.0

    def rate(x: Any) -> Any:
        total = phi * x + amax
        root = np.sqrt(total**2 - 4 * theta * phi * x * amax)
        return (total - root) / (2 * theta)

    figure = new_figure(4.8, 3.0)
    axes = figure.subplots()
    ppfd = np.linspace(0, 2000, 201)
    axes.plot(ppfd, rate(ppfd), color="#4E9A3A")
    low, high = 200, 1800
    axes.plot([low, high], rate(np.array([low, high])), "o--", color=MARK)
    mean = (low + high) / 2
    axes.plot(mean, rate(mean), "o", color=INK)
    axes.plot(mean, (rate(low) + rate(high)) / 2, "D", color=MARK)
    axes.annotate(
        "both halves alike", (mean, rate(mean)), (mean - 60, rate(mean) + 3),
        ha="right", color=INK,
    )  # fmt: skip
    axes.annotate(
        "one half in the sun", (mean, (rate(low) + rate(high)) / 2),
        (mean + 60, (rate(low) + rate(high)) / 2 - 4), color=MARK,
    )  # fmt: skip
    axes.set(
        xlabel="absorbed photons [µmol m⁻² s⁻¹]",
        ylabel="assimilation [µmol m⁻² s⁻¹]",
        xlim=(0, 2000), ylim=(0, 48),
    )  # fmt: skip
    return figure


def agrivoltaics(_: Shapes) -> Figure:
    """Draws the field of a campaign across its rows at three hours, and its
    light."""
    tables = campaign_of("agrivoltaic")
    stand = Stand(tables)
    evaluated = stand.evaluate(stand.baseline, tolerance=0.005).isel(
        plant=0, band=0
    )
    figure = new_figure(4.8, 6.0)
    grid = figure.subplots(4, 1, height_ratios=(1, 1, 1, 1.6))
    tables |= {
        "light": {"paths": 16, "randomisations": 4},
        "search": {"population": 2, "elites": 0},
        "stop": {"generations": 1},
        "final": {"candidates": 1, "paths": 16, "randomisations": 2},
    }
    colors = {"panel": "#234E78", "leaf": "#4E9A3A"}
    for axes, hour in zip(grid, (8, 12, 18)):
        (day,) = tables["day"]
        day |= {"start": time(hour), "end": time(hour + 1)}
        with TemporaryDirectory() as folder:
            field = drawn(tables, Path(folder))
        # The picture has the field and its neighbours on both sides.
        (panel,) = tables["panel"]
        across = np.concatenate(
            [
                field.corners[..., (0, 2)] + (panel["pitch"] * i, 0)
                for i in (-1, 0, 1)
            ]
        )
        kinds = 3 * [
            next((kind for kind in colors if kind in group), "")
            for group in field.groups
        ]
        axes.add_collection(
            PolyCollection(
                across, facecolors=[colors.get(k, "#A3B57E") for k in kinds],
                edgecolors=[colors.get(k, "none") for k in kinds],
                linewidths=[1.5 if k == "panel" else 0.1 for k in kinds],
            )
        )  # fmt: skip
        axes.plot([-5, 11], [0, 0], color="#8F7459", lw=2)
        axes.text(-5, 4.4, f"{hour}:00", color=INK)
        axes.set(xlim=(-5, 11), ylim=(-0.1, 5.2))
        bare(axes)
    hours, light = (
        evaluated.hour,
        evaluated.object_light_by_hour.sel(object="panel"),
    )
    last = grid[-1]
    for label, values, color in (
        ("front of modules", light.sel(object_side="front"), "#234E78"),
        ("back of modules", light.sel(object_side="back"), "#7FA8CC"),
        ("leaves, absorbed per ground", evaluated.absorbed_by_hour, "#4E9A3A"),
        ("ground", evaluated.ground_light_by_hour, "#8F7459"),
    ):
        last.plot(hours, values, color=color, label=label)
    last.set(xlabel="hour", ylabel="PAR [W m⁻²]", xlim=(6, 21), ylim=(0, 640))
    last.legend(fontsize=8, loc="upper left", ncols=2)
    return figure
