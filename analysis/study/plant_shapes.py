#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the shape of model plants with that of plants measured in a field.

plant_shapes.py FOLDER [--to FILE.png]

Draws fields of crops/maize.toml, crops/maize_hybrid.toml and the hybrid of the
1980s with FIELD_PLANTS of shared.py in FOLDER, and compares their leaves with
those of 11 plants of Iowa (measured/README.md).
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import tomllib
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pandas as pd
from estimates import print_table
from shared import (
    ANYWHERE,
    CAMPAIGNS,
    FIELD_PLANTS,
    HYBRID,
    HYBRID_1980S,
    MAIZE,
    Numbers,
    breed_tables,
    folder_at,
    guard,
    run_program,
)

from ideotype import Mesh
from ideotype.figures.style import RC, new_figure

MEASURED = Path(__file__).parent / "measured"
V02 = CAMPAIGNS / "plants" / "maize_v02.toml"
ROWS = 10  # The number of rows of a field and of plants per row.
CELLS = 40
"""The number of faces along a leaf: about 2 cm, near the 2.5 cm of measured
planes."""
STEEP = 70
IOWA = "11 plants of Iowa"
TITLES = {
    "inclination": ("inclination of leaf surfaces [deg]", 1),
    "steep": (f"share of area steeper than {STEEP} deg", 2),
    "reach": ("reach of leaves [m]", 2),
    "height": ("share of area by height", 2),
}
THIRDS = ("lower", "middle", "upper")
HEIGHTS = np.array([0, 0.2, 0.4, 0.6, 0.8, 1, 1.2, 1.4])
"""Heights relative to the highest insertion."""
PLANTS = {
    "version 0.2": (V02, {}),
    "as measured, all alike": (MAIZE, {}),
    "as measured, in the field": (MAIZE, FIELD_PLANTS),
    "hybrid of the 1980s, in the field": (HYBRID_1980S, FIELD_PLANTS),
    "hybrid, in the field": (HYBRID, FIELD_PLANTS),
}


@dataclass(frozen=True)
class Shape:
    """The leaves of plants. Angles and reach are stated for all leaves and for
    each third of the leaves."""

    inclination: Numbers  # The angle of surfaces from the horizontal [deg].
    steep: Numbers  # The fraction of the area steeper than STEEP.
    reach: Numbers  # The horizontal reach of midribs from their bases [m].
    height: Numbers  # The fraction of the area between HEIGHTS.


def read_obj(path: Path) -> Mesh:
    """Reads a mesh exported by the program."""
    vertices, faces, groups, group = [], [], [], ""
    for line in path.read_text().splitlines():
        word, *rest = line.split()
        if word == "v":
            vertices.append([float(x) for x in rest])
        elif word == "g":
            group = rest[0]
        elif word == "f":
            faces.append(tuple(int(x) - 1 for x in rest))
            groups.append(group)
    return Mesh(np.array(vertices), tuple(faces), tuple(groups))


def turned(crop: Path) -> str:
    """Returns an arbitrary trait of the whole plant. The first generation
    contains the baseline for any trait."""
    traits = tomllib.loads(crop.read_text()).get("trait", [])
    whole = (each["name"] for each in traits if each.get("per") == "plant")
    return next(whole, "azimuth")


def drawn(tables: Any, folder: Path) -> Mesh:
    """Returns the field of the baseline in the first generation of a
    campaign."""
    (history,) = breed_tables(tables, folder)
    to = history.with_suffix(".obj")
    to.unlink(missing_ok=True)
    program = os.environ.get("IDEOTYPE_EXECUTABLE", "ideotype")
    words = [program, "export", str(history), "--to", str(to)]
    words += ["--generation", "0", "--slot", "0", "--field"]
    run_program(words, stderr=subprocess.PIPE).check_returncode()
    return read_obj(to)


def field_of(
    name: str,
    crop: Path,
    variation: Any,
    folder: Path,
    size: tuple[int, int] = (ROWS, ROWS),
    spacing: tuple[float, float] = (0.76, 0.15),
    seed: int = 0,
) -> Mesh:
    """Returns the field of a plant as drawn in the first generation, where it
    is the baseline, with the given numbers of rows and of plants per row, and
    the given distances [m]."""
    tables = {
        **ANYWHERE,
        "name": re.sub("[^a-z0-9]+", "_", name),
        "seed": seed,
        "spacing": [dict(zip(("row", "plant"), spacing, strict=True))],
        "field": {
            "rows": size[0],
            "plants": size[1],
            "variation": variation,
        },
        "plant": {"baseline": str(crop), "cells_along": CELLS},
        "traits": [{"name": "turns", "free": [turned(crop)]}],
        "light": {"paths": 16, "randomisations": 2},
        "search": {"optimizer": "ga", "population": 2, "elites": 0},
        "stop": {"generations": 1},
        "final": {"candidates": 1, "paths": 16, "randomisations": 2},
    }
    return drawn(tables, folder)


