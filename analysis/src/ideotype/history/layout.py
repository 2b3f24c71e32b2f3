# SPDX-License-Identifier: Apache-2.0
"""The positions of the plants of a case, and the light absorbed by their
leaves."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..mesh.geometry import Mesh
from .case import Case
from .file import HistoryError
from .quantity import Profile


class HasProfiles(Protocol):
    """An evaluated plant, of a history or of the user."""

    def profile(self, name: str) -> Profile:
        """Returns a quantity along its axis."""


def row_direction(case: Case) -> float | None:
    """Returns the direction of the rows [deg], clockwise from north, in which
    azimuth 0 points. None if the history does not state it."""
    name = case.attributes.get("spacing")
    for spacing in case.resolved.get("spacing", []):
        if spacing.get("name") == name and "row_direction" in spacing:
            return float(spacing["row_direction"])
    return None


def places(case: Case, plants: int = 1) -> list[NDArray[np.float64]]:
    """Returns the positions [2] of a plant and then of its neighbours, across
    and along the rows [m]: one row on each side and `plants` plants in each
    direction along a row. An isolated plot has only the plants that exist; a
    history without a single spacing has only one plant."""
    if case.is_over("spacing"):
        return [np.zeros(2)]
    row = float(case.attributes.get("row_spacing", 0))
    plant = float(case.attributes.get("plant_spacing", 0))
    rows = 1
    if case.is_isolated:
        field = case.resolved.get("field", {})
        rows = min(rows, (int(field.get("rows", 1)) - 1) // 2)
        plants = min(plants, (int(field.get("plants", 1)) - 1) // 2)
    positions = [
        np.array([row * i, plant * j])
        for i in range(-rows, rows + 1)
        for j in range(-plants, plants + 1)
        if (row or not i) and (plant or not j)
    ]
    return sorted(positions, key=lambda place: bool(place.any()))


def leaf_light(
    plant: HasProfiles, mesh: Mesh, ground: float | None = None
) -> dict[str, float | None]:
    """Returns the light absorbed by each leaf of a mesh, by group, from the
    history: per area of ground, or per area of leaf if `ground`, the ground
    area of the plant [m2], is given. None for groups that are not leaves, and
    for all groups if the history does not distinguish leaves."""
    light: dict[str, float | None] = dict.fromkeys(mesh.groups)
    try:
        profile = plant.profile("absorbed_by_leaf")
    except HistoryError:
        return light
    if profile.labels.dtype.kind == "U":  # The leaves of several components.
        return light
    leaves = {
        rank: group for group, rank in zip(mesh.groups, mesh.ranks) if rank
    }
    # A growing crop has lower leaves that the full-grown plant has shed.
    lost = max(len(profile.labels) - len(leaves), 0)
    for leaf, value in zip(profile.labels, profile.values.tolist()):
        if group := leaves.get(leaf - lost):
            lai = mesh.area(group) / ground if ground else 1
            light[group] = value / lai
    return light
