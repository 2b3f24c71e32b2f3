# SPDX-License-Identifier: Apache-2.0
"""Compares the atlas with pyribs 0.12.0 on the benchmark of that package
(atlas_benchmark.py), with 300 generations of 100 points. The QD score is the
sum of the noise-free objectives of the leaders of all cells. Scores of pyribs
are means of three seeds, by `GridArchive` with `IsoLineEmitter` (iso_sigma =
0.1024, line_sigma = 0.2) or `GaussianEmitter` (sigma = 0.5), which begin at
0."""

from __future__ import annotations

import numpy as np
import pytest
from atlas_benchmark import CELLS, REACH, by_atlas, features, worth

from ideotype import Error, Search

# Score of the better emitter of pyribs, by the standard deviation of the
# noise.
_PYRIBS = {0: 29_632.0, 10: 17_629.2}  # of lines, Gaussian
# The same after 3,000 evaluations: the best of three emitters with batches of 36
# or 100, mean of 20 seeds (tests/search/atlas_pyribs.py).
_PYRIBS_EARLY = {5: 9_042.0, 10: 10_338.0, 20: 10_193.0}  # of CMA-ME


def _score(noise: float, seed: int, evaluations: int = 30_000) -> float:
    leaders = by_atlas(noise, seed, 100, evaluations)
    cells = np.floor((features(leaders) + REACH) / (2 * REACH) * CELLS)
    assert len(np.unique(cells, axis=0)) == len(leaders)
    return float(worth(leaders).sum())


@pytest.mark.parametrize(("noise", "least"), [(0, 0.95), (10, 1.3)])
def test_an_atlas_is_as_good_as_one_by_pyribs(
    noise: float, least: float
) -> None:
    scores = [_score(noise, seed) for seed in (1, 2)]
    assert np.mean(scores) > least * _PYRIBS[noise], scores


@pytest.mark.parametrize("noise", _PYRIBS_EARLY)
def test_an_atlas_of_few_noisy_evaluations_is_better(noise: float) -> None:
    scores = [_score(noise, seed, 3_000) for seed in (1, 2, 3, 4, 5)]
    assert np.mean(scores) > _PYRIBS_EARLY[noise], scores


def test_an_atlas_needs_axes_and_features() -> None:
    with pytest.raises(Error, match="axes: an atlas needs"):
        Search([0], [1], optimizer="atlas")
    with pytest.raises(Error, match="axes: an atlas needs"):
        Search([0], [1], optimizer="ga", axes=[(0, 1, 3)])
    search = Search([0], [1], optimizer="atlas", axes=[(0, 1, 3)])
    with pytest.raises(Error, match="features: an atlas needs 1"):
        search.tell(search.ask()[:, 0])
