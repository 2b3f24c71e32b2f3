# SPDX-License-Identifier: Apache-2.0
"""The posterior density of parameters.

A measured value y of a row has the density N(y; f(x), s2), in which f is the
computed value and s2 the sum of four variances: of the measurement, of the
program (its random numbers), of the emulator, and d2 of the model's discrepancy
(Kennedy and O'Hagan 2001, doi:10.1111/1467-9868.00294, here independent between
rows). The discrepancy d of each quantity is a parameter with a half-normal
prior. A measured range has the probability that a value with this error is in
it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.special import log_ndtr, ndtr, ndtri

from .observations import Observations
from .parameters import Parameter, values_at

Numbers = NDArray[np.float64]
Compute = Callable[[Numbers], Numbers]

DISCREPANCY = 0.1
"""The scale of the half-normal prior of a discrepancy, relative to the root
mean square of the measured values of its quantity (E: 0.05 to 0.2)."""


class Posterior:
    """The log posterior density at standard normal numbers z: those of the
    parameters, then one for the discrepancy of each quantity. A priori all are
    standard normal."""

    def __init__(
        self,
        parameters: Sequence[Parameter],
        observations: Observations,
        compute: Compute,
        known_variance: Numbers,
        *,
        has_discrepancy: bool = True,
    ) -> None:
        """compute: function from values of the parameters
            [points, parameters] to rows [points, rows].
        known_variance: variance of the program and of the emulator [rows].
        has_discrepancy: whether discrepancies are estimated, else 0."""
        self.parameters = list(parameters)
        self.observations = observations
        self.compute = compute
        self._fitted = np.flatnonzero(observations.is_fitted)
        low, high = observations.low, observations.high
        self._low, self._high = low[self._fitted], high[self._fitted]
        self._is_range = self._low < self._high
        self._variance = (observations.error**2 + known_variance)[self._fitted]
        self.quantities = observations.quantities if has_discrepancy else []
        """The quantities with a discrepancy."""
        names = [observations.rows[i].quantity for i in self._fitted]
        self._quantity = np.array(
            [
                self.quantities.index(n) if self.quantities else 0
                for n in names
            ],
            int,
        )
        values = observations.value[self._fitted]
        self.scales = np.array(
            [
                DISCREPANCY
                * np.sqrt((values[self._quantity == q] ** 2).mean())
                for q in range(len(self.quantities))
            ]
        )
        """The scale of the prior of each discrepancy, in the unit of the first
        row of its quantity."""

    @property
    def known_deviation(self) -> Numbers:
        """The standard deviation of each row in the likelihood, without a
        discrepancy."""
        return np.sqrt(self._variance)

    @property
    def size(self) -> int:
        """The number of standard normal numbers."""
        return len(self.parameters) + len(self.quantities)

    def discrepancies(self, z: Numbers) -> Numbers:
        """Returns the discrepancies at points z [points, quantities]."""
        tail = z[:, len(self.parameters) :]
        return self.scales * ndtri((1 + ndtr(tail)) / 2)

    def log_likelihood(self, z: Numbers) -> Numbers:
        """Returns the log likelihood at points z [points]."""
        if not self._fitted.size:
            return np.zeros(len(z))
        computed = self.compute(
            values_at(self.parameters, z[:, : len(self.parameters)])
        )
        variance = np.tile(self._variance, (len(z), 1))
        if self.quantities:
            variance += self.discrepancies(z)[:, self._quantity] ** 2
        return self._log_probability(computed[:, self._fitted], variance)

    def _log_probability(
        self, computed: Numbers, variance: Numbers
    ) -> Numbers:
        deviation = np.sqrt(variance)
        with np.errstate(invalid="ignore", divide="ignore"):
            above = (self._low - computed) / deviation
            below = (self._high - computed) / deviation
            normal = (
                -(above**2) / 2 - np.log(deviation) - np.log(2 * np.pi) / 2
            )
            # The smaller of both tails avoids a difference of numbers near 1.
            is_upper = above > 0
            near = np.where(is_upper, -above, below)
            far = np.where(is_upper, -below, above)
            ratio = np.exp(np.minimum(log_ndtr(far) - log_ndtr(near), -1e-12))
            within = log_ndtr(near) + np.log1p(-ratio)
            total = np.where(self._is_range, within, normal).sum(axis=1)
        return np.where(np.isnan(total), -np.inf, total)

    def __call__(self, z: Numbers) -> Numbers:
        """Returns the log posterior density at points z [points], up to a
        constant."""
        z = np.atleast_2d(z)
        is_near = (np.abs(z) < 8).all(axis=1)
        density = np.full(len(z), -np.inf)
        if is_near.any():
            near = z[is_near]
            density[is_near] = (
                self.log_likelihood(near) - (near**2).sum(axis=1) / 2
            )
        return density
