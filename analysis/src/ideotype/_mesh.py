# SPDX-License-Identifier: Apache-2.0
"""The light in any mesh."""

from __future__ import annotations

import re
from collections.abc import Sequence
from datetime import date
from os import PathLike
from typing import Any

import numpy as np
import xarray
from numpy.typing import ArrayLike, NDArray

import ideotype._core as _core

from ._arrays import real, unmasked
from ._errors import Error

Pair = tuple[float, float]


class Canopy:
    """A mesh whose light can be found; `ideotype.mesh` makes it."""

    def __init__(
        self,
        vertices: ArrayLike,
        faces: ArrayLike | Sequence[Sequence[int]],
        groups: Sequence[str] | None = None,
    ) -> None:
        self._vertices = _vertices(vertices)
        self._corners, self._counts = _polygons(faces, len(self._vertices))
        count = len(self._counts)
        names = ["leaf"] * count if groups is None else list(groups)
        if len(names) != count:
            raise Error(
                f"groups has {len(names)} names for {count} faces; "
                "give the name of each face's organ"
            )
        self._names = list(dict.fromkeys(names))
        places = {name: i for i, name in enumerate(self._names)}
        self._face_group = np.array([places[x] for x in names], np.uint32)

    def evaluate(
        self,
        *,
        period: Pair | None = None,
        isolated: bool = False,
        ground_area: float | None = None,
        field: tuple[int, int, float, float] | None = None,
        jitter: float | None = None,
        sun: Pair | None = None,
        sky: str | None = None,
        site: tuple[float, float, float] | None = None,
        day: date | str | None = None,
        beam_ppfd: float | None = None,
        sky_ppfd: float | None = None,
        climate: str | PathLike[str] | None = None,
        photosynthesis: str | PathLike[str] | None = None,
        exact: bool = False,
        leaf: Pair | None = None,
        stalk: Pair | None = None,
        sheath: Pair | None = None,
        soil_albedo: float | None = None,
        scene: str | PathLike[str] | None = None,
        tolerance: float | None = None,
        paths: int | None = None,
        by_face: bool = False,
        seed: int | None = None,
    ) -> xarray.Dataset:
        """Evaluates where light goes, as `ideotype light` does: an option that
        is not given is as on its command line.

        period: the period of the lattice on which the mesh repeats, along x
            and y [m].
        isolated: whether the mesh stands alone on endless soil, with
            `ground_area` [m2] that light per area refers to.
        field: rows, plants of a row, row and plant spacing [m]. The mesh is a
            plant at x = y = 0 and repeats in rows along y, each plant turned
            at random by up to `jitter` [deg].
        sun: elevation and azimuth, clockwise from north = +y [deg]; level
            ground receives 1, or `beam_ppfd` [umol m-2 s-1].
        sky: "uniform", "overcast" or "clear"; level ground receives 1, or
            `sky_ppfd` [umol m-2 s-1].
        site: latitude, longitude [deg] and UTC offset [h] of the sun and sky
            of a clear `day`, "2021-07-01".
        climate: file with the tables [site] and [climate] of a campaign.
        photosynthesis: file with this table, for assimilation; `exact` means
            what `--exact` means on the command line.
        leaf, stalk, sheath: reflectance and transmittance, by default those of
            the command line. Groups whose names begin with "stalk" or "sheath"
            are stalks or sheaths, all others are leaves.
        scene: file of materials, components and wavebands, as `--scene` of the
            command line takes it; it tells all optics and photosynthesis.
        tolerance: relative standard error of the leaves' light; `paths` gives
            a number of paths instead.
        by_face: whether the light that each face absorbs is returned too.

        Returns a Dataset: `incident` is the light on the ground; `leaves`,
        `stalks` (all other organs) and `soil` are what these absorb, and
        `reflected` is what leaves the canopy, per area of ground; `absorbed`
        is by `group`, and `absorbed_by_layer` is the light of leaves by
        height. Quantities that a history has are there too, for a single sun
        or sky those that are no rates. Each has its NAME_standard_error. With
        a `scene` there are instead, by `band`, `incident`, `soil`,
        `reflected`, `absorbed_by_component` and `absorbed` by `group`; and by
        `component` its leaf area index `lai`, `gross_assimilation` and
        `net_assimilation`.

        Raises Error if options contradict each other."""
        arguments = _arguments(
            period=period,
            boundary="isolated" if isolated else None,
            ground_area=ground_area,
            field=field,
            jitter=jitter,
            sun=sun,
            sky=sky,
            site=site,
            date=day,
            beam_ppfd=beam_ppfd,
            sky_ppfd=sky_ppfd,
            climate=climate,
            photosynthesis=photosynthesis,
            exact=exact,
            soil_albedo=soil_albedo,
            scene=scene,
            tolerance=tolerance,
            paths=paths,
            seed=seed,
        )
        surfaces = {"leaf": leaf, "stalk": stalk, "sheath": sheath}
        for name, pair in surfaces.items():
            if pair is not None:
                for part, value in zip(
                    ("reflectance", "transmittance"), pair, strict=True
                ):
                    arguments += [f"--{name}-{part}", str(value)]
        try:
            found = _core.evaluate_mesh(
                self._vertices,
                self._corners,
                self._counts,
                self._face_group,
                self._names,
                arguments,
                by_face,
            )
        except Error as error:
            raise type(error)(_in_python(str(error))) from None
        is_ppfd = beam_ppfd is not None or sky_ppfd is not None
        if scene is not None:
            return _scene_dataset(found, found["is_day"], is_ppfd)
        if found["is_day"]:
            return _dataset(found, "MJ m-2 day-1", 1e-6)
        return _dataset(found, "umol m-2 s-1" if is_ppfd else "1", 1)


