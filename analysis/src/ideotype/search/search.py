# SPDX-License-Identifier: Apache-2.0
"""The optimizers of the program for any function, by ask and tell."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..common.arrays import real, require_whole
from ..common.compiled import _core
from ..errors import Error

Numbers = NDArray[np.float64]


class Search:
    """Searches for the best point between bounds, one generation at a time.

    Points depend only on the arguments and on the values of earlier
    generations. docs/optimisers.md describes the optimizers."""

    def __init__(
        self,
        lower: ArrayLike,
        upper: ArrayLike,
        *,
        start: ArrayLike | None = None,
        maximise: Sequence[bool] = (True,),
        optimizer: str = "auto",
        population: int | None = None,
        seed: int = 1,
        circular: ArrayLike | None = None,
        traits: Sequence[str] | None = None,
        kinds: Sequence[str] | None = None,
        axes: Sequence[tuple[float, float, int]] = (),
    ) -> None:
        """Begins a search.

        lower, upper: bounds [genes].
        start: point at which the search begins [genes], by default the middle.
        maximise: whether each objective is maximised, else minimised.
        optimizer: name of the optimizer, as in `search.optimizer` of a
            campaign.
        population: number of points of a generation.
        seed: seed of the random numbers.
        circular: whether the two bounds of each gene are the same point
            [genes].
        traits: name of the trait of each gene [genes]; genes of a trait belong
            together. By default each gene is a trait.
        kinds: kind of each gene [genes]: "real", by default; "integer", the
            whole numbers between the bounds; or "choice", whole numbers that
            stand for values without an order.
        axes: lower bound, upper bound and number of cells of each feature of
            an atlas, which searches for the best point of each cell; tell()
            then needs the features of points.

        Raises Error if shapes disagree or a number is out of range."""
        bounds = [real(lower, "lower"), real(upper, "upper")]
        if (
            bounds[0].ndim != 1
            or bounds[0].shape != bounds[1].shape
            or not np.all(bounds[0] < bounds[1])
        ):
            raise Error(
                "lower and upper: two lists of the same length are needed, and "
                "each lower bound must be below its upper bound"
            )
        require_whole(seed, "seed", 0, 2**64 - 1)
        if population is not None:
            require_whole(population, "population", 2, 100_000)
        if np.ndim(maximise) != 1 or len(maximise) == 0:
            raise Error(
                "maximise: one truth value is needed for each objective, such "
                "as [True]"
            )
        count = len(bounds[0])
        middle = (
            np.mean(bounds, axis=0) if start is None else real(start, "start")
        )
        around = (
            np.zeros(count, bool) if circular is None else np.asarray(circular)
        )
        if middle.shape != (count,) or around.shape != (count,):
            raise Error(
                f"start and circular: {count} numbers are needed, one for each bound"
            )
        names = (
            [str(i) for i in range(count)] if traits is None else list(traits)
        )
        if len(names) != count:
            raise Error(
                f"traits: {count} names are needed, one for each bound"
            )
        kind_names = ["real"] * count if kinds is None else list(kinds)
        is_discrete = np.array([kind != "real" for kind in kind_names])
        if len(kind_names) != count or np.any(
            is_discrete & (np.mod(bounds, 1).any(axis=0) | around.astype(bool))
        ):
            raise Error(
                f"kinds: {count} names are needed, one for each bound; the "
                "bounds of integers and choices are whole numbers, and not "
                "circular"
            )
        if start is None:
            middle = np.where(is_discrete, np.floor(middle), middle)
        elif np.any(is_discrete & (np.mod(middle, 1) != 0)):
            raise Error("start: integers and choices are whole numbers")
        if bool(axes) != (optimizer == "atlas") or not all(
            lower < upper and cells > 0 for lower, upper, cells in axes
        ):
            raise Error(
                "axes: an atlas needs (lower, upper, cells) of each feature, "
                "with lower < upper and cells > 0; other searches have none"
            )
        senses = [
            "maximises" if is_max else "minimises" for is_max in maximise
        ]
        self._words = (
            f"{optimizer}, {count} genes, {' and '.join(dict.fromkeys(senses))}"
            f" {len(maximise)} objective{'s' if len(maximise) > 1 else ''}, "
            f"seed {seed}"
        )
        self._objectives = len(maximise)
        self._features = len(axes)
        self._search = _core.make_search(
            optimizer,
            population or 0,
            seed,
            middle.tolist(),
            bounds[0].tolist(),
            bounds[1].tolist(),
            around.astype(bool).tolist(),
            names,
            kind_names,
            [bool(is_max) for is_max in maximise],
            list(axes),
        )

    def __repr__(self) -> str:
        return f"<Search: {self._words}>"

    def ask(self) -> Numbers:
        """Returns the points of the next generation [points, genes]. They
        remain the same until tell()."""
        return np.array(self._search.ask())

    def tell(
        self,
        values: ArrayLike,
        violations: ArrayLike | None = None,
        features: ArrayLike | None = None,
    ) -> None:
        """Passes the values of the points that ask() returned.

        values: [points] or [points, objectives]; NaN if the evaluation of a
            point failed.
        violations: violation of the constraints by each point [points]; 0:
            none.
        features: features of the points, for an atlas [points, axes].

        Raises Error if shapes disagree."""
        count = len(self._search.ask())
        objectives = np.asarray(values, float).reshape(-1, self._objectives)
        failed = (
            np.zeros(count)
            if violations is None
            else real(violations, "violations")
        )
        if len(objectives) != count or failed.shape != (count,):
            raise Error(
                f"values: {count} points were asked for, but {len(objectives)} are "
                "given; give one value for each"
            )
        kinds = (
            np.empty((0, 0))
            if features is None
            else np.asarray(features, float)
        )
        if self._features and kinds.shape != (count, self._features):
            raise Error(
                f"features: an atlas needs {self._features} of each of {count} points"
            )
        self._search.tell(objectives.tolist(), failed.tolist(), kinds.tolist())

    def best(self, count: int = 1) -> Numbers:
        """Returns the best points found, best first [at most count, genes]:
        the candidates for a re-evaluation with independent random numbers."""
        return np.array(self._search.best(count))
