"""The baseline plant against the best one that was bred."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .estimate import Estimate, relative_gain
from .rows import Evaluation


@dataclass(frozen=True)
class Pair:
    """Baseline and best, judged in the same way."""

    baseline: Evaluation
    best: Evaluation

    @property
    def is_final(self) -> bool:
        """Both evaluated anew at the end. If not, the best is the best of
        many noisy figures and too high on average."""
        return self.baseline.is_final and self.best.is_final

    @property
    def difference(self) -> Estimate:
        """By how much the first objective is higher, in its unit. The standard
        error takes both as independent."""
        best, baseline = self.best.objective, self.baseline.objective
        return Estimate(
            best.mean - baseline.mean,
            math.hypot(best.standard_error, baseline.standard_error),
            best.unit,
        )

    @property
    def gain(self) -> Estimate:
        """By how much the first objective is higher [%]. The standard error
        takes both as independent: an upper bound where they share random
        numbers."""
        return relative_gain(self.best.objective, self.baseline.objective)

    @property
    def gain_per_leaf_area(self) -> Estimate:
        """By how much more PAR a unit of leaf area absorbs [%], with an error
        as that of the gain.

        Raises HistoryError if the history does not tell it."""
        return relative_gain(
            self.best.per_leaf_area, self.baseline.per_leaf_area
        )
