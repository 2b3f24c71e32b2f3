"""The genes of a case: names, traits, units and bounds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Genes:
    """One entry per gene, in the order of a genome."""

    names: tuple[str, ...]
    traits: tuple[str, ...]
    """Such as "length"."""
    leaves: NDArray[np.int64]
    """Ranks; 1 is the lowest leaf, 0 the whole plant."""
    units: tuple[str, ...]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    is_circular: NDArray[np.bool_]
    """lower and upper are the same point."""
    is_free: NDArray[np.bool_]
    """Bred; the others keep the baseline's value."""

    def columns(self, trait: str) -> NDArray[np.int64]:
        """Genes of a trait, lowest leaf first."""
        found = [i for i, name in enumerate(self.traits) if name == trait]
        return np.array(sorted(found, key=lambda i: self.leaves[i]), dtype=int)

    def words(self, gene: int) -> str:
        """ "insertion angle of leaf 3"."""
        trait, leaf = self.traits[gene].replace("_", " "), self.leaves[gene]
        return f"{trait} of leaf {leaf}" if leaf else trait
