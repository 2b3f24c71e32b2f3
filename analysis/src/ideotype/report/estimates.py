# SPDX-License-Identifier: Apache-2.0
"""The gain of an optimised plant under draws of the estimates of its crop:
plant and baseline are re-evaluated with each draw, in the same light."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import Error, InputError
from ..history.case import Case
from .blocks import Fact, Note
from .organ_split import evaluate_pair

if TYPE_CHECKING:
    from ..calibration.parameters import Parameter

DRAWS = 20


@dataclass(frozen=True)
class DrawnGains:
    """Gains of the best plant of a case over the baseline in its first
    objective."""

    gains: list[float]
    """The gain in each draw [% of the baseline]."""
    parameters: int
    """The number of drawn parameters."""


def evaluate_draws(
    case: Case, parameters: Sequence[Parameter], draws: int = DRAWS
) -> DrawnGains | Note | None:
    """Evaluates the best plant of a case and the baseline under draws of the
    prior of parameters, as finalists are evaluated. All draws have the random
    numbers of the history, so that only the parameters differ.

    Returns None if the search has not ended, and the reason if the plants
    cannot be evaluated."""
    if case.is_sensitivity or not case.pairs or not case.best_pair.is_final:
        return None
    z = np.random.default_rng(1).normal(size=(draws, len(parameters)))
    try:
        # A report without draws needs no compiled module, which this imports.
        from ..calibration.parameters import values_at

        gains = [
            _gain(case, parameters, values)
            for values in values_at(parameters, z)
        ]
    except (Error, InputError) as reason:
        return Note(
            f"The gain of {case.name} with other estimates is not known: "
            f"{reason}."
        )
    return DrawnGains(gains, len(parameters))


def _gain(
    case: Case, parameters: Sequence[Parameter], values: np.ndarray
) -> float:
    from ..calibration.parameters import settings_at
    from ..validation.comparison import change_settings

    crop = case.best_history.resolved["plant"]["baseline"]
    settings = change_settings(settings_at(parameters, values), crop)
    baseline, best = evaluate_pair(case, settings).mean(axis=1)
    sign = case.best.row.goals[0].sign
    return float(sign * 100 * (best - baseline) / abs(baseline))


def describe_drawn(
    drawn: Mapping[str, DrawnGains | Note],
) -> list[Fact]:
    """Returns the range of gains over the draws of all cases; nothing without
    draws."""
    known = [x for x in drawn.values() if isinstance(x, DrawnGains)]
    if not known:
        return []
    gains = np.concatenate([x.gains for x in known])
    low, high = (
        f"{x:+.1f}".replace("-", "\N{MINUS SIGN}")
        for x in (gains.min(), gains.max())
    )
    cases = f" in {len(known)} cases" if len(known) > 1 else ""
    return [
        Fact(
            "gain if the crop's estimates were off by their stated errors",
            f"{low} to {high} % ({len(known[0].gains)} draws of "
            f"{known[0].parameters} estimates{cases})",
        )
    ]
