# SPDX-License-Identifier: Apache-2.0
"""Answers of ideotype, through its Python package.

As a script it writes answers/ideotype.csv, with a seed that the values do not
contain."""

from __future__ import annotations

import tempfile
from pathlib import Path

import tomli_w
from answers import write_answers
from cases import Case, mesh_of
from plain import Answers

import ideotype

PATHS = 2**17  # for each case
FRESH_SEED = 1001  # make.py counts from 1

MODEL_KEYS = {
    "hyperbola": ("phi", "theta", "amax"),
    "collatz": ("vmax", "alpha", "theta", "beta", "k"),
    "farquhar": ("vcmax", "jmax", "tpu", "theta", "beta"),
}


def answer(case: Case, paths: int, seed: int = 1) -> Answers:
    """Answers a case with the given number of paths."""
    if case["class"] == "energy":
        found = ideotype.leaf_energy_balance(case["inputs"])
        return {k: (found[k], 0.0) for k in case["quantities"]}
    mesh = mesh_of(case)
    component: dict[str, object] = {"name": "all", "groups": ""}
    light = {k: case["light"][k] for k in case["light"]}
    if leaf := case.get("photosynthesis"):
        component["photosynthesis"] = {
            "model": leaf["model"],
            "profile": "none",
            "weather": False,
            **{k: leaf[k] for k in MODEL_KEYS[leaf["model"]]},
        }
        light["beam_ppfd" if "sun" in light else "sky_ppfd"] = case["ppfd"]
    if "sun" in light:
        light["sun"] = tuple(light["sun"])
    document = {
        "soil_albedo": {"par": case["soil_albedo"]},
        "material": [
            {"groups": prefix, "par": values}
            for prefix, values in case["materials"].items()
        ],
        "component": [component],
    }
    vertices = [corner for face in mesh.corners for corner in face]
    faces = [range(4 * i, 4 * i + 4) for i in range(len(mesh.corners))]
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.toml"
        scene.write_text(tomli_w.dumps(document))
        found = ideotype.mesh(vertices, faces, groups=mesh.groups).evaluate(
            period=tuple(case["period"]),
            scene=scene,
            seed=seed,
            paths=paths,
            **light,
        )
    first = found.isel(band=0)
    answers: Answers = {}
    for name in case["quantities"]:
        key = name
        data = first
        if name not in ("soil", "reflected", "gross_assimilation"):
            key, data = "absorbed", first.sel(group=name)
        elif name == "gross_assimilation":
            data = found.isel(component=0)
        answers[name] = (
            float(data[key]),
            float(data[f"{key}_standard_error"]),
        )
    return answers


if __name__ == "__main__":
    write_answers("ideotype", lambda case: answer(case, PATHS, FRESH_SEED))
