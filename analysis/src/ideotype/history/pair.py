# SPDX-License-Identifier: Apache-2.0
"""Compares the best plant with the baseline."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .estimate import Estimate, difference, relative_gain
from .rows import Evaluation


@dataclass(frozen=True)
class Pair:
    """The baseline and the best plant of one history, evaluated alike."""

    baseline: Evaluation
    best: Evaluation

    @property
    def is_final(self) -> bool:
        """Whether both were re-evaluated after the search. Otherwise the best
        plant was selected by noisy values, so that its objective is
        overestimated on average."""
        return self.baseline.is_final and self.best.is_final

    @property
    def is_paired(self) -> bool:
        """Whether both plants have common random numbers. Standard errors of
        differences are then paired, else those of independent plants."""
        baseline, best = self.baseline.row, self.best.row
        return (
            baseline.generation[0] == best.generation[0]
            and baseline.randomisations.shape[2] > 1
            and bool(np.isfinite(baseline.randomisations).all())
            and bool(np.isfinite(best.randomisations).all())
        )

    @property
    def difference(self) -> Estimate:
        """The difference of the best plant from the baseline in the first
        objective, in its unit."""
        return difference(
            *self._both(self.best.objective, self.baseline.objective)
        )

    @property
    def gain(self) -> Estimate:
        """The gain in the first objective [%]."""
        return self.gain_in(self.best.row.goals[0].name)

    def gain_in(self, name: str) -> Estimate:
        """Returns the gain of the best plant in an objective or a quantity
        without axes [%]. Errors are paired for objectives; for quantities the
        plants count as independent.

        Raises HistoryError if the history lacks the quantity."""
        best, baseline = self.best.estimate(name), self.baseline.estimate(name)
        return relative_gain(*self._both(best, baseline))

    @property
    def gain_per_leaf_area(self) -> Estimate:
        """The gain in absorbed PAR per leaf area [%].

        Raises HistoryError if the history lacks the quantity."""
        best, baseline = self.best.per_leaf_area, self.baseline.per_leaf_area
        return relative_gain(*self._both(best, baseline))

    def _both(
        self, best: Estimate, baseline: Estimate
    ) -> tuple[Estimate, ...]:
        if self.is_paired:
            return best, baseline
        return replace(best, draws=np.empty(0)), baseline
