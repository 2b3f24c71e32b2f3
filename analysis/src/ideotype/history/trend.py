# SPDX-License-Identifier: Apache-2.0
"""Estimates the further gain of searches from the trend of their population
means."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .estimate import Estimate
from .interval import student

LEAST = 4
"""The smallest number of generations for the estimate of a trend."""

MATTERS = 0.5
"""The smallest relevant gain [% of the baseline], unless a tenth of the gain
found is larger."""

PART_THAT_MATTERS = 0.1
"""The relevant share of the gain found."""


class End(Enum):
    """Whether searches have converged."""

    YES = "yes"
    NO = "no"
    UNKNOWN = "unknown"


@dataclass(frozen=True)
class FurtherGain:
    """The gain expected from as many generations again, by a linear trend,
    with the ends of its 95 % confidence interval, in the unit of the
    values."""

    mean: float
    low: float
    high: float


def further_gain(runs: Sequence[ArrayLike], sign: int) -> FurtherGain | None:
    """Extrapolates the population means of one or more searches over as many
    generations again, and returns the mean over searches. runs: population
    means by generation of each search. sign: sign of an improvement.

    A line is fitted to the second half of the generations of each search. The
    standard error of its slope accounts for autocorrelation by the effective
    number of generations n (1 - r) / (1 + r), where r is the lag-1
    autocorrelation of the residuals, or 0 if that is negative. For searches
    with diminishing gains, a linear trend gives an upper bound. None if a
    search has fewer than LEAST generations in its second half."""
    trends = []
    for run in runs:
        values = sign * np.asarray(run, dtype=float)
        half = values[len(values) // 2 :]
        if len(half) < LEAST or not np.isfinite(half).all():
            return None
        slope, error, freedom = _slope(half)
        trends.append((len(values) * slope, len(values) * error, freedom))
    if not trends:
        return None
    gains, errors, freedoms = np.array(trends).T
    mean = float(gains.mean())
    variance = float(np.sum(errors**2))
    # The degrees of freedom of a sum of variances (Welch and Satterthwaite).
    freedom = (
        variance**2 / float(np.sum(errors**4 / freedoms)) if variance else 1.0
    )
    reach = student(freedom) * math.sqrt(variance) / len(trends)
    return FurtherGain(mean, mean - reach, mean + reach)


def _slope(values: NDArray[np.float64]) -> tuple[float, float, float]:
    """Returns the slope of the regression line through values, its standard
    error and its degrees of freedom."""
    count = len(values)
    number = np.arange(count)
    slope, start = np.polyfit(number, values, 1)
    rest = values - (slope * number + start)
    squares = float(rest @ rest)
    scatter = float(np.sum((number - number.mean()) ** 2))
    lag = float(rest[1:] @ rest[:-1]) / squares if squares > 0 else 0.0
    lag = max(lag, 0.0)
    effective = count * (1 - lag) / (1 + lag)
    freedom = max(effective - 2, 1.0)
    error = math.sqrt(squares / freedom / scatter)
    return float(slope), error, freedom


def verdict(further: FurtherGain, matters: float) -> End:
    """Returns whether searches have converged: YES if the interval of the
    further gain excludes relevant gains and equal losses (as after a restart),
    NO if it is above 0, else UNKNOWN."""
    if -matters < further.low and further.high < matters:
        return End.YES
    return End.NO if further.low > 0 else End.UNKNOWN


def searches_differ(gains: Sequence[Estimate], matters: float) -> bool:
    """Returns whether the gains of searches differ significantly (Cochran's Q
    at 5 %) and by at least `matters`."""
    means = np.array([gain.mean for gain in gains])
    errors = np.array([gain.standard_error for gain in gains])
    if len(means) < 2 or np.ptp(means) < matters:
        return False
    if not (errors > 0).all():
        return True
    # SciPy is imported at its use, because its import takes long.
    from scipy.special import chdtri

    weights = errors**-2
    mean = weights @ means / weights.sum()
    q = float(weights @ (means - mean) ** 2)
    return q > float(chdtri(len(means) - 1, 0.05))
