# SPDX-License-Identifier: Apache-2.0
"""Re-evaluates the parts of a worth."""

from __future__ import annotations

from collections.abc import Container

import numpy as np

from ..history.history import History
from .worth import Floats, Worth


def evaluate_parts(
    history: History,
    genome: Floats,
    worth: Worth,
    environments: int,
    seed: int,
) -> Floats:
    """Evaluates a plant with its management in all environments, like a
    finalist. Returns the parts of its worth
    [environments, randomisations, parts]; those that the campaign lacks are 0.

    Raises Error if the evaluation fails, and NotCompiled without the compiled
    module, which a report without decisions does not need."""
    from ..common.compiled import _core
    from ..stand.plants import restore_stand

    stand = restore_stand(history, genome, same_isa=False)
    plants = _core.grown_plants(stand, np.ascontiguousarray(genome))
    under = _core.PlantStand(stand, plants, plants.reach, None)
    _, draws, _, numbers = under.evaluate(0, True, seed, None)
    sizes = {axis: len(at) for axis, _, _, at in under.axes}
    columns = {
        name: values[:, None]
        for (name, *_), values in zip(under.objectives, draws)
    }
    begin = 0
    for name, _, _, axes, *_ in under.quantities:
        end = begin + int(np.prod([sizes[axis] for axis in axes]))
        columns[name] = numbers[:, begin:end]
        begin = end
    parts = np.zeros((environments, len(numbers), len(worth.parts)))
    for i, name in enumerate(worth.parts):
        found = columns.get(name_in(columns, name))
        if found is not None:
            parts[:, :, i] = found.T
    return parts


def name_in(columns: Container[str], part: str) -> str:
    """Returns the name under which a part has a value for each environment:
    objectives and parts of margins over several scenarios have an axis."""
    by_scenario = f"{part}_by_scenario"
    return by_scenario if by_scenario in columns else part
