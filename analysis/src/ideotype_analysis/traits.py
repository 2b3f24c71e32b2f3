"""The genes of a case: names, units and bounds."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Traits:
    """One entry per gene, in the order of a genome."""

    names: tuple[str, ...]
    units: tuple[str, ...]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    is_circular: NDArray[np.bool_]
    """lower and upper are the same point."""
    is_free: NDArray[np.bool_]
    """Bred; the others keep the baseline's value."""

    def columns(self, kind: str) -> NDArray[np.int64]:
        """Genes of a kind, such as "length", lowest leaf first."""
        found = [
            (int(match[1]), i)
            for i, name in enumerate(self.names)
            if (match := re.fullmatch(rf"leaf(\d+)_{re.escape(kind)}", name))
        ]
        return np.array([i for _, i in sorted(found)], dtype=int)

    def leaves(self, kind: str) -> NDArray[np.int64]:
        """Leaf ranks of those genes; 1 is the lowest leaf."""
        ranks = re.compile(r"leaf(\d+)_")
        names = [self.names[i] for i in self.columns(kind)]
        return np.array(
            [int(match[1]) for n in names if (match := ranks.match(n))],
            dtype=int,
        )
