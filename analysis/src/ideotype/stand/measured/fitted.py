# SPDX-License-Identifier: Apache-2.0
"""Makes crops of digitised plants."""

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

    exponent: exponent of the crop's bends, by which insertion angle and
        curvature are fitted to the angles of the midrib (equal parts of its
        length have equal weights).

    A blade that has a width also has roll and twist: the mean turn of its
    cross sections and their slope from base to tip (least squares, weighted by
    width)."""
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

    crop: crop with everything that was not measured: stalk, sheaths, organs,
        traits, and widths, azimuths and heights, which are taken from the leaf
        at an equal relative position.
    form: form of leaves, "midrib", or "angles" for insertion angles and
    curvatures."""
    exponent = crop.get("blade", {}).get("curvature_exponent", 1.5)
    own = crop["leaf"]
    leaves = []
    for i, blade in enumerate(blades):
        leaf = leaf_of(blade, exponent)
        place = i / max(len(blades) - 1, 1) * (len(own) - 1)
        like = own[round(place)]
        leaf.setdefault("width", like["width"])
        if not blade.has_azimuth:
            leaf["azimuth"] = like["azimuth"]
        if not blade.has_height:
            leaf["insertion_height"] = like["insertion_height"]
        if form == "midrib":
            del leaf["insertion_angle"], leaf["curvature"]
        else:
            del leaf["midrib"]
            leaf["insertion_angle"] = min(max(leaf["insertion_angle"], 0), 90)
            leaf["curvature"] = min(max(leaf["curvature"], 0), 180)
        leaves.append(_rounded(leaf))
    highest = max(leaf["insertion_height"] for leaf in leaves)
    organs = [
        organ | {"leaf": max(1, len(leaves) - len(own) + organ["leaf"])}
        if "leaf" in organ
        else organ
        for organ in crop.get("organ", [])
    ]
    found = crop | {
        "name": name,
        "stalk": crop["stalk"] | {"height": highest},
        "leaf": leaves,
    }
    if organs:
        found["organ"] = organs
    return found


def readable_crop(
    blades: Sequence[Blade], crop: dict[str, Any], title: str
) -> dict[str, Any]:
    """Returns the crop that crop_of() makes of leaves by angles, in a form
    that campaigns can read: the name of the crop keeps only letters and digits
    of the title."""
    name = re.sub(r"[^A-Za-z0-9-]+", "_", title).strip("_-")[:64]
    found = crop_of(blades, crop, name or "plant", "angles")
    # A lowest leaf may be digitised a millimetre below the ground.
    for leaf in found["leaf"]:
        leaf["insertion_height"] = max(leaf["insertion_height"], 0)
    return found


def _rounded(value: Any) -> Any:
    """Rounds numbers to a tenth of a millimetre or degree."""
    if isinstance(value, dict):
        return {
            key: round(float(each), 1)
            if key
            in {"insertion_angle", "curvature", "azimuth", "roll", "twist"}
            else _rounded(each)
            for key, each in value.items()
        }
    if isinstance(value, list):
        return [_rounded(each) for each in value]
    return round(float(value), 4)


def mesh_of(crop: dict[str, Any], folder: Path) -> Mesh:
    """Returns the surfaces of a crop's plant, with its foot at the origin and
    y along the row. Raises InputError if the program refuses the crop."""
    free = [each["name"] for each in crop.get("trait", [{"name": "azimuth"}])]
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
