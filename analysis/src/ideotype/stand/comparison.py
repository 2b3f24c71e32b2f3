# SPDX-License-Identifier: Apache-2.0
"""Comparisons of plants: values, differences from a reference and ranks, as
tables, text and HTML."""

from __future__ import annotations

import html
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..common.labels import unit_label, words
from ..history.estimate import NORMAL, Estimate, difference, relative_gain

Key = tuple[str, int]
"""A number of a plant: the name of a quantity and the index along its axis, 0
without an axis. Leaves are counted from the highest leaf, 0."""

MATTERS = (
    *("lai", "absorbed_par", "absorbed_light", "intercepted_fraction"),
    *("absorbed_par_per_leaf_area", "net_assimilation", "carbon_balance"),
    *("leaf_nitrogen", "transpiration", "dry_matter"),
)
"""The quantities that the page shows in addition to objectives, if the
campaign has them."""

_CASES = 3
"""The largest number of cases with several lines each, and the number of cases
side by side."""

_PLANTS = 3
"""The largest number of plants in columns; more plants have a line each."""

_REPEATABLE = 0.95
"""The target repeatability of the recommended accuracy."""

_LEAST_TOLERANCE = 1e-5

_LIGHT = ("absorbed_par", "absorbed_light")
"""The quantities to which the tolerance of an evaluation refers."""


@dataclass(frozen=True)
class Quantity:
    """A quantity without axes, or along leaves or height layers."""

    name: str
    unit: str
    axis: str = ""
    coordinates: tuple[float, ...] = (0,)
    names: tuple[str, ...] = ()
    """The names that the values, from 1, stand for; empty for measures."""


