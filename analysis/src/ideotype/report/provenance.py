# SPDX-License-Identifier: Apache-2.0
"""The origin of a report: histories, programs, commands and campaigns."""

from __future__ import annotations

import math
from collections.abc import Sequence
from datetime import timedelta

from ..history.case import Case
from ..history.history import History
from .blocks import Block, Listing, Table
from .tables import UNKNOWN

_PROVENANCE = (
    ("campaign", "campaign"),
    ("campaign hash", "campaign_sha256"),
    ("seed", "seed"),
    ("program", "program_version"),
    ("commit", "git_sha"),
    ("uncommitted changes", "git_dirty"),
    ("ISA", "isa"),
    ("compiler", "compiler"),
    ("Embree", "embree_version"),
    ("created", "created"),
)
_DIGITS = 12
"""The number of digits of a hash that are shown."""


def tabulate_provenance(cases: Sequence[Case]) -> list[Block]:
    """Returns the origin of the figures: a row per history, the commands, and
    the campaigns with all defaults."""
    histories = [h for case in cases for h in case.histories]
    header = (
        "file",
        "state",
        *[title for title, _ in _PROVENANCE],
        "wall time",
    )
    rows = [_make_row(history) for history in histories]
    starts = [
        (h.path.name, s.started, s.host, str(s.ranks), s.command)
        for h in histories
        for s in h.sessions()
    ]
    blocks: list[Block] = [
        Table(header, rows, "Histories"),
        Table(
            ("file", "started (UTC)", "host", "ranks", "command"),
            starts,
            "Sessions",
            has_long_cells=True,
        ),
    ]
    shown: set[str] = set()
    for history in histories:
        name = str(history.attributes.get("campaign", history.path.stem))
        text = history.campaign("resolved")
        if text not in shown:
            shown.add(text)
            title = f"Campaign {name} with all defaults"
            blocks.append(Listing(title, text))
    return blocks


def _make_row(history: History) -> list[str]:
    has = history.attributes
    cells = [str(has.get(key, UNKNOWN)) for _, key in _PROVENANCE]
    state = history.state()
    seconds = state.wall_time
    return [
        history.path.name,
        str(state),
        *[
            cell[:_DIGITS] if key in ("campaign_sha256", "git_sha") else cell
            for cell, (_, key) in zip(cells, _PROVENANCE)
        ],
        str(timedelta(seconds=round(seconds)))
        if math.isfinite(seconds)
        else "unknown",
    ]
