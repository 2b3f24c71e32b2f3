# SPDX-License-Identifier: Apache-2.0
"""Counts the best plants with traits at a bound, by the rule of the program:
src/search/population.hpp and src/run/bounds.cpp have the same numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .case import Case
from .genes import Genes

BESIDE = 0.05
"""The distance from a bound, over the range of a gene, within which a value is
at the bound."""

_LEAST_PART = 0.2
"""The part of a trait's values at a bound from which on it is reported."""

_SIDES = {"lower": -1, "upper": 1}


def sides(genes: Genes, genome: NDArray[np.float64]) -> NDArray[np.int64]:
    """Returns -1 for each gene of a plant at its lower bound, 1 for each at
    its upper bound, else 0. Circular genes have no bounds, nor have genes that
    are not bred or have no range."""
    reach = BESIDE * (genes.upper - genes.lower)
    can_be = genes.is_free & ~genes.is_circular & (reach > 0)
    low = genome <= genes.lower + reach
    high = (genome >= genes.upper - reach) & ~low
    return np.where(can_be, high.astype(int) - low.astype(int), 0)


@dataclass(frozen=True)
class TraitAtBound:
    """A trait at one of its bounds, counted in several searches."""

    trait: str
    bound: str
    """The bound, lower or upper."""
    count: int
    """The values at the bound."""
    values: int
    """The genes of the trait in all searches."""
    searches: int

    def __str__(self) -> str:
        trait = self.trait.replace("_", " ")
        told = f"{trait} is at its {self.bound} bound"
        if self.values == 1:
            return told
        what = "searches" if self.values == self.searches else "values"
        return f"{told} in {self.count} of {self.values} {what}"


def traits_at_bounds(cases: Sequence[Case]) -> list[TraitAtBound]:
    """Returns the traits that are at a bound in at least a fifth of their
    values, of the best plants that were evaluated again."""
    plants = [
        (pair.best.row.genes, sides(pair.best.row.genes, genome))
        for case in cases
        for pair in case.pairs
        if pair.is_final
        for genome in pair.best.row.genome[:1]
    ]
    return [*_counted(plants)]


def _counted(
    plants: Sequence[tuple[Genes, NDArray[np.int64]]],
) -> Iterator[TraitAtBound]:
    found: dict[str, list[int]] = {}
    for genes, side in plants:
        can_be = genes.is_free & ~genes.is_circular
        for gene in np.flatnonzero(can_be):
            found.setdefault(genes.traits[gene], []).append(int(side[gene]))
    for trait, values in found.items():
        for bound, sign in _SIDES.items():
            count = values.count(sign)
            if count and count >= _LEAST_PART * len(values):
                yield TraitAtBound(
                    trait, bound, count, len(values), len(plants)
                )


def bounds_in_words(cases: Sequence[Case]) -> str:
    """Returns a clause about the traits that are at a bound; "" if there is
    none."""
    found = traits_at_bounds(cases)
    if not found:
        return ""
    limit = "the bound" if len(found) == 1 else "these bounds"
    return f"{', '.join(map(str, found))}; the gain may be limited by {limit}"
