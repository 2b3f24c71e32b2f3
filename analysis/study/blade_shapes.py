# SPDX-License-Identifier: Apache-2.0
"""Shapes of leaf blades: how they bend, twist, roll and wave, and their meshes."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from scipy.interpolate import BSpline
from shared import Numbers

ALONG, HALF = 40, 2  # Cells from base to tip, and from midrib to margin.
FINE = 8  # Integration steps along the midrib per cell.
#: The knots of blades in the program.
KNOTS = [0, 0, 0, 0, 1 / 3, 2 / 3, 1, 1, 1, 1]


def power(exponent: float, s: float) -> float:
    """Returns the fraction of the bend that a midrib has reached at relative
    length s, as in crop files."""
    return float(s**exponent)


def perez(half: float, s: float) -> float:
    """Returns the fraction of a bend that consists of two segments. The first,
    up to `half`, contains two thirds of the bend.

    ADEL and ArchiCrop call this leaf_shape_perez; in CORNIBU
    (doi:10.1016/j.compag.2024.109694) half = 0.5."""
    first = s <= half
    c, t = (-0.2, s / half) if first else (5, (s - half) / (1 - half))
    part = (1 + c) * t * t / (1 + c * t * t)
    return part * 2 / 3 if first else 2 / 3 + part / 3


def prevot(s: float) -> float:
    """Returns the fraction of the bend of a midrib that consists of a parabola
    up to its highest point, followed by an arc of a circle.

    This is the form of Prevot and others 1991, Agronomie 11, 491, with medians
    of leaf 6 of the inbred F2 (ADEL, adelMons/data/05_geomF2_S1B1.h): 56 deg
    up to 0.53, then 63 deg."""
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
    """Changes of shape that apply to each blade."""

    source: str
    bend: Callable[[float], float] = partial(power, 1.5)  # noqa: RUF009
    total_bend: float | None = None
    """The bend of all leaves [deg]; if it is not given, each has its own."""
    twist: float = 0
    """The twist of the tip about the midrib [deg]."""
    one_sense: bool = False
    """Whether all leaves twist to the same side, else each at random."""
    roll: float = 0
    """The largest roll of the cross-section [deg], alternating between
    sides."""
    half_waves: int = 8
    """Whether the roll has half waves from base to tip that are as long as the
    blade is wide."""
    amplitude: float = 0
    """The amplitude of the margins, normal to the blade [m]."""
    wavelength: float = 0.15
    """The wavelength of the margins [m]."""

    @property
    def varies(self) -> bool:
        """Returns whether leaves differ at random."""
        return bool(
            self.roll or self.amplitude or (self.twist and not self.one_sense)
        )


ADEL = "ADEL, ArchiCrop, CORNIBU"
#: The model of github.com/UniCornXZC/parametric_maize_leaf, "Modeling Maize
#: Leaf Geometry and Surface Area by Triangle Mesh", with 7 or 10 random angles
#: of up to 45 deg.
ROLL = "parametric_maize_leaf"
#: The shapes by name; E marks estimates of this project.
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
    """Returns the half widths of a blade at the rows of its mesh [m]."""
    profile = BSpline(KNOTS, controls, 3)(np.linspace(0, 1, ALONG + 1))
    return np.asarray(width / 2 * profile / profile.max())


def rolls(shape: Shape, halves: Numbers, draw: random.Random) -> Numbers:
    """Returns the rotation of the cross sections at the rows of a mesh [rad].
    Random extremes alternate between both sides; each half wave is as long as
    the blade is wide at its position."""
    count, first = shape.half_waves, draw.choice([0, 1])
    ends = np.zeros(count + 1)
    for k in range(1, count):
        ends[k] = (-1) ** (k + first) * shape.roll * draw.random()
    # The phase advances in inverse proportion to the width, which counts as at
    # least 40 % of the largest width.
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
    """Returns the vertices, row by row from the base, each row from margin to
    margin."""
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
        """Returns the direction of the midrib, or the direction rotated ahead
        by an angle [rad]."""
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
