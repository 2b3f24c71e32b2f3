# SPDX-License-Identifier: Apache-2.0
"""Selection indices, and responses to selection, with standard errors."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from scipy.stats import norm

from ..errors import Error
from .covariances import Matrix
from .genetics import Population
from .surface import Surface

NEGLIGIBLE = 0.05
"""A trait is left alone if an index without it loses less than this fraction
of the response."""


class Advice(StrEnum):
    """What to do with a trait."""

    more = "select for"
    less = "select against"
    alone = "leave alone"
    unknown = "undecided"


def intensity(selected: int, candidates: int) -> float:
    """Returns the intensity of truncation selection in standard deviations,
    for a finite number of candidates (Burrows 1972, doi:10.2307/2529111).

    Raises Error unless 1 <= selected <= candidates."""
    if not 1 <= selected <= candidates:
        raise Error(
            f"{selected} of {candidates} lines cannot be selected; select at "
            "least one and at most all"
        )
    if selected == candidates:
        return 0.0
    share = selected / candidates
    infinite = float(norm.pdf(norm.ppf(1 - share)) / share)
    rest = candidates - selected
    return infinite - rest / (2 * selected * (candidates + 1) * infinite)


def smith_hazel(
    genetic: Matrix, phenotypic: Matrix, weights: Matrix
) -> Matrix:
    """Returns b = P^-1 G a (Smith 1936, doi:10.1111/j.1469-1809.1936.tb02143.x;
    Hazel 1943, doi:10.1093/genetics/28.6.476). Traits without variance get
    0."""
    return np.asarray(
        np.linalg.pinv(phenotypic, rcond=1e-12, hermitian=True)
        @ genetic
        @ weights
    )


def response(
    genetic: Matrix, phenotypic: Matrix, index: Matrix, strength: float
) -> Matrix:
    """Returns the response of traits to a cycle of truncation selection by an
    index b: R = i G b / sqrt(b' P b) [traits]; 0 if the index does not
    vary."""
    variance = float(index @ phenotypic @ index)
    if variance <= 0:
        return np.zeros(len(index))
    return np.asarray(strength * genetic @ index / math.sqrt(variance))


@dataclass(frozen=True)
class Index:
    """A selection index for one case or the mean of cases. Arrays of draws
    have the errors of G and of the gradient."""

    case: str
    weights: Matrix
    """Economic weights a: the gradient [% per unit]."""
    weights_standard_error: Matrix
    smith_hazel: Matrix
    """The weights b of phenotypes [% per unit]."""
    smith_hazel_standard_error: Matrix
    trait_response: Matrix
    """The response of traits in one cycle by Smith-Hazel [units]."""
    trait_response_standard_error: Matrix
    gain: float
    """The response of the objective, a' R [%]; without curvature."""
    gain_standard_error: float
    base_gain: float
    """The response to the base index, b = a [%]."""
    base_gain_standard_error: float
    single_gain: Matrix
    """The response of the objective if one trait alone is selected
    [traits] [%]."""
    single_gain_standard_error: Matrix
    first_probability: Matrix
    """The fraction of the draws in which this trait has the largest single
    gain [traits]."""
    lost_without: Matrix
    """The fraction of the gain that an index without the trait loses."""
    advice: tuple[Advice, ...]


def make_index(
    population: Population,
    surface: Surface,
    *,
    plots: float,
    strength: float,
    case: str,
    seed: int = 1,
    draws: int = 400,
) -> Index:
    """Computes the indices, responses and their errors.

    population: of measures of plants alone.
    plots: number of plots of a candidate.
    strength: intensity of selection in standard deviations.
    seed: seed of the draws; without draws of G in the population the errors
        are those of the gradient."""
    random = np.random.default_rng(seed)
    best = _Response.compute(
        population.genetic,
        population.phenotypic(plots),
        surface.gradient,
        strength,
    )
    slopes = surface.draw(draws, random)
    drawn = []
    for k, slope in enumerate(slopes):
        genetic, error = population.genetic, population.error
        if len(population.draws):
            pick = k % len(population.draws)
            genetic = population.draws[pick]
            error = population.error_draws[pick]
        drawn.append(
            _Response.compute(
                genetic, genetic + error / plots, slope, strength
            )
        )

    def error_of(name: str) -> Matrix:
        values = np.array([getattr(x, name) for x in drawn])
        return np.asarray(values.std(axis=0, ddof=1))

    single = np.array([x.single for x in drawn])
    lost = np.array([x.lost for x in drawn])
    scaled = np.array([x.index for x in drawn]) * population.deviation
    return Index(
        case,
        surface.gradient,
        surface.gradient_standard_error,
        best.index,
        error_of("index"),
        best.traits,
        error_of("traits"),
        best.gain,
        float(error_of("gain")),
        best.base,
        float(error_of("base")),
        best.single,
        single.std(axis=0, ddof=1),
        np.bincount(single.argmax(axis=1), minlength=single.shape[1]) / draws,
        best.lost,
        tuple(
            _advise(scaled[:, i], lost[:, i])
            for i in range(len(population.traits))
        ),
    )


@dataclass(frozen=True)
class _Response:
    index: Matrix
    traits: Matrix
    gain: float
    base: float
    single: Matrix
    lost: Matrix

    @classmethod
    def compute(
        cls,
        genetic: Matrix,
        phenotypic: Matrix,
        weights: Matrix,
        strength: float,
    ) -> _Response:
        def gain(index: Matrix) -> float:
            moved = response(genetic, phenotypic, index, strength)
            return float(weights @ moved)

        count = len(weights)
        index = smith_hazel(genetic, phenotypic, weights)
        whole = gain(index)
        single, lost = np.zeros((2, count))
        for i in range(count):
            only = np.zeros(count)
            covariance = genetic[i] @ weights
            only[i] = np.sign(covariance)
            single[i] = gain(only)
            rest = [k for k in range(count) if k != i]
            without = np.zeros(count)
            without[rest] = np.linalg.pinv(
                phenotypic[np.ix_(rest, rest)], rcond=1e-12, hermitian=True
            ) @ (genetic[rest] @ weights)
            lost[i] = 1 - gain(without) / whole if whole > 0 else 0
        return cls(
            index,
            response(genetic, phenotypic, index, strength),
            whole,
            gain(weights),
            single,
            lost,
        )


def _advise(scaled: Matrix, lost: Matrix) -> Advice:
    """Returns the advice by the 95 % intervals of the weight and of the loss
    without the trait."""
    if np.quantile(lost, 0.975) < NEGLIGIBLE:
        return Advice.alone
    low, high = np.quantile(scaled, [0.025, 0.975])
    if low > 0:
        return Advice.more
    return Advice.less if high < 0 else Advice.unknown
