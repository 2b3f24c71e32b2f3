# SPDX-License-Identifier: Apache-2.0
"""Atlases: the best plant in each cell of a grid of quantities
(quality-diversity search)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .quantity import Integers
from .rows import Evaluation, Origin, Rows


@dataclass(frozen=True)
class AtlasAxis:
    """A quantity by which an atlas classifies plants."""

    name: str
    unit: str
    edges: NDArray[np.float64]
    """The bounds of cells [cells + 1]."""

    @property
    def cells(self) -> int:
        """The number of cells."""
        return len(self.edges) - 1

    def spans(self) -> list[str]:
        """Returns the bounds of each cell as texts, such as "2 to 2.5"."""
        return [
            f"{low:.3g} to {high:.3g}"
            for low, high in zip(self.edges, self.edges[1:])
        ]

    def cell_of(self, values: NDArray[np.float64]) -> Integers:
        """Returns the cells to which values belong, by the rule of the
        search."""
        low, high = self.edges[[0, -1]]
        cells = np.floor((values - low) / (high - low) * self.cells)
        return cells.astype(int)


@dataclass(frozen=True)
class Atlas:
    """The best plants of all occupied cells (leaders), re-evaluated after the
    search with independent random numbers, common to all leaders."""

    axes: tuple[AtlasAxis, ...]
    leaders: Rows
    cells: Integers
    """The cell of each leader on each axis [leaders, axes]."""
    looks: Integers
    """The number of evaluations of each leader in the search [leaders]."""

    @property
    def is_confirmed(self) -> NDArray[np.bool_]:
        """Whether each leader was re-evaluated during the search [leaders]."""
        return self.looks > 1

    def one(self, index: int) -> Evaluation:
        """Returns one leader."""
        return self.leaders.one(index, True)

    def on_two_axes(self) -> list[int]:
        """Returns the leaders that a map over the first two axes shows: the
        best leader of each cell of the map."""
        sign = self.leaders.goals[0].sign
        order = np.argsort(
            -sign * self.leaders.objectives[:, 0], kind="stable"
        )
        _, first = np.unique(self.cells[order, :2], axis=0, return_index=True)
        return sorted(int(i) for i in order[first])


def _make_axis(axis: dict[str, Any], unit: str) -> AtlasAxis:
    low, high = axis["range"]
    edges = np.linspace(float(low), float(high), int(axis["cells"]) + 1)
    return AtlasAxis(axis["quantity"], unit, edges)


def make_atlas(
    axes: Sequence[dict[str, Any]], finalists: Rows, rows: Rows
) -> Atlas | None:
    """Returns the atlas of a search; None without finalists.

    axes: quantity, range and number of cells of each axis of the campaign.
    finalists: evaluated finalists, without the baseline.
    rows: all evaluations of the search."""
    if not len(finalists):
        return None
    positions = dict(zip(rows.row.tolist(), range(len(rows))))
    first, looks = [], []
    for row in finalists.parents[:, 0].tolist():
        # The parent of a re-evaluated row is its previous evaluation.
        count, at = 1, positions[row]
        while rows.origin[at] == Origin.ELITE:
            count, at = count + 1, positions[int(rows.parents[at, 0])]
        first.append(at)
        looks.append(count)
    founders = rows.take(np.array(first))
    known = tuple(
        _make_axis(axis, founders[axis["quantity"]].unit) for axis in axes
    )
    cells = [axis.cell_of(founders[axis.name].values) for axis in known]
    return Atlas(known, finalists, np.stack(cells, 1), np.array(looks))
