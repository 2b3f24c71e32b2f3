# SPDX-License-Identifier: Apache-2.0
"""Answers by the second method: plain.cpp for light, leaf.py for leaves."""

from __future__ import annotations

import subprocess
import tempfile
from functools import cache
from pathlib import Path

import numpy as np
from cases import HERE, Case, material_of, mesh_of
from leaf import energy_balance, gross

Answers = dict[str, tuple[float, float]]


@cache
def _tracer() -> tuple[Path, tempfile.TemporaryDirectory[str]]:
    folder = tempfile.TemporaryDirectory()
    program = Path(folder.name) / "plain"
    subprocess.run(
        ["c++", "-std=c++20", "-O2", HERE / "plain.cpp", "-o", program],
        check=True,
    )
    return program, folder


def face_weights(case: Case) -> list[float]:
    """Returns gross assimilation per absorbed light for each face, if leaves
    are black and the sun is the only source, so that each point receives the
    full beam or no light."""
    mesh = mesh_of(case)
    if "photosynthesis" not in case:
        return [0.0] * len(mesh.groups)
    elevation, azimuth = np.radians(case["light"]["sun"])
    to_sun = np.array(
        [
            np.cos(elevation) * np.sin(azimuth),
            np.cos(elevation) * np.cos(azimuth),
            np.sin(elevation),
        ]
    )
    weights = []
    for c in mesh.corners:
        normal = np.cross(c[2] - c[0], c[3] - c[1])
        cosine = abs(normal @ to_sun) / np.linalg.norm(normal)
        beam = case["ppfd"] * cosine / to_sun[2]
        weights.append(gross(beam, case["photosynthesis"]) / beam)
    return weights


def trace(case: Case, paths: int, repeats: int, seed: int) -> Answers:
    """Traces a case of light, or of assimilation under the sun."""
    mesh, light = mesh_of(case), case["light"]
    kind = light.get("sky", "sun")
    elevation, azimuth = light.get("sun", (0, 0))
    lines = [
        f"{mesh.period[0]} {mesh.period[1]} {case['soil_albedo']} {kind} "
        f"{elevation} {azimuth} {len(mesh.names)} {len(mesh.groups)}"
    ]
    for name, corners, weight in zip(
        mesh.groups, mesh.corners, face_weights(case), strict=True
    ):
        numbers = [weight, *material_of(case, name), *corners.ravel()]
        lines.append(
            f"{mesh.names.index(name)} "
            + " ".join(f"{x:.17g}" for x in numbers)
        )
    said = subprocess.run(
        [_tracer()[0], str(paths), str(repeats), str(seed)],
        input="\n".join(lines),
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    rows = [tuple(map(float, line.split())) for line in said.splitlines()]
    if "photosynthesis" in case:
        mean, error = rows[2]
        return {
            "gross_assimilation": (case["ppfd"] * mean, case["ppfd"] * error)
        }
    names = ["soil", "reflected", "", *mesh.names]
    return {k: (r[0], r[1]) for k, r in zip(names, rows, strict=True) if k}


def answer(case: Case, paths: int, repeats: int, seed: int = 1) -> Answers:
    """Answers any case; returns nothing if theory is the second method."""
    if case["class"] == "energy":
        found = energy_balance(case["inputs"])
        return {k: (found[k], 0.0) for k in case["quantities"]}
    if "photosynthesis" in case and case["class"] == "assimilation":
        black = not any(any(m) for m in case["materials"].values())
        if not black:
            return {}
    return trace(case, paths, repeats, seed)
