# SPDX-License-Identifier: Apache-2.0
"""Adapts stands to the gest-api standard, which the generators of libEnsemble,
Xopt and Optimas follow.

https://github.com/campa-consortium/gest-api"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gest_api.vocs import VOCS

from ..common.arrays import real
from ..errors import Error
from ..stand.stand import Stand

_SENSES = {"maximise": "MAXIMIZE", "minimise": "MINIMIZE"}


def vocs(stand: Stand) -> VOCS:
    """Returns the free genes of a stand as variables, in their units, and the
    objectives of its campaign."""
    genes = stand.genes[stand.free]
    return VOCS(
        variables={
            gene.name: [gene.lower, gene.upper] for gene in genes.itertuples()
        },
        objectives={
            name: _SENSES[sense] for name, sense in stand.objectives.items()
        },
    )


class Evaluator:
    """Evaluates one point at a time: takes the values of the free genes by
    name and returns the objectives by name."""

    def __init__(self, stand: Stand, **options: Any) -> None:
        """stand: stand in which points are evaluated. options: keyword
        arguments of Stand.evaluate, such as tolerance and seed."""
        self._stand = stand
        self._options = options
        self._names = list(stand.genes.name[stand.free])

    def __call__(self, point: Mapping[str, float]) -> dict[str, float]:
        """Evaluates one point. Raises Error if the plant cannot be
        evaluated."""
        plant = [real(point[name], name).item() for name in self._names]
        result = self._stand.evaluate(
            plant, list(self._stand.objectives), threads=1, **self._options
        )
        message = str(result.message.item())
        if message:
            raise Error(message)
        return {name: result[name].item() for name in self._stand.objectives}
