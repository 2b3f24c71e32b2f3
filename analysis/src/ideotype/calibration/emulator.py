# SPDX-License-Identifier: Apache-2.0
"""An emulator of the program: a polynomial with a Gaussian process for its
residuals.

Rows are independent, with one correlation function exp(-d2 / (2 l2)) of the
distance d between scaled points. Its length l and its share of noise are those
with the smallest error in cross-validation. Rasmussen and Williams 2006,
Gaussian Processes for Machine Learning, section 2.7: Gaussian process with
explicit basis functions, here by least squares."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Error

Numbers = NDArray[np.float64]

FOLDS = 5
LENGTHS = (1.0, 2.0, 4.0)
NOISES = (1e-4, 1e-2, 1.0)


def terms(x: Numbers, count: int) -> Numbers:
    """Returns the terms of a polynomial at points [points, terms]: a full
    quadratic if `count` points are 1.5 times its terms or more, else squares
    without products, else a plane."""
    size = x.shape[1]
    columns = [np.ones(len(x)), *x.T]
    if count >= 1.5 * (2 * size + 1):
        columns += [x[:, i] ** 2 for i in range(size)]
    if count >= 1.5 * (size + 1) * (size + 2) / 2:
        columns += [x[:, i] * x[:, j] for i in range(size) for j in range(i)]
    return np.stack(columns, axis=1)


def _correlation(a: Numbers, b: Numbers, length: float) -> Numbers:
    squares = (a**2).sum(1)[:, None] + (b**2).sum(1)[None] - 2 * a @ b.T
    return np.exp(-np.maximum(squares, 0) / (2 * length**2))


@dataclass(frozen=True)
class Fit:
    """An emulator without its error."""

    points: Numbers
    trend: Numbers  # [terms, rows]
    weights: Numbers  # [points, rows]
    length: float

    @staticmethod
    def to(x: Numbers, y: Numbers, length: float, noise: float) -> Fit:
        basis = terms(x, len(x))
        trend: Any
        weights: Any
        trend = np.linalg.lstsq(basis, y, rcond=None)[0]
        covariance = _correlation(x, x, length) + noise * np.eye(len(x))
        weights = np.linalg.solve(covariance, y - basis @ trend)
        return Fit(x, trend, weights, length)

    def __call__(self, x: Numbers) -> Numbers:
        return (
            terms(x, len(self.points)) @ self.trend
            + _correlation(x, self.points, self.length) @ self.weights
        )


@dataclass(frozen=True)
class Emulator:
    """An emulator of all rows with the standard error of each."""

    fit: Fit
    error: Numbers
    """The standard error of each row, the root mean square in cross-validation
    [rows]."""
    count: int
    """The number of evaluations that it was made from."""

    @staticmethod
    def make(x: Numbers, y: Numbers, near: int = 0) -> Emulator:
        """Makes an emulator.

        x: scaled points [points, parameters]. y: rows [points, rows]; points
            with a NaN are left out.
        near: number of last points to which the error refers, 0: all.

        Raises Error if there are fewer than two points for each fold."""
        good = np.isfinite(y).all(axis=1)
        is_near = np.arange(len(y)) >= (len(y) - near if near else 0)
        x, y, is_near = x[good], y[good], is_near[good]
        if len(x) < 2 * FOLDS:
            raise Error(
                f"only {len(x)} points of the design could be computed; narrow "
                "the priors, or raise --design"
            )
        scale = np.maximum(
            y.std(axis=0), 1e-12 * np.abs(y).max(axis=0) + 1e-300
        )
        fold = np.arange(len(x)) % FOLDS
        best: tuple[float, float, float, Numbers] | None = None
        for length, noise in product(LENGTHS, NOISES):
            apart = np.empty_like(y)
            for k in range(FOLDS):
                left_out = fold == k
                part = Fit.to(x[~left_out], y[~left_out], length, noise)
                apart[left_out] = part(x[left_out]) - y[left_out]
            errors = np.sqrt((apart[is_near] ** 2).mean(axis=0))
            score = float(((errors / scale) ** 2).mean())
            if best is None or score < best[0]:
                best = score, length, noise, errors
        assert best is not None
        _, length, noise, errors = best
        return Emulator(Fit.to(x, y, length, noise), errors, len(x))

    def with_error(self, error: Numbers) -> Emulator:
        """Returns this emulator with another standard error."""
        return replace(self, error=error)

    def __call__(self, x: Numbers) -> Numbers:
        """Returns the rows at scaled points [points, rows]."""
        return self.fit(x)
