# SPDX-License-Identifier: Apache-2.0
"""Fronts, which are plants that no other betters in all objectives."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._arrays import real
from .pair import Pair
from .reading.rows import Evaluation, Rows


def non_dominated(
    objectives: ArrayLike, signs: ArrayLike, violation: ArrayLike = 0.0
) -> NDArray[np.bool_]:
    """Returns which rows of [rows, objectives] no other dominates: a row
    dominates another if it is as good in all objectives and better in one.
    `signs` are 1 where larger is better, else -1. A row that violates
    constraints is dominated by all that violate them less."""
    values = real(objectives, "objectives") * real(signs, "signs")
    violation = np.broadcast_to(real(violation, "violation"), len(values))
    one, other = values[:, None], values[None]
    betters = (one >= other).all(2) & (one > other).any(2)
    less = violation[:, None] < violation[None]
    same = violation[:, None] == violation[None]
    return ~(less | same & betters).any(0)


@dataclass(frozen=True)
class Front:
    """The plants that a search for several objectives has found."""

    members: Rows
    """The finalists but the baseline, or before they are evaluated the front
    of the last generation."""
    is_kept: NDArray[np.bool_]
    """Whether no other member dominates a member; the others have fallen off,
    since they owed their place to noise."""
    baseline: Evaluation

    @property
    def is_final(self) -> bool:
        """Whether the members were evaluated again at the end, with fresh
        random numbers."""
        return self.baseline.is_final

    @property
    def kept(self) -> Rows:
        """The members that no other dominates."""
        return self.members.take(self.is_kept)

    def one(self, index: int) -> Evaluation:
        """Returns one member."""
        return self.members.one(index, self.is_final)

    def number(self, index: int) -> int:
        """Returns the number that names a member: its row in /final, or its
        place in a front that is not evaluated again."""
        return int(self.members.row[index]) if self.is_final else index + 1

    def pair(self, index: int) -> Pair:
        """Returns the baseline and a member."""
        return Pair(self.baseline, self.one(index))


def front_of(rows: Rows, baseline: Evaluation) -> Front | None:
    """Returns the front of bred rows: finalists if the baseline is one, or a
    generation whose front is to be found. None if no row is done."""
    done = rows.done
    signs = [objective.sign for objective in done.goals]
    is_kept = non_dominated(done.objectives, signs, done.violation)
    if not baseline.is_final:
        done = done.take(is_kept)
        done = done.take(np.sort(done.ranking(len(done))))
        is_kept = np.full(len(done), True)
    return Front(done, is_kept, baseline) if len(done) else None
