# SPDX-License-Identifier: Apache-2.0
"""Counts the best plants with traits at a bound, by the rule of the program;
src/search/gene.hpp and src/run/bounds.cpp have the same constants."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .case import Case
from .genes import Genes

MARGIN = 0.05
"""The largest distance of a value from a bound, relative to the range of the
gene, at which the value counts as at the bound."""

_LEAST_SHARE = 0.2
"""The smallest share of the values of a trait at a bound that is reported."""

_SIDES = {"lower": -1, "upper": 1}


def sides(genes: Genes, genome: NDArray[np.float64]) -> NDArray[np.int64]:
    """Returns -1 for each gene at its lower bound, 1 at its upper bound, else
    0 [genes]. Circular genes, fixed genes, choices and genes without a range
    have no bounds."""
    reach = MARGIN * (genes.upper - genes.lower)
    can_be = genes.have_bounds & (reach > 0)
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
    """The number of values at the bound."""
    values: int
    """The number of genes of the trait in all searches."""
    searches: int

    def __str__(self) -> str:
        trait = self.trait.replace("_", " ")
        clause = f"{trait} is at its {self.bound} bound"
        if self.values == 1:
            return clause
        unit = "searches" if self.values == self.searches else "values"
        return f"{clause} in {self.count} of {self.values} {unit}"


def traits_at_bounds(cases: Sequence[Case]) -> list[TraitAtBound]:
    """Returns the traits with at least a fifth of their values at one bound,
    over the re-evaluated best plants of the cases."""
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
    sides_by_trait: dict[str, list[int]] = {}
    for genes, side in plants:
        for gene in np.flatnonzero(genes.have_bounds):
            sides_by_trait.setdefault(genes.traits[gene], []).append(
                int(side[gene])
            )
    for trait, values in sides_by_trait.items():
        for bound, sign in _SIDES.items():
            count = values.count(sign)
            if count and count >= _LEAST_SHARE * len(values):
                yield TraitAtBound(
                    trait, bound, count, len(values), len(plants)
                )


def bounds_in_words(cases: Sequence[Case]) -> str:
    """Returns a clause on the traits at a bound; "" if there is none."""
    traits = traits_at_bounds(cases)
    if not traits:
        return ""
    limit = "the bound" if len(traits) == 1 else "these bounds"
    return f"{', '.join(map(str, traits))}; the gain may be limited by {limit}"
