# SPDX-License-Identifier: Apache-2.0
"""Reads files of digitised plants: midribs, NURBS surfaces, meshes and point
clouds."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np

from .._arrays import require_file
from .._errors import Error
from .blades import Blade
from .midribs import read_midribs
from .nurbs import read_nurbs
from .plant_clouds import read_clouds


def read_plant(
    path: Path,
    plant: str | None = None,
    leaves: Path | None = None,
    unit: str = "auto",
    ground: float = np.nan,
) -> list[Blade]:
    """Returns the blades of a digitised plant, lowest first.

    path: CSV of midribs, DAT of NURBS surfaces, or OBJ or PLY with a group,
        object or colour for each leaf.
    plant: name in the column `plant` of a CSV file.
    leaves: CSV of further measures of each leaf of a CSV file.
    unit: unit of lengths: "m", "cm", "mm" or "auto".
    ground: z of the soil in this unit; NaN: z of the lowest point.

    Raises Error with the line of what cannot be read."""
    require_file(path)
    suffix = path.suffix.lower()
    if suffix == ".csv":
        blades = read_midribs(path, plant, leaves, unit)
    elif suffix in {".dat", ".txt"}:
        blades = read_nurbs(path, unit, ground)
    elif suffix in {".obj", ".ply"}:
        blades = read_clouds(path, unit, ground)
    else:
        raise Error(
            f"{path}: the format is unknown; give a CSV file of midribs, a "
            "DAT file of NURBS surfaces, or an OBJ or PLY file"
        )
    if not blades:
        raise Error(f"{path}: there is no leaf in this file; choose another")
    if suffix != ".csv":
        blades.sort(key=lambda blade: blade.midrib[0, 2])
    return blades


def is_digitised(path: Path) -> bool:
    """Returns whether read_plant() reads a file of plants; a CSV file must
    hold points along midribs, and not measures of whole leaves."""
    suffix = path.suffix.lower()
    if suffix != ".csv" or not path.is_file():
        return suffix in {".obj", ".ply", ".dat", ".txt"}
    with path.open(encoding="utf-8", errors="replace") as file:
        lines = (line for line in file if not line.startswith("#"))
        head = next(lines, "").lower().split(",")
    names = {word.strip().split("_")[0] for word in head}
    return {"x", "z"} <= names


def read_crop(path: Path) -> dict[str, Any]:
    """Returns the tables of a crop file that gives the measures which were not
    taken.

    Raises Error if the file is no crop file, or if its leaves are not blades
    at the stalk."""
    try:
        crop = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise Error(f"{path}: {error}") from None
    if not crop.get("leaf") or "stalk" not in crop:
        raise Error(
            f"{path}: this is no crop file (it lacks [[leaf]] or [stalk]); "
            "name one"
        )
    if any("petiole_length" in leaf for leaf in crop["leaf"]):
        raise Error(
            f"{path}: its leaves have petioles (only leaves of one blade at "
            "the stalk can be fitted); choose another crop"
        )
    return crop
