# SPDX-License-Identifier: Apache-2.0
"""Fits crops to digitised plants."""

from __future__ import annotations

import datetime
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ...mesh.geometry import Mesh
from ..stand import Stand
from .blades import Blade

_STEPS = 10
"""The number of segments of a midrib in a crop file."""


def leaf_of(blade: Blade, exponent: float) -> dict[str, Any]:
    """Returns the measures of a blade as a table [[leaf]] of a crop file.

    Insertion angle and curvature are fitted to the angle of the midrib by
    least squares, with equal weights for equal lengths: angle(s) =
    insertion_angle + curvature s^exponent, s from 0 at the base to 1 at the
    tip. A blade with edges also has roll and twist (`Blade.roll_and_twist`).

    exponent: exponent of bending of the crop (`blade.curvature_exponent`)."""
    outward, up = blade.in_its_plane
    steps = np.column_stack([np.diff(outward), np.diff(up)])
    sizes = np.linalg.norm(steps, axis=1)
    angles = np.degrees(np.unwrap(np.arctan2(steps[:, 0], steps[:, 1])))
    along = (np.cumsum(sizes) - sizes / 2) / sizes.sum()
    bend = np.column_stack([np.ones(len(along)), along**exponent])
    (insertion, curvature), *_ = np.linalg.lstsq(
        bend * np.sqrt(sizes)[:, None], angles * np.sqrt(sizes), rcond=None
    )
    leaf = {
        "length": blade.length,
        "insertion_angle": insertion,
        "curvature": curvature,
        "azimuth": blade.azimuth % 360,
        "insertion_height": blade.midrib[0, 2],
    }
    if blade.width is not None:
        roll, twist = blade.roll_and_twist
        leaf |= {"width": blade.width, "roll": roll, "twist": twist}
    ends = np.linspace(0, 1, _STEPS + 1)
    at = np.concatenate([[0], np.cumsum(sizes)]) / sizes.sum()
    leaf["midrib"] = [
        [float(np.interp(s, at, outward)), float(np.interp(s, at, up))]
        for s in ends
    ]
    return leaf


def crop_of(
    blades: Sequence[Blade], crop: dict[str, Any], name: str, form: str
) -> dict[str, Any]:
    """Returns the tables of a crop file with these leaves, lowest first.

    crop: tables of the crop that supplies everything not measured: stalk,
        sheaths, organs and traits, and missing widths, azimuths and heights
        of the leaf at the same relative position.
    name: name of the crop.
    form: form of the leaves, "midrib", or "angles" for insertion angles and
        curvatures."""
    exponent = crop.get("blade", {}).get("curvature_exponent", 1.5)
    crop_leaves = crop["leaf"]
    leaves = []
    for i, blade in enumerate(blades):
        leaf = leaf_of(blade, exponent)
        position = i / max(len(blades) - 1, 1) * (len(crop_leaves) - 1)
        counterpart = crop_leaves[round(position)]
        leaf.setdefault("width", counterpart["width"])
        if not blade.has_azimuth:
            leaf["azimuth"] = counterpart["azimuth"]
        if not blade.has_height:
            leaf["insertion_height"] = counterpart["insertion_height"]
        if form == "midrib":
            del leaf["insertion_angle"], leaf["curvature"]
        else:
            del leaf["midrib"]
            leaf["insertion_angle"] = min(max(leaf["insertion_angle"], 0), 90)
            leaf["curvature"] = min(max(leaf["curvature"], 0), 180)
        leaves.append(_rounded(leaf))
    highest = max(leaf["insertion_height"] for leaf in leaves)
    organs = [
        organ
        | {"leaf": max(1, len(leaves) - len(crop_leaves) + organ["leaf"])}
        if "leaf" in organ
        else organ
        for organ in crop.get("organ", [])
    ]
    tables = crop | {
        "name": name,
        "stalk": crop["stalk"] | {"height": highest},
        "leaf": leaves,
    }
    if organs:
        tables["organ"] = organs
    return tables


def readable_crop(
    blades: Sequence[Blade], crop: dict[str, Any], title: str
) -> dict[str, Any]:
    """Returns the crop of crop_of() in the form "angles", valid in campaigns:
    its name consists of the letters and digits of the title, and no leaf is
    below the ground."""
    name = re.sub(r"[^A-Za-z0-9-]+", "_", title).strip("_-")[:64]
    fitted = crop_of(blades, crop, name or "plant", "angles")
    # A lowest leaf may be digitised a millimetre below the ground.
    for leaf in fitted["leaf"]:
        leaf["insertion_height"] = max(leaf["insertion_height"], 0)
    return fitted


def _rounded(value: Any) -> Any:
    """Rounds numbers to a tenth of a millimetre or degree."""
    if isinstance(value, dict):
        return {
            key: round(float(item), 1)
            if key
            in {"insertion_angle", "curvature", "azimuth", "roll", "twist"}
            else _rounded(item)
            for key, item in value.items()
        }
    if isinstance(value, list):
        return [_rounded(item) for item in value]
    return round(float(value), 4)


def mesh_of(crop: dict[str, Any], folder: Path) -> Mesh:
    """Returns the surfaces of the plant of a crop, with its foot at the origin
    and y along the row. Raises InputError if the crop is invalid."""
    free = [
        trait["name"] for trait in crop.get("trait", [{"name": "azimuth"}])
    ]
    stand = Stand(
        {
            "name": "fit",
            "site": [
                {"name": "any", "latitude": 0, "longitude": 0, "utc_offset": 0}
            ],
            "day": [
                {
                    "date": datetime.date(2025, 3, 20),
                    "start": datetime.time(12),
                    "end": datetime.time(13),
                }
            ],
            "spacing": [{"row": 1.0, "plant": 1.0}],
            "traits": [{"name": "any", "free": free[:1]}],
            "plant": {"baseline": crop},
        },
        folder=folder,
    )
    return stand.mesh(stand.baseline)
