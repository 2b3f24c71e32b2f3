# SPDX-License-Identifier: Apache-2.0
"""Draws the importance of the traits of the best plant."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

from ..common.labels import title
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
    for shift, attribute, color, marker, label in (
        (-0.12, "back", style.BEST, "o", "set to the baseline"),
        (0.12, "off", style.ACCENT, "s", "changed by 10 % or 10°"),
    ):
        losses = [getattr(change, attribute) for change in changes]
        axes.errorbar(
            [x.mean for x in losses],
            np.arange(len(changes)) + shift,
            xerr=style.half_width([x.standard_error for x in losses]),
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
    style.set_answer(figure, get_answer(changes))
    return figure


def get_answer(changes: Sequence[Change]) -> str:
    """States which traits cause the gain, and which trait is most sensitive."""
    clear = [
        x for x in changes if x.back.mean > NORMAL * x.back.standard_error
    ]
    if not clear:
        return (
            "No single trait has a significant effect when it is set to the "
            "baseline."
        )
    causes = " and ".join(
        f"{_words(x.trait)} ({x.back.interval_text()} percentage points)"
        for x in clear[:2]
    )
    worst = max(changes, key=lambda x: x.off.mean)
    return (
        f"Largest loss if one trait is set to the baseline: {causes}. "
        f"{title(worst.trait.removesuffix('_profile'))} is the most sensitive "
        f"trait: an error of 10 % or 10° costs {worst.off.interval_text()} "
        "percentage points."
    )


def _words(trait: str) -> str:
    return style.words(trait).removesuffix(" profile")
