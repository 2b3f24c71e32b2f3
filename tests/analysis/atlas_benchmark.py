# SPDX-License-Identifier: Apache-2.0
"""The benchmark of pyribs for atlases, and the atlas of this package on it.

Tjanaka et al. 2023 (doi:10.1145/3583131.3590374): the sphere function of 20
genes and a linear projection of them onto two features, 20 x 20 cells."""

from __future__ import annotations

import numpy as np

from ideotype import Search

GENES, BOUND, CELLS = 20, 5.12, 20
REACH = BOUND * GENES / 2
"""The largest value of a feature."""


def worth(points: np.ndarray) -> np.ndarray:
    """Returns the objective of points [point, gene]."""
    shift = 0.4 * BOUND
    worst = GENES * (BOUND + shift) ** 2
    return 100 * (1 - ((points - shift) ** 2).sum(axis=1) / worst)


def features(points: np.ndarray) -> np.ndarray:
    """Returns the features of points [point, feature]."""
    return points.reshape(len(points), 2, -1).sum(axis=2)


def by_atlas(
    noise: float, seed: int, batch: int, evaluations: int
) -> np.ndarray:
    """Returns the leaders [cell, gene] after a number of evaluations with
    normal noise of a standard deviation."""
    search = Search(
        [-BOUND] * GENES,
        [BOUND] * GENES,
        optimizer="atlas",
        population=batch,
        seed=seed,
        axes=[(-REACH, REACH, CELLS)] * 2,
    )
    random, count = np.random.default_rng(seed), 0
    while count < evaluations:
        points = search.ask()
        luck = noise * random.standard_normal(len(points))
        search.tell(worth(points) + luck, features=features(points))
        count += len(points)
    return search.best(CELLS**2)
