# SPDX-License-Identifier: Apache-2.0
"""Describes the differences of the best plant from the baseline in words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.labels import unit_label, words
from ..history.case import Case
from ..history.genes import Genes

_DIRECTIONS = {
    "leaf.length": ("shorter", "longer"),
    "leaf.width": ("narrower", "wider"),
    "leaf.insertion_angle": ("more erect", "more horizontal"),
    "leaf.azimuth": ("anticlockwise", "clockwise"),
    "leaf.curvature": ("straighter", "more curved"),
    "leaf.insertion_height": ("lower", "higher"),
    "leaf.internode": ("shorter", "longer"),
    "leaf.petiole_length": ("shorter", "longer"),
    "leaf.petiole_angle": ("more erect", "more horizontal"),
    "stalk.height": ("shorter", "taller"),
    "stalk.base_diameter": ("thinner", "thicker"),
    "stalk.top_diameter": ("thinner", "thicker"),
}
"""The words for less and more of a measure on which a trait acts."""

_OTHER = ("lower", "higher")
_EFFECTS = ("sets", "scales", "shifts")
_ONE_WAY = 0.9
"""The net change over the mean size of changes above which leaves change in
one direction."""


@dataclass(frozen=True)
class TraitChange:
    """The difference of the best plant from the baseline in one trait."""

    trait: str
    size: float
    """The mean size of the difference over the range of the trait."""
    text: str
    """The difference in words, such as "29 % shorter"."""

    def __str__(self) -> str:
        return f"{words(self.trait).removesuffix(' profile')} ({self.text})"


def find_direction_words(case: Case, trait: str) -> tuple[str, str]:
    """Returns the words for less and more of a trait."""
    baseline = case.resolved.get("plant", {}).get("baseline", {})
    declared: list[dict[str, Any]] = baseline.get("trait", [])
    # In histories before crops declared traits, a trait is a measure of leaves.
    measures = [f"leaf.{trait}"]
    for each in declared:
        if each["name"] == trait:
            measures = [m for e in _EFFECTS for m in each.get(e, [])]
    return next((_DIRECTIONS[m] for m in measures if m in _DIRECTIONS), _OTHER)


def measure_change(case: Case, trait: str) -> TraitChange:
    """Returns the difference of the best plant from the baseline in an
    optimised trait: of an angle in degrees, of other measures in % of the baseline, or
    in their unit if the baseline has none."""
    genes = case.genes
    columns = genes.columns(trait)
    best, baseline = (
        plant.row.genome[0, columns] for plant in (case.best, case.baseline)
    )
    change = best - baseline
    if genes.is_discrete(columns[0]):
        return _measure_step(genes, columns[0], best[0], baseline[0])
    is_circular = bool(genes.is_circular[columns].all())
    if is_circular:
        change = (change + 180) % 360 - 180
    width = (genes.upper - genes.lower)[columns]
    size = float(np.mean(np.abs(change) / width))
    unit = f" {unit_label(genes.units[columns[0]])}".replace(" °", "°")
    if genes.units[columns[0]] != "deg" and baseline.all():
        change, unit = 100 * change / np.abs(baseline), " %"
    text = _in_words(
        change, unit, find_direction_words(case, trait), is_circular
    )
    return TraitChange(trait, size, text)


def _measure_step(
    genes: Genes, gene: int, best: float, baseline: float
) -> TraitChange:
    """Returns the difference in an integer or a choice."""
    if genes.is_choice(gene):
        size = float(best != baseline)
    else:
        width = genes.upper[gene] - genes.lower[gene]
        size = abs(best - baseline) / width
    text = "unchanged"
    if best != baseline:
        text = (
            f"{genes.text(gene, best)} instead of {genes.text(gene, baseline)}"
        )
    return TraitChange(genes.traits[gene], size, text)


def describe_changes(case: Case, traits: Sequence[str]) -> str:
    """Names the two of some traits in which the best plant differs most from
    the baseline, relative to their bounds; "" before both are known."""
    if not case.pairs or not traits:
        return ""
    changes = [measure_change(case, trait) for trait in traits]
    changes.sort(key=lambda change: -change.size)
    largest = " and ".join(map(str, changes[:2]))
    return f"The best plant differs most from the baseline in {largest}."


def _in_words(
    change: NDArray[np.float64],
    unit: str,
    directions: tuple[str, str],
    is_circular: bool,
) -> str:
    mean, net = float(np.abs(change).mean()), float(change.mean())
    if mean == 0:
        return "unchanged"
    average = " on average" if len(change) > 1 else ""
    number = f"{mean:.0f}" if mean >= 1 else f"{mean:.1g}"
    if is_circular:
        return f"turned by {number}{unit}{average}"
    less, more = directions
    if abs(net) > _ONE_WAY * mean:
        return f"{number}{unit} {more if net > 0 else less}{average}"
    return f"{number}{unit}{average}, {less} or {more} depending on the leaf"
