# SPDX-License-Identifier: Apache-2.0
"""Measures the importance of the traits of the best plant by changing one
trait at a time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

import ideotype

from ..case import Case
from ..reading.estimate import NORMAL, Estimate
from ..reading.genes import Genes
from . import style

_GENERATIONS = 16
"""The number of generations in whose fields plants are compared, with random
numbers that the search has not used."""

_OF_GROWING = 4
"""The number of generations for plants that grow, which have separate fields
at each stage."""

_FIRST = 1_000_000
"""The number of the first generation in which plants are compared."""

_STEP = 0.1
"""The relative change of a trait that is no angle."""

_TURN = 10.0
"""The change of an angle [deg]."""


@dataclass(frozen=True)
class Change:
    """The loss of the best plant if a trait is changed, in % of the baseline's
    objective; positive if the changed plant is worse."""

    trait: str
    back: Estimate
    """The loss with the trait of the baseline."""
    off: Estimate
    """The loss with the trait 10 % or 10 deg larger or smaller, whichever is
    worse."""


def changes_of(case: Case, threads: int = 1) -> list[Change]:
    """Evaluates the best plant of a case with each bred trait changed, in the
    same fields and light as the best plant and the baseline. Returns the
    traits whose return to the baseline costs most first; errors are paired.

    Raises Error if there is no compiled module, or the module cannot use the
    history."""
    best = case.best.row.genome[0]
    baseline = case.baseline.row.genome[0]
    genes = case.genes
    traits = [
        trait
        for kind in ("leaf", "profile", "plant")
        for trait in genes.bred(kind)
    ]
    plants = [baseline, best]
    for trait in traits:
        columns = genes.columns(trait)
        plants += [
            _with(best, columns, baseline[columns]),
            *(
                _with(best, columns, _moved(genes, columns, best, sign))
                for sign in (1, -1)
            ),
        ]
    grows = "day_of_stage" in case.best.row.quantities
    values = _evaluate(
        case.best_history.path,
        np.array(plants),
        _OF_GROWING if grows else _GENERATIONS,
        threads,
    )
    sign = case.best.row.goals[0].sign
    scale = 100 / abs(values[0].mean())
    losses = sign * scale * (values[1] - values)
    found = []
    for k, trait in enumerate(traits):
        back, *moved = (_mean(each) for each in losses[2 + 3 * k : 5 + 3 * k])
        found.append(Change(trait, back, max(moved, key=lambda x: x.mean)))
    return sorted(found, key=lambda each: -each.back.mean)


def _with(
    genome: NDArray[np.float64],
    columns: NDArray[np.int64],
    numbers: NDArray[np.float64],
) -> NDArray[np.float64]:
    changed = genome.copy()
    changed[columns] = numbers
    return changed


def _moved(
    genes: Genes,
    columns: NDArray[np.int64],
    genome: NDArray[np.float64],
    sign: int,
) -> NDArray[np.float64]:
    """Returns genes changed by 10 deg or 10 %; the percentage is taken of the
    larger of the value and half of the range, since an added number may be
    0."""
    own = genome[columns]
    if genes.units[columns[0]] == "deg":
        step = np.full(len(columns), _TURN)
    else:
        half = (genes.upper - genes.lower)[columns] / 2
        step = _STEP * np.maximum(np.abs(own), half)
    moved = own + sign * step
    if genes.is_circular[columns].all():
        moved = np.mod(moved, 360.0)
    return moved


def _evaluate(
    path: Path,
    plants: NDArray[np.float64],
    generations: int,
    threads: int,
) -> NDArray[np.float64]:
    """Returns the first objective by randomisation [plants,
    randomisations]."""
    stand = ideotype.Stand.from_history(path, same_isa=False)
    found = [
        stand.evaluate(
            plants, [], generation=_FIRST + k, threads=threads
        ).objective_by_randomisation.values[:, 0]
        for k in range(generations)
    ]
    return np.concatenate(found, axis=1)


def _mean(values: NDArray[np.float64]) -> Estimate:
    error = float(values.std(ddof=1)) / np.sqrt(len(values))
    return Estimate(float(values.mean()), error, "%")


def draw_importance(case: Case, changes: Sequence[Change]) -> Figure:
    """Draws the loss of the best plant by each change."""
    figure = style.new_figure(style.WIDTH, 1.4 + 0.5 * len(changes))
    axes = figure.add_subplot()
    for shift, what, color, marker, label in (
        (-0.12, "back", style.BEST, "o", "as the baseline has it"),
        (0.12, "off", style.ANEW, "s", "10 % or 10° off"),
    ):
        found = [getattr(change, what) for change in changes]
        axes.errorbar(
            [x.mean for x in found],
            np.arange(len(changes)) + shift,
            xerr=style.half_width([x.standard_error for x in found]),
            color=color, marker=marker, linestyle="none", label=label,
        )  # fmt: skip
    axes.axvline(0, color=style.BASELINE, linewidth=1, linestyle="--")
    axes.set_yticks(range(len(changes)), [_words(x.trait) for x in changes])
    axes.set_ylim(len(changes) - 0.5, -0.5)
    axes.set_xlabel(
        f"loss of the best plant in {style.words(case.best.row.goals[0].name)}\n"
        "[% of the baseline]"
    )
    figure.legend(loc="outside lower center", ncols=2)
    style.answer(figure, answer_of(changes))
    return figure


def answer_of(changes: Sequence[Change]) -> str:
    """Tells which traits cause the gain, and which traits must be exact."""
    clear = [
        x for x in changes if x.back.mean > NORMAL * x.back.standard_error
    ]
    if not clear:
        return (
            "No single trait: with any of them as in the baseline the best "
            "plant loses no more than the interval."
        )
    makes = " and ".join(
        f"{_words(x.trait)} ({x.back.interval_text()} points)"
        for x in clear[:2]
    )
    worst = max(changes, key=lambda x: x.off.mean)
    return (
        f"{makes[:1].upper()}{makes[1:]} most: that is lost if only this is as in the baseline. "
        f"Most care is due to {_words(worst.trait)}, which costs "
        f"{worst.off.interval_text()} points if it is 10 % or 10° off."
    )


def _words(trait: str) -> str:
    return style.words(trait).removesuffix(" profile")
