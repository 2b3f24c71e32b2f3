# SPDX-License-Identifier: Apache-2.0
"""Where the leaves of plants point."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .case import Case
from .file import HistoryError
from .profile_curve import curve

_MEASURE = "leaf.azimuth"


def azimuths(case: Case, genomes: NDArray) -> NDArray[np.float64]:
    """Of the leaves of plants, lowest first [plants, leaves], in [0, 360)
    [deg]: every trait that acts on azimuths does, whether it is bred or not.

    Raises HistoryError if none does."""
    baseline = case.resolved.get("plant", {}).get("baseline", {})
    traits = baseline.get("trait")
    if traits is None:
        # Before crops declared traits, a gene was the azimuth itself.
        columns = case.genes.columns("azimuth")
        if not len(columns):
            raise HistoryError("the plants have no azimuths")
        return genomes[:, columns]
    own = np.array([leaf["azimuth"] for leaf in baseline["leaf"]], dtype=float)
    found = np.tile(own, (len(genomes), 1))
    acting = False
    for trait in traits:
        for effect in ("sets", "scales", "shifts"):
            if _MEASURE in trait.get(effect, []):
                numbers = _by_leaf(case, trait["name"], genomes, len(own))
                found = _act(effect, found, numbers)
                acting = True
    if not acting:
        raise HistoryError("no trait acts on azimuths")
    return np.mod(found, 360.0)


def _act(effect: str, values: NDArray, numbers: NDArray) -> NDArray:
    if effect == "sets":
        return numbers
    return values * numbers if effect == "scales" else values + numbers


def _by_leaf(case: Case, trait: str, genomes: NDArray, leaves: int) -> NDArray:
    """A trait's number for each leaf."""
    numbers = genomes[:, case.genes.columns(trait)]
    if case.genes.kind(trait) == "profile":
        return curve(numbers, np.linspace(0, 1, leaves))
    return np.broadcast_to(numbers, (len(genomes), leaves))
