# SPDX-License-Identifier: Apache-2.0
"""Ranked plants with a line each, and the reliability of their ranks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..analysis.reading.estimate import NORMAL
from .compared import Comparison, Quantity
from .compared_cells import aligned, title_of, told

_SIDE_BY_SIDE = 3
"""The number of cases side by side."""

_REPEATABLE = 0.95
"""The repeatability for which an accuracy is recommended."""

_LEAST_TOLERANCE = 1e-5

_LIGHT = ("absorbed_par", "absorbed_light")
"""The light to which the tolerance of an evaluation refers."""


def ranking_of(
    found: Comparison, quantity: Quantity, case: int | None = None
) -> list[str]:
    """Returns a line for each plant, best first: the quantity in each case,
    its increase over the reference and the rank of the plant; then sentences
    on the reliability of the ranks.

    case: case that orders the plants, None for the mean of all cases."""
    name = quantity.name
    order = _order(found, name, case)
    ends = "smallest" if name in found.minimised else "largest"
    if case is not None:
        by = f"{ends} in {found.cases[case]} first"
    elif len(found.cases) > 1:
        by = f"{ends} mean of {len(found.cases)} cases first"
    else:
        by = f"{ends} first"
    lines = [f"{title_of(quantity)}, {by}"]
    for begin in range(0, len(found.cases), _SIDE_BY_SIDE):
        cases = range(len(found.cases))[begin : begin + _SIDE_BY_SIDE]
        lines += ["", *_table(found, name, cases, order)]
    return [*lines, "", *_reliability(found, name)]


def _order(
    found: Comparison, name: str, case: int | None
) -> NDArray[np.int64]:
    means = found.means(name)
    by = means.mean(1) if case is None else means[:, case]
    return np.argsort(by if name in found.minimised else -by, kind="stable")


def _table(
    found: Comparison,
    name: str,
    cases: Sequence[int],
    order: NDArray[np.int64],
) -> list[str]:
    """Returns a block of columns for each case under the name of the case."""
    ranks = found.ranks(name)
    blocks = [["", "", *(found.plants[p] for p in order)]]
    for case in cases:
        rows = [["", "more [%]", "rank"]]
        for plant in order:
            gain = told(found.gain(plant, case, (name, 0)), has_sign=True)
            rows.append(
                [
                    told(found.value(plant, case, (name, 0))),
                    "reference" if plant == found.reference else gain,
                    f"{ranks[plant, case]:g}",
                ]
            )
        blocks.append([found.cases[case], *aligned(rows)])
    widths = [max(map(len, block)) for block in blocks]
    return [
        "   ".join(x.ljust(w) for x, w in zip(line, widths)).rstrip()
        for line in zip(*blocks, strict=True)
    ]


def _reliability(found: Comparison, name: str) -> list[str]:
    count = len(found.plants)
    if count < 2:
        return []
    lines = []
    pairs = [_Pairs.of(found, name, case) for case in range(len(found.cases))]
    for case, (title, of_case) in enumerate(zip(found.cases, pairs)):
        best = _order(found, name, case)[0]
        apart, errors = (x[best] for x in found.pairs(name, case))
        level = np.count_nonzero(np.abs(apart) <= NORMAL * errors) - 1
        lines.append(
            f"{title}: repeatability {of_case.repeatability:.2f}; no "
            f"significant difference from {found.plants[best]} in {level} of "
            f"{count - 1} others."
        )
    lines += _correlation(found, name)
    return lines + _recommended(
        found, min(pairs, key=lambda x: x.repeatability)
    )


@dataclass(frozen=True)
class _Pairs:
    """The pairs of plants of a case."""

    square: float
    """The mean square of the differences of pairs."""
    noise: float
    """The mean square of the standard errors of these differences."""

    @classmethod
    def of(cls, found: Comparison, name: str, case: int) -> _Pairs:
        places = np.triu_indices(len(found.plants), 1)
        apart, errors = (x[places] for x in found.pairs(name, case))
        return cls(float(np.mean(apart**2)), float(np.mean(errors**2)))

    @property
    def repeatability(self) -> float:
        """The share of the variance between plants that is not noise: Piepho
        and Moehring 2007, doi:10.1534/genetics.107.074229, with means of
        paired differences. 0 if all plants are equal."""
        if self.square == 0:
            return 0.0
        return max(0.0, 1 - self.noise / self.square)


def _correlation(found: Comparison, name: str) -> list[str]:
    """Returns a sentence on the correlation of ranks between cases."""
    if len(found.cases) < 2 or len(found.plants) < 3:
        return []
    matrix = found.rank_correlation(name)
    first, second = np.triu_indices(len(found.cases), 1)
    values = matrix[first, second]
    if not np.isfinite(values).all():
        return []
    ends = f"{values.min():.2f}"
    if len(values) > 1:
        least = int(np.argmin(values))
        ends += (
            f" to {values.max():.2f}, least between "
            f"{found.cases[first[least]]} and {found.cases[second[least]]}"
        )
    return [f"Rank correlation between cases (Spearman): {ends}."]


def _recommended(found: Comparison, pairs: _Pairs) -> list[str]:
    """Returns a sentence on the accuracy that a reliable ranking of the least
    repeatable case needs."""
    if pairs.repeatability >= _REPEATABLE:
        return []
    if pairs.repeatability == 0:
        return [
            "Differences are not larger than their noise; try a smaller "
            "--tolerance."
        ]
    wanted = (pairs.square - pairs.noise) * (1 / _REPEATABLE - 1)
    factor = float(np.sqrt(wanted / pairs.noise))
    text = (
        f"For a repeatability of {_REPEATABLE} in each case errors have to be "
        f"{1 / factor:.2g} times smaller"
    )
    present = _relative_error(found)
    if present is not None:
        least = max(present * factor, _LEAST_TOLERANCE)
        text += f": about --tolerance {least:.1g}"
    return [text + "."]


def _relative_error(found: Comparison) -> float | None:
    """Returns the median relative standard error of absorbed light, to which
    `--tolerance` refers; None without such a quantity."""
    errors = [
        own.standard_error / own.mean
        for numbers in found.numbers.values()
        for name in _LIGHT
        if (own := numbers.get((name, 0))) is not None and own.mean > 0
    ]
    return float(np.median(errors)) if errors else None
