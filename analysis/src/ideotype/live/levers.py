# SPDX-License-Identifier: Apache-2.0
"""The sliders of the live page: for each gene a name, a usual unit and a
description."""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from ..common.labels import title
from ..stand.stand import Stand
from .conditions import Tables

_WORDS = {
    "length": ("Leaf length", "Length of the blade, from collar to tip."),
    "width": ("Leaf width", "Largest width of the blade."),
    "insertion_angle": (
        "Leaf insertion angle",
        "Angle between stalk and leaf base; 0° is vertical.",
    ),
    "curvature": (
        "Leaf curvature",
        "Downward bending from leaf base to tip.",
    ),
    "azimuth": (
        "Leaf azimuth",
        "Direction of the leaf seen from above, clockwise from the row.",
    ),
    "azimuth_deviation": (
        "Azimuth deviation",
        "Rotation of the leaf out of the leaf plane of the plant.",
    ),
    "leaf_plane": (
        "Leaf plane",
        "Rotation of all leaves of the plant about the stalk.",
    ),
    "height": ("Plant height", "Height of the stalk with all leaf collars."),
    "stalk_diameter": ("Stalk diameter", "Diameter of the stalk."),
    "leaflet_size": ("Leaflet size", "Size of all leaflets of a leaf."),
    "leaflet_angle": (
        "Leaflet angle",
        "Angle between leaflets and petiole.",
    ),
    "leaflet_width": ("Leaflet width", "Width of all leaflets."),
    "petiole_length": ("Petiole length", "Length of the petioles."),
    "petiole_angle": (
        "Petiole angle",
        "Angle between stem and petiole.",
    ),
    "internode": ("Internode length", "Length of stem between two leaves."),
    "internode_length": (
        "Internode length",
        "Length of stem between leaves, the same for all internodes.",
    ),
}
_PLACES = {
    3: ("lowest leaf", "middle leaf", "top leaf"),
    4: ("lowest leaf", "lower middle", "upper middle", "top leaf"),
    5: ("lowest leaf", "lower", "middle", "upper", "top leaf"),
}


def make_levers(stand: Stand, base: Tables) -> list[dict[str, Any]]:
    """Returns a description of each gene: group and label; kind, "profile",
    "plant" or "leaf"; and the scale, shift and unit of the shown number, gene
    x scale + shift."""
    genes = stand.genes.to_dict("records")
    crops = {"": base["plant"]["baseline"]} | {
        component["name"]: component["crop"]
        for component in base.get("component", [])
        if "crop" in component
    }
    points = {
        trait: len({g["name"] for g in genes if g["trait"] == trait})
        for trait in {gene["trait"] for gene in genes}
    }
    return [_lever(gene, crops, points[gene["trait"]]) for gene in genes]


def _lever(
    gene: dict[str, Any], crops: dict[str, Tables], points: int
) -> dict[str, Any]:
    component, _, trait = gene["trait"].rpartition(".")
    crop = crops.get(component, {})
    table: dict[str, Any] = next(
        (t for t in crop.get("trait", []) if t["name"] == trait), {}
    )
    word, description = _WORDS.get(
        trait.removesuffix("_profile"),
        (title(trait), ""),
    )
    if table.get("over_density"):
        description = "Slope over the logarithm of plant density."
    kind, place, label = "plant", 0.5, word
    if gene["leaf"]:
        kind, label = "leaf", f"leaf {gene['leaf']}"
        # A trait that sets a measure is shown in the units of this measure.
    elif table.get("per") == "profile" or points > 1:
        kind, at = "profile", int(re.findall(r"\d+$", gene["name"])[0])
        place = (at - 1) / max(points - 1, 1)
        names = _PLACES.get(points)
        label = names[at - 1] if names else f"point {at} of {points}"
    return {
        "name": gene["name"],
        "component": component,
        "group": word,
        "label": label,
        "kind": kind,
        "leaf": gene["leaf"],
        "lower": min(gene["lower"], gene["baseline"]),
        "upper": max(gene["upper"], gene["baseline"]),
        "help": description,
        **_shown(gene, table, crop, place),
    }


def _shown(
    gene: dict[str, Any], table: Tables, crop: Tables, place: float
) -> dict[str, Any]:
    """Returns the scale, shift and unit in which a gene's number is shown."""
    if table.get("over_density"):
        return {"scale": 1.0, "shift": 0.0, "unit": ""}
    if "scales" in table:
        path = table["scales"][0]
        measure = _measure(crop, path, place)
        if measure is None or _unit(path) is None:
            return {"scale": 100.0, "shift": 0.0, "unit": "%"}
        factor, unit = _unit(path) or (1.0, "")
        return {"scale": measure * factor, "shift": 0.0, "unit": unit}
    factor, unit = _UNITS.get(gene["unit"], (1.0, gene["unit"]))
    shift = 0.0
    if "shifts" in table and not gene["leaf"]:
        path = table["shifts"][0]
        if "azimuth" not in path:
            shift = factor * (_measure(crop, path, place) or 0.0)
    return {"scale": factor, "shift": shift, "unit": unit}


_UNITS = {"m": (100.0, "cm"), "deg": (1.0, "°"), "1": (1.0, "")}


def _unit(path: str) -> tuple[float, str] | None:
    if re.search("length|width|height|diameter", path):
        return _UNITS["m"]
    if re.search("angle|curvature|roll|twist", path):
        return _UNITS["deg"]
    return None


def _measure(crop: Tables, path: str, place: float) -> float | None:
    """Returns a measure of a crop file; measures of leaves are taken at a
    place from the lowest leaf, 0, to the highest, 1."""
    part, _, name = path.partition(".")
    if part != "leaf":
        value = crop.get(part, {}).get(name)
        return float(value) if isinstance(value, (int, float)) else None
    leaves = crop.get("leaf", [])
    values = [leaf.get(name) for leaf in leaves]
    if not values or not all(isinstance(v, (int, float)) for v in values):
        return None
    at = np.linspace(0, 1, len(values))
    return float(np.interp(place, at, np.array(values, float)))
