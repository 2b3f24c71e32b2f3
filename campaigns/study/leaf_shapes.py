#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures whether twist, waves and drooping tips of leaves matter.

leaf_shapes.py FOLDER [--seeds N] [--fields N] [--paths N] [--only WORD...]

Breeds ames_quick.toml in FOLDER, draws the blades of its baseline and of its
best plants with finer meshes, gives them other shapes, and evaluates each in
the same fields with the same random numbers. Prints what each shape does to
the light that leaves absorb, and to the gain of the bred plants over the
baseline. Shapes keep the length and area of each blade; parts that vary from
leaf to leaf are drawn at random for each plant of a field. Histories that are
complete are not run again. IDEOTYPE_EXECUTABLE names the program, else it is
that on PATH.
"""

from __future__ import annotations

import argparse
import math
import os
import random
import re
import tomllib
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from itertools import chain
from pathlib import Path
from statistics import fmean, stdev

import numpy as np
from scipy.interpolate import BSpline
from shared import CAMPAIGNS, Numbers, best, breed, guard

import ideotype

ROWS, PLANTS, ROW, PLANT, TURN = 4, 4, 0.762, 0.1524, 10
ALONG, HALF = 40, 2  # Cells from base to tip, and from midrib to margin.
FINE = 8  # Steps of the midrib's integral per cell.
#: The knots of the program's blades.
KNOTS = [0, 0, 0, 0, 1 / 3, 2 / 3, 1, 1, 1, 1]
#: The points of each group, in one or two variants, and the faces that use
#: them.
Mesh = dict[str, list[tuple[Numbers, list[list[int]]]]]


def power(exponent: float, s: float) -> float:
    """Returns the part of the bend that is reached at relative length s, in
    crop files."""
    return float(s**exponent)


def perez(half: float, s: float) -> float:
    """Returns the part of a bend in two segments; the first, up to `half`, has
    two thirds of it.

    ADEL and ArchiCrop call this leaf_shape_perez; CORNIBU
    (doi:10.1016/j.compag.2024.109694) has half = 0.5."""
    first = s <= half
    c, t = (-0.2, s / half) if first else (5, (s - half) / (1 - half))
    part = (1 + c) * t * t / (1 + c * t * t)
    return part * 2 / 3 if first else 2 / 3 + part / 3


def prevot(s: float) -> float:
    """Returns the part of the bend of a parabola up to the highest point of
    the midrib, then of an arc of a circle.

    Prevot and others 1991, Agronomie 11, 491, have it, with medians of leaf 6
    of the inbred F2 (ADEL, adelMons/data/05_geomF2_S1B1.h): 56 deg up to 0.53,
    then 63 deg."""
    rise, top, fall = 56.0, 0.53, 63.0
    if s > top:
        return (rise + fall * (s - top) / (1 - top)) / (rise + fall)

    def length(slope: float) -> float:
        return slope * math.sqrt(1 + slope**2) + math.asinh(slope)

    start = math.tan(math.radians(rise))
    low, high = 0.0, start
    for _ in range(40):
        middle = (low + high) / 2
        long = length(middle) > length(start) * (1 - s / top)
        low, high = (low, middle) if long else (middle, high)
    return (rise - math.degrees(math.atan(low))) / (rise + fall)


@dataclass(frozen=True)
class Shape:
    """The changes of each blade."""

    source: str
    bend: Callable[[float], float] = partial(power, 1.5)  # noqa: RUF009
    total_bend: float | None = None
    """The bend of all leaves [deg]; if it is not given, each has its own."""
    twist: float = 0
    """The twist of the tip about the midrib [deg]."""
    one_sense: bool = False
    """Whether all leaves twist one way, else each at random."""
    roll: float = 0
    """The largest roll of the cross-section [deg], in turn to both sides."""
    half_waves: int = 8
    """The half waves of the roll, base to tip, as long as the blade is
    wide."""
    amplitude: float = 0
    """The amplitude of the margins, normal to the blade [m]."""
    wavelength: float = 0.15
    """The wavelength of the margins [m]."""

    @property
    def varies(self) -> bool:
        """Whether leaves differ at random."""
        return bool(
            self.roll or self.amplitude or (self.twist and not self.one_sense)
        )


ADEL = "ADEL, ArchiCrop, CORNIBU"
#: The model of github.com/UniCornXZC/parametric_maize_leaf, "Modeling Maize
#: Leaf Geometry and Surface Area by Triangle Mesh": 7 or 10 angles, at random
#: up to 45 deg.
ROLL = "parametric_maize_leaf"
#: The shapes, in which E marks our estimates.
SHAPES = {
    "as in crop files": Shape(""),
    "twist of 10 deg": Shape("E", twist=10),
    "twist of 30 deg": Shape("E", twist=30),
    "twist of 60 deg": Shape("E", twist=60),
    "twist of 60 deg, one sense": Shape("E", twist=60, one_sense=True),
    "twist of 90 deg": Shape("E, extreme", twist=90),
    "roll to both sides, up to 22 deg": Shape(f"{ROLL}, half", roll=22.5),
    "roll to both sides, up to 45 deg": Shape(ROLL, roll=45),
    "roll to both sides, up to 10 deg": Shape("E", roll=10),
    "waves of margins, 1 cm": Shape("E", amplitude=0.01),
    "waves of margins, 2 cm": Shape("E, extreme", amplitude=0.02),
    "bend exponent 1": Shape("arc of a circle; E", partial(power, 1)),
    "bend exponent 2": Shape("E", partial(power, 2)),
    "bend exponent 3, tips droop": Shape("E", partial(power, 3)),
    "two segments, break at 0.5": Shape(ADEL, partial(perez, 0.5)),
    "parabola and arc": Shape("Prevot 1991, ADEL's F2", prevot),
    "parabola and arc, bend of 119 deg": Shape(
        "the same, as measured", prevot, 119
    ),
}


def half_widths(controls: list[float], width: float) -> Numbers:
    """Returns half widths of a blade at the rows of its mesh [m]."""
    profile = BSpline(KNOTS, controls, 3)(np.linspace(0, 1, ALONG + 1))
    return np.asarray(width / 2 * profile / profile.max())


def rolls(shape: Shape, halves: Numbers, draw: random.Random) -> Numbers:
    """Returns turns of the cross-sections at the rows of a mesh [rad]: random
    extremes to one side and the other in turn, half waves as long as the blade
    is wide there."""
    count, first = shape.half_waves, draw.choice([0, 1])
    ends = np.zeros(count + 1)
    for k in range(1, count):
        ends[k] = (-1) ** (k + first) * shape.roll * draw.random()
    # The phase grows by the inverse of the width, which never counts as less
    # than 40 % of the largest.
    steps = np.append(0, 1 / np.maximum(halves[1:], 0.4 * halves.max()))
    phase = count * np.cumsum(steps) / steps.sum()
    k = np.minimum(phase.astype(int), count - 1)
    smooth = (1 - np.cos(np.pi * (phase - k))) / 2
    return np.asarray(np.radians(ends[k] + (ends[k + 1] - ends[k]) * smooth))


def blade(
    shape: Shape,
    leaf: dict[str, float],
    halves: Numbers,
    rise: float,
    base: Numbers,
    seed: int,
) -> Numbers:
    """Returns vertices, row by row from the base and from margin to margin."""
    azimuth = math.radians(leaf["azimuth"])
    out = np.array([math.sin(azimuth), math.cos(azimuth), 0])
    across = np.array([math.cos(azimuth), -math.sin(azimuth), 0])
    up = np.array([0, 0, 1])
    bend = leaf["curvature"] if shape.total_bend is None else shape.total_bend
    length = leaf["length"]
    draw = random.Random(seed)
    roll = rolls(shape, halves, draw)
    sense = 1 if shape.one_sense or seed % 2 else -1
    phases = [2 * math.pi * draw.random() for _ in range(2)]

    def along(s: Numbers, ahead: float = 0) -> Numbers:
        """Returns the midrib's direction, or one that is ahead of it by an
        angle [rad]."""
        bent = leaf["insertion_angle"] + bend * np.vectorize(shape.bend)(s)
        angle = (np.radians(bent) + ahead)[:, None]
        return np.asarray(np.sin(angle) * out + np.cos(angle) * up)

    middles = (np.arange(ALONG * FINE) + 0.5) / FINE / ALONG
    steps = along(middles) * length / FINE / ALONG
    feet = base + np.insert(np.cumsum(steps, axis=0), 0, 0, axis=0)[::FINE]
    s = np.linspace(0, 1, ALONG + 1)
    normal = along(s, -math.pi / 2)
    turn = (sense * math.radians(shape.twist) * s + roll)[:, None]
    x = np.cos(turn) * across + np.sin(turn) * normal
    n = np.cos(turn) * normal - np.sin(turn) * across
    u = np.linspace(-1, 1, WIDE)
    size = shape.amplitude * np.minimum(1, s / 0.3) * halves / halves.max()
    phase = np.where(u > 0, phases[1], phases[0])
    at = 2 * math.pi * length * s / shape.wavelength
    wave = size[:, None] * u**2 * np.sin(phase + at[:, None])
    aside = halves[:, None] * u * math.cos(rise)
    above = halves[:, None] * np.abs(u) * math.sin(rise) + wave
    points = (
        feet[:, None]
        + aside[..., None] * x[:, None]
        + above[..., None] * n[:, None]
    )
    return np.asarray(points).reshape(-1, 3)


WIDE = 2 * HALF + 1
CELLS = [
    [
        i * WIDE + j,
        i * WIDE + j + 1,
        (i + 1) * WIDE + j + 1,
        (i + 1) * WIDE + j,
    ]
    for i in range(ALONG)
    for j in range(2 * HALF)
]


def area(points: Numbers) -> float:
    a, b, c, d = np.moveaxis(points[CELLS], 1, 0)
    both = np.cross(b - a, c - a), np.cross(c - a, d - a)
    return float(sum(np.linalg.norm(x, axis=1).sum() for x in both) / 2)


class Plant:
    """A plant of a stand, as the program and as this script draw it."""

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
        """Returns the plant with finer blades of another shape, which keep
        their areas."""
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
    """Returns the field of ames.toml, rows from east to west: x is east, y
    north.

    The y of a plant is along the row and its x to the south; each plant is
    turned at random."""
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
                # RESULTS.md.
                vertices.append(np.round(np.column_stack(placed), 6))
                faces += [[count + i for i in face] for face in own]
                groups += [re.split("[0-9_]", name)[0]] * len(own)
                count += len(points)
    return ideotype.mesh(np.concatenate(vertices), faces, groups=groups)


def leaf_light(mesh: Mesh, options: argparse.Namespace) -> list[float]:
    """Returns what leaves absorb of a clear day's light, field by field
    [%]."""

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


def mean_and_error(values: list[float]) -> tuple[float, float]:
    return fmean(values), stdev(values) / math.sqrt(len(values))


def text_of(values: list[float]) -> str:
    mean, error = mean_and_error(values)
    return f"{mean:+.2f} ± {error:.2f}"


def changes(after: list[float], before: list[float]) -> list[float]:
    return [100 * (a / b - 1) for a, b in zip(after, before, strict=True)]


def gains(lights: list[list[float]]) -> list[list[float]]:
    """Returns the gain of each bred plant over the first, field by field
    [%]."""
    return [changes(own, lights[0]) for own in lights[1:]]


def mean_of(lists: list[list[float]]) -> list[float]:
    return list(map(fmean, zip(*lists, strict=True)))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
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
