# SPDX-License-Identifier: Apache-2.0
"""Chooses representative climates by k-medoids."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..errors import Error
from .features import Features

_TRIALS = 100
"""Number of random starts, in addition to the one of BUILD."""


@dataclass(frozen=True)
class Representatives:
    """Climates that represent a record, with their weights."""

    names: tuple[str, ...]
    """The chosen climates, in the order of the record."""
    weights: NDArray[np.float64]
    """The share of the record that each of them represents; their sum is 1."""
    represented_by: dict[str, str]
    """The representative of each climate of the record."""
    kept: float
    """The share of the variance of the features between climates that the
    representatives keep: 1 less the sum of squared distances from the
    representatives over that from the mean."""
    loss: pd.DataFrame
    """One row for each feature: mean and standard deviation of the record,
    those of the weighted representatives, and the difference of the means in
    standard deviations of the record (`shift`)."""


def choose_representatives(
    features: Features, count: int, seed: int = 1
) -> Representatives:
    """Chooses `count` climates so that the sum of the distances of all
    climates from the nearest of them is least: k-medoids by FasterPAM
    (Schubert and Rousseeuw 2021, doi:10.1016/j.is.2021.101804), from BUILD and
    100 random starts. Distances are Euclidean between standardised features.

    Raises Error if there are fewer climates than `count`, or the package
    kmedoids is missing."""
    values = features.values
    if not 1 <= count <= len(values):
        raise Error(
            f"{count} of {len(values)} climates cannot be chosen; give a "
            f"number from 1 to {len(values)}"
        )
    scores = _standardize(values)
    distance = np.linalg.norm(scores[:, None] - scores[None], axis=2)
    chosen = _find_medoids(distance, count, seed)
    nearest = chosen[distance[:, chosen].argmin(1)]
    nearest[chosen] = chosen  # also where two climates are equal
    weights = (nearest[:, None] == chosen).sum(0) / len(values)
    names = [str(x) for x in values.index]
    spread = float((scores**2).sum())
    missed = float((distance[np.arange(len(values)), nearest] ** 2).sum())
    return Representatives(
        tuple(names[i] for i in chosen),
        weights,
        {names[i]: names[m] for i, m in enumerate(nearest)},
        1 - missed / spread if spread > 0 else 1.0,
        _tabulate_loss(values, chosen, weights),
    )


def _standardize(values: pd.DataFrame) -> NDArray[np.float64]:
    """Returns features with mean 0 and standard deviation 1; those that do not
    vary are 0."""
    numbers = values.to_numpy(float)
    deviation = numbers.std(0)
    varies = deviation > 1e-9 * np.abs(numbers).max(0, initial=0)
    return np.where(
        varies,
        (numbers - numbers.mean(0)) / np.where(varies, deviation, 1),
        0.0,
    )


def _find_medoids(
    distance: NDArray[np.float64], count: int, seed: int
) -> NDArray[np.int64]:
    """Returns the indices of the medoids in increasing order."""
    try:
        import kmedoids
    except ImportError as error:
        raise Error(
            "ideotype environments needs the package kmedoids; install it: "
            "pip install 'ideotype[environments]'"
        ) from error
    if count == len(distance):
        return np.arange(count)
    best = kmedoids.fasterpam(distance, count, init="build", random_state=seed)
    for trial in range(_TRIALS):
        other = kmedoids.fasterpam(
            distance, count, init="random", random_state=seed + trial
        )
        if other.loss < best.loss:
            best = other
    return np.sort(np.asarray(best.medoids, np.int64))


def _tabulate_loss(
    values: pd.DataFrame,
    chosen: NDArray[np.int64],
    weights: NDArray[np.float64],
) -> pd.DataFrame:
    some = values.iloc[chosen]
    mean = (some * weights[:, None]).sum()
    deviation = ((some - mean) ** 2 * weights[:, None]).sum() ** 0.5
    whole = values.std(ddof=0)
    return pd.DataFrame(
        {
            "mean": values.mean(),
            "chosen_mean": mean,
            "deviation": whole,
            "chosen_deviation": deviation,
            "shift": ((mean - values.mean()) / whole.where(whole > 0)).fillna(
                0
            ),
        }
    )
