# SPDX-License-Identifier: Apache-2.0
"""Members of the Pareto fronts of fronts.py, with the amount of a resource
that their carbon requires."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from shared import Numbers

from ideotype import Stand

BALANCE = "carbon balance [mol m-2 day-1]"


@dataclass(frozen=True)
class Price:
    """The resource that carbon requires, and the titles of its table."""

    quantity: str
    name: str
    unit: str
    question: str
    titles: tuple[str, ...]

    @property
    def title(self) -> str:
        return self.name + self.unit


LEAVES = Price(
    "lai",
    "leaf area index",
    "",
    "How much leaf area does a season's carbon need?",
    (BALANCE, "per leaf area", "of one more unit of leaf area"),
)
WATER = Price(
    "transpiration",
    "transpiration",
    " [mm day-1]",
    "How much water does the carbon of a dry month need?",
    (
        *("over the baseline's [%]", BALANCE, "over the baseline's [%]"),
        *("carbon per water [g kg-1]", "leaf area index"),
    ),
)


@dataclass(frozen=True)
class Found:
    """Plants in the order of the resource that they require, with the
    baseline."""

    stand: Stand
    price: Price
    genomes: Numbers  # genomes [plants, genes], the baseline last
    lai: Numbers
    paid_by_randomisation: Numbers  # the resource, like `carbon`
    carbon: Numbers  # carbon balance of plants [plants, randomisations]
    is_front: np.ndarray  # whether a plant is not dominated by any other
    seed: Numbers  # the seed that found each plant, without the baseline

    @property
    def front(self) -> list[int]:
        return [int(i) for i in np.flatnonzero(self.is_front)]

    @property
    def paid(self) -> Numbers:
        """The amount of the resource that each plant requires."""
        return np.asarray(self.paid_by_randomisation.mean(1))

    def shown(self, count: int) -> list[int]:
        """Returns members of the front at approximately equal steps of the
        resource."""
        paid = self.paid[self.front]
        step = (paid[-1] - paid[0]) / max(count - 1, 1)
        number = np.round((paid - paid[0]) / max(step, 1e-9))
        off = np.abs(paid - paid[0] - number * step)
        return [
            self.front[int(np.where(number == each, off, np.inf).argmin())]
            for each in np.unique(number)
        ]
