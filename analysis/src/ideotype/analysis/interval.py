# SPDX-License-Identifier: Apache-2.0
"""Means over seeds with confidence intervals."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from .estimate import Estimate

_NORMAL = 1.960

ONE_SEED = (
    "one seed: the interval holds the noise of the light, not that of the "
    "search"
)
"""The note that stands wherever the interval of a single seed is."""


def meaning(seeds: Iterable[int]) -> str:
    """Tells the meaning of intervals that have so many seeds each."""
    counts = set(seeds)
    several = ["95 % confidence interval over seeds"] * bool(counts - {1})
    return "; ".join([*several, *[ONE_SEED] * (1 in counts)])


def student(degrees_of_freedom: int) -> float:
    """Returns the two-sided 95 % quantile of Student's t."""
    # The import stands here, since it takes as long as all else together.
    from scipy.special import stdtrit

    return float(stdtrit(degrees_of_freedom, 0.975))


@dataclass(frozen=True)
class Interval:
    """A mean over seeds with its 95 % confidence interval; that of a single
    seed knows the noise of the light alone."""

    mean: float
    half_width: float
    """Half the width of the interval; NaN if it is not known."""
    unit: str
    seeds: int

    def number(self) -> str:
        """Returns "1.50 ± 0.06", without the unit."""
        if not math.isfinite(self.half_width):
            return f"{self.mean:.4g}, error unknown"
        digits = 2
        if self.half_width > 0:
            digits = min(
                max(1 - math.floor(math.log10(self.half_width)), 0), 6
            )
        return f"{self.mean:.{digits}f} ± {self.half_width:.{digits}f}"

    def __str__(self) -> str:
        """Returns "1.50 ± 0.06 %", and for a single seed what that does not
        hold."""
        unit = "" if self.unit == "1" else f" {self.unit}"
        known = f" ({ONE_SEED})" if self.seeds == 1 else ""
        return f"{self.number()}{unit}{known}"

    def plus(self, other: Interval) -> Interval:
        """Returns the sum of both, which have the same seeds and unit; the
        half-width is the most that it can be, since they need not be
        independent."""
        half_width = self.half_width + other.half_width
        return Interval(
            self.mean + other.mean, half_width, self.unit, self.seeds
        )


def interval(figures: Sequence[Estimate]) -> Interval:
    """Returns the 95 % confidence interval of the mean of independent seeds:
    Student's t over their scatter, or the normal one of their standard errors
    where that is wider, as it is for a single seed and for seeds that agree by
    chance."""
    if not figures:
        raise ValueError("no figure to average")
    means = np.array([figure.mean for figure in figures])
    errors = np.array([figure.standard_error for figure in figures])
    count = len(means)
    measured = _NORMAL * float(np.sqrt(np.sum(errors**2))) / count
    half_width = measured
    if count > 1:
        scatter = float(means.std(ddof=1)) / math.sqrt(count)
        half_width = float(np.nanmax([measured, student(count - 1) * scatter]))
    return Interval(float(means.mean()), half_width, figures[0].unit, count)
