#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the pictures of the manual with plants that the program makes.

draw.py [NAME...]

A picture is docs/figures/NAME.png; without a name all are drawn."""

from __future__ import annotations

import argparse
import copy
import sys
import tomllib
from collections.abc import Callable
from datetime import time
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Rectangle
from PIL import Image

from ideotype import Stand, mesh
from ideotype._geometry import Mesh
from ideotype.analysis.style import RC, new_figure

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS.parent / "campaigns" / "study"))
from draw_plants import TURN, draw  # noqa: E402
from plant_shapes import drawn  # noqa: E402
from shared import ANYWHERE, read_campaign  # noqa: E402

ROW, PLANT = 0.76, 0.15
"""Distances between rows and between plants in a row [m]."""
INK, MARK = "#333333", "#D55E00"

Change = Callable[[dict[str, Any]], None]


class Shapes:
    """Plants by crop file, as the program makes them."""

    def __init__(self) -> None:
        self._maize = tomllib.loads(
            (DOCS.parent / "campaigns/crops/maize.toml").read_text()
        )

    def of(self, crop: dict[str, Any]) -> Mesh:
        # Some trait has to be within its range, whatever it is.
        crop = {key: crop[key] for key in crop if key != "bounds"}
        crop["trait"] = [
            {
                "name": "height", "per": "plant", "unit": "1",
                "scales": ["stalk.height"], "range": [0.5, 1.5],
            }
        ]  # fmt: skip
        stand = Stand({**ANYWHERE, "plant": {"baseline": crop}})
        return stand.mesh(stand.baseline)

    def maize(self, change: Change = lambda crop: None) -> Mesh:
        crop = copy.deepcopy(self._maize)
        change(crop)
        return self.of(crop)

    def single_leaf(self, folding_angle: float = 10, **leaf: float) -> Mesh:
        """Returns a leaf of 70 cm on a short stalk, to the right."""
        crop = {
            "name": "leaf",
            "stalk": {"height": 0.5, "base_diameter": 0.02},
            "blade": {"folding_angle": folding_angle},
            "leaf": [
                {
                    "length": 0.7, "width": 0.085, "insertion_angle": 30,
                    "curvature": 60, "azimuth": 90, "insertion_height": 0.35,
                    **leaf,
                }
            ],
        }  # fmt: skip
        return self.of(crop)


def turned(mesh: Mesh, angle: float) -> Mesh:
    """Turns a mesh clockwise, seen from above [deg]."""
    c, s = np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))
    x, y, z = mesh.vertices.T
    return Mesh(
        np.array([c * x + s * y, c * y - s * x, z]).T, mesh.faces, mesh.groups
    )


def bare(axes: Axes) -> None:
    axes.set_aspect("equal")
    axes.axis("off")


def show_side(axes: Axes, mesh: Mesh) -> None:
    """Shows a mesh from the south: right is across the rows."""
    draw(axes, mesh, is_side=True, turn=0.0)


def azimuth(shapes: Shapes) -> Figure:
    """Draws azimuths seen from above, with a compass."""
    figure = new_figure(5.2, 2.9)
    left, right = figure.subplots(1, 2)
    directions = (0, 45, 90, 180, 270)

    def five(crop: dict[str, Any]) -> None:
        leaves = crop["leaf"][2:7]
        for leaf, direction in zip(leaves, directions):
            leaf["azimuth"] = direction
        crop["leaf"] = leaves
        del crop["organ"]

    plant = shapes.maize(five)
    draw(left, plant, is_side=False)
    for direction in directions:
        a = np.deg2rad(direction)
        left.annotate(
            f"{direction}°", (0.74 * np.sin(a) + 0.09, 0.74 * np.cos(a)),
            ha="center", va="center", color=MARK, fontsize=10,
        )  # fmt: skip
    left.plot([0, 0], [-0.85, 0.85], color=INK, lw=0.8, ls="--", zorder=0)
    left.text(0.02, -0.86, "the row", fontsize=8, color=INK, va="top")
    left.annotate(
        "", (0.40, 0.62), (0.10, 0.82), color=MARK,
        arrowprops={
            "arrowstyle": "->", "color": MARK, "connectionstyle": "arc3,rad=-0.25"
        },
    )  # fmt: skip
    left.set(xlim=(-0.95, 0.95), ylim=(-0.98, 0.95))
    left.set_title("azimuth of a leaf")
    bare(left)

    # The row runs from west to east: its direction is 90 deg clockwise from
    # north.
    right.plot([-0.8, 0.8], [0, 0], color=INK, lw=0.8, ls="--", zorder=0)
    for x in (-0.6, -0.2, 0.2, 0.6):
        right.plot(x, 0, "o", color="#4E9A3A", ms=9)
    right.annotate(
        "",
        (0, 0.85),
        (0, 0.12),
        arrowprops={"arrowstyle": "-|>", "color": INK},
    )
    right.text(0, 0.88, "north", ha="center", va="bottom", color=INK)
    right.add_patch(
        Arc((0, 0.0), 0.8, 0.8, theta1=0, theta2=90, color=MARK, lw=1.5)
    )
    right.text(0.36, 0.34, "row_direction\n90°", color=MARK, fontsize=9)
    right.annotate(
        "azimuth 0°", (0.84, 0), (0.84, -0.22), ha="center", color=MARK,
        fontsize=9, arrowprops={"arrowstyle": "-", "color": MARK},
    )  # fmt: skip
    right.text(
        0, -0.42, "azimuth 90°: south", color=MARK, ha="center", fontsize=9
    )
    right.annotate(
        "",
        (0, -0.36),
        (0, -0.06),
        arrowprops={"arrowstyle": "->", "color": MARK},
    )
    right.set(xlim=(-1.05, 1.15), ylim=(-0.98, 0.98))
    right.set_title("direction of a row")
    bare(right)
    return figure


def insertion_angle(shapes: Shapes) -> Figure:
    figure = new_figure(4.8, 2.1)
    grid = figure.subplots(1, 4, sharex=True, sharey=True)
    for axes, angle in zip(grid, (10, 30, 60, 90)):
        show_side(axes, shapes.single_leaf(insertion_angle=angle, curvature=0))
        axes.plot([0, 0], [0.35, 0.75], color=MARK, lw=0.8, ls="--")
        axes.add_patch(
            Arc((0, 0.35), 0.5, 0.5, theta1=90 - angle, theta2=90, color=MARK)
        )
        axes.set_title(f"{angle}°")
        bare(axes)
    grid[0].set(xlim=(-0.12, 0.78), ylim=(0, 1.1))
    return figure


def curvature(shapes: Shapes) -> Figure:
    figure = new_figure(4.8, 2.1)
    grid = figure.subplots(1, 4, sharex=True, sharey=True)
    for axes, bend in zip(grid, (0, 45, 90, 140)):
        show_side(axes, shapes.single_leaf(curvature=bend))
        axes.set_title(f"{bend}°")
        bare(axes)
    grid[0].set(xlim=(-0.12, 0.6), ylim=(0, 1.0))
    return figure


def folding(shapes: Shapes) -> Figure:
    """Draws a blade along the midrib of a level leaf: the V of the blade."""
    figure = new_figure(4.8, 1.2)
    grid = figure.subplots(1, 3, sharex=True, sharey=True)
    for axes, angle in zip(grid, (0, 10, 40)):
        mesh = shapes.single_leaf(
            angle, insertion_angle=90, curvature=0, azimuth=0
        )
        blade = [i for i, group in enumerate(mesh.groups) if group != "stalk"]
        blade_alone = Mesh(
            mesh.vertices,
            tuple(mesh.faces[i] for i in blade),
            tuple(mesh.groups[i] for i in blade),
        )
        show_side(axes, blade_alone)
        axes.plot([0, 0.06], [0.35, 0.35], color=MARK, lw=0.8, ls="--")
        if angle:
            axes.add_patch(
                Arc((0, 0.35), 0.08, 0.08, theta1=0, theta2=angle, color=MARK)
            )
        axes.set_title(f"{angle}°")
        bare(axes)
    grid[0].set(xlim=(-0.07, 0.07), ylim=(0.33, 0.40))
    return figure


def cell(shapes: Shapes) -> Figure:
    """Draws a field from above, and how it repeats."""
    figure = new_figure(5.2, 2.1)
    left, right = figure.subplots(1, 2, width_ratios=(4.2, 2.6))
    plant = shapes.maize()
    rng = np.random.default_rng(1)
    turns = rng.uniform(-10, 10, (2, 2))
    for axes, copies in ((left, range(-1, 2)), (right, range(1))):
        for i in copies:
            for j in copies:
                for row in range(2):
                    for slot in range(2):
                        mesh = turned(plant, turns[row, slot])
                        # Rows stand apart in x, plants in y.
                        shift = [
                            ((i * 2) + row) * ROW, ((j * 2) + slot) * 2 * PLANT, 0
                        ]  # fmt: skip
                        moved = Mesh(
                            mesh.vertices + shift, mesh.faces, mesh.groups
                        )
                        draw(axes, moved, is_side=False)
        axes.add_patch(
            Rectangle(
                (-ROW / 2, -PLANT), 2 * ROW, 4 * PLANT,
                fill=False, color=MARK, lw=1.6, zorder=5,
            )
        )  # fmt: skip
        bare(axes)
    # Copies are pale.
    for x, y, width, height in (
        (-3, -3, 9, 3 - PLANT), (-3, 3 * PLANT, 9, 3),
        (-3, -PLANT, 3 - ROW / 2, 4 * PLANT),
        (1.5 * ROW, -PLANT, 3, 4 * PLANT),
    ):  # fmt: skip
        left.add_patch(
            Rectangle((x, y), width, height, color="white", alpha=0.55, lw=0)
        )
    left.set(xlim=(-1.7, 2.5), ylim=(-0.85, 1.15))
    left.set_title('boundary = "periodic"')
    right.set(xlim=(-0.9, 1.7), ylim=(-0.85, 1.15))
    right.set_title('boundary = "isolated"')
    return figure


def traits(shapes: Shapes) -> Figure:
    """Draws what a change of each trait does to maize."""

    def scale(key: str, factor: float) -> Change:
        def change(crop: dict[str, Any]) -> None:
            for leaf in crop["leaf"]:
                leaf[key] *= factor

        return change

    def put(key: str, values: Callable[[int], float]) -> Change:
        def change(crop: dict[str, Any]) -> None:
            for i, leaf in enumerate(crop["leaf"]):
                leaf[key] = values(i)

        return change

    def taller(crop: dict[str, Any]) -> None:
        scale("insertion_height", 1.2)(crop)
        crop["stalk"]["height"] *= 1.2

    def no_organs(crop: dict[str, Any]) -> None:
        for organ in crop["organ"]:
            organ["present"] = False

    shown: list[tuple[str, Change]] = [
        ("baseline", lambda crop: None),
        ("length × 0.7", scale("length", 0.7)),
        ("width × 1.4", scale("width", 1.4)),
        ("insertion_angle 60", put("insertion_angle", lambda i: 60)),
        ("curvature × 0.3", scale("curvature", 0.3)),
        ("height × 1.2", taller),
        ("azimuth 0, 180", put("azimuth", lambda i: 180.0 * (i % 2))),
        ("azimuth, a spiral", put("azimuth", lambda i: 137.5 * i % 360)),
        ("organs absent", no_organs),
    ]
    figure = new_figure(4.4, 9.4)
    grid = figure.subplots(
        6, 3, sharex=True, sharey="row", height_ratios=(2.5, 1.5) * 3
    )
    for i, (title, change) in enumerate(shown):
        mesh = shapes.maize(change)
        side, above = grid[i // 3 * 2 : i // 3 * 2 + 2, i % 3]
        draw(side, mesh, is_side=True)
        draw(above, mesh, is_side=False)
        side.set_title(title, fontsize=9)
        bare(side)
        bare(above)
        side.set(xlim=(-0.75, 0.75), ylim=(0, 2.5))
        above.set(ylim=(-0.75, 0.75))
    return figure


def light(shapes: Shapes) -> Figure:
    """Draws what faces absorb at two times of a clear day, in a dense
    stand."""
    plant = shapes.maize()
    surfaces = mesh(plant.vertices, plant.faces, groups=plant.groups)
    figure = new_figure(4.6, 4.4)
    grid = figure.subplots(1, 2, sharex=True, sharey=True)
    found = [
        surfaces.evaluate(
            period=(ROW, PLANT), by_face=True, paths=1 << 18, **source
        ).absorbed_by_face.values
        for source in ({"sun": (60, 180)}, {"sky": "uniform"})
    ]
    brightest = np.quantile(found[0], 0.98)
    colors = matplotlib.colormaps["viridis"]
    for axes, title, values in zip(
        grid, ("sun at 60°, from the south", "diffuse light"), found
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
    tables = read_campaign(DOCS.parent / "campaigns/agrivoltaic.toml")
    stand = Stand(tables)
    found = stand.evaluate(stand.baseline, tolerance=0.005).isel(
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
    hours, light = found.hour, found.object_light_by_hour.sel(object="panel")
    last = grid[-1]
    for label, values, color in (
        ("front of modules", light.sel(object_side="front"), "#234E78"),
        ("back of modules", light.sel(object_side="back"), "#7FA8CC"),
        ("leaves, absorbed per ground", found.absorbed_by_hour, "#4E9A3A"),
        ("ground", found.ground_light_by_hour, "#8F7459"),
    ):
        last.plot(hours, values, color=color, label=label)
    last.set(xlabel="hour", ylabel="PAR [W m⁻²]", xlim=(6, 21), ylim=(0, 640))
    last.legend(fontsize=8, loc="upper left", ncols=2)
    return figure


FIGURES: dict[str, Callable[[Shapes], Figure]] = {
    "azimuth": azimuth,
    "insertion_angle": insertion_angle,
    "curvature": curvature,
    "folding": folding,
    "cell": cell,
    "traits": traits,
    "light": light,
    "response": response,
    "agrivoltaics": agrivoltaics,
}


def save(figure: Figure, path: Path) -> None:
    """Saves a figure with few colours, so that it is small."""
    figure.savefig(path, dpi=150, bbox_inches="tight")
    with Image.open(path) as image:
        image.convert("RGB").quantize(96).save(path, optimize=True)


def main() -> None:
    parser = argparse.ArgumentParser(usage=(__doc__ or "").split("\n")[2])
    parser.add_argument("names", nargs="*", choices=[[], *FIGURES])
    options = parser.parse_args()
    (DOCS / "figures").mkdir(exist_ok=True)
    with matplotlib.rc_context(RC):
        for name in options.names or FIGURES:
            save(FIGURES[name](Shapes()), DOCS / "figures" / f"{name}.png")


if __name__ == "__main__":
    main()
