# SPDX-License-Identifier: Apache-2.0
"""Writes tests/data/catcmawm.txt: the updates of integers and choices by CatCMA
with margin of the package cmaes 0.13.1, for test_discrete_distributions.cpp.

A search with one integer has a line "integer COUNT MARGIN GENERATIONS". Each
generation then has five lines: the mean; the positions of the better half; the
same after centring; mean and deviation after the update of the normal
distribution; and the same after the correction.

A search with choices has a line "choices CHOICES POPULATION MARGIN
GENERATIONS" and a line with the number of entries of each choice. Each
generation then has two lines: the entries of all points, best first, and the
probabilities after the update. The package adapts its step size one generation
late; the class below does not, as in Akimoto et al. 2019 (PMLR 97:171)."""

import numpy as np
from cmaes import CatCMAwM


def line(numbers):
    print(" ".join(f"{x:.17g}" for x in np.ravel(numbers)))


class Recorded(CatCMAwM):
    """A search that prints each step of its updates."""

    def _integer_centering(self, positions):
        line(self._mean)
        line(positions[: self._mu])
        centred = super()._integer_centering(positions)
        line(centred[: self._mu])
        return centred

    def _margin_correction(self):
        self._print_marginal()
        super()._margin_correction()
        self._print_marginal()

    def _print_marginal(self):
        scale = self._sigma * self._A * np.sqrt(np.diag(self._C))
        line([self._mean[0], scale[0]])

    def _update_categorical(self, ranked):
        print(*ranked.argmax(axis=2).ravel())
        self._delta = self._delta_init / self._Delta
        super()._update_categorical(ranked)
        line(np.concatenate([q[:k] for q, k in zip(self._q, self._K)]))


def run(search, loss, noise, generations):
    rng = np.random.default_rng(generations)
    for _ in range(generations):
        points = [search.ask() for _ in range(search.population_size)]
        search.tell(
            [(point, loss(point) + noise * rng.normal()) for point in points]
        )


for count, target, noise, generations in [
    (2, 1, 0.1, 30),
    (5, 0, 0.5, 60),
    (9, 6, 0.01, 60),
    (30, 11, 3.0, 60),
]:
    search = Recorded(z_space=[range(count)], population_size=8, seed=count)
    print("integer", count, f"{search._alpha:.17g}", generations)
    run(
        search,
        lambda point, target=target: (point.z[0] - target) ** 2,
        noise,
        generations,
    )

for counts, population, generations in [
    ([2], 6, 30),
    ([3, 5], 10, 40),
    ([2, 2, 7, 4], 8, 60),
]:
    search = Recorded(
        c_space=counts, population_size=population, seed=population
    )
    margin = 1 - 0.73 ** (1 / len(counts))
    print("choices", len(counts), population, f"{margin:.17g}", generations)
    print(*counts)
    run(search, lambda point: -point.c[:, 0].sum(), 0.5, generations)
