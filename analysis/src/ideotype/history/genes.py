# SPDX-License-Identifier: Apache-2.0
"""The genes of a case: names, traits, units and bounds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..common.labels import unit_label, words

Kind = Literal["leaf", "plant", "profile"]
"""The kinds of traits. A trait has one gene per leaf, one gene per plant, or
one gene per point of a smooth curve over leaf position; the points are
equidistant from the lowest leaf to the highest."""


@dataclass(frozen=True)
class Genes:
    """The genes in the order of a genome; each field has one entry per
    gene."""

    names: tuple[str, ...]
    traits: tuple[str, ...]
    """The trait of each gene, such as "length"."""
    leaves: NDArray[np.int64]
    """The leaf rank of each gene, from 1 for the lowest leaf; 0: not of a
    single leaf."""
    units: tuple[str, ...]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    is_circular: NDArray[np.bool_]
    """Whether `lower` and `upper` are the same point, as for azimuths."""
    is_free: NDArray[np.bool_]
    """Whether the search varies each gene; others keep the value of the
    baseline."""
    kinds: tuple[str, ...] = ()
    """The kind of each gene: "real"; "integer", the whole numbers between the
    bounds; or "choice", whole numbers of values without an order."""
    values: tuple[tuple[str, ...], ...] = ()
    """The values that `lower`, `lower` + 1, ... stand for, as TOML; empty if
    the number itself is the value."""

    def is_discrete(self, gene: int) -> bool:
        """Returns whether a gene is an integer or a choice."""
        return bool(self.kinds) and self.kinds[gene] != "real"

    def is_choice(self, gene: int) -> bool:
        """Returns whether the values of a gene have no order."""
        return bool(self.kinds) and self.kinds[gene] == "choice"

    def text(self, gene: int, value: float, form: str = ".4g") -> str:
        """Returns the text of a gene's value: the value that it stands for, or
        the number."""
        if not self.values or not self.values[gene]:
            return format(value, form)
        return self.values[gene][round(value - self.lower[gene])]

    @property
    def have_bounds(self) -> NDArray[np.bool_]:
        """Whether a value of each gene can be at a bound: not of circular
        genes, fixed ones and choices."""
        choices = [self.is_choice(gene) for gene in range(len(self.names))]
        return self.is_free & ~self.is_circular & ~np.array(choices, bool)

    def columns(self, trait: str) -> NDArray[np.int64]:
        """Returns the genes of a trait, lowest leaf or point first."""
        genes = [i for i, name in enumerate(self.traits) if name == trait]
        return np.array(sorted(genes, key=lambda i: self.leaves[i]), dtype=int)

    def kind(self, trait: str) -> Kind:
        """Returns the kind of a trait's genes."""
        columns = self.columns(trait)
        if self.leaves[columns].any():
            return "leaf"
        return "profile" if len(columns) > 1 else "plant"

    def bred(self, kind: Kind) -> list[str]:
        """Returns the traits of a kind with a free gene."""
        free = dict.fromkeys(
            t for t, is_free in zip(self.traits, self.is_free) if is_free
        )
        return [trait for trait in free if self.kind(trait) == kind]

    def number(self, gene: int) -> int:
        """Returns the leaf rank of a gene, or the number of its point of a
        profile, from 1; 0 for a trait of the whole plant."""
        trait = self.traits[gene]
        if self.kind(trait) == "profile":
            return int(np.flatnonzero(self.columns(trait) == gene)[0]) + 1
        return int(self.leaves[gene])

    def label(self, trait: str) -> str:
        """Returns the axis label of a trait: "insertion angle [°]", or
        "height [1]" for a factor."""
        unit = unit_label(self.units[self.columns(trait)[0]])
        return f"{words(trait)} [{unit}]"


def curve(points: NDArray, at: NDArray) -> NDArray[np.float64]:
    """Interpolates points, equidistant over [0, 1] on the last axis, at `at`,
    as the program interpolates profiles: by a monotone cubic (Fritsch and
    Butland 1984, doi:10.1137/0905021)."""
    # This import takes as long as all other imports together.
    from scipy.interpolate import PchipInterpolator

    points = np.asarray(points)
    if points.shape[-1] == 1:
        return np.repeat(points, len(at), axis=-1)
    position = np.linspace(0, 1, points.shape[-1])
    return PchipInterpolator(position, points, axis=-1)(at)
