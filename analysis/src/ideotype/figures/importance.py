# SPDX-License-Identifier: Apache-2.0
"""Draws the importance of the traits of the best plant."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

from ..history.case import Case
from ..history.estimate import NORMAL, Estimate
from . import style


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
