# SPDX-License-Identifier: Apache-2.0
"""A short search for a better plant, which starts from the plant that a page
shows."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ..errors import Error
from ..search.search import Search
from .bench import Bench, Genome, Shown
from .numbers import Layout

EVALUATIONS = 200
"""The number of evaluations of a search."""

_POPULATION = 8
_TOLERANCE = 0.01
_SEED = 1
"""The seed of all evaluations of a search, which thus uses common random
numbers: 200 evaluations are too few for a search with varying fields."""

_CHECKS = 12
"""The number of evaluations of the proposed plant and of the starting plant,
with random numbers that the search has not used."""

_FINALISTS = 3
_MINIMISED = {"transpiration", "respiration", "distance_from_lines"}


class Improvement:
    """A search that other threads can end."""

    def __init__(self, bench: Bench, shown: Shown, goal: str) -> None:
        self.is_ended = False
        self._is_dropped = False
        self._bench, self._shown, self._goal = bench, shown, goal
        self._free = np.flatnonzero(bench.opened.free)
        if not len(self._free):
            raise Error(
                "the campaign optimises no trait of this plant; choose another "
                "component"
            )
        place = bench.place(bench.own)
        genes = place.stand.genes.iloc[self._free]
        start = shown.genome[self._free]
        self._lower = np.minimum(genes["lower"].to_numpy(float), start)
        self._upper = np.maximum(genes["upper"].to_numpy(float), start)
        self._genes = genes
        objectives = place.stand.objectives
        self._sign = (
            objectives[goal] == "maximise"
            if goal in objectives
            else goal not in _MINIMISED
        ) * 2 - 1

    def drop(self) -> None:
        """Ends the search without a result."""
        self.is_ended = self._is_dropped = True

    def run(self, send: Callable[[dict[str, Any]], None]) -> None:
        """Searches. Reports progress and the best plant after each generation,
        and at the end the gain, estimated with independent random numbers."""
        stand = self._bench.careful(self._shown.conditions)
        layout = Layout(stand)
        if self._goal not in layout.places:
            raise Error(
                f"there is no quantity {self._goal!r:.40}; choose one of the "
                "list"
            )

        def value(genome: Genome, seed: int) -> tuple[float, float]:
            if self._is_dropped:
                return float("nan"), 0.0
            try:
                evaluated = stand.evaluate_one(
                    genome, seed=seed, tolerance=_TOLERANCE
                )
            except Error:
                return float("nan"), 0.0
            value = layout.scalar(evaluated.numbers, self._goal)
            return self._sign * value, evaluated.violation

        search = Search(
            self._lower,
            self._upper,
            start=np.clip(
                self._shown.genome[self._free], self._lower, self._upper
            ),
            optimizer="cma_es",
            population=_POPULATION,
            circular=self._genes["is_circular"].to_numpy(bool),
            traits=list(self._genes["trait"]),
        )
        done = 0
        while done < EVALUATIONS and not self.is_ended:
            points = search.ask()
            results = self._bench.map(
                value, [self._plant(p) for p in points], [_SEED] * len(points)
            )
            values, violations = np.array(results).T
            search.tell(values, violations)
            done += len(points)
            best = self._plant(search.best()[0])
            send({"done": done, "of": EVALUATIONS, "genome": best.tolist()})
        if not self._is_dropped:
            self._judge(search, value, send, done)

    def _plant(self, point: Genome) -> Genome:
        genome = self._shown.genome.copy()
        genome[self._free] = point
        return genome

    def _judge(
        self,
        search: Search,
        value: Callable[[Genome, int], tuple[float, float]],
        send: Callable[[dict[str, Any]], None],
        done: int,
    ) -> None:
        """Chooses among the best plants, and estimates the gain with random
        numbers that are independent of this choice."""
        seeds = list(range(1000, 1000 + _CHECKS))

        def mean(genome: Genome, among: list[int]) -> np.ndarray:
            found = self._bench.map(value, [genome] * len(among), among)
            return np.array(found)[:, 0]

        few = [self._plant(point) for point in search.best(_FINALISTS)]
        means = [mean(g, list(range(900, 904))).mean() for g in few]
        best = (
            few[int(np.nanargmax(means))]
            if np.isfinite(means).any()
            else few[0]
        )
        apart = self._sign * (
            mean(best, seeds) - mean(self._shown.genome, seeds)
        )
        gain, error = apart.mean(), apart.std(ddof=1) / np.sqrt(len(apart))
        is_better = self._sign * gain > 0
        send(
            {
                "done": done,
                "of": EVALUATIONS,
                "is_final": True,
                "is_better": bool(is_better),
                "goal": self._goal,
                "gain": float(gain),
                "standard_error": float(error),
                "genome": (best if is_better else self._shown.genome).tolist(),
            }
        )