def mesh(
    vertices: ArrayLike,
    faces: ArrayLike | Sequence[Sequence[int]],
    *,
    groups: Sequence[str] | None = None,
) -> Canopy:
    """Returns a canopy of any surfaces, such as those of trimesh, PlantGL or a
    plant model of one's own.

    vertices: [vertices, 3] in metres; x is east, y is north, z is up.
    faces: [faces, 3], [faces, 4], or a list of polygons of any number of
        corners, counted from 0; they are divided into triangles as those of
        OBJ files are.
    groups: name of the organ that each face belongs to; "leaf" if not given.

    Raises Error if arrays do not fit together."""
    return Canopy(vertices, faces, groups)


def _vertices(given: ArrayLike) -> NDArray[np.float64]:
    vertices = np.ascontiguousarray(real(given, "vertices"))
    if vertices.ndim != 2 or vertices.shape[1] != 3:
        raise Error(
            f"vertices are an array of {vertices.shape}; give [vertices, 3]"
        )
    bad = np.flatnonzero(~np.isfinite(vertices).all(axis=1))
    if bad.size:
        raise Error(
            f"vertices[{bad[0]}] is {vertices[bad[0]]}; coordinates must be "
            "finite"
        )
    return vertices


def _polygons(
    given: ArrayLike | Sequence[Sequence[int]], vertices: int
) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
    """Returns the corners of all faces, and the number of corners of each."""
    # Rows may differ in length, unlike those of an array.
    every: Any = unmasked(given, "faces")
    if not len(every):
        raise Error("faces is empty; a mesh needs at least one face")
    counts = np.fromiter(map(len, every), np.uint32, len(every))
    few = np.flatnonzero(counts < 3)
    if few.size:
        raise Error(
            f"faces[{few[0]}] has {counts[few[0]]} corners; give three or more"
        )
    corners = real(
        np.concatenate([np.asarray(face) for face in every]), "faces"
    )
    whole = corners.astype(np.int64)
    wrong = (whole != corners) | (whole < 0) | (whole >= vertices)
    if wrong.any():
        place = int(np.flatnonzero(wrong)[0])
        face = int(np.searchsorted(np.cumsum(counts), place, side="right"))
        raise Error(
            f"faces[{face}] has corner {corners[place]:.15g}; vertices are 0 to "
            f"{vertices - 1}"
        )
    return whole.astype(np.uint32), counts


def _arguments(**given: Any) -> list[str]:
    """Returns the words of a command line with these options; None leaves one
    out."""
    words: list[str] = []
    for name, value in given.items():
        if value is None or value is False:
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            values = value if isinstance(value, tuple | list) else [value]
            words += map(str, values)
    return words


def _in_python(message: str) -> str:
    """Puts the names of arguments in the place of those of options."""
    message = re.sub(r"--(leaf|stalk|sheath)-\w+", r"\1", message)
    message = message.replace("--date", "--day")
    return re.sub(
        r"--([a-z-]+)", lambda found: found[1].replace("-", "_"), message
    )


