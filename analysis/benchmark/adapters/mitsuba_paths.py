#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Answers of Mitsuba 3, a renderer of computer graphics (pip install mitsuba
scipy).

Mitsuba has no periodic cell, and its integrators trace from sensors in a finite
field. This adapter therefore has a separate path loop on Mitsuba's ray
tracing (Embree). Dr.Jit records the loop once, compiles it, and then runs it
without Python:

* The scene is one block of whole cells, at least `BLOCK` metres wide, with the
  soil. A ray that leaves it at one side enters at the opposite side: the field
  has no end, and no copies are in memory beyond the block.
* Paths start above the stand with the directions of the sun or the sky, so that
  they reach surfaces in proportion to the light. Each surface that a path
  meets absorbs its part of the weight 1; the path survives with the
  probability of the albedo.
* Starts and first directions are a Kronecker sequence with a random shift for
  each seed. It spreads them more evenly than random numbers do.

The standard error is that of `REPEATS` seeds, but at least the weight of one
path. Mitsuba compiles with LLVM: if the system's version is too old,
DRJIT_LIBLLVM_PATH gives the path of another."""

from __future__ import annotations

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_mono")
import drjit as dr  # noqa: E402
from answers import write_answers  # noqa: E402
from cases import Case, material_of, mesh_of  # noqa: E402

SAMPLES = 2**17  # paths of a case and seed
REPEATS = 16  # seeds
BLOCK = 2.0  # m
BINS = 64  # for the reflected light, the soil and the organs
OFFSET = 2e-5  # m, of new rays from their surface
SEGMENTS = 1000  # passages through the block after which a path ends


def triangles(faces: np.ndarray) -> np.ndarray:
    """Returns two triangles [2 n, 3, 3] for each face [n, 4, 3]."""
    return faces[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3, 3)


def packed(numbers: np.ndarray) -> mi.Float:
    return mi.Float(np.ascontiguousarray(numbers, np.float32).ravel())


def random_numbers(stream: mi.UInt32, seed: mi.UInt32) -> mi.PCG32:
    """Returns generators whose states are hashes of stream and seed, as those
    of Mitsuba's samplers; streams of neighbouring states are correlated."""
    state, sequence = mi.sample_tea_32(stream, seed)
    return mi.PCG32(1, mi.UInt64(state), mi.UInt64(sequence))


def kronecker(index: mi.UInt32, shift: mi.PCG32) -> list[mi.Float]:
    """Returns a point in four dimensions for each index: multiples of powers
    of the root of x^5 = x + 1, as fractions of 32 bits that wrap (Roberts
    2018, The unreasonable effectiveness of quasirandom sequences)."""
    root = 1.1673039782614187
    return [
        mi.Float((index * round(2**32 / root**k) + shift.next_uint32()) >> 8)
        * 2**-24
        for k in (1, 2, 3, 4)
    ]


def to_sun(case: Case) -> list[float]:
    """Returns the direction to the sun, or upward under a sky."""
    elevation, azimuth = np.radians(case["light"].get("sun", (90, 0)))
    return [
        float(np.cos(elevation) * np.sin(azimuth)),
        float(np.cos(elevation) * np.cos(azimuth)),
        float(np.sin(elevation)),
    ]


class Field:
    """A case of light as a scene of Mitsuba. `names` are `reflected`, `soil` and
    the groups of the mesh."""

    def __init__(self, case: Case) -> None:
        mesh = mesh_of(case)
        self.names = ["reflected", "soil", *mesh.names]
        self.light = case["light"].get("sky", "sun")
        self.sun = dr.opaque(mi.Vector3f, to_sun(case))
        period = np.array(mesh.period)
        cell = triangles(np.array(mesh.corners))
        owner = np.repeat([self.names.index(n) for n in mesh.groups], 2)
        optics = np.repeat(
            [material_of(case, name) for name in mesh.groups], 2, axis=0
        )

        # All copies of the cell that reach into the block, above the soil.
        number = np.ceil(BLOCK / period)
        size = number * period
        height = float(cell[..., 2].max()) + 1e-3
        self.size = dr.opaque(mi.Vector3f, [*size.tolist(), height])
        least, most = cell[..., :2].min((0, 1)), cell[..., :2].max((0, 1))
        x, y = (
            period[i]
            * np.arange(-np.ceil(most[i] / period[i]), number[i] + 1 - low)
            for i, low in enumerate(np.floor(least / period))
        )
        shifts = np.stack(np.meshgrid(x, y, [0.0]), axis=-1).reshape(-1, 1, 3)
        copies = (cell + shifts[:, None]).reshape(-1, 3, 3)
        is_inside = (
            (copies.max(1)[:, :2] >= 0) & (copies.min(1)[:, :2] <= size)
        ).all(1)
        (a, b), (c, d) = (-1, -1), size + 1
        soil = np.array([[[a, b, 0], [c, b, 0], [c, d, 0], [a, d, 0]]])
        block = np.concatenate([copies[is_inside], triangles(soil)])
        mesh = mi.Mesh("block", 3 * len(block), len(block))
        target = mi.traverse(mesh)
        target["vertex_positions"] = packed(block)
        target["faces"] = mi.UInt32(np.arange(3 * len(block), dtype=np.uint32))
        target.update()
        self.scene = mi.load_dict({"type": "scene", "block": mesh})

        # Normal, optics and owner of each triangle.
        normal = np.cross(block[:, 1] - block[:, 0], block[:, 2] - block[:, 0])
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        soil_optics = [[case["soil_albedo"], 0, 0]] * 2
        self.faces = [
            packed(normal),
            packed(
                np.concatenate(
                    [np.tile(optics, (len(shifts), 1))[is_inside], soil_optics]
                )
            ),
        ]
        soil_owner = [1, 1]
        self.owner = mi.UInt32(
            np.concatenate(
                [np.tile(owner, len(shifts))[is_inside], soil_owner]
            ).astype(np.uint32)
        )

    def trace(self, samples: int, seed: int, shifts: int = 1) -> np.ndarray:
        """Returns the fraction of the light that each of `names` receives, as
        the mean over independent shifts of the sequence. The first call with a
        kind of light compiles."""
        received = trace(
            self.scene,
            self.faces,
            self.owner,
            self.size,
            self.light,
            self.sun,
            dr.zeros(mi.Float64, BINS),
            dr.arange(mi.UInt32, samples),
            dr.opaque(mi.UInt32, seed),
            dr.opaque(mi.UInt32, shifts),
        )
        return received.numpy()[: len(self.names)] / samples