@dataclass(frozen=True)
class Comparison:
    """Plants evaluated in one or more cases. All plants of a case have the
    same fields and common random numbers, so differences have paired standard
    errors."""

    plants: tuple[str, ...]
    cases: tuple[str, ...]
    quantities: tuple[Quantity, ...]
    """The quantities, the objectives first. Coordinates are leaf ranks, from
    the lowest leaf of the plant with most leaves, or heights [m]."""
    objectives: tuple[str, ...]
    """The names of the objectives."""
    leaves: tuple[int, ...]
    """The leaf count of each plant."""
    numbers: dict[tuple[int, int], dict[Key, Estimate]] = field(repr=False)
    """The numbers of each plant and case, with their randomisations."""
    minimised: frozenset[str] = frozenset()
    """The minimised objectives."""
    reference: int = 0
    """The index of the plant to which differences refer."""

    @property
    def objective(self) -> Quantity:
        """The first objective."""
        return self.quantities[0]

    def value(self, plant: int, case: int, key: Key) -> Estimate | None:
        """Returns a number of a plant; None if the plant lacks this leaf."""
        return self.numbers[plant, case].get(key)

    def difference(self, plant: int, case: int, key: Key) -> Estimate | None:
        """Returns the difference of a number from that of the reference."""
        return self._paired(difference, plant, case, key)

    def gain(self, plant: int, case: int, key: Key) -> Estimate | None:
        """Returns the difference relative to the reference [%]; None if the
        number of the reference is 0."""
        reference = self.value(self.reference, case, key)
        if reference is None or reference.mean == 0:
            return None
        return self._paired(relative_gain, plant, case, key)

    def _paired(
        self, combine: Any, plant: int, case: int, key: Key
    ) -> Estimate | None:
        both = (
            self.value(plant, case, key),
            self.value(self.reference, case, key),
        )
        return None if None in both else combine(*both)

    def means(self, name: str) -> NDArray[np.float64]:
        """Returns the means of a quantity without axes [plant, case]."""
        return np.array(
            [
                [
                    self.numbers[p, c][name, 0].mean
                    for c in range(len(self.cases))
                ]
                for p in range(len(self.plants))
            ]
        )

    def ranks(self, name: str) -> NDArray[np.float64]:
        """Returns the ranks of the plants in each case [plant, case]: 1 is the
        largest value, of a minimised objective the smallest. Equal plants have
        the mean of their ranks."""
        means = pd.DataFrame(self.means(name))
        return means.rank(ascending=name in self.minimised).to_numpy()

    def rank_correlation(self, name: str) -> NDArray[np.float64]:
        """Returns Spearman's rank correlation between cases [case, case]; NaN
        if all plants of a case are equal."""
        ranks = pd.DataFrame(self.ranks(name))
        return ranks.corr().to_numpy()

    def pairs(
        self, name: str, case: int
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Returns the differences between plants, first less second, and their
        standard errors, both [plant, plant]."""
        values = [
            self.numbers[p, case][name, 0] for p in range(len(self.plants))
        ]
        means = np.array([x.mean for x in values])
        counts = {len(x.draws) for x in values}
        if len(counts) == 1 and min(counts) > 1:
            draws = np.array([x.draws for x in values])
            scatter = [np.std(x - draws, axis=1, ddof=1) for x in draws]
            errors = np.array(scatter) / np.sqrt(draws.shape[1])
        else:
            squares = np.array([x.standard_error for x in values]) ** 2
            errors = np.sqrt(squares[:, None] + squares)
        return means[:, None] - means, errors

    @property
    def table(self) -> pd.DataFrame:
        """One row for each plant, case and number: plant, case, quantity,
        unit, leaf (rank from the lowest of the plant), leaf_from_top (1 is the
        highest), layer_m, mean, standard_error, and the difference from the
        reference with its paired standard error, also in per cent."""
        return pd.DataFrame(
            [
                self._line(p, c, quantity, index)
                for p in range(len(self.plants))
                for c in range(len(self.cases))
                for quantity in self.quantities
                for index in self._indices(p, quantity)
            ]
        ).astype({"leaf": "Int64", "leaf_from_top": "Int64"})

    def _indices(self, plant: int, quantity: Quantity) -> Sequence[int]:
        """Returns the indices along an axis that a plant has, the lowest leaf
        first."""
        if quantity.axis == "leaf":
            return range(self.leaves[plant])[::-1]
        return range(len(quantity.coordinates))

    def _line(
        self, plant: int, case: int, quantity: Quantity, index: int
    ) -> dict[str, Any]:
        key = quantity.name, index
        is_leaf, is_layer = (quantity.axis == x for x in ("leaf", "layer"))
        line: dict[str, Any] = {
            "plant": self.plants[plant],
            "case": self.cases[case],
            "quantity": quantity.name,
            "unit": quantity.unit,
            "leaf": self.leaves[plant] - index if is_leaf else None,
            "leaf_from_top": index + 1 if is_leaf else None,
            "layer_m": quantity.coordinates[index] if is_layer else None,
        }
        for name, number in (
            ("", self.value(plant, case, key)),
            ("difference", self.difference(plant, case, key)),
            ("percent", self.gain(plant, case, key)),
        ):
            line[name or "mean"] = number.mean if number else None
            error = f"{name}_standard_error".lstrip("_")
            line[error] = number.standard_error if number else None
        return line

    def __str__(self) -> str:
        return format_page(self)

    def __repr__(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        return format_html(self)


def format_page(
    comparison: Comparison, has_all: bool = False, sort: str = ""
) -> str:
    """Returns the comparison as text for one screen: for up to three cases the
    objectives and some other quantities in each case, for more cases the first
    objective.

    has_all: whether to show every quantity without axes in every case.
    sort: quantity by which plants are ranked, by default the first objective,
        or case that orders them, by default the mean of all cases. With it,
        and for more than three plants, each plant has a line."""
    lines = [_head(comparison)]
    if sort or len(comparison.plants) > _PLANTS:
        by_case = sort in comparison.cases
        name = comparison.objective.name if by_case or not sort else sort
        case = comparison.cases.index(sort) if by_case else None
        for quantity in comparison.quantities:
            if quantity.axis or quantity.names:
                continue
            if has_all or quantity.name == name:
                lines += ["", *format_ranking(comparison, quantity, case)]
    elif len(comparison.cases) > _CASES and not has_all:
        lines += ["", *_by_case(comparison)]
    else:
        for case, name in enumerate(comparison.cases):
            shown = _shown(comparison, has_all)
            lines += ["", name, *_case_lines(comparison, case, shown)]
    lines += ["", _notes(comparison, has_all)]
    return "\n".join(lines)


def _head(comparison: Comparison) -> str:
    reference, others = _reference(comparison)
    if not others:
        return f"{reference}, without a plant to compare"
    if len(others) > _PLANTS:
        return f"{len(others)} plants compared with {reference}"
    names = ", ".join(comparison.plants[p] for p in others)
    return f"{names} compared with {reference}"


def _reference(comparison: Comparison) -> tuple[str, list[int]]:
    """Returns the name of the reference and the indices of all others."""
    others = [
        p for p in range(len(comparison.plants)) if p != comparison.reference
    ]
    return comparison.plants[comparison.reference], others


def _notes(comparison: Comparison, has_all: bool) -> str:
    note = "± is half of a 95 % confidence interval"
    if len(comparison.plants) > 1:
        note += ", paired for differences: plants share fields and light.\n"
        note += f"Reference: {comparison.plants[comparison.reference]}"
        note += (
            "." if comparison.reference else ", the first; --reference NAME."
        )
    if not has_all:
        note += (
            "\n--all prints every quantity, --csv FILE and --json those by "
            "leaf too."
        )
    return note


def _shown(comparison: Comparison, has_all: bool) -> list[Quantity]:
    numbers = [q for q in comparison.quantities if not q.axis]
    if has_all:
        return numbers
    objectives = set(comparison.objectives)
    return [
        quantity
        for quantity in numbers
        if quantity.name in objectives or quantity.name in MATTERS
    ]


def _numbers_table(
    comparison: Comparison, case: int, shown: Sequence[Quantity]
) -> list[list[str]]:
    """Returns one line for each quantity: the number of each plant, and the
    increase over the reference [%]."""
    name, others = _reference(comparison)
    heads = (x for p in others for x in (comparison.plants[p], "more [%]"))
    rows = [["", name, *heads]]
    for quantity in shown:
        key = quantity.name, 0
        row = [
            format_title(quantity),
            format_number(
                quantity, comparison.value(comparison.reference, case, key)
            ),
        ]
        for plant in others:
            gain = comparison.gain(plant, case, key)
            row += [
                format_number(quantity, comparison.value(plant, case, key)),
                format_estimate(
                    None if quantity.names else gain, has_sign=True
                ),
            ]
        rows.append(row)
    return rows


def _case_lines(
    comparison: Comparison, case: int, shown: Sequence[Quantity]
) -> list[str]:
    return align_rows(_numbers_table(comparison, case, shown))


def _by_case(comparison: Comparison) -> list[str]:
    name, others = _reference(comparison)
    heads = (f"{comparison.plants[p]} more [%]" for p in others)
    rows = [[format_title(comparison.objective), name, *heads]]
    key = comparison.objective.name, 0
    for case, title in enumerate(comparison.cases):
        gains = (
            format_estimate(comparison.gain(plant, case, key), has_sign=True)
            for plant in others
        )
        rows.append(
            [
                title,
                format_estimate(
                    comparison.value(comparison.reference, case, key)
                ),
                *gains,
            ]
        )
    return align_rows(rows)


def format_html(comparison: Comparison) -> str:
    """Returns the comparison as HTML: one table for each case, or for more
    than three plants their ranking as text."""
    if len(comparison.plants) > _PLANTS:
        return f"<pre>{html.escape(format_page(comparison))}</pre>"
    parts = [f"<p>{html.escape(_head(comparison))}</p>"]
    for case, name in enumerate(comparison.cases):
        head, *rows = _numbers_table(
            comparison, case, _shown(comparison, False)
        )
        cells = "".join(f"<th>{html.escape(x)}</th>" for x in head)
        lines = "".join(
            "<tr>"
            + "".join(f"<td>{html.escape(x)}</td>" for x in row)
            + "</tr>"
            for row in rows
        )
        parts.append(
            f"<table><caption>{html.escape(name)}</caption>"
            f"<thead><tr>{cells}</tr></thead><tbody>{lines}</tbody></table>"
        )
    parts.append(f"<p>{html.escape(_notes(comparison, True))}</p>")
    return "".join(parts)


def format_ranking(
    comparison: Comparison, quantity: Quantity, case: int | None = None
) -> list[str]:
    """Returns one line for each plant, best first, with the quantity in each
    case, its increase over the reference and the rank of the plant; then
    sentences on the reliability of the ranks.

    case: index of the case that orders the plants; None: mean of all
        cases."""
    name = quantity.name
    order = _order(comparison, name, case)
    ends = "smallest" if name in comparison.minimised else "largest"
    if case is not None:
        by = f"{ends} in {comparison.cases[case]} first"
    elif len(comparison.cases) > 1:
        by = f"{ends} mean of {len(comparison.cases)} cases first"
    else:
        by = f"{ends} first"
    lines = [f"{format_title(quantity)}, {by}"]
    for begin in range(0, len(comparison.cases), _CASES):
        cases = range(len(comparison.cases))[begin : begin + _CASES]
        lines += ["", *_ranks_table(comparison, name, cases, order)]
    return [*lines, "", *_reliability(comparison, name)]


def _order(
    comparison: Comparison, name: str, case: int | None
) -> NDArray[np.int64]:
    means = comparison.means(name)
    by = means.mean(1) if case is None else means[:, case]
    return np.argsort(
        by if name in comparison.minimised else -by, kind="stable"
    )


def _ranks_table(
    comparison: Comparison,
    name: str,
    cases: Sequence[int],
    order: NDArray[np.int64],
) -> list[str]:
    """Returns a block of columns for each case, headed by its name."""
    ranks = comparison.ranks(name)
    blocks = [["", "", *(comparison.plants[p] for p in order)]]
    for case in cases:
        rows = [["", "more [%]", "rank"]]
        for plant in order:
            gain = format_estimate(
                comparison.gain(plant, case, (name, 0)), has_sign=True
            )
            rows.append(
                [
                    format_estimate(comparison.value(plant, case, (name, 0))),
                    "reference" if plant == comparison.reference else gain,
                    f"{ranks[plant, case]:g}",
                ]
            )
        blocks.append([comparison.cases[case], *align_rows(rows)])
    widths = [max(map(len, block)) for block in blocks]
    return [
        "   ".join(x.ljust(w) for x, w in zip(line, widths)).rstrip()
        for line in zip(*blocks, strict=True)
    ]


def _reliability(comparison: Comparison, name: str) -> list[str]:
    count = len(comparison.plants)
    if count < 2:
        return []
    lines = []
    pairs = [
        _Pairs.from_case(comparison, name, case)
        for case in range(len(comparison.cases))
    ]
    for case, (title, variance) in enumerate(zip(comparison.cases, pairs)):
        best = _order(comparison, name, case)[0]
        apart, errors = (x[best] for x in comparison.pairs(name, case))
        level = np.count_nonzero(np.abs(apart) <= NORMAL * errors) - 1
        lines.append(
            f"{title}: repeatability {variance.repeatability:.2f}; no "
            f"significant difference from {comparison.plants[best]} in {level} "
            f"of {count - 1} others."
        )
    lines += _correlation(comparison, name)
    return lines + _recommended(
        comparison, min(pairs, key=lambda x: x.repeatability)
    )


@dataclass(frozen=True)
class _Pairs:
    """The variance between the plants of a case, from pairs."""

    square: float
    """The mean square difference of pairs."""
    noise: float
    """The mean square standard error of these differences."""

    @classmethod
    def from_case(cls, comparison: Comparison, name: str, case: int) -> _Pairs:
        upper = np.triu_indices(len(comparison.plants), 1)
        apart, errors = (x[upper] for x in comparison.pairs(name, case))
        return cls(float(np.mean(apart**2)), float(np.mean(errors**2)))

    @property
    def repeatability(self) -> float:
        """The fraction of the variance between plants that is not noise
        (Piepho and Moehring 2007, doi:10.1534/genetics.107.074229), from mean
        squares of paired differences. 0 if all plants are equal."""
        if self.square == 0:
            return 0.0
        return max(0.0, 1 - self.noise / self.square)


def _correlation(comparison: Comparison, name: str) -> list[str]:
    """Returns a sentence on the correlation of ranks between cases."""
    if len(comparison.cases) < 2 or len(comparison.plants) < 3:
        return []
    matrix = comparison.rank_correlation(name)
    first, second = np.triu_indices(len(comparison.cases), 1)
    values = matrix[first, second]
    if not np.isfinite(values).all():
        return []
    ends = f"{values.min():.2f}"
    if len(values) > 1:
        least = int(np.argmin(values))
        names = [comparison.cases[x[least]] for x in (first, second)]
        ends += f" to {values.max():.2f}, least between {' and '.join(names)}"
    return [f"Rank correlation between cases (Spearman): {ends}."]


def _recommended(comparison: Comparison, pairs: _Pairs) -> list[str]:
    """Returns a sentence on the accuracy needed for a reliable ranking in the
    least repeatable case."""
    if pairs.repeatability >= _REPEATABLE:
        return []
    if pairs.repeatability == 0:
        return [
            "Differences do not exceed their noise; try a smaller --tolerance."
        ]
    wanted = (pairs.square - pairs.noise) * (1 / _REPEATABLE - 1)
    factor = float(np.sqrt(wanted / pairs.noise))
    text = (
        f"A repeatability of {_REPEATABLE} in each case requires errors "
        f"{1 / factor:.2g} times smaller"
    )
    present = _relative_error(comparison)
    if present is not None:
        least = max(present * factor, _LEAST_TOLERANCE)
        text += f": about --tolerance {least:.1g}"
    return [text + "."]


def _relative_error(comparison: Comparison) -> float | None:
    """Returns the median relative standard error of absorbed light, to which
    `--tolerance` refers; None if the campaign lacks this quantity."""
    errors = [
        light.standard_error / light.mean
        for numbers in comparison.numbers.values()
        for name in _LIGHT
        if (light := numbers.get((name, 0))) is not None and light.mean > 0
    ]
    return float(np.median(errors)) if errors else None


def format_estimate(figure: Estimate | None, has_sign: bool = False) -> str:
    """Returns a number ± half of its 95 % confidence interval; an exact number
    has no interval."""
    if figure is None or not math.isfinite(figure.mean):
        return "–"
    text = figure.interval_text()
    if has_sign and figure.standard_error == 0:
        text = f"{figure.mean:.2f}"
    is_plus = has_sign and figure.mean > 0 and text.strip("0.") != ""
    return f"+{text}" if is_plus else text


def format_number(quantity: Quantity, figure: Estimate | None) -> str:
    """Returns a number of a quantity, or the name that it stands for."""
    if figure is None or not quantity.names:
        return format_estimate(figure)
    number = int(figure.mean)
    return quantity.names[number - 1] if number > 0 else "–"


def format_title(quantity: Quantity) -> str:
    """Returns the words and the unit of a quantity."""
    unit = unit_label(quantity.unit)
    return words(quantity.name) + ("" if unit == "1" else f" [{unit}]")


def align_rows(rows: Sequence[Sequence[str]]) -> list[str]:
    """Returns rows of equal columns as lines; the first column is aligned to
    the left, the others to the right."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(
            cell.ljust(width) if i == 0 else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(row, widths))
        ).rstrip()
        for row in rows
    ]
