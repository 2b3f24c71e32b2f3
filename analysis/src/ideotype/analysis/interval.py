# SPDX-License-Identifier: Apache-2.0
"""Means over seeds with confidence intervals."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from .estimate import NORMAL, Estimate, with_half_width

SEARCH_SCATTER = 0.2
"""The standard deviation of the gains of searches with other seeds over their
mean gain, which a single search cannot tell of itself. Of searches with a few
hundred evaluations it was .12 (net assimilation of a day, 15 cases with three
searches each), .18 (carbon of a growing season) and .28 (net assimilation at a
given leaf area)."""

ONE_SEED = (
    f"one search: its interval takes from other searches that gains differ by "
    f"{100 * SEARCH_SCATTER:.0f} % between seeds (standard deviation)"
)
"""The note that stands wherever the interval of a single search is."""


def meaning(seeds: Iterable[int]) -> str:
    """Tells the meaning of intervals that have so many seeds each."""
    counts = set(seeds)
    several = ["95 % confidence interval over searches"] * bool(counts - {1})
    return "; ".join([*several, *[ONE_SEED] * (1 in counts)])


def student(degrees_of_freedom: int) -> float:
    """Returns the two-sided 95 % quantile of Student's t."""
    # The import stands here, since it takes as long as all else together.
    from scipy.special import stdtrit

    return float(stdtrit(degrees_of_freedom, 0.975))


@dataclass(frozen=True)
class Interval:
    """A mean over searches with its 95 % confidence interval."""

    mean: float
    half_width: float
    """Half the width of the interval; NaN if it is not known."""
    unit: str
    seeds: int

    def number(self) -> str:
        """Returns "1.50 ± 0.06", without the unit."""
        return with_half_width(self.mean, self.half_width)

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        return f"{self.number()}{unit}"

    def plus(self, other: Interval) -> Interval:
        """Returns the sum of both, which have the same seeds and unit; the
        half-width is the most that it can be, since they need not be
        independent."""
        half_width = self.half_width + other.half_width
        return Interval(
            self.mean + other.mean, half_width, self.unit, self.seeds
        )


def interval(figures: Sequence[Estimate], search: float = 0.0) -> Interval:
    """Returns the 95 % confidence interval of the mean of independent seeds:
    Student's t over their scatter, or the normal one of their standard errors
    where that is wider, as it is for seeds that agree by chance. That of a
    single seed also has `search`, the standard deviation between searches in
    the unit of the figure."""
    if not figures:
        raise ValueError("no figure to average")
    means = np.array([figure.mean for figure in figures])
    errors = np.array([figure.standard_error for figure in figures])
    count = len(means)
    half_width = NORMAL * float(np.sqrt(np.sum(errors**2))) / count
    if count > 1:
        scatter = float(means.std(ddof=1)) / math.sqrt(count)
        half_width = float(
            np.nanmax([half_width, student(count - 1) * scatter])
        )
    else:
        half_width = math.hypot(half_width, NORMAL * search)
    return Interval(float(means.mean()), half_width, figures[0].unit, count)