def means(values: Numbers, leaf: Numbers, weights: Numbers) -> Numbers:
    """Returns means over all leaves and over each third of the leaves by
    rank."""
    third = np.floor(3 * (leaf - 0.5) / leaf.max())
    parts = [leaf > 0, *(third == i for i in range(3))]
    return np.array([np.average(values[k], weights=weights[k]) for k in parts])


def shape_of(field: Mesh) -> Shape:
    faces = pd.DataFrame({"face": field.faces, "group": field.groups})
    of = faces.group.str.extract(r"plant(?P<plant>\d+)_leaf(?P<leaf>\d+)")
    faces = faces.join(of.astype(float)).dropna()
    corners = field.vertices[np.array(faces.face.tolist())]
    a, b, c, d = np.moveaxis(corners, 1, 0)
    # The area of a nearly flat face is half the product of its diagonals.
    normals = np.cross(c - a, d - b) / 2
    area = np.linalg.norm(normals, axis=1)
    inclination = np.degrees(np.arccos(np.abs(normals[:, 2]) / area))
    rows = []
    tops: dict[float, float] = {}
    for (plant, leaf), own in faces.groupby(["plant", "leaf"]):
        used = sorted({i for face in own.face for i in face})
        midrib = field.vertices[used].reshape(-1, 3, 3)[:, 1]
        aside = np.linalg.norm((midrib - midrib[0])[:, :2], axis=1)
        rows.append((leaf, aside.max()))
        tops[plant] = max(midrib[0, 2], tops.get(plant, 0))
    leaf, reach = np.array(rows).T
    ranks = faces.leaf.to_numpy()
    height = corners[:, :, 2].mean(axis=1) / faces.plant.map(tops)
    return Shape(
        means(inclination, ranks, area),
        means(inclination > STEEP, ranks, area),
        means(reach, leaf, np.ones(len(leaf))),
        np.histogram(height, HEIGHTS, weights=area)[0] / area.sum(),
    )


def measured() -> tuple[Shape, dict[str, Numbers]]:
    """Returns the mean over plants and the values of each plant."""
    order = ["all", *THIRDS]
    heights, steps, plants = (
        pd.read_csv(MEASURED / f"iowa_{name}.csv", index_col=0)
        for name in ("area_by_height", "inclination_distribution", "leaves")
    )
    table = plants.pivot(columns="third")
    each = {
        "inclination": table.inclination_deg[order].to_numpy(),
        "reach": table.reach_m[order].to_numpy(),
        "height": heights.iloc[:, 2:].to_numpy(),
    }
    steep = steps.loc[order, ["70_80", "80_90"]].sum(axis=1).to_numpy()
    mean = {what: np.nanmean(x, axis=0) for what, x in each.items()}
    return Shape(steep=steep, **mean), each


def draw(shapes: dict[str, Shape], each: dict[str, Numbers], to: Path) -> None:
    figure = new_figure(7.2, 5.6)
    panels = figure.subplots(2, 2)
    for axes, (what, (title, _)) in zip(panels.ravel(), TITLES.items()):
        first = what != "height"
        x = np.arange(3) if first else (HEIGHTS[:-1] + HEIGHTS[1:]) / 2
        if what in each:
            axes.plot(x, each[what][:, first:].T, color="#C8C8C8", lw=0.8)
        for name, shape in shapes.items():
            style = "k--" if name == IOWA else "o-"
            axes.plot(x, getattr(shape, what)[first:], style, label=name)
        if first:
            axes.set_xticks(x, [f"{third} third" for third in THIRDS])
        else:
            axes.set_xlabel("height over that of the highest insertion")
        axes.set_title(title)
    panels[0, 0].legend(fontsize=7)
    figure.savefig(to, dpi=130)


def main() -> None:
    parser = argparse.ArgumentParser(usage=(__doc__ or "").split("\n")[2])
    parser.add_argument("folder", type=folder_at)
    parser.add_argument(
        "--to", type=Path, default=CAMPAIGNS / "study/figures/plant_shapes.png"
    )
    options = parser.parse_args()
    shapes = {
        name: shape_of(field_of(name, crop, variation, options.folder))
        for name, (crop, variation) in PLANTS.items()
    }
    shapes[IOWA], each = measured()
    draw(shapes, each, options.to)
    rows = []
    for what, (title, digits) in TITLES.items():
        parts = ["all", *THIRDS]
        if what == "height":
            parts = [f"{a:.1f} to {b:.1f}" for a, b in pairwise(HEIGHTS)]
        for i, part in enumerate(parts):
            values = (getattr(shape, what)[i] for shape in shapes.values())
            cells = (f"{value:.{digits}f}" for value in values)
            rows.append([f"{title}: {part}", *cells])
    print_table(["", *shapes], rows)


if __name__ == "__main__":
    with matplotlib.rc_context(RC):
        guard(main)
