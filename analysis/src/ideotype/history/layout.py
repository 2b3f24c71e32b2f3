# SPDX-License-Identifier: Apache-2.0
"""The places of the plants of a case, and the light that leaves absorb."""

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
    """Returns the direction of the case's rows [deg], clockwise from north;
    azimuth 0 points in this direction. None if the history has no
    direction."""
    name = case.attributes.get("spacing")
    for spacing in case.resolved.get("spacing", []):
        if spacing.get("name") == name and "row_direction" in spacing:
            return float(spacing["row_direction"])
    return None


def places(case: Case, plants: int = 1) -> list[NDArray[np.float64]]:
    """Returns the places [m] across and along the rows of a plant, which comes
    first, and of its neighbours: one row on each side, and the given number of
    plants before and behind. An isolated plot has only its own plants; a
    history with no distances or with several has only the plant."""
    if case.is_over("spacing"):
        return [np.zeros(2)]
    row = float(case.attributes.get("row_spacing", 0))
    plant = float(case.attributes.get("plant_spacing", 0))
    rows = 1
    if case.is_isolated:
        field = case.resolved.get("field", {})
        rows = min(rows, (int(field.get("rows", 1)) - 1) // 2)
        plants = min(plants, (int(field.get("plants", 1)) - 1) // 2)
    found = [
        np.array([row * i, plant * j])
        for i in range(-rows, rows + 1)
        for j in range(-plants, plants + 1)
        if (row or not i) and (plant or not j)
    ]
    return sorted(found, key=lambda place: bool(place.any()))


def leaf_light(
    plant: HasProfiles, mesh: Mesh, ground: float | None = None
) -> dict[str, float | None]:
    """Returns the light that each group of the plant's mesh absorbs, as the
    history has it, per area of ground, or per area of leaf on so much ground
    of the plant [m2]; None for groups that are no leaves, and for all groups
    if the history does not distinguish leaves."""
    found: dict[str, float | None] = dict.fromkeys(mesh.groups)
    try:
        told = plant.profile("absorbed_by_leaf")
    except HistoryError:
        return found
    if told.labels.dtype.kind == "U":  # of several components
        return found
    leaves = {
        rank: group for group, rank in zip(mesh.groups, mesh.ranks) if rank
    }
    # Crops that grow have lower leaves that a full-grown plant has lost.
    lost = max(len(told.labels) - len(leaves), 0)
    for leaf, value in zip(told.labels, told.values.tolist()):
        if group := leaves.get(leaf - lost):
            over = mesh.area(group) / ground if ground else 1
            found[group] = value / over
    return found
