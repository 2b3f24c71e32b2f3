# SPDX-License-Identifier: Apache-2.0
"""Means over seeds with confidence intervals."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .reading.estimate import NORMAL, Estimate, with_interval

SEARCH_SCATTER = 0.2
"""The standard deviation of the gains of searches with other seeds over their
mean gain, which a single search cannot tell of itself. Of searches with a few
hundred evaluations it was .12 (net assimilation of a day, 15 cases with three
searches each), .18 (carbon of a growing season) and .28 (net assimilation at a
given leaf area)."""

BEYOND = 0.15
"""The distance of the optimum above the mean gain of searches, over that gain.
In campaigns/study/distance.py, where a much longer search tells it, it was
above the mean of three searches of 600 evaluations by .12 to .15, and above a
single one by .07 to .20. Shorter searches may miss more."""

ENOUGH = 600
"""The number of evaluations of the searches that BEYOND was measured with."""

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
    """A mean over searches with its 95 % interval, which need not be as far
    above it as below."""

    mean: float
    below: float
    """The mean less the lower end of the interval; NaN if it is not known."""
    above: float
    """The upper end of the interval less the mean."""
    unit: str
    seeds: int

    @property
    def low(self) -> float:
        """The lower end of the interval."""
        return self.mean - self.below

    @property
    def high(self) -> float:
        """The upper end of the interval."""
        return self.mean + self.above

    @property
    def is_sure(self) -> bool:
        """Whether the interval is on one side of 0."""
        return self.low * self.high > 0

    def number(self) -> str:
        """Returns "1.50 ± 0.06", or "1.50 -0.06 +0.20" where both ends are
        not as far, without the unit."""
        return with_interval(self.mean, self.below, self.above)

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        return f"{self.number()}{unit}"

    def scaled(self, factor: float, unit: str) -> Interval:
        """Returns the figure in another unit, for an exact positive factor."""
        return Interval(
            factor * self.mean,
            factor * self.below,
            factor * self.above,
            unit,
            self.seeds,
        )

    def plus(self, other: Interval) -> Interval:
        """Returns the sum of both, which have the same seeds and unit; the
        interval is the widest that it can be, since they need not be
        independent."""
        return Interval(
            self.mean + other.mean,
            self.below + other.below,
            self.above + other.above,
            self.unit,
            self.seeds,
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
    return Interval(
        float(means.mean()), half_width, half_width, figures[0].unit, count
    )


def over_searches(
    figures: Sequence[Estimate], gains: Sequence[Estimate] = ()
) -> Interval:
    """Returns the interval of the mean over searches. That of a single search
    takes from others how much they differ: SEARCH_SCATTER of `gains`, in the
    unit of the figures, which by default are gains themselves."""
    return interval(figures, SEARCH_SCATTER * abs((gains or figures)[0].mean))


def gain_interval(gains: Sequence[Estimate], sign: int) -> Interval:
    """Returns the interval of the mean gain over searches, as over_searches()
    does, which on the side of an improvement (`sign`: 1 above, -1 below)
    reaches at least to where the optimum may be."""
    found = over_searches(gains)
    farther = max(found.above, BEYOND * abs(found.mean))
    if sign > 0:
        return replace(found, above=farther)
    return replace(found, below=farther)


def bars(intervals: Sequence[Interval]) -> NDArray[np.float64]:
    """Returns what error bars show: how far intervals reach below and above
    [2, n], 0 where that is not known."""
    return np.nan_to_num([[x.below, x.above] for x in intervals]).T
