# SPDX-License-Identifier: Apache-2.0
"""Re-evaluates the parts of margins."""

from __future__ import annotations

import numpy as np

from ..common.compiled import _core
from ..history.history import History
from ..stand.plants import restore_stand
from .margin import PARTS, Floats


def evaluate_parts(
    history: History, genome: Floats, environment: int, seed: int
) -> Floats:
    """Evaluates a plant with its management in one environment, like a
    finalist. Returns the parts of its margin by randomisation
    [parts, randomisations], in the order of PARTS; those that the campaign
    lacks are 0.

    Raises Error if the evaluation fails."""
    stand = restore_stand(history, genome, same_isa=False)
    plants = _core.grown_plants(stand, np.ascontiguousarray(genome))
    under = _core.PlantStand(stand, plants, plants.reach, environment)
    _, draws, _, by_randomisation = under.evaluate(0, True, seed, None)
    columns = {}
    begin = 0
    sizes = {axis: len(at) for axis, _, _, at in under.axes}
    for name, _, _, axes, *_ in under.quantities:
        if not axes:
            columns[name] = by_randomisation[:, begin]
        begin += int(np.prod([sizes[axis] for axis in axes]))
    for (name, *_), values in zip(under.objectives, draws):
        columns[name] = values
    nothing = np.zeros(by_randomisation.shape[0])
    return np.array([columns.get(name, nothing) for name, _ in PARTS.values()])
