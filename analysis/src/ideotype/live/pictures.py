# SPDX-License-Identifier: Apache-2.0
"""The baseline and the best plant of a history for drawing by the live
page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ..errors import Error
from ..history.history import open_history
from ..history.layout import leaf_light
from ..report.scene import describe_shape, pack_vertices
from ..stand.stand import Stand


def make_plants(path: Path) -> dict[str, Any]:
    """Returns the baseline and the best plant with the light that each leaf
    absorbs per area of ground. Raises Error or HistoryError if the plants
    cannot be drawn."""
    with open_history(path) as history:
        pair = history.baseline(), history.best()
        spacing = [
            float(history.attributes.get(name, 0.5))
            for name in ("row_spacing", "plant_spacing")
        ]
    plants = [plant for plant in pair if plant is not None]
    if len(plants) < 2:
        raise Error("no plant is evaluated yet")
    stand = Stand.from_history(path, same_isa=False)
    drawn = []
    for plant in plants:
        mesh = stand.mesh(plant.row.genome[0])
        drawn.append(
            {
                **describe_shape(mesh),
                **pack_vertices(mesh.vertices),
                "light": list(leaf_light(plant, mesh).values()),
            }
        )
    row, along = spacing
    return {
        "plants": drawn,
        "neighbours": [[x, y] for x in (-row, 0, row)
                       for y in (-2 * along, -along, 0, along, 2 * along)
                       if x or y],
    }  # fmt: skip
