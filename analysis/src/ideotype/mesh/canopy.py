# SPDX-License-Identifier: Apache-2.0
"""Computes the light absorbed by any mesh."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import date
from os import PathLike
from typing import Any

import numpy as np
import xarray
from numpy.typing import ArrayLike, NDArray

from ..common.arrays import real, unmasked
from ..common.compiled import _core
from ..errors import Error
from .datasets import dataset

Pair = tuple[float, float]


class Canopy:
    """A mesh that repeats on a lattice, stands alone or forms a field.
    `ideotype.mesh` makes it."""

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
        number = {name: i for i, name in enumerate(self._names)}
        self._face_group = np.array([number[x] for x in names], np.uint32)

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
        """Computes the light absorbed, reflected and transmitted by the mesh,
        as `ideotype light` does. Options have the defaults of the command
        line.

        period: the period of the lattice on which the mesh repeats, along x
            and y [m].
        isolated: whether the mesh stands alone on unbounded soil; light per
            area then refers to `ground_area` [m2].
        field: number of rows, plants per row, row spacing and plant spacing
            [m]. The mesh is a plant at x = y = 0 that repeats in rows along y;
            each plant is turned at random by up to `jitter` [deg].
        sun: elevation and azimuth, clockwise from north = +y [deg]. The
            irradiance of level ground is 1, or `beam_ppfd` [umol m-2 s-1].
        sky: "uniform", "overcast" or "clear". The irradiance of level ground
            is 1, or `sky_ppfd` [umol m-2 s-1].
        site: latitude, longitude [deg] and UTC offset [h]; with it the sun
            and sky are those of a clear `day`, such as "2021-07-01".
        climate: file with the tables [site] and [climate] of a campaign.
        photosynthesis: file with the table [photosynthesis], for assimilation;
            `exact` has the meaning of `--exact` on the command line.
        leaf, stalk, sheath: reflectance and transmittance, by default the
            values of the command line. Groups whose names begin with "stalk"
            or "sheath" are stalks or sheaths, all others are leaves.
        scene: file of materials, components and wavebands, as for `--scene` of
            the command line; it defines all optics and photosynthesis.
        tolerance: relative standard error of the light absorbed by leaves;
            `paths` gives the number of paths instead.
        by_face: whether to return the light absorbed by each face.

        Returns a Dataset with these quantities and their NAME_standard_error,
        per area of ground: `incident`, the light above the canopy; `leaves`,
        `stalks` (all other organs) and `soil`, the light that each absorbs;
        `reflected`, the light that escapes from the canopy; `absorbed`, the
        light absorbed by each `group`; and the light absorbed by leaves by
        height, `absorbed_by_layer`, by origin (beam, sky or other surfaces),
        `leaves_by_origin`, and by side, `leaves_by_side`. The Dataset also has
        the quantities of a history, for a single sun or sky without rates.
        With a `scene` it has instead, by `band`, `incident`, `soil`,
        `reflected`, `absorbed_by_component` and `absorbed` by `group`; and by
        `component` the leaf area index `lai`, `gross_assimilation` and
        `net_assimilation`.

        Raises Error if options contradict each other."""
        given: dict[str, Any] = {
            "period": period,
            "boundary": "isolated" if isolated else None,
            "ground_area": ground_area,
            "field": field,
            "jitter": jitter,
            "sun": sun,
            "sky": sky,
            "site": site,
            "date": day,
            "beam_ppfd": beam_ppfd,
            "sky_ppfd": sky_ppfd,
            "climate": climate,
            "photosynthesis": photosynthesis,
            "exact": exact or None,
            "soil_albedo": soil_albedo,
            "scene": scene,
            "tolerance": tolerance,
            "paths": paths,
            "seed": seed,
        }
        surfaces = {"leaf": leaf, "stalk": stalk, "sheath": sheath}
        for name, pair in surfaces.items():
            if pair is not None:
                reflectance, transmittance = pair
                given[f"{name}_reflectance"] = reflectance
                given[f"{name}_transmittance"] = transmittance
        parts = _core.evaluate_mesh(
            self._vertices,
            self._corners,
            self._counts,
            self._face_group,
            self._names,
            {k: _values(v) for k, v in given.items() if v is not None},
            by_face,
        )
        return dataset(*parts)


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
    # Polygons may differ in their number of corners, unlike rows of an array.
    polygons: Any = unmasked(given, "faces")
    if not len(polygons):
        raise Error("faces is empty; a mesh needs at least one face")
    counts = np.fromiter(map(len, polygons), np.uint32, len(polygons))
    few = np.flatnonzero(counts < 3)
    if few.size:
        raise Error(
            f"faces[{few[0]}] has {counts[few[0]]} corners; give three or more"
        )
    corners = real(
        np.concatenate([np.asarray(face) for face in polygons]), "faces"
    )
    whole = corners.astype(np.int64)
    wrong = (whole != corners) | (whole < 0) | (whole >= vertices)
    if wrong.any():
        position = int(np.flatnonzero(wrong)[0])
        face = int(np.searchsorted(np.cumsum(counts), position, side="right"))
        raise Error(
            f"faces[{face}] has the corner {corners[position]:.15g}; name "
            f"vertices from 0 to {vertices - 1}"
        )
    return whole.astype(np.uint32), counts


def _values(given: Any) -> list[bool | int | float | str]:
    """Returns the values of a key; dates and paths become texts."""
    many = given if isinstance(given, tuple | list | np.ndarray) else [given]
    plain = [x.item() if isinstance(x, np.generic) else x for x in many]
    return [str(x) if isinstance(x, date | PathLike) else x for x in plain]
