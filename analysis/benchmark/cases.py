# SPDX-License-Identifier: Apache-2.0
"""The cases of the benchmark, one dict each, with the contents of
cases/NAME.json."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from leaf import saturated
from meshes import MESHES, read_obj, write_obj

HERE = Path(__file__).parent
Case = dict[str, Any]

PAR, NIR, BLACK = [0.05, 0.05, 0.05], [0.4, 0.4, 0.4], [0.0, 0.0, 0.0]
UNLIKE = [0.05, 0.12, 0.06]
UNIFORM, OVERCAST = {"sky": "uniform"}, {"sky": "overcast"}

HYPERBOLA = {"model": "hyperbola", "phi": 0.06, "theta": 0.7, "amax": 50.0}
COLLATZ = {
    "model": "collatz",
    "vmax": 39.0,
    "alpha": 0.067,
    "theta": 0.83,
    "beta": 0.93,
    "k": 0.7,
    "temperature": 30.0,
}
FARQUHAR = {
    "model": "farquhar",
    "vcmax": 110.0,
    "jmax": 195.0,
    "tpu": 13.0,
    "theta": 0.97875,
    "beta": 0.98,
    "temperature": 30.0,
}
# CO2 within leaves at 30 deg C and 60 % relative humidity: 400 (0.84 - 0.19 D)
# for C4 leaves, and 400 g1 / (g1 + sqrt(D)) with g1 = 5.79 for C3 leaves.
DEFICIT = 0.4 * saturated(30)
COLLATZ["ci"] = 400 * (0.84 - 0.19 * DEFICIT)
FARQUHAR["ci"] = 400 * 5.79 / (5.79 + DEFICIT**0.5)

AIR = {
    "ppfd": 1361.0,
    "nir": 162.5,
    "longwave": 839.0,
    "air": 28.4,
    "rh": 0.55,
    "co2": 410.0,
    "pressure": 99.0,
    "wind": 1.5,
    "width": 0.08,
}
LEAF = {
    "vmax": 39.0,
    "alpha": 0.067,
    "theta": 0.83,
    "beta": 0.93,
    "k": 0.7,
    "rd": 0.8,
    "g0": 0.01,
    "g1": 1.6,
    "emissivity": 0.96,
}
ENERGY = {
    "noon": {},
    "shade": {"ppfd": 60.0, "nir": 120.0, "longwave": 850.0},
    "dim": {"ppfd": 300.0, "nir": 80.0, "longwave": 800.0},
    "cool": {"air": 14.0, "longwave": 640.0, "ppfd": 900.0},
    "warm": {"air": 35.0, "longwave": 900.0},
    "dry": {"rh": 0.25},
    "moist": {"rh": 0.85},
    "calm": {"wind": 0.4, "ppfd": 800.0},
    "windy": {"wind": 6.0},
    "narrow": {"width": 0.01},
    "thin_air": {"co2": 250.0},
    "enriched": {"co2": 800.0},
    "old": {"vmax": 15.0},
    "high": {"pressure": 75.0},
}


def sun(elevation: float, azimuth: float) -> dict[str, list[float]]:
    return {"sun": [elevation, azimuth]}


def label(light: dict[str, Any]) -> str:
    if "sky" in light:
        return str(light["sky"])
    return "sun{:g}_{:g}".format(*light["sun"])


def all_cases() -> dict[str, Case]:
    """Returns each case by its name."""
    cases: dict[str, Case] = {}

    def add(
        kind: str,
        mesh: str,
        optics: list[float],
        soil: float,
        light: dict[str, Any],
        **more: Any,
    ) -> None:
        words = {str(PAR): "par", str(NIR): "nir", str(BLACK): "black"}
        parts = [kind, mesh, words.get(str(optics), "unlike"), label(light)]
        if soil:
            parts.insert(3, f"soil{soil:g}")
        if more:
            parts.append(more["photosynthesis"]["model"])
        made = MESHES[mesh]()
        # If no surface scatters, nothing is reflected.
        scatters = optics != BLACK or soil > 0
        cases["-".join(parts)] = {
            "class": kind,
            "mesh": f"meshes/{mesh}.obj",
            "period": list(made.period),
            "light": light,
            "materials": {"": optics},
            "soil_albedo": soil,
            "quantities": ["gross_assimilation"]
            if more
            else [*made.names, "soil", *["reflected"] * scatters],
            **more,
        }

    for mesh in ("sheet1", "sheet2", "sheet5"):
        for optics, soil in ((PAR, 0.1), (NIR, 0.2)):
            for light in (sun(30, 180), UNIFORM):
                add("sheets", mesh, optics, soil, light)
        add("sheets", mesh, UNLIKE, 0.3, UNIFORM)
    for mesh, light in (
        ("beer2", sun(90, 0)), ("beer2", sun(30, 60)), ("beer2", UNIFORM),
        ("beer4", sun(45, 90)), ("beer4", OVERCAST), ("beer6", sun(20, 250)),
        ("beer6", sun(60, 10)), ("beer6", UNIFORM),
    ):  # fmt: skip
        add("beer", mesh, BLACK, 0, light)
    for mesh in ("spherical", "erect", "rosette", "maize"):
        for light in (sun(75, 180), sun(45, 120), sun(20, 250), UNIFORM):
            add("black", mesh, BLACK, 0, light)
    for light in (sun(60, 90), sun(40, 120), UNIFORM):
        add("strips", "walls", BLACK, 0, light)
        add("strips", "strips", BLACK, 0, light)
    add("strips", "walls", BLACK, 0.3, UNIFORM)
    for mesh in ("walls", "strips"):
        for optics, light in (
            (PAR, UNIFORM),
            (NIR, UNIFORM),
            (NIR, sun(40, 120)),
        ):
            add("strips", mesh, optics, 0.2, light)
    for mesh in ("panels_tilted", "panels_dense", "panels_upright"):
        for light in (sun(50, 270), sun(35, 230), UNIFORM):
            add("panels", mesh, BLACK, 0, light)
        add("panels", mesh, BLACK, 0.25, UNIFORM)
        add("panels", mesh, PAR, 0.1, sun(50, 270))
    for mesh in ("spherical", "erect", "flat", "rosette", "maize"):
        for light in (sun(45, 120), UNIFORM):
            add("par", mesh, PAR, 0.1, light)
            add("nir", mesh, NIR, 0.2, light)
    for optics, soil in ((PAR, 0.1), (NIR, 0.2)):
        for light in (sun(55, 200), OVERCAST):
            add(
                "par" if soil == 0.1 else "nir", "mixture", optics, soil, light
            )
    for mesh, light, leaf in (
        ("sheet1", sun(30, 180), HYPERBOLA), ("sheet5", UNIFORM, HYPERBOLA),
        ("sheet1", UNIFORM, COLLATZ), ("sheet2", sun(30, 180), COLLATZ),
        ("sheet5", UNIFORM, COLLATZ), ("sheet1", UNIFORM, FARQUHAR),
        ("sheet2", sun(30, 180), FARQUHAR), ("sheet5", UNIFORM, FARQUHAR),
    ):  # fmt: skip
        add(
            "assimilation",
            mesh,
            PAR,
            0.1,
            light,
            ppfd=1500.0,
            photosynthesis=leaf,
        )
    for mesh in ("spherical", "erect", "maize"):
        for leaf in (HYPERBOLA, COLLATZ):
            add("assimilation", mesh, BLACK, 0, sun(45, 120), ppfd=1200.0,
                photosynthesis=leaf)  # fmt: skip
    for name, change in ENERGY.items():
        cases[f"energy-{name}"] = {
            "class": "energy",
            "inputs": AIR | LEAF | change,
            "quantities": [
                "leaf", "net", "gs", "ci", "transpiration", "latent", "sensible",
            ],
        }  # fmt: skip
    return cases


def write_cases() -> None:
    """Rewrites meshes/ and cases/."""
    for folder in ("meshes", "cases"):
        (HERE / folder).mkdir(exist_ok=True)
        for old in (HERE / folder).iterdir():
            old.unlink()
    for name, make in MESHES.items():
        write_obj(make(), HERE / "meshes" / f"{name}.obj")
    for name, case in all_cases().items():
        (HERE / "cases" / f"{name}.json").write_text(
            json.dumps(case, indent=1) + "\n"
        )


def read_cases() -> dict[str, Case]:
    """Reads cases/ without the code that wrote it, like any program."""
    return {
        path.stem: json.loads(path.read_text())
        for path in sorted((HERE / "cases").glob("*.json"))
    }


def mesh_of(case: Case) -> Any:
    return read_obj(HERE / case["mesh"], tuple(case["period"]))


def material_of(case: Case, group: str) -> list[float]:
    """Returns the reflectance of the upper and of the lower face, and the
    transmittance."""
    return next(v for k, v in case["materials"].items() if group.startswith(k))
