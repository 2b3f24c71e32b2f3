# SPDX-License-Identifier: Apache-2.0
"""Tables of the light that organs other than leaves absorb, and of the balance
of light."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..common.labels import words
from ..history.case import Case
from ..history.interval import Interval
from .blocks import Note, Table
from .tables import UNKNOWN, bare


def organs(cases: Sequence[Case]) -> list[Table]:
    """Tabulates the light that organs other than leaves absorb, if histories
    have it."""
    plants = [
        (f"{case.name} {who}", case.light_by_organ(who))
        for case in cases
        if case.pairs
        for who in ("baseline", "best")
    ]
    names = list(dict.fromkeys(name for _, parts in plants for name in parts))
    if names == ["stalk"]:
        return []
    rows = [
        [plant, *(_percent(parts.get(name)) for name in names)]
        for plant, parts in plants
    ]
    return [
        Table(
            ("plant", *map(words, names)),
            rows,
            "PAR that organs other than leaves absorb, in % of the incident.",
        )
    ]


def _percent(share: Interval | None) -> str:
    if share is None:
        return UNKNOWN
    return bare(share.scaled(100, "%"))


def balance(cases: Sequence[Case]) -> Note:
    """Tabulates the error of the balance of light."""
    errors = [
        abs(pair_member.estimate("balance_error").mean)
        for case in cases
        for pair in case.pairs
        for pair_member in (pair.baseline, pair.best)
        if "balance_error" in pair_member.row.quantities
    ]
    if not errors:
        return Note("The histories do not say how well the balance closes.")
    return Note(
        "Leaves, other organs, soil and reflected light add up to the light "
        "that enters; the largest deviation of all plants shown is "
        f"{np.max(errors):.1g} of it."
    )