def _dataset(found: dict[str, Any], unit: str, scale: float) -> xarray.Dataset:
    """Returns what is found as arrays; `scale` turns it into the unit."""
    arrays: dict[str, Any] = {}

    def add(
        name: str,
        dims: tuple[str, ...],
        mean: Any,
        error: Any,
        units: str = unit,
        meaning: str = "",
    ) -> None:
        about = {"units": units, "long_name": meaning or name}
        arrays[name] = (dims, mean, about)
        arrays[f"{name}_standard_error"] = (dims, error, {"units": units})

    for name, (mean, error) in found["budget"].items():
        add(name, (), scale * mean, scale * error)
    groups = scale * found["absorbed_by_group"]
    add("absorbed", ("group",), groups[:, 0], groups[:, 1])
    layers = scale * found["absorbed_by_layer"]
    add("absorbed_by_layer", ("layer",), layers[:, 0], layers[:, 1])
    faces = scale * found["absorbed_by_face"]
    if len(faces):
        # Light by face is per one-sided area of the face.
        add("absorbed_by_face", ("face",), faces[:, 0], faces[:, 1])
    for name, units, meaning, mean, error in found["numbers"]:
        add(name, (), mean, error, units, meaning)
    arrays["incident"] = ((), scale * found["incident"], {"units": unit})
    # Incident light is exact.
    arrays.pop("incident_standard_error", None)
    if "gross_assimilation" in found:
        # The light of a single sun or sky is that of a second [mol].
        is_day = unit.endswith("day-1")
        moles = 1 if is_day else 1e6
        of = "mol m-2 day-1" if is_day else "umol m-2 s-1"
        mean, error = (moles * x for x in found["gross_assimilation"])
        loss = moles * found["net_loss"]
        add("gross_assimilation", (), mean, error, of)
        add("net_assimilation", (), mean - loss, error, of)
    middles = found["layer_thickness"] * (np.arange(len(layers)) + 0.5)
    return xarray.Dataset(
        arrays,
        {
            "group": found["groups"],
            "layer": ("layer", middles, {"units": "m"}),
        },
        {
            "paths": found["paths"],
            "ground_area": found["ground_area"],
            "balance_error": found["balance_error"],
            "is_tolerance_met": not found["is_capped"],
            "warnings": found["warnings"],
        },
    )


def _scene_dataset(
    found: dict[str, Any], is_day: bool, is_ppfd: bool
) -> xarray.Dataset:
    """Returns the light and assimilation of a scene file, by band and
    component."""
    unit = "MJ m-2 day-1" if is_day else "umol m-2 s-1" if is_ppfd else "1"
    scale = 1e-6 if is_day else 1.0
    bands = found["bands"]
    arrays: dict[str, Any] = {}

    def add(
        name: str, dims: tuple[str, ...], pairs: Any, units: str, by: float
    ) -> None:
        numbers = by * np.asarray(pairs, float)
        arrays[name] = (dims, numbers[..., 0], {"units": units})
        arrays[f"{name}_standard_error"] = (
            dims,
            numbers[..., 1],
            {"units": units},
        )

    for name, dims in (
        ("soil", ("band",)),
        ("reflected", ("band",)),
        ("absorbed_by_component", ("band", "component")),
        ("absorbed", ("band", "group")),
    ):
        add(name, dims, [band[name] for band in bands], unit, scale)
    incident = [scale * band["incident"] for band in bands]
    arrays["incident"] = (("band",), incident, {"units": unit})
    arrays["lai"] = (("component",), found["lai"], {"units": "m2 m-2"})
    if "gross_assimilation" in found:
        moles = 1 if is_day else 1e6
        of = "mol m-2 day-1" if is_day else "umol m-2 s-1"
        gross = found["gross_assimilation"]
        net = gross - np.array([[lost, 0] for lost in found["respired"]])
        add("gross_assimilation", ("component",), gross, of, moles)
        add("net_assimilation", ("component",), net, of, moles)
    return xarray.Dataset(
        arrays,
        {
            "band": [band["name"] for band in bands],
            "component": found["components"],
            "group": found["groups"],
        },
        {
            "paths": found["paths"],
            "ground_area": found["ground_area"],
            "is_tolerance_met": not found["is_capped"],
            "warnings": found["warnings"],
        },
    )
