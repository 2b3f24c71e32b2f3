# SPDX-License-Identifier: Apache-2.0
"""Opens the input of the live page: a campaign, a crop, a measured plant, or an
optimised plant."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from importlib.resources import as_file, files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Error
from ..history.atlas import Atlas
from ..history.history import open_history
from ..stand.measured.agreement import agreement
from ..stand.measured.fitted import mesh_of, readable_crop
from ..stand.measured.leaf_tables import measured_crops
from ..stand.measured.plant_sources import (
    crop_tables,
    is_digitised,
    read_crop,
    read_plant,
    require_blades,
)
from ..stand.stand import Stand
from .conditions import Conditions, Tables, cut_case, seasons_of

CROPS = ("maize", "sorghum", "soybean", "cowpea")
"""The crops that come with the package."""


@dataclass(frozen=True)
class Opened:
    """The plant and field that a live page begins with."""

    title: str
    about: str
    """A sentence about the origin of the plant."""
    base: Tables
    """A resolved campaign of one case."""
    seasons: list[Tables]
    """The tables [[climate]] and [[weather]] of each season of the case; the
    first one is that of `base`."""
    genome: NDArray[np.float64]
    """The plant that the page shows first [genes]."""
    free: NDArray[np.bool_]
    """Whether the campaign optimises a gene [genes]."""
    map: dict[str, Any] | None = None
    """The best plants of all kinds, if the plant comes from an atlas."""

    @property
    def conditions(self) -> Conditions:
        """The conditions of the campaign."""
        return Conditions.of(self.base)


def open_place(
    place: str,
    *,
    case: int = 0,
    plant: str | None = None,
    crop: str = "maize",
) -> Opened:
    """Opens a campaign or crop file (.toml), a history (.h5), a plant that was
    measured (.csv of midribs or of leaves; .obj, .ply or .dat), or a crop by
    its name.

    case: number of the case of a campaign, from 0.
    plant: name of the plant in a CSV file with several.
    crop: crop, by name or file, with all traits that were not measured.

    Raises Error if the input cannot be used."""
    path = Path(place)
    suffix = path.suffix.lower()
    if place in CROPS:
        return _open_crop(_known(place), place, "A crop of the package.")
    if not path.is_file():
        raise Error(
            f"{place}: there is no such file; give a campaign, a crop file, a "
            f"history, a measured plant, or one of {', '.join(CROPS)}"
        )
    if suffix == ".h5":
        return _open_history(path)
    if is_digitised(path):
        return _open_measured(path, plant, crop)
    if suffix == ".csv":
        return _open_leaves(path, plant, crop)
    if suffix != ".toml":
        raise Error(
            f"{place}: files of this kind cannot be opened; give .toml, .h5, "
            ".csv, .obj, .ply or .dat"
        )
    try:
        content = tomllib.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise Error(f"{place}: this is no TOML ({error})") from None
    if "leaf" in content and "plant" not in content:
        about = "The plant of a crop file."
        return _open_crop(str(path.resolve()), path.stem, about)
    stand = Stand.from_campaign(path, case=case)
    about = f"The baseline of the campaign {path.name}."
    return _opened(path.stem, about, stand, stand.baseline)


def _opened(
    title: str,
    about: str,
    stand: Stand,
    genome: NDArray[np.float64],
    atlas: Atlas | None = None,
) -> Opened:
    tables = tomllib.loads(stand.campaign)
    base = cut_case(tables, stand.entries)
    seasons = seasons_of(tables, stand.entries)
    _add_profiles(base["plant"]["baseline"])
    searched = {gene for gene, is_free in zip(stand.genes["name"], stand.free)
              if is_free}  # fmt: skip
    _free_all(base)
    every = Stand(base)
    names = list(every.genes["name"])

    def complete(genome: NDArray[np.float64]) -> NDArray[np.float64]:
        """Returns a genome extended by the traits of components that the
        campaign does not optimise."""
        found = dict(zip(stand.genes["name"], genome))
        return np.array(
            [found.get(n, b) for n, b in zip(names, every.baseline)]
        )

    free = np.array([name in searched for name in names])
    kinds = _make_map(atlas, complete) if atlas else None
    return Opened(title, about, base, seasons, complete(genome), free, kinds)


def _make_map(
    atlas: Atlas,
    complete: Callable[[NDArray[np.float64]], NDArray[np.float64]],
) -> dict[str, Any]:
    """Returns the map of an atlas for the page: the leaders of the cells of
    the first two axes."""
    leaders, goal = atlas.leaders, atlas.leaders.goals[0]
    return {
        "goal": {"name": goal.name, "unit": goal.unit, "sign": goal.sign},
        "axes": [
            {
                "name": axis.name,
                "unit": axis.unit,
                "edges": axis.edges.tolist(),
            }
            for axis in atlas.axes[:2]
        ],
        "plants": [
            {
                "cell": atlas.cells[i, :2].tolist(),
                "value": float(leaders.objectives[i, 0]),
                "standard_error": float(
                    leaders.objectives_standard_error[i, 0]
                ),
                "is_confirmed": bool(atlas.is_confirmed[i]),
                "genome": complete(leaders.genome[i]).tolist(),
            }
            for i in atlas.on_two_axes()
        ],
    }


def _add_profiles(crop: Tables) -> None:
    """Adds profiles over leaf position to a crop file that declares none."""
    traits = crop.setdefault("trait", [])
    if any(trait.get("per") == "profile" for trait in traits):
        return
    for measure, how, bounds in _PROFILES:
        if all(measure in leaf for leaf in crop["leaf"]):
            traits.append(
                {
                    "name": f"{measure}_profile",
                    "per": "profile",
                    how: [f"leaf.{measure}"],
                    "unit": "1" if how == "scales" else "deg",
                    "range": bounds,
                    "bred": False,
                }
            )


_PROFILES = (
    ("length", "scales", [0.65, 1.35]),
    ("width", "scales", [0.65, 1.35]),
    ("insertion_angle", "shifts", [-10, 50]),
    ("curvature", "scales", [0.5, 1.5]),
)
"""The measure of each added profile, the way in which the profile changes the
measure, and its bounds, as in the crop file of maize."""


def _free_all(base: Tables) -> None:
    """Makes the traits of all components free; meshes have none."""
    for component in base.get("component", []):
        if "crop" not in component:
            continue
        traits = component["crop"].get("trait", [])
        component["free"] = [trait["name"] for trait in traits]


def _open_history(path: Path) -> Opened:
    with open_history(path) as history:
        best, atlas = history.best(), history.atlas()
        name = str(history.attributes.get("case", path.stem))
    if best is None:
        raise Error(f"{path}: no plant is evaluated yet; come back later")
    genome = best.row.genome[0]
    stand = Stand.from_history(path, genome, same_isa=False)
    about = f"The best plant of {path.name}."
    if atlas and "keys" in tomllib.loads(stand.campaign)["search"]:
        about += " The map shows other plants with the keys of this one."
    return _opened(name, about, stand, genome, atlas)


def _open_measured(path: Path, plant: str | None, crop: str) -> Opened:
    source = Path(_known(crop) if crop in CROPS else crop)
    blades = read_plant(path, plant)
    like = read_crop(source)
    require_blades(like, str(source))
    fitted = readable_crop(blades, like, path.stem)
    off = agreement(blades, fitted, mesh_of(fitted, source.parent))
    about = (
        f"Measured: {len(blades)} leaves of {path.name}, with midribs fitted to "
        f"{off['midrib_rms_mm'].mean():.0f} mm (root mean square). Traits that "
        f"were not measured are those of {source.stem}."
    )
    return _open_crop(fitted, plant or path.stem, about)


def _open_leaves(path: Path, plant: str | None, crop: str) -> Opened:
    crops = measured_crops(
        path, plant=plant or "", otherwise=crop_tables(crop)
    )
    if len(crops) > 1:
        names = ", ".join(each.plant for each in crops[:5])
        raise Error(
            f"{path}: the table has {len(crops)} plants; choose one with --of: "
            f"{names}{', ...' if len(crops) > 5 else ''}"
        )
    about = "Measured leaves."
    return _open_crop(crops[0].tables, plant or path.stem, about)


def _open_crop(crop: str | dict[str, Any], title: str, about: str) -> Opened:
    """Puts a plant into the field and the season that come with the
    package."""
    with as_file(files(__package__) / "start") as folder:
        tables = tomllib.loads((folder / "quickstart.toml").read_text())
        # Only some crops have rules of bounds and measures of lines.
        lines = {"lines": "lines/maize_panel.toml"}
        tries: list[Tables] = [
            {"bounds": "breedable", "feasibility": lines},
            {"bounds": "breedable"},
            {},
        ]
        problem: Error | None = None
        for extra in tries:
            change = dict(extra)
            feasibility = change.pop("feasibility", None)
            campaign = tables | {"plant": {"baseline": crop, **change}}
            if feasibility:
                campaign["feasibility"] = feasibility
            if title in _DENSE:
                row, density = _DENSE[title]
                campaign["spacing"] = [{"row": row, "density": density}]
            try:
                stand = Stand(campaign, folder=folder)
            except Error as error:
                problem = error
            else:
                return _opened(title, about, stand, stand.baseline)
    raise problem or Error(f"{title}: it cannot be opened")


_DENSE = {"soybean": (0.38, 35.0), "cowpea": (0.5, 12.0)}
"""Usual row distances [m] and densities [m-2] of crops that are not planted
like maize."""


def _known(name: str) -> str:
    """Returns the path of the file of a crop that comes with the package."""
    with as_file(files(__package__) / "start" / "crops") as folder:
        return str(folder / f"{name}.toml")
