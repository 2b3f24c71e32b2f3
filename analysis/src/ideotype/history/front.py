# SPDX-License-Identifier: Apache-2.0
"""Fronts, which consist of the plants that no other plant dominates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..common.arrays import real
from .pair import Pair
from .rows import Evaluation, Rows


def non_dominated(
    objectives: ArrayLike, signs: ArrayLike, violation: ArrayLike = 0.0
) -> NDArray[np.bool_]:
    """Returns a mask of the rows of [rows, objectives] that no other row
    dominates: a row dominates another row if it is as good in all objectives
    and better in at least one. `signs` are 1 where larger is better, else -1.
    A row that violates constraints is dominated by all rows with less
    violation."""
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
    """The finalists without the baseline, or the front of the last generation
    until finalists are evaluated."""
    is_kept: NDArray[np.bool_]
    """Whether no other member dominates a member; dominated members owed their
    place to noise."""
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
        """Returns the number that names a member: the row in /final, or the
        place in a front that is not evaluated again."""
        return int(self.members.row[index]) if self.is_final else index + 1

    def pair(self, index: int) -> Pair:
        """Returns the baseline and a member."""
        return Pair(self.baseline, self.one(index))


def front_of(rows: Rows, baseline: Evaluation) -> Front | None:
    """Returns the front of bred rows: of finalists if a baseline is given, or
    else of a generation. None if no row is done."""
    done = rows.done
    signs = [objective.sign for objective in done.goals]
    is_kept = non_dominated(done.objectives, signs, done.violation)
    if not baseline.is_final:
        done = done.take(is_kept)
        done = done.take(np.sort(done.ranking(len(done))))
        is_kept = np.full(len(done), True)
    return Front(done, is_kept, baseline) if len(done) else None
