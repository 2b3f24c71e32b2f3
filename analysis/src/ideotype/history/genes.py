# SPDX-License-Identifier: Apache-2.0
"""The genes of a case: names, traits, units and bounds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..common.labels import unit_label, words

Kind = Literal["leaf", "plant", "profile"]
"""The kinds of traits: a trait has a gene for each leaf, for the plant, or for
each point of a smooth curve over leaf position, at equal distances from the
lowest leaf to the highest."""


@dataclass(frozen=True)
class Genes:
    """The genes, with one entry each, in the order of a genome."""

    names: tuple[str, ...]
    traits: tuple[str, ...]
    """The trait of each gene, such as "length"."""
    leaves: NDArray[np.int64]
    """The rank of the leaf of each gene: 1 is the lowest leaf, 0 means no
    single leaf."""
    units: tuple[str, ...]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    is_circular: NDArray[np.bool_]
    """Whether the bounds `lower` and `upper` of each gene are the same
    point."""
    is_free: NDArray[np.bool_]
    """Whether each gene is bred; a gene that is not bred keeps the baseline's
    value."""

    def columns(self, trait: str) -> NDArray[np.int64]:
        """Returns the genes of a trait, lowest leaf or point first."""
        found = [i for i, name in enumerate(self.traits) if name == trait]
        return np.array(sorted(found, key=lambda i: self.leaves[i]), dtype=int)

    def kind(self, trait: str) -> Kind:
        """Returns the kind of a trait's genes."""
        columns = self.columns(trait)
        if self.leaves[columns].any():
            return "leaf"
        return "profile" if len(columns) > 1 else "plant"

    def bred(self, kind: Kind) -> list[str]:
        """Returns the traits of a kind that have a free gene."""
        free = dict.fromkeys(
            t for t, is_free in zip(self.traits, self.is_free) if is_free
        )
        return [trait for trait in free if self.kind(trait) == kind]

    def number(self, gene: int) -> int:
        """Returns the leaf rank, or the point of a profile from 1; 0 for a
        trait of the whole plant."""
        trait = self.traits[gene]
        if self.kind(trait) == "profile":
            return int(np.flatnonzero(self.columns(trait) == gene)[0]) + 1
        return int(self.leaves[gene])

    def label(self, trait: str) -> str:
        """Returns the label of an axis: "insertion angle [°]", or "height [1]"
        for a factor."""
        unit = unit_label(self.units[self.columns(trait)[0]])
        return f"{words(trait)} [{unit}]"


def curve(points: NDArray, at: NDArray) -> NDArray[np.float64]:
    """Returns the curve through points at equal distances over [0, 1] on the
    last axis, as the program draws a profile: monotone between neighbours
    (Fritsch and Butland 1984, doi:10.1137/0905021)."""
    # The import stands here, since it takes as long as all else together.
    from scipy.interpolate import PchipInterpolator

    points = np.asarray(points)
    if points.shape[-1] == 1:
        return np.repeat(points, len(at), axis=-1)
    place = np.linspace(0, 1, points.shape[-1])
    return PchipInterpolator(place, points, axis=-1)(at)
