# SPDX-License-Identifier: Apache-2.0
"""`ideotype fit SOURCE --crop CROP --to FILE` writes a crop file of a
digitised plant, and tells how well the file meets each leaf of the plant."""

from __future__ import annotations

import argparse
import datetime
import json
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w

from ._errors import Error, printable_lines
from ._geometry import Mesh
from ._output import REFUSED, OutputRefused, require_output, write_file
from ._scans.agreement import agreement
from ._scans.blades import Blade
from ._scans.plant_sources import read_crop, read_plant
from ._stand import Stand

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


def main(arguments: Sequence[str] | None = None) -> int:
    """Fits, writes, prints and returns the exit code: 0, 2 for a wrong command
    line, 3 for an input that cannot be read, 4 for an output file that exists
    or is a symbolic link."""
    parser = argparse.ArgumentParser(
        prog="ideotype fit",
        description="Makes a crop file of a plant that was digitised and tells "
        "how well each leaf is met. SOURCE is a CSV file of midribs (leaf, x "
        "out from the stalk, z up, if need be y, in _m, _cm or _mm), a DAT file "
        "of NURBS surfaces (MaizeField3D), or a mesh or point cloud with a "
        "group, object or colour for each leaf (OBJ, PLY).",
    )
    add = parser.add_argument
    add("source", type=Path, metavar="SOURCE")
    add("--crop", type=Path, required=True, metavar="FILE",
        help="crop file that has what was not measured")  # fmt: skip
    add("--to", type=Path, required=True, metavar="FILE", help="TOML to write")
    add("--plant", metavar="NAME", help="of a CSV file with a column plant")
    add("--leaves", type=Path, metavar="FILE",
        help="CSV file of lengths, widths, azimuths and heights of the leaves")  # fmt: skip
    add("--unit", choices=["auto", "m", "cm", "mm"], default="auto",
        help="of a source that does not tell it; auto: as leaves are long")  # fmt: skip
    add("--ground", type=float, default=float("nan"), metavar="Z",
        help="of the soil in the unit of the source; else of its lowest point")  # fmt: skip
    add("--form", choices=["midrib", "angles"], default="midrib",
        help="points of midribs, or insertion angles and curvatures")  # fmt: skip
    add("--name", help="of the plant; else that of FILE")
    add("--json", action="store_true", help="print JSON instead of text")
    options = parser.parse_args(arguments)
    try:
        require_output(options.to, replaces=False)
        blades = read_plant(
            options.source,
            options.plant,
            options.leaves,
            options.unit,
            options.ground,
        )
        crop = read_crop(options.crop)
        name = options.name or options.to.stem
        crop = crop_of(blades, crop, name, options.form)
        found = agreement(blades, crop, mesh_of(crop, options.crop.parent))
        write_file(options.to, tomli_w.dumps(crop), replaces=False)
    except OutputRefused as error:
        print(printable_lines(f"ideotype fit: {error}"), file=sys.stderr)
        return REFUSED
    except (Error, OSError) as error:
        print(printable_lines(f"ideotype fit: {error}"), file=sys.stderr)
        return 3
    if options.json:
        print(
            json.dumps(json.loads(found.to_json(orient="records")), indent=1)
        )
    else:
        print(found.to_string(index=False, float_format="{:.4g}".format))
        print(f"\n{len(found)} leaves are in {options.to}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
