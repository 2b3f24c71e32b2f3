# SPDX-License-Identifier: Apache-2.0
"""Means over independent searches with 95 % confidence intervals."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .estimate import NORMAL, Estimate, with_interval

SEARCH_SCATTER = 0.2
"""The coefficient of variation of gains between searches, which a single
search cannot estimate. For searches of a few hundred evaluations it was 0.12
(net assimilation of a day, 15 cases with three searches each), 0.18 (carbon of
a growing season) and 0.28 (net assimilation at a given leaf area)."""

BEYOND = 0.15
"""The distance of the optimum above the mean gain of searches, relative to
this gain. analysis/study/distance.py measures it by a much longer search: the
optimum was above the mean of three searches of 600 evaluations by 0.12 to
0.15, and above single searches by 0.07 to 0.20. Shorter searches may miss
more."""

ENOUGH = 600
"""The number of evaluations of the searches with which BEYOND was measured."""

ONE_SEED = (
    "only one search was run; the interval assumes the spread of "
    f"{100 * SEARCH_SCATTER:.0f} % between searches (standard deviation) seen "
    "elsewhere"
)
"""The note on each interval of a single search."""


def meaning(seeds: Iterable[int]) -> str:
    """Returns an explanation of intervals over the given numbers of seeds."""
    counts = set(seeds)
    several = ["95 % confidence interval over searches"] * bool(counts - {1})
    return "; ".join([*several, *[ONE_SEED] * (1 in counts)])


def student(degrees_of_freedom: float) -> float:
    """Returns the two-sided 95 % quantile of Student's t."""
    # SciPy is imported at its use, because its import takes long.
    from scipy.special import stdtrit

    return float(stdtrit(degrees_of_freedom, 0.975))


def student_error(deviation: float, count: int) -> float:
    """Returns the standard error of a mean of a few values with this standard
    deviation, scaled so that the normal interval equals Student's; NaN for a
    single value."""
    if count < 2:
        return math.nan
    return student(count - 1) / NORMAL * deviation / math.sqrt(count)


@dataclass(frozen=True)
class Interval:
    """A mean over searches with its 95 % confidence interval, which may be
    asymmetric."""

    mean: float
    below: float
    """The mean less the lower end of the interval; NaN: unknown."""
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
        interval."""
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
        """Returns the sum of two intervals with equal seeds and units. The
        half-widths are added, since the terms need not be independent."""
        return Interval(
            self.mean + other.mean,
            self.below + other.below,
            self.above + other.above,
            self.unit,
            self.seeds,
        )


def interval(figures: Sequence[Estimate], search: float = 0.0) -> Interval:
    """Returns the 95 % confidence interval of the mean over independent seeds:
    Student's t interval from the scatter between seeds, or the normal interval
    from their standard errors if it is wider, as for seeds that agree by
    chance. The interval of a single seed also covers `search`, the standard
    deviation between searches in the unit of the mean."""
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
    """Returns the interval of the mean over searches. For a single search the
    standard deviation between searches is assumed: SEARCH_SCATTER times
    `gains`, by default the estimates themselves."""
    return interval(figures, SEARCH_SCATTER * abs((gains or figures)[0].mean))


def gain_interval(gains: Sequence[Estimate], sign: int) -> Interval:
    """Returns the interval of the mean gain over searches, as over_searches().
    On the side of an improvement (`sign`: 1 above, -1 below) it extends by at
    least BEYOND times the gain, to the expected optimum."""
    gain = over_searches(gains)
    farther = max(gain.above, BEYOND * abs(gain.mean))
    if sign > 0:
        return replace(gain, above=farther)
    return replace(gain, below=farther)


def bars(intervals: Sequence[Interval]) -> NDArray[np.float64]:
    """Returns the lengths of error bars below and above means [2, intervals];
    0 if unknown."""
    return np.nan_to_num([[x.below, x.above] for x in intervals]).T