def downward(
    light: str, sun: mi.Vector3f, u: mi.Float, v: mi.Float
) -> mi.Vector3f:
    """Returns directions with the distribution of light on level ground."""
    if light == "sun":
        return -sun
    cosine = dr.sqrt(u)
    if light == "overcast":
        # The density is 6/7 c + 12/7 c^2: two parts by their inverses.
        cosine = dr.select(
            u < 3 / 7,
            dr.sqrt(u * 7 / 3),
            dr.cbrt(dr.maximum(u - 3 / 7, 0) * 7 / 4),
        )
    sine = dr.safe_sqrt(1 - cosine**2)
    s, c = dr.sincos(2 * dr.pi * v)
    return mi.Vector3f(sine * c, sine * s, -dr.maximum(cosine, 1e-6))


# Other numbers of paths or triangles may be recorded again.
@dr.freeze(warn_after=1000)
@dr.syntax
def trace(
    scene: mi.Scene,
    faces: list[mi.Float],
    owner: mi.UInt32,
    size: mi.Vector3f,
    light: str,
    sun: mi.Vector3f,
    none: mi.Float64,
    index: mi.UInt32,
    seed: mi.UInt32,
    shifts: mi.UInt32,
) -> mi.Float64:
    """Returns the sums of the weights that owners receive; the first is what
    leaves upward. Each turn of the loop traces one ray through the block."""
    received = mi.Float64(none)
    random = random_numbers(index, seed)
    # No path has the stream of a shift.
    number = index // shifts
    shift = random_numbers(2**32 - 1 - (index - number * shifts), seed)
    x, y, u, v = kronecker(number, shift)
    at = mi.Vector3f(x, y, 1) * size
    way = downward(light, sun, u, v)
    is_active, turns = mi.Bool(True), mi.UInt32(0)
    while is_active:
        # Distances to the sides and to the top of the block.
        side_x = dr.select(way.x > 0, size.x, 0)
        side_y = dr.select(way.y > 0, size.y, 0)
        to_x = dr.select(way.x == 0, dr.inf, (side_x - at.x) / way.x)
        to_y = dr.select(way.y == 0, dr.inf, (side_y - at.y) / way.y)
        to_top = dr.select(way.z > 0, (size.z - at.z) / way.z, dr.inf)
        to_side = dr.minimum(to_x, to_y)
        ray = mi.Ray3f(mi.Point3f(at), way, dr.minimum(to_side, to_top), 0, [])
        hit = scene.ray_intersect_preliminary(ray, active=is_active)
        is_hit = hit.is_valid()
        is_out = is_active & ~is_hit & (to_top <= to_side)

        # Absorption, and the light that leaves upward.
        face = hit.prim_index
        normal = dr.gather(mi.Vector3f, faces[0], face, is_hit)
        optics = dr.gather(mi.Vector3f, faces[1], face, is_hit)
        is_upper = dr.dot(normal, way) < 0
        reflectance = dr.select(is_upper, optics.x, optics.y)
        albedo = reflectance + optics.z
        dr.scatter_add(
            received,
            mi.Float64(dr.select(is_hit, 1 - albedo, 1)),
            dr.select(
                is_hit,
                dr.gather(mi.UInt32, owner, face, is_hit),
                0,
            ),
            is_hit | is_out,
        )

        # The next ray: scattered, or continued at the opposite side.
        fate = random.next_float32()
        is_up = is_upper == (fate < reflectance)
        normal = dr.select(is_up, normal, -normal)
        local = mi.warp.square_to_cosine_hemisphere(
            mi.Point2f(random.next_float32(), random.next_float32())
        )
        across = at + to_side * way
        is_x = to_x <= to_y
        across.x = dr.select(is_x, size.x - side_x, across.x)
        across.y = dr.select(is_x, across.y, size.y - side_y)
        at = dr.select(is_hit, at + hit.t * way + OFFSET * normal, across)
        way = dr.select(is_hit, mi.Frame3f(normal).to_world(local), way)
        turns += 1
        is_active &= ~is_out & (~is_hit | (fate < albedo))
        is_active &= turns < SEGMENTS
    return received


def answer(case: Case) -> dict[str, tuple[float, float | None]]:
    if case["class"] in ("energy", "assimilation"):
        return {}
    field = Field(case)
    found = np.array(
        [field.trace(SAMPLES, seed) for seed in range(1, REPEATS + 1)]
    )
    errors = np.maximum(
        found.std(0, ddof=1) / REPEATS**0.5, 1 / SAMPLES / REPEATS
    )
    pairs = zip(found.mean(0).tolist(), errors.tolist(), strict=True)
    return dict(zip(field.names, pairs, strict=True))


if __name__ == "__main__":
    write_answers("mitsuba", answer)
