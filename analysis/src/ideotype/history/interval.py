# SPDX-License-Identifier: Apache-2.0
"""Means over seeds with confidence intervals."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .estimate import NORMAL, Estimate, with_interval

SEARCH_SCATTER = 0.2
"""The standard deviation of the gains of searches with different seeds over
their mean gain, which a single search cannot estimate. For searches with a few
hundred evaluations this ratio was .12 (net assimilation of a day, 15 cases
with three searches each), .18 (carbon of a growing season) and .28 (net
assimilation at a given leaf area)."""

BEYOND = 0.15
"""The distance of the optimum above the mean gain of searches, over that gain.
analysis/study/distance.py measures it by a much longer search: the optimum
was above the mean of three searches of 600 evaluations by .12 to .15, and
above single searches by .07 to .20. Shorter searches may miss more."""

ENOUGH = 600
"""The number of evaluations of the searches with which BEYOND was measured."""

ONE_SEED = (
    f"one search: its interval takes from other searches that gains differ by "
    f"{100 * SEARCH_SCATTER:.0f} % between seeds (standard deviation)"
)
"""The note beside every interval of a single search."""


def meaning(seeds: Iterable[int]) -> str:
    """Explains intervals that have the given numbers of seeds."""
    counts = set(seeds)
    several = ["95 % confidence interval over searches"] * bool(counts - {1})
    return "; ".join([*several, *[ONE_SEED] * (1 in counts)])


def student(degrees_of_freedom: float) -> float:
    """Returns the two-sided 95 % quantile of Student's t."""
    # SciPy is imported at its use, because its import takes long.
    from scipy.special import stdtrit

    return float(stdtrit(degrees_of_freedom, 0.975))


@dataclass(frozen=True)
class Interval:
    """A mean over searches with its 95 % interval, which may be asymmetric."""

    mean: float
    below: float
    """The mean less the lower end of the interval; NaN if the interval is not
    known."""
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
        """Returns "1.50 ± 0.06", or "1.50 -0.06 +0.20" for an asymmetric
        interval, without the unit."""
        return with_interval(self.mean, self.below, self.above)

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        return f"{self.number()}{unit}"

    def scaled(self, factor: float, unit: str) -> Interval:
        """Returns the interval in another unit, for an exact positive
        factor."""
        return Interval(
            factor * self.mean,
            factor * self.below,
            factor * self.above,
            unit,
            self.seeds,
        )

    def plus(self, other: Interval) -> Interval:
        """Returns the sum of two intervals with equal seeds and units; the sum
        has the widest possible interval, since the terms need not be
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
    Student's t interval of the seeds' scatter, or the normal interval of the
    seeds' standard errors if this is wider, as for seeds that agree by chance.
    The interval of a single seed also covers `search`, the standard deviation
    between searches in the unit of the mean."""
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
    """Returns the interval of the mean over searches. The interval of a single
    search takes the scatter from other searches: SEARCH_SCATTER of `gains`, in
    the unit of the estimates, which by default are the gains."""
    return interval(figures, SEARCH_SCATTER * abs((gains or figures)[0].mean))


def gain_interval(gains: Sequence[Estimate], sign: int) -> Interval:
    """Returns the interval of the mean gain over searches, as over_searches()
    does; on the side of an improvement (`sign`: 1 above, -1 below) the
    interval reaches at least to the possible optimum."""
    found = over_searches(gains)
    farther = max(found.above, BEYOND * abs(found.mean))
    if sign > 0:
        return replace(found, above=farther)
    return replace(found, below=farther)


def bars(intervals: Sequence[Interval]) -> NDArray[np.float64]:
    """Returns the lengths of error bars below and above means [2, n]; unknown
    lengths are 0."""
    return np.nan_to_num([[x.below, x.above] for x in intervals]).T
