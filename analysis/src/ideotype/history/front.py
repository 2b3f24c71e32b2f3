# SPDX-License-Identifier: Apache-2.0
"""Pareto fronts: the plants that no other plant dominates."""

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
    """Returns a mask [rows] of the non-dominated rows of `objectives`
    [rows, objectives]. A row dominates another if it is at least as good in
    all objectives and better in one, or violates constraints less (Deb et al.
    2002, doi:10.1109/4235.996017).

    signs: 1 where larger is better, else -1 [objectives].
    violation: violation of the constraints [rows], 0 if all are met."""
    values = real(objectives, "objectives") * real(signs, "signs")
    violation = np.broadcast_to(real(violation, "violation"), len(values))
    first, second = values[:, None], values[None]
    is_better = (first >= second).all(2) & (first > second).any(2)
    is_less = violation[:, None] < violation[None]
    is_equal = violation[:, None] == violation[None]
    return ~(is_less | is_equal & is_better).any(0)


@dataclass(frozen=True)
class Front:
    """The Pareto front of a search for several objectives."""

    members: Rows
    """The finalists without the baseline, or the front of the last generation
    until finalists are evaluated."""
    is_kept: NDArray[np.bool_]
    """Whether each member is non-dominated; dominated members were selected by
    noise."""
    baseline: Evaluation

    @property
    def is_final(self) -> bool:
        """Whether the members were re-evaluated after the search, with
        independent random numbers."""
        return self.baseline.is_final

    @property
    def kept(self) -> Rows:
        """The members that no other dominates."""
        return self.members.take(self.is_kept)

    def one(self, index: int) -> Evaluation:
        """Returns one member."""
        return self.members.one(index, self.is_final)

    def number(self, index: int) -> int:
        """Returns the number that identifies a member: its row in /final, or
        its position, from 1, in a front that is not re-evaluated yet."""
        return int(self.members.row[index]) if self.is_final else index + 1

    def pair(self, index: int) -> Pair:
        """Returns the baseline and a member."""
        return Pair(self.baseline, self.one(index))


def make_front(rows: Rows, baseline: Evaluation) -> Front | None:
    """Returns the Pareto front of rows without the baseline: of finalists if
    the baseline is final, else of a generation. None if no row is done."""
    done = rows.done
    signs = [objective.sign for objective in done.goals]
    is_kept = non_dominated(done.objectives, signs, done.violation)
    if not baseline.is_final:
        done = done.take(is_kept)
        done = done.take(np.sort(done.ranking(len(done))))
        is_kept = np.full(len(done), True)
    return Front(done, is_kept, baseline) if len(done) else None
