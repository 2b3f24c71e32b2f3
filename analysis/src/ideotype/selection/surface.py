# SPDX-License-Identifier: Apache-2.0
"""The objective near the mean of a population: gradient and curvature over
traits, by paired differences."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from ..history.estimate import Estimate, relative_gain
from .covariances import Matrix
from .field import Field
from .genetics import Population
from .store import Array

GRADIENT_STEP = 0.5
"""The step of the gradient [genetic standard deviations]."""

CURVATURE_STEP = 1.0
"""The step of the curvature, about the spread of the lines."""

TRUSTED = 2.0
"""The distance from the centre, in each trait, up to which the approximation
is used [genetic standard deviations]; beyond it the objective is constant."""


@dataclass(frozen=True)
class Surface:
    """A quadratic approximation of the objective around a plant, in % of the
    mean objective of that plant over cases. Traits are in the units of their
    measures."""

    centre: Matrix
    """The trait values of the plant [traits]."""
    step: Matrix
    """The genetic standard deviations [traits]."""
    objective: Matrix
    """The objective of the plant [cases x randomisations], negative if it is
    minimised."""
    gradients: Matrix
    """By randomisation [cases x randomisations x traits] [% per unit]."""
    curvatures: Matrix
    """Second derivatives by randomisation [cases x randomisations x traits x
    traits]."""

    @property
    def gradient(self) -> Matrix:
        """The mean over cases [traits]: the economic weights."""
        return self.gradients.mean(axis=(0, 1))

    @property
    def curvature(self) -> Matrix:
        """The mean over cases [traits x traits]."""
        return self.curvatures.mean(axis=(0, 1))

    @property
    def gradient_standard_error(self) -> Matrix:
        """[traits]."""
        return _standard_error(self.gradients.mean(axis=0))

    @property
    def curvature_standard_error(self) -> Matrix:
        """[traits x traits]."""
        return _standard_error(self.curvatures.mean(axis=0))

    @property
    def shrunk_curvature(self) -> Matrix:
        """The curvature with each element shrunk by its error (positive-part,
        James and Stein 1961): far from the centre noise of second derivatives
        would dominate [traits x traits]."""
        bend = self.curvature
        square = bend**2
        keep = np.maximum(square - self.curvature_standard_error**2, 0)
        return np.asarray(
            bend
            * np.divide(
                keep, square, out=np.zeros_like(bend), where=square > 0
            )
        )

    def of_case(self, case: int) -> Surface:
        """Returns the surface in one case, in % of the objective there."""
        part = slice(case, case + 1)
        objective = self.objective[part]
        factor = abs(self.objective.mean() / objective.mean())
        return Surface(
            self.centre,
            self.step,
            objective,
            factor * self.gradients[part],
            factor * self.curvatures[part],
        )

    def value(self, plants: Matrix) -> Matrix:
        """Returns the approximate objective of plants, relative to the centre
        [%]. plants: trait values [... x traits]. Traits further away than
        TRUSTED count as if they were there."""
        apart = self._within_trust(plants)
        bend = np.einsum("...i,ij,...j", apart, self.shrunk_curvature, apart)
        return apart @ self.gradient + bend / 2

    def slope(self, plant: Matrix) -> Matrix:
        """Returns the gradient at another plant [traits]; 0 for traits beyond
        TRUSTED."""
        apart = self._within_trust(plant)
        slope = self.gradient + self.shrunk_curvature @ apart
        return np.where(np.isclose(apart, plant - self.centre), slope, 0)

    def _within_trust(self, plants: Matrix) -> Matrix:
        farthest = TRUSTED * self.step
        return np.clip(plants - self.centre, -farthest, farthest)

    def draw(self, count: int, random: np.random.Generator) -> Matrix:
        """Draws gradients from their errors, by samples of randomisations
        [draws x traits]."""
        means = self.gradients.mean(axis=0)
        picks = random.integers(0, len(means), (count, len(means)))
        return means[picks].mean(axis=1)


def _standard_error(by_draw: Matrix) -> Matrix:
    return by_draw.std(axis=0, ddof=1) / math.sqrt(len(by_draw))


def explore(
    field: Field,
    population: Population,
    *,
    draws: int = 16,
    on_progress: Callable[[int, int], Any] = lambda done, count: None,
) -> Surface:
    """Computes gradient and curvature at the mean of a population, by central
    differences with common random numbers: the gradient (Lande 1979,
    doi:10.1111/j.1558-5646.1979.tb04694.x) and its change with the traits
    (Lande and Arnold 1983, doi:10.1111/j.1558-5646.1983.tb00236.x).

    draws: number of draws of fields and light of each plant.

    Raises Error if an evaluation fails, or a trait does not vary."""
    step = population.deviation
    count = len(step)
    pairs = list(combinations(range(count), 2))
    offsets = np.concatenate(
        [
            np.zeros((1, count)),
            *(
                sign * size * np.eye(count)
                for size in (GRADIENT_STEP, CURVATURE_STEP)
                for sign in (1, -1)
            ),
            *(
                sign
                * CURVATURE_STEP
                * np.eye(count)[list(pair)].sum(axis=0)[None]
                for pair in pairs
                for sign in (1, -1)
            ),
        ]
    )
    plants = population.mean + offsets * step
    values = field.evaluate(plants, draws, on_progress=on_progress)
    centre = values[0]
    percent = 100 / abs(centre.mean())
    near, far = values[1 : 1 + 2 * count], values[1 + 2 * count :]
    # A trait without genetic variance has no effect on any response.
    inverse = np.divide(1, step, out=np.zeros(count), where=step > 0)
    gradients = np.stack(
        [
            percent * (near[i] - near[count + i]) / (2 * GRADIENT_STEP)
            for i in range(count)
        ],
        axis=-1,
    )
    second = np.zeros((*centre.shape, count, count))
    for i in range(count):
        second[..., i, i] = far[i] + far[count + i] - 2 * centre
    for k, (i, j) in enumerate(pairs):
        plus, minus = far[2 * count + 2 * k], far[2 * count + 2 * k + 1]
        # f(++) + f(--) - 2 f contains both curvatures and twice the mixed one.
        mixed = plus + minus - 2 * centre - second[..., i, i]
        second[..., i, j] = (mixed - second[..., j, j]) / 2
        second[..., j, i] = second[..., i, j]
    second *= percent / CURVATURE_STEP**2
    return Surface(
        population.mean,
        step,
        centre,
        gradients * inverse,
        second * np.outer(inverse, inverse),
    )


def paired_difference(a: Array, b: Array) -> tuple[float, float]:
    """Returns the difference a - b of means over cases in % of |b|, and its
    paired standard error. a, b: [cases x randomisations]."""
    first, second = (
        Estimate(float(draws.mean()), math.nan, draws=draws)
        for draws in (a.mean(axis=0), b.mean(axis=0))
    )
    gain = relative_gain(first, second)
    return math.copysign(1, second.mean) * gain.mean, gain.standard_error
