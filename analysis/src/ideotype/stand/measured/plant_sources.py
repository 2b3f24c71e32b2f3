# SPDX-License-Identifier: Apache-2.0
"""Reads files of digitised plants (midribs, NURBS surfaces, meshes and point
clouds), and the crops that supply everything not measured."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np

from ...common.arrays import require_file
from ...common.compiled import _core
from ...errors import Error, did_you_mean
from .blades import Blade
from .midribs import is_coordinate, read_midribs
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
    leaves: CSV of additional measures of the leaves of a CSV file.
    unit: unit of lengths: "m", "cm", "mm" or "auto".
    ground: z of the soil in this unit; NaN: z of the lowest point.

    Raises Error with the file, its line and a remedy."""
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
    """Returns whether a file contains a digitised plant for read_plant(). A
    CSV file must contain points along midribs, not measures of whole
    leaves."""
    suffix = path.suffix.lower()
    if suffix != ".csv" or not path.is_file():
        return suffix in {".obj", ".ply", ".dat", ".txt"}
    with path.open(encoding="utf-8-sig", errors="replace") as file:
        lines = (line for line in file if line.strip(' \t",;\r\n'))
        data = (line for line in lines if line.lstrip(' \t"')[0] != "#")
        head = next(data, "").lower().split(",")
    return any(is_coordinate(word.strip()) for word in head)


def crop_tables(crop: str, folder: Path = Path()) -> dict[str, Any]:
    """Returns the tables of a crop given by its name, such as "maize", or by
    its file, relative to a folder.

    Raises InputError with all problems of the file, Error if there is no such
    crop or file."""
    known = _core.known_crops()
    if crop in known:
        return tomllib.loads(known[crop])
    path = folder / crop
    if path.suffix.lower() == ".csv":
        raise Error(
            f"{path}: a table of leaves is no crop (it has no stalk, organs "
            "and traits); name a crop such as maize, or a crop file (.toml)"
        )
    if not path.is_file():
        near = [*known, *(x.name for x in path.parent.glob("*.toml"))]
        raise Error(
            f"{path}: there is no such crop file"
            + (
                did_you_mean(path.name, near)
                or f" (crops: {', '.join(known)})"
            )
        )
    tables = read_crop(path)
    _core.read_plant(str(path))
    return tables


def require_blades(crop: dict[str, Any], name: str) -> None:
    """Raises Error if the leaves of a crop have petioles."""
    if any("petiole_length" in leaf for leaf in crop["leaf"]):
        raise Error(
            f"{name}: its leaves have petioles (only leaves of one blade at "
            "the stalk can be fitted); choose another crop"
        )


def read_crop(path: Path) -> dict[str, Any]:
    """Returns the tables of a crop file.

    Raises Error if the file is not a crop file."""
    try:
        crop = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise Error(f"{path}: {error}") from None
    if not crop.get("leaf") or "stalk" not in crop:
        raise Error(
            f"{path}: this is no crop file (it lacks [[leaf]] or [stalk]); "
            "name one"
        )
    return crop
