"""Means over seeds with confidence intervals."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .estimate import Estimate

_STUDENT = (
    *(12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228),
    *(2.201, 2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086),
    *(2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042),
)
"""Two-sided 95 % quantiles of Student's t for 1, 2, ... degrees of freedom."""

_NORMAL = 1.960


def student(degrees_of_freedom: int) -> float:
    """The two-sided 95 % quantile; beyond 30 that of 30, which is on the safe
    side by less than 4.2 %."""
    return _STUDENT[min(degrees_of_freedom, len(_STUDENT)) - 1]


@dataclass(frozen=True)
class Interval:
    """A mean over seeds with its 95 % confidence interval."""

    mean: float
    half_width: float
    """NaN if it is not known."""
    unit: str
    seeds: int

    def __str__(self) -> str:
        """ "+1.50 ± 0.06 %"."""
        if not math.isfinite(self.half_width):
            return f"{self.mean:.4g} {self.unit}, error unknown"
        digits = 2
        if self.half_width > 0:
            digits = min(
                max(1 - math.floor(math.log10(self.half_width)), 0), 6
            )
        text = f"{self.mean:.{digits}f} ± {self.half_width:.{digits}f}"
        return text if self.unit == "1" else f"{text} {self.unit}"


def interval(figures: Sequence[Estimate]) -> Interval:
    """The 95 % confidence interval of the mean of independent seeds: Student's
    t over their scatter, or the normal one of their standard errors where that
    is wider, as it is for a single seed and for seeds that agree by chance."""
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
