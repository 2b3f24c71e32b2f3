#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Answers of Mitsuba 3, a path tracer of computer graphics (pip install
mitsuba).

Mitsuba has no periodic cell. The mesh is therefore repeated `REACH` metres to
each side, and light is measured on the faces of the middle copy and on the
soil below it. Each sample is a random point on either side of a face with a
cosine-distributed direction; Mitsuba's path integrator computes the radiance
from this direction. The reflected light is the remainder of the balance.
Mitsuba has no material that both reflects and transmits diffusely, so that
this adapter defines one, `Sheet`. Mitsuba compiles with LLVM: if the system's
version is too old, DRJIT_LIBLLVM_PATH gives the path of another."""

from __future__ import annotations

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_mono")
import drjit as dr  # noqa: E402
from answers import write_answers  # noqa: E402
from cases import Case, material_of, mesh_of  # noqa: E402

REACH = 12.0
SAMPLES = 2**18  # for each case; half of the points are on the soil


class Sheet(mi.BSDF):
    """A Lambertian sheet without thickness, with a reflectance of each face
    and a transmittance."""

    def __init__(self, props: mi.Properties) -> None:
        mi.BSDF.__init__(self, props)
        self.upper, self.lower = props["upper"], props["lower"]
        self.through = props["through"]
        flags = mi.BSDFFlags
        self.m_components = [
            flags.DiffuseReflection | flags.FrontSide | flags.BackSide,
            flags.DiffuseTransmission | flags.FrontSide | flags.BackSide,
        ]
        self.m_flags = self.m_components[0] | self.m_components[1]

    def _reflectance(self, wi: mi.Vector3f) -> mi.Float:
        return dr.select(mi.Frame3f.cos_theta(wi) > 0, self.upper, self.lower)

    def sample(self, ctx, si, one, two, active=True):
        reflectance = self._reflectance(si.wi)
        total = reflectance + self.through
        is_reflected = one * total < reflectance
        out = mi.warp.square_to_cosine_hemisphere(two)
        up = mi.Frame3f.cos_theta(si.wi) > 0
        out.z = dr.select(up == is_reflected, out.z, -out.z)
        sample = mi.BSDFSample3f()
        sample.wo, sample.eta = out, 1.0
        sample.pdf = self.pdf(ctx, si, out, active)
        sample.sampled_type = mi.UInt32(+mi.BSDFFlags.DiffuseReflection)
        sample.sampled_component = mi.UInt32(0)
        return sample, dr.select(active & (total > 0), mi.Spectrum(total), 0)

    def eval(self, ctx, si, wo, active=True):
        same = si.wi.z * wo.z > 0
        part = dr.select(same, self._reflectance(si.wi), self.through)
        return dr.select(active, mi.Spectrum(part * dr.abs(wo.z) / dr.pi), 0)

    def pdf(self, ctx, si, wo, active=True):
        reflectance = self._reflectance(si.wi)
        total = dr.maximum(reflectance + self.through, 1e-30)
        same = si.wi.z * wo.z > 0
        part = dr.select(same, reflectance, self.through) / total
        return dr.select(active, part * dr.abs(wo.z) / dr.pi, 0)

    def eval_pdf(self, ctx, si, wo, active=True):
        return self.eval(ctx, si, wo, active), self.pdf(ctx, si, wo, active)

    def traverse(self, callback) -> None:
        pass

    def to_string(self) -> str:
        return "Sheet[]"


mi.register_bsdf("sheet", Sheet)


def light_of(case: Case) -> dict[str, object]:
    """Returns an emitter that gives unit irradiance on level ground."""
    if "sun" in case["light"]:
        elevation, azimuth = np.radians(case["light"]["sun"])
        to_sun = [
            np.cos(elevation) * np.sin(azimuth),
            np.cos(elevation) * np.cos(azimuth),
            np.sin(elevation),
        ]
        return {
            "type": "directional",
            "direction": [-x for x in to_sun],
            "irradiance": {"type": "uniform", "value": 1 / to_sun[2]},
        }
    if case["light"]["sky"] == "uniform":
        return {
            "type": "constant",
            "radiance": {"type": "uniform", "value": 1 / np.pi},
        }
    # The sky as a map by zenith angle, with z up.
    rows = (np.arange(512) + 0.5) / 512 * np.pi
    cosine = np.maximum(np.cos(rows), 0)
    radiance = np.where(cosine > 0, (1 + 2 * cosine) * 3 / 7 / np.pi, 0)
    picture = np.repeat(radiance[:, None, None], 8, 1).astype(np.float32)
    return {
        "type": "envmap",
        "bitmap": mi.Bitmap(picture, mi.Bitmap.PixelFormat.Y),
        "to_world": mi.ScalarTransform4f().rotate([1, 0, 0], 90),
    }


def sheets_of(case: Case, name: str, shifts: np.ndarray) -> mi.Mesh:
    """Returns all copies of the faces of a group as one triangle mesh."""
    mesh = mesh_of(case)
    one = np.array([c for g, c in zip(mesh.groups, mesh.corners) if g == name])
    corners = (one[None] + shifts[:, None, None]).reshape(-1, 3)
    first = 4 * np.arange(len(corners) // 4)[:, None]
    upper, lower, through = material_of(case, name)
    properties = mi.Properties()
    properties["bsdf"] = mi.load_dict(
        {"type": "sheet", "upper": upper, "lower": lower, "through": through}
    )
    made = mi.Mesh(name, len(corners), len(corners) // 2, props=properties)
    target = mi.traverse(made)
    target["vertex_positions"] = corners.ravel()
    target["faces"] = (first + np.array([[0, 1, 2, 0, 2, 3]])).ravel()
    target.update()
    return made


def scene_of(case: Case) -> mi.Scene:
    mesh = mesh_of(case)
    x, y = (
        period
        * np.arange(-np.ceil(REACH / period), np.ceil(REACH / period) + 1)
        for period in mesh.period
    )
    shifts = np.stack(np.meshgrid(x, y, [0.0]), axis=-1).reshape(-1, 3)
    return mi.load_dict(
        {
            "type": "scene",
            "light": light_of(case),
            "soil": {
                "type": "rectangle",
                "to_world": mi.ScalarTransform4f().scale([1e3, 1e3, 1]),
                "bsdf": {
                    "type": "diffuse",
                    "reflectance": {
                        "type": "uniform",
                        "value": case["soil_albedo"],
                    },
                },
            },
        }
        | {name: sheets_of(case, name, shifts) for name in mesh.names}
    )


def irradiance(
    scene: mi.Scene,
    points: np.ndarray,
    normals: np.ndarray,
    to_sun: np.ndarray | None,
    seed: int,
) -> np.ndarray:
    """Returns the irradiance of points on the side of their normals. Each
    point has one sample: a cosine-distributed ray, and a ray to the sun."""
    n = len(points)
    sampler = mi.load_dict({"type": "independent"})
    sampler.seed(seed, n)
    position = mi.Point3f(points.T.astype(np.float32))
    normal = mi.Normal3f(normals.T.astype(np.float32))
    start = position + 2e-5 * normal
    along = mi.Frame3f(normal).to_world(
        mi.warp.square_to_cosine_hemisphere(sampler.next_2d())
    )
    integrator = mi.load_dict({"type": "path", "max_depth": 64, "rr_depth": 8})
    light, *_ = integrator.sample(
        scene, sampler, mi.RayDifferential3f(start, along)
    )
    found = np.array(light).reshape(-1)[:n] * np.pi
    if to_sun is not None:
        cosine = normals @ to_sun
        shadow = np.array(
            scene.ray_test(mi.Ray3f(start, mi.Vector3f(*map(float, to_sun))))
        )
        found = found + np.where(
            (cosine > 0) & ~shadow, np.maximum(cosine, 0) / to_sun[2], 0
        )
    return found


def points_on(
    corners: np.ndarray, number: int, random: np.random.Generator
) -> np.ndarray:
    """Returns uniformly distributed random points on a quadrilateral."""
    halves = np.array(
        [
            np.linalg.norm(
                np.cross(corners[1] - corners[0], corners[2] - corners[0])
            ),
            np.linalg.norm(
                np.cross(corners[2] - corners[0], corners[3] - corners[0])
            ),
        ]
    )
    u, v = random.random((2, number))
    over = u + v > 1
    u[over], v[over] = 1 - u[over], 1 - v[over]
    is_first = random.random(number) * halves.sum() < halves[0]
    second = np.where(is_first[:, None], corners[1], corners[3])
    return (
        corners[0]
        + u[:, None] * (second - corners[0])
        + v[:, None] * (corners[2] - corners[0])
    )


def answer(case: Case) -> dict[str, tuple[float, float | None]]:
    if case["class"] in ("energy", "assimilation"):
        return {}
    mesh, scene = mesh_of(case), scene_of(case)
    random = np.random.default_rng(1)
    ground = float(np.prod(mesh.period))
    to_sun = None
    if "sun" in case["light"]:
        elevation, azimuth = np.radians(case["light"]["sun"])
        to_sun = np.array(
            [
                np.cos(elevation) * np.sin(azimuth),
                np.cos(elevation) * np.cos(azimuth),
                np.sin(elevation),
            ]
        )
    each = SAMPLES // 2 // (2 * len(mesh.corners))
    points, normals, weights, owners = [], [], [], []
    for name, corners, area in zip(mesh.groups, mesh.corners, mesh.area):
        upper, lower, through = material_of(case, name)
        normal = np.cross(corners[2] - corners[0], corners[3] - corners[1])
        normal /= np.linalg.norm(normal)
        for side, reflectance in ((1, upper), (-1, lower)):
            points.append(points_on(corners, each, random))
            normals.append(np.broadcast_to(side * normal, (each, 3)))
            weights.append(area / ground * (1 - reflectance - through))
            owners.append(name)
    flat = np.zeros((SAMPLES // 2, 3))
    flat[:, :2] = random.random((SAMPLES // 2, 2)) * mesh.period
    points.append(flat)
    normals.append(np.broadcast_to([0.0, 0.0, 1.0], flat.shape))
    weights.append(1 - case["soil_albedo"])
    owners.append("soil")
    light = irradiance(
        scene, np.concatenate(points), np.concatenate(normals), to_sun, 1
    )
    parts = np.split(light, np.cumsum([len(p) for p in points])[:-1])
    found: dict[str, list[float]] = {}
    for part, weight, owner in zip(parts, weights, owners, strict=True):
        sums = found.setdefault(owner, [0.0, 0.0])
        sums[0] += weight * part.mean()
        sums[1] += weight**2 * part.var() / len(part)
    answers: dict[str, tuple[float, float | None]] = {
        k: (mean, variance**0.5) for k, (mean, variance) in found.items()
    }
    rest = 1 - sum(mean for mean, _ in answers.values())
    error = sum(e**2 for _, e in answers.values()) ** 0.5  # type: ignore[operator]
    return answers | {"reflected": (rest, error)}


if __name__ == "__main__":
    write_answers("mitsuba", answer)
