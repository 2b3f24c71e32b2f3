#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the effect of twist, waves and drooping tips of leaves.

leaf_shapes.py FOLDER [--seeds N] [--fields N] [--paths N] [--only WORD...]

Runs ames_quick.toml in FOLDER and draws the blades of its baseline and of its
best plants with finer meshes and other shapes. All are evaluated in the same
fields with common random numbers. Prints the effect of each shape on absorbed
light, and on the gain of the optimised plants over the baseline. Shapes keep
the length and area of each blade; parts that vary from leaf to leaf are random
for each plant of a field. Finished histories are not repeated.
IDEOTYPE_EXECUTABLE names the program; without it, the one on PATH is used.
"""

from __future__ import annotations

import argparse
import math
import os
import random
import re
import tomllib
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from itertools import chain
from pathlib import Path
from statistics import fmean

import numpy as np
from blade_shapes import (
    CELLS,
    SHAPES,
    Shape,
    area,
    blade,
    half_widths,
)  # fmt: skip
from estimates import estimate, plus_minus
from shared import CAMPAIGNS, Numbers, best, breed, guard, parser_of

import ideotype

ROWS, PLANTS, ROW, PLANT, TURN = 4, 4, 0.762, 0.1524, 10
#: The points of each group, in one or two variants, with the faces that use
#: them.
Mesh = dict[str, list[tuple[Numbers, list[list[int]]]]]


class Plant:
    """A plant of a stand, drawn by the program and by this script."""

    def __init__(self, stand: ideotype.Stand, genome: Numbers) -> None:
        self.traits = tomllib.loads(stand.crop_file(genome))
        own = stand.mesh(genome)
        self.mesh: Mesh = {}
        for name in dict.fromkeys(own.groups):
            faces = [
                face
                for face, group in zip(own.faces, own.groups, strict=True)
                if group == name
            ]
            used = sorted({i for face in faces for i in face})
            at = {old: new for new, old in enumerate(used)}
            renumbered = [[at[i] for i in face] for face in faces]
            self.mesh[name] = [(own.vertices[used], renumbered)]

    def drawn(self, shape: Shape) -> Mesh:
        """Returns the plant with finer blades of another shape and unchanged
        area."""
        folding = math.radians(self.traits["blade"]["folding_angle"])
        controls = self.traits["blade"]["width_controls"]
        mesh = {k: v for k, v in self.mesh.items() if not k.startswith("leaf")}
        for rank, leaf in enumerate(self.traits["leaf"], start=1):
            ((points, faces),) = self.mesh[f"leaf{rank:02}"]
            base = points[faces[0][1]]
            halves = half_widths(controls, leaf["width"])
            draw = partial(blade, leaf=leaf, rise=folding, base=base)
            wanted = area(draw(Shape(""), halves=halves, seed=0))
            variants = mesh[f"leaf{rank:02}"] = []
            for seed in (2 * rank, 2 * rank + 1) if shape.varies else (0,):
                own = halves
                for _ in range(2):
                    own = own * (
                        wanted / area(draw(shape, halves=own, seed=seed))
                    )
                variants.append((draw(shape, halves=own, seed=seed), CELLS))
        return mesh


def field_of(mesh: Mesh, seed: int) -> ideotype.Canopy:
    """Returns the field of ames.toml with rows from east to west: x is east, y
    is north.

    In the coordinates of the plant, y is along the row and x points south;
    each plant is rotated at random."""
    draw, choose = random.Random(seed), random.Random(seed)
    vertices: list[Numbers] = []
    faces: list[list[int]] = []
    groups: list[str] = []
    count = 0
    for row in range(ROWS):
        for place in range(PLANTS):
            turn = math.radians(draw.uniform(-TURN, TURN))
            c, s = math.cos(turn), math.sin(turn)
            for name, variants in mesh.items():
                points, own = choose.choice(variants)
                x, y, z = points.T
                x, y = c * x - s * y, s * x + c * y
                placed = y + place * PLANT, -x + row * ROW, z
                # Points are rounded to the micrometre, as in the meshes of
                # docs/results/organs_and_leaves.md.
                vertices.append(np.round(np.column_stack(placed), 6))
                faces += [[count + i for i in face] for face in own]
                groups += [re.split("[0-9_]", name)[0]] * len(own)
                count += len(points)
    return ideotype.mesh(np.concatenate(vertices), faces, groups=groups)


def leaf_light(mesh: Mesh, options: argparse.Namespace) -> list[float]:
    """Returns the fraction of a clear day's light that leaves absorb, field by
    field [%]."""

    def share(seed: int) -> float:
        found = field_of(mesh, seed).evaluate(
            period=(PLANTS * PLANT, ROWS * ROW),
            site=(42, -93.6, -5),
            day="2025-08-07",
            paths=options.paths,
            seed=seed,
        )
        return float(100 * found.leaves / found.incident)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(share, range(1, options.fields + 1)))


def text_of(values: list[float]) -> str:
    return plus_minus(estimate(values), 2, "+")


def changes(after: list[float], before: list[float]) -> list[float]:
    return [100 * (a / b - 1) for a, b in zip(after, before, strict=True)]


def gains(lights: list[list[float]]) -> list[list[float]]:
    """Returns the gain of each optimised plant over the first plant, field by
    field [%]."""
    return [changes(own, lights[0]) for own in lights[1:]]


def mean_of(lists: list[list[float]]) -> list[float]:
    return list(map(fmean, zip(*lists, strict=True)))


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("--seeds", type=int, default=3, metavar="N")
    parser.add_argument("--fields", type=int, default=4, metavar="N")
    parser.add_argument("--paths", type=int, default=2**19, metavar="N")
    parser.add_argument(
        "--only",
        nargs="+",
        default=[""],
        metavar="WORD",
        help="shapes with a word",
    )
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    options = parser.parse_args()
    if options.fields < 2:
        parser.error("--fields must be 2 or more (errors are from fields)")
    options.folder.mkdir(parents=True, exist_ok=True)
    histories = breed(
        CAMPAIGNS / "ames_quick.toml",
        "ames_quick",
        [f"replicates={options.seeds}"],
        options.folder,
    )
    stand = ideotype.Stand.from_history(histories[0], same_isa=False)
    genomes = [stand.baseline, *map(best, histories)]
    plants = [Plant(stand, genome) for genome in genomes]

    before: list[list[float]] = []
    print(
        "| shape of the blades | source | light of the baseline [%] ", end=""
    )
    print("| of bred plants [%] | gain [%] | change of the gain | by plant |")
    print("|---|---|---|---|---|---|---|", flush=True)

    def print_row(
        name: str, source: str, meshes: list[Mesh]
    ) -> list[list[float]]:
        lights = [leaf_light(mesh, options) for mesh in meshes]
        own = gains(lights)
        cells = [
            f"{fmean(x):.2f}" for x in (lights[0], list(chain(*lights[1:])))
        ]
        cells += [f"{fmean(mean_of(own)):.2f}", "", ""]
        if before:
            light = [
                changes(*pair) for pair in zip(lights, before, strict=True)
            ]
            cells[:2] = [text_of(light[0]), text_of(mean_of(light[1:]))]
            gain = [
                [x - y for x, y in zip(*pair, strict=True)]
                for pair in zip(own, gains(before), strict=True)
            ]
            by_plant = ", ".join(f"{fmean(each):+.2f}" for each in gain)
            cells[3:] = [text_of(mean_of(gain)), by_plant]
        print(f"| {name} | {source} | " + " | ".join(cells) + " |", flush=True)
        return lights

    for i, (name, shape) in enumerate(SHAPES.items()):
        if i and not any(word in name for word in options.only):
            continue
        lights = print_row(
            name, shape.source, [plant.drawn(shape) for plant in plants]
        )
        before = before or lights
    if any(word in "mesh" for word in options.only):
        print_row("the program's mesh", "", [plant.mesh for plant in plants])


if __name__ == "__main__":
    guard(main)
