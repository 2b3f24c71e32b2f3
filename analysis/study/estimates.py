# SPDX-License-Identifier: Apache-2.0
"""Estimates of the study, which are means with standard errors: gains of
plants with common random numbers, intervals over seeds, and tables of them.
Printed ± is half of a 95 % interval."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from statistics import fmean, stdev

import numpy as np

from ideotype.history.estimate import NORMAL, relative_gain
from ideotype.history.estimate import Estimate as Figure
from ideotype.history.interval import interval, student_error

Estimate = tuple[float, float]
"""A mean and its standard error."""


def estimate(values: Sequence[float]) -> Estimate:
    """Returns the mean and the standard error of randomisations."""
    return fmean(values), stdev(values) / math.sqrt(len(values))


def sign_change(
    low: tuple[float, Estimate], high: tuple[float, Estimate]
) -> Estimate:
    """Returns the position at which the line through two points is zero."""
    (x, (y, error)), (x2, (y2, error2)) = low, high
    slope = (y2 - y) / (x2 - x)
    weight = -y / (y2 - y)
    error = math.hypot((1 - weight) * error, weight * error2)
    return x - y / slope, error / abs(slope)


def gain(before: Sequence[float], after: Sequence[float]) -> Estimate:
    """Returns 100 (after / before - 1) [%] from common randomisations of both
    plants."""
    found = relative_gain(
        *(
            Figure(*estimate(values), draws=np.array(values))
            for values in (after, before)
        )
    )
    return found.mean, found.standard_error


def difference(before: Sequence[float], after: Sequence[float]) -> Estimate:
    """Returns after - before from common randomisations of both plants."""
    return estimate(np.subtract(after, before).tolist())


def has_percent(before: Sequence[float]) -> bool:
    """Returns whether gains over these values can be stated in per cent: their
    mean must be above zero by three standard errors. If it were below zero,
    even the sign of the gain in per cent would be wrong."""
    mean, error = estimate(before)
    return mean > 3 * error


def ratio(a: Estimate, b: Estimate) -> Estimate:
    """Returns the ratio of two estimates with independent errors."""
    mean = a[0] / b[0]
    return mean, abs(mean) * math.hypot(a[1] / a[0], b[1] / b[0])


def mean_over_seeds(values: Sequence[Estimate]) -> Estimate:
    """Returns the mean over seeds. Its standard error is the larger of that of
    the evaluations and that between seeds. The latter is scaled so that the
    normal interval equals Student's interval for the few seeds."""
    means = [mean for mean, _ in values]
    error = math.hypot(*(error for _, error in values)) / len(values)
    if len(values) > 1:
        error = max(error, student_error(stdev(means), len(means)))
    return fmean(means), error


def half_interval(error: float) -> float:
    """Returns half of the 95 % interval for a standard error."""
    return NORMAL * error


def plus_minus(value: Estimate, digits: int = 1, sign: str = "") -> str:
    """Formats a mean and half of its 95 % interval; with the sign "+" for
    gains."""
    mean, error = value
    return f"{mean:{sign}.{digits}f} ± {half_interval(error):.{digits}f}"


def interval_of(values: Sequence[Estimate]) -> str:
    """Formats the mean of gains with its 95 % interval over seeds, and the
    gain of each seed."""
    found = interval([Figure(*value, "%") for value in values])
    seeds = ", ".join(f"{mean:+.1f}" for mean, _ in values)
    return f"{found} (95 %; by seed {seeds})"


def print_table(titles: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Prints a table as Markdown."""
    print(f"| {' | '.join(titles)} |")
    print("|---" * len(titles) + "|")
    for row in rows:
        print(f"| {' | '.join(row)} |")
