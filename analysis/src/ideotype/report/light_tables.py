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
from .tables import UNKNOWN, format_bare


def tabulate_organs(cases: Sequence[Case]) -> list[Table]:
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
            "PAR absorbed by organs other than leaves, in % of incident PAR.",
        )
    ]


def _percent(share: Interval | None) -> str:
    if share is None:
        return UNKNOWN
    return format_bare(share.scaled(100, "%"))


def describe_balance(cases: Sequence[Case]) -> Note:
    """States the error of the light balance."""
    errors = [
        abs(pair_member.estimate("balance_error").mean)
        for case in cases
        for pair in case.pairs
        for pair_member in (pair.baseline, pair.best)
        if "balance_error" in pair_member.row.quantities
    ]
    if not errors:
        return Note("The histories have no error of the light balance.")
    return Note(
        "Light balance: light absorbed by leaves, other organs and soil, and "
        "reflected light, add up to incident light; the largest relative "
        f"deviation of all plants shown is {np.max(errors):.1g}."
    )
