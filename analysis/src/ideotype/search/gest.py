# SPDX-License-Identifier: Apache-2.0
"""Adapts stands to generators and ensembles of the gest-api standard, such as
the generators of libEnsemble, Xopt and Optimas.

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
    """An evaluator of one point at a time: it takes values of free genes by
    name and returns objectives by name."""

    def __init__(self, stand: Stand, **options: Any) -> None:
        """Keeps the stand. options: options of Stand.evaluate, such as
        tolerance and seed."""
        self._stand = stand
        self._options = options
        self._names = list(stand.genes.name[stand.free])

    def __call__(self, point: Mapping[str, float]) -> dict[str, float]:
        """Evaluates one point. Raises Error if the plant cannot be
        evaluated."""
        plant = [real(point[name], name).item() for name in self._names]
        found = self._stand.evaluate(
            plant, list(self._stand.objectives), threads=1, **self._options
        )
        message = str(found.message.item())
        if message:
            raise Error(message)
        return {name: found[name].item() for name in self._stand.objectives}
