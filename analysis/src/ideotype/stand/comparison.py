# SPDX-License-Identifier: Apache-2.0
"""Compared plants: their numbers, differences from a reference and ranks, as
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
"""A number of a plant: the name of a quantity, and the place along the axis of
the quantity, 0 without an axis. Leaves are counted from the highest leaf,
0."""

MATTERS = (
    *("lai", "absorbed_par", "absorbed_light", "intercepted_fraction"),
    *("absorbed_par_per_leaf_area", "net_assimilation", "carbon_balance"),
    *("leaf_nitrogen", "transpiration", "dry_matter"),
)
"""The quantities that the page shows besides objectives, if a campaign
measures them."""

_CASES = 3
"""The number of cases beyond which a page has only a line for each case, and
the number of cases side by side."""

_PLANTS = 3
"""The number of plants beyond which each plant has a line."""


_REPEATABLE = 0.95
"""The repeatability for which an accuracy is recommended."""

_LEAST_TOLERANCE = 1e-5

_LIGHT = ("absorbed_par", "absorbed_light")
"""The light to which the tolerance of an evaluation refers."""


@dataclass(frozen=True)
class Quantity:
    """A quantity without axes, or along the leaves or layers of height."""

    name: str
    unit: str
    axis: str = ""
    coordinates: tuple[float, ...] = (0,)
    names: tuple[str, ...] = ()
    """The names that the number counts from 1; none if it is a measure."""


@dataclass(frozen=True)
class Comparison:
    """Plants in the light of one or more cases. All plants of a case have the
    same fields and random numbers, so that differences have paired errors; all
    errors are standard errors."""

    plants: tuple[str, ...]
    cases: tuple[str, ...]
    quantities: tuple[Quantity, ...]
    """The quantities, the objectives first. Coordinates are ranks from the
    lowest leaf of the plant with most leaves, or heights [m]."""
    objectives: tuple[str, ...]
    """The names of the objectives."""
    leaves: tuple[int, ...]
    """The number of leaves of each plant."""
    numbers: dict[tuple[int, int], dict[Key, Estimate]] = field(repr=False)
    """The numbers of each plant in each case, with their randomisations."""
    minimised: frozenset[str] = frozenset()
    """The objectives of which the least is best."""
    reference: int = 0
    """The index of the plant from which differences are."""

    @property
    def objective(self) -> Quantity:
        """The first objective."""
        return self.quantities[0]

    def value(self, plant: int, case: int, key: Key) -> Estimate | None:
        """Returns a number of a plant; None if the plant lacks the leaf."""
        return self.numbers[plant, case].get(key)

    def difference(self, plant: int, case: int, key: Key) -> Estimate | None:
        """Returns the difference of a plant's number from the reference's
        number."""
        return self._paired(difference, plant, case, key)

    def gain(self, plant: int, case: int, key: Key) -> Estimate | None:
        """Returns the difference relative to the reference [%]; None if the
        number of the reference is 0."""
        own = self.value(self.reference, case, key)
        if own is None or own.mean == 0:
            return None
        return self._paired(relative_gain, plant, case, key)

    def _paired(
        self, of_both: Any, plant: int, case: int, key: Key
    ) -> Estimate | None:
        both = (
            self.value(plant, case, key),
            self.value(self.reference, case, key),
        )
        return None if None in both else of_both(*both)

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
        """Returns the ranks of the plants in each case [plant, case]; 1 is the
        least of a minimised objective, or else the largest. Equal plants share
        the mean of their ranks."""
        means = pd.DataFrame(self.means(name))
        return means.rank(ascending=name in self.minimised).to_numpy()

    def rank_correlation(self, name: str) -> NDArray[np.float64]:
        """Returns Spearman's correlation between the ranks in each two cases;
        NaN where all plants of a case are equal."""
        ranks = pd.DataFrame(self.ranks(name))
        return ranks.corr().to_numpy()

    def pairs(
        self, name: str, case: int
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Returns the difference of each two plants, first less second, and
        the standard errors of the differences [plant, plant]."""
        own = [self.numbers[p, case][name, 0] for p in range(len(self.plants))]
        means = np.array([x.mean for x in own])
        counts = {len(x.draws) for x in own}
        if len(counts) == 1 and min(counts) > 1:
            draws = np.array([x.draws for x in own])
            scatter = [np.std(x - draws, axis=1, ddof=1) for x in draws]
            errors = np.array(scatter) / np.sqrt(draws.shape[1])
        else:
            squares = np.array([x.standard_error for x in own]) ** 2
            errors = np.sqrt(squares[:, None] + squares)
        return means[:, None] - means, errors

    @property
    def table(self) -> pd.DataFrame:
        """A row for each plant, case and number: plant, case, quantity, unit,
        leaf (rank from the lowest of its plant), leaf_from_top (1 is the
        highest), layer_m, mean, standard_error, and the difference from the
        reference with its paired error, also in per cent."""
        return pd.DataFrame(
            [
                self._line(p, c, quantity, place)
                for p in range(len(self.plants))
                for c in range(len(self.cases))
                for quantity in self.quantities
                for place in self._places(p, quantity)
            ]
        ).astype({"leaf": "Int64", "leaf_from_top": "Int64"})

    def _places(self, plant: int, quantity: Quantity) -> Sequence[int]:
        """Returns the places along an axis that a plant has, the lowest leaf
        first."""
        if quantity.axis == "leaf":
            return range(self.leaves[plant])[::-1]
        return range(len(quantity.coordinates))

    def _line(
        self, plant: int, case: int, quantity: Quantity, place: int
    ) -> dict[str, Any]:
        key = quantity.name, place
        is_leaf, is_layer = (quantity.axis == x for x in ("leaf", "layer"))
        line: dict[str, Any] = {
            "plant": self.plants[plant],
            "case": self.cases[case],
            "quantity": quantity.name,
            "unit": quantity.unit,
            "leaf": self.leaves[plant] - place if is_leaf else None,
            "leaf_from_top": place + 1 if is_leaf else None,
            "layer_m": quantity.coordinates[place] if is_layer else None,
        }
        for name, found in (
            ("", self.value(plant, case, key)),
            ("difference", self.difference(plant, case, key)),
            ("percent", self.gain(plant, case, key)),
        ):
            line[name or "mean"] = found.mean if found else None
            error = f"{name}_standard_error".lstrip("_")
            line[error] = found.standard_error if found else None
        return line

    def __str__(self) -> str:
        return page_of(self)

    def __repr__(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        return html_of(self)


def page_of(found: Comparison, has_all: bool = False, sort: str = "") -> str:
    """Returns a page for one screen: for a few cases the objectives and some
    other quantities in each case, for many cases the first objective; with
    `has_all` every quantity without axes in every case.

    More than three plants, and those that are sorted, are ranked with a line
    each. `sort` is the name of the quantity that ranks them, by default the
    first objective, or of the case that orders them, by default the mean of
    all cases."""
    lines = [_head(found)]
    if sort or len(found.plants) > _PLANTS:
        by_case = sort in found.cases
        name = found.objective.name if by_case or not sort else sort
        case = found.cases.index(sort) if by_case else None
        for quantity in found.quantities:
            if quantity.axis or quantity.names:
                continue
            if has_all or quantity.name == name:
                lines += ["", *ranking_of(found, quantity, case)]
    elif len(found.cases) > _CASES and not has_all:
        lines += ["", *_by_case(found)]
    else:
        for case, name in enumerate(found.cases):
            shown = _shown(found, has_all)
            lines += ["", name, *_of_case(found, case, shown)]
    lines += ["", _notes(found, has_all)]
    return "\n".join(lines)


def _head(found: Comparison) -> str:
    own, others = _reference(found)
    if not others:
        return f"{own}, which is compared with nothing"
    if len(others) > _PLANTS:
        return f"{len(others)} plants compared with {own}"
    names = ", ".join(found.plants[p] for p in others)
    return f"{names} compared with {own}"


def _reference(found: Comparison) -> tuple[str, list[int]]:
    """Returns the name of the reference and the indices of all others."""
    others = [p for p in range(len(found.plants)) if p != found.reference]
    return found.plants[found.reference], others


def _notes(found: Comparison, has_all: bool) -> str:
    note = "± is half of a 95 % confidence interval"
    if len(found.plants) > 1:
        note += ", of differences by pairs: plants share fields and light.\n"
        note += f"Reference: {found.plants[found.reference]}"
        note += "." if found.reference else ", the first; --reference NAME."
    if not has_all:
        note += (
            "\n--all prints every quantity, --csv FILE and --json those by "
            "leaf too."
        )
    return note


def _shown(found: Comparison, has_all: bool) -> list[Quantity]:
    numbers = [each for each in found.quantities if not each.axis]
    if has_all:
        return numbers
    objectives = set(found.objectives)
    return [
        each
        for each in numbers
        if each.name in objectives or each.name in MATTERS
    ]


def _numbers_table(
    found: Comparison, case: int, shown: Sequence[Quantity]
) -> list[list[str]]:
    """Returns a line for each quantity: the number of each plant, and the
    increase over the reference [%]."""
    name, others = _reference(found)
    heads = (x for p in others for x in (found.plants[p], "more [%]"))
    rows = [["", name, *heads]]
    for quantity in shown:
        key = quantity.name, 0
        row = [
            title_of(quantity),
            number_of(quantity, found.value(found.reference, case, key)),
        ]
        for plant in others:
            gain = found.gain(plant, case, key)
            row += [
                number_of(quantity, found.value(plant, case, key)),
                told(None if quantity.names else gain, has_sign=True),
            ]
        rows.append(row)
    return rows


def _of_case(
    found: Comparison, case: int, shown: Sequence[Quantity]
) -> list[str]:
    return aligned(_numbers_table(found, case, shown))


def _by_case(found: Comparison) -> list[str]:
    name, others = _reference(found)
    heads = (f"{found.plants[p]} more [%]" for p in others)
    rows = [[title_of(found.objective), name, *heads]]
    key = found.objective.name, 0
    for case, title in enumerate(found.cases):
        gains = (
            told(found.gain(plant, case, key), has_sign=True)
            for plant in others
        )
        rows.append(
            [title, told(found.value(found.reference, case, key)), *gains]
        )
    return aligned(rows)


def html_of(found: Comparison) -> str:
    """Returns the page of all cases as tables of HTML, one after another, and
    the ranking of more than three plants as text."""
    if len(found.plants) > _PLANTS:
        return f"<pre>{html.escape(page_of(found))}</pre>"
    parts = [f"<p>{html.escape(_head(found))}</p>"]
    for case, name in enumerate(found.cases):
        head, *rows = _numbers_table(found, case, _shown(found, False))
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
    parts.append(f"<p>{html.escape(_notes(found, True))}</p>")
    return "".join(parts)


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
    for begin in range(0, len(found.cases), _CASES):
        cases = range(len(found.cases))[begin : begin + _CASES]
        lines += ["", *_ranks_table(found, name, cases, order)]
    return [*lines, "", *_reliability(found, name)]


def _order(
    found: Comparison, name: str, case: int | None
) -> NDArray[np.int64]:
    means = found.means(name)
    by = means.mean(1) if case is None else means[:, case]
    return np.argsort(by if name in found.minimised else -by, kind="stable")


def _ranks_table(
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


def told(figure: Estimate | None, has_sign: bool = False) -> str:
    """Returns a number with half of its 95 % interval; an exact number has no
    interval."""
    if figure is None or not math.isfinite(figure.mean):
        return "–"
    text = figure.interval_text()
    if has_sign and figure.standard_error == 0:
        text = f"{figure.mean:.2f}"
    is_plus = has_sign and figure.mean > 0 and text.strip("0.") != ""
    return f"+{text}" if is_plus else text


def number_of(quantity: Quantity, figure: Estimate | None) -> str:
    """Returns a number of a quantity, or the name that the number counts."""
    if figure is None or not quantity.names:
        return told(figure)
    place = int(figure.mean)
    return quantity.names[place - 1] if place > 0 else "–"


def title_of(quantity: Quantity) -> str:
    """Returns the words of a quantity, with its unit."""
    unit = unit_label(quantity.unit)
    return words(quantity.name) + ("" if unit == "1" else f" [{unit}]")


def aligned(rows: Sequence[Sequence[str]]) -> list[str]:
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
