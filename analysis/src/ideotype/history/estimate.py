# SPDX-License-Identifier: Apache-2.0
"""Estimates: means with standard errors, in any unit."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

NORMAL = 1.960
"""The half-width of a 95 % confidence interval in standard errors."""

_EXACT = 1e-9
"""The relative error below which a number counts as exact."""

DAILY_ENERGY = "MJ m-2 day-1"


def with_interval(mean: float, below: float, above: float) -> str:
    """Returns "1.50 ± 0.06", or "1.50 -0.06 +0.20" for an asymmetric interval;
    without an interval for an exact number. The shorter side determines the
    number of digits, so that it is not rounded to 0."""
    if not math.isfinite(below + above):
        return f"{mean:.4g} ± ?"
    known = [end for end in (below, above) if end > _EXACT * abs(mean)]
    if not known:
        return f"{mean:.4g}"
    digits = max(1 - math.floor(math.log10(min(known))), 0)
    ends = [f"{end:.{digits}f}" for end in (below, above)]
    if ends[0] == ends[1]:
        return f"{mean:.{digits}f} ± {ends[0]}"
    return f"{mean:.{digits}f} \N{MINUS SIGN}{ends[0]} +{ends[1]}"


@dataclass(frozen=True)
class Estimate:
    """A mean and its standard error in the same unit; NaN: unknown error."""

    mean: float
    standard_error: float
    unit: str = "1"
    draws: NDArray[np.float64] = field(
        default_factory=lambda: np.empty(0), compare=False, repr=False
    )
    """The value in each independent randomisation [randomisations]. Estimates
    with common random numbers are paired by it; empty if unknown."""

    @property
    def is_near_zero(self) -> bool:
        """Whether the mean is within three standard errors of zero, so that
        per cent of it mean little."""
        return abs(self.mean) <= 3 * self.standard_error

    def scaled(self, factor: float, unit: str) -> Estimate:
        """Returns the estimate in another unit, for an exact factor."""
        return Estimate(
            factor * self.mean,
            abs(factor) * self.standard_error,
            unit,
            factor * self.draws,
        )

    def interval_text(self) -> str:
        """Returns the mean ± half of its 95 % confidence interval; the mean
        alone if it is exact or its error is unknown."""
        if not math.isfinite(self.standard_error):
            return f"{self.mean:.4g}"
        half_width = NORMAL * self.standard_error
        return with_interval(self.mean, half_width, half_width)

    def __str__(self) -> str:
        return f"{self.interval_text()} {self.unit}"


def difference(a: Estimate, b: Estimate) -> Estimate:
    """Returns a - b, with a paired standard error if both have the same
    randomisations, else with that of independent estimates."""
    return Estimate(a.mean - b.mean, _error(a, b, 1.0), a.unit)


def relative_gain(best: Estimate, baseline: Estimate) -> Estimate:
    """Returns 100 (best / baseline - 1) [%]. The standard error is first order
    (delta method), paired as in difference()."""
    if baseline.mean == 0:
        return Estimate(math.nan, math.nan, "%")
    ratio = best.mean / baseline.mean
    error = _error(best, baseline, ratio) / abs(baseline.mean)
    return Estimate(100 * (ratio - 1), 100 * error, "%")


def _error(a: Estimate, b: Estimate, factor: float) -> float:
    """Returns the standard error of a - factor b."""
    if (count := len(a.draws)) > 1 and count == len(b.draws):
        scatter = np.std(a.draws - factor * b.draws, ddof=1)
        return float(scatter) / math.sqrt(count)
    return math.hypot(a.standard_error, factor * b.standard_error)
