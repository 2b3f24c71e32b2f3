# SPDX-License-Identifier: Apache-2.0
"""The expected value of a plant that was selected as the best of many noisy
evaluations."""

from __future__ import annotations

import numpy as np

from .estimate import Estimate
from .rows import Rows

_FEWEST = 4
"""The smallest number of rows for which the variance can be partitioned into
noise and differences between plants."""


def shrunken(rows: Rows, index: int) -> Estimate:
    """Returns the expected first objective of row `index` of a generation.

    The largest of many noisy values is too large on average. The value is
    therefore shrunken towards the mean of the generation by parametric
    empirical Bayes (Morris 1983, doi:10.1080/01621459.1983.10477920). Of n
    rows with mean m, variance s2 between rows and noise variance v, the value
    y becomes y - B (y - m) with B = (n - 3) / (n - 1) min(1, v / s2); its
    variance is v (1 - (n - 1) / n B) + 2 / (n - 3) B^2 (y - m)^2. All rows
    have common random numbers, so v is the noise of differences within the
    generation; common noise is added to the standard error.

    rows: evaluations that are done. If the row meets the constraints, only
    rows that do so count."""
    unit = rows.goals[0].unit
    given = float(rows.objectives[index, 0])
    error = float(rows.objectives_standard_error[index, 0])
    if not rows.violation[index] > 0:
        rows = rows.take(~(rows.violation > 0))
    values = rows.objectives[:, 0]
    n = len(values)
    total = float(np.mean(rows.objectives_standard_error[:, 0] ** 2))
    noise = _noise(rows, total) if n > 1 else 0.0
    if not noise > 0:
        return Estimate(given, error, unit)
    mean, spread = float(values.mean()), float(values.var(ddof=1))
    shared, off = max(0.0, total - noise), given - mean
    if n < _FEWEST:
        return Estimate(mean, (spread + shared) ** 0.5, unit)
    taken = (n - 3) / (n - 1) * (noise / spread if noise < spread else 1.0)
    variance = noise * (1 - (n - 1) / n * taken)
    variance += 2 / (n - 3) * (taken * off) ** 2
    return Estimate(mean + (1 - taken) * off, (variance + shared) ** 0.5, unit)


def _noise(rows: Rows, total: float) -> float:
    """Returns the noise variance of one row, without noise common to all
    rows."""
    draws = rows.randomisations[:, 0, :]
    n, count = draws.shape
    if count < 2 or not np.isfinite(draws).all():
        return total
    apart = draws - draws.mean(axis=0)
    apart -= apart.mean(axis=1, keepdims=True)
    # The residuals have (n - 1) (count - 1) degrees of freedom; a row is a mean
    # of `count` draws.
    return float((apart**2).sum() / ((n - 1) * (count - 1) * count))
