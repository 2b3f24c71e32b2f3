# SPDX-License-Identifier: Apache-2.0
"""The state of a case, its sessions and the summaries of its generations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .file import Writer
from .quantity import Quantity

_REASONS = {
    "generations": "reached stop.generations",
    "room": "reached stop.generations",
    "evaluations": "reached stop.evaluations",
    "wall_time": "reached stop.wall_time",
    "no_gain": "gained no more, by stop.no_gain",
    "gain_left": "expected too little further gain, by stop.gain_left",
}
"""The reasons for the end of a search in words. An optimiser with generations
of varying size may fill its file ("room") before the number of generations is
reached."""


@dataclass(frozen=True)
class State:
    """The state of a case."""

    writer: Writer
    finished: bool
    reason: str
    """The reason for the end of the case, such as "generations"."""
    wall_time: float
    """The time of all sessions up to their last report [s]."""

    def __str__(self) -> str:
        if self.finished:
            return f"finished ({_REASONS.get(self.reason, self.reason)})"
        return {
            Writer.WRITING: "running",
            Writer.CLOSED: "stopped; resume it with ideotype run --resume",
            Writer.GONE: (
                "interrupted; its writer was killed, or runs on a machine "
                "whose locks are not visible here"
            ),
        }[self.writer]


@dataclass(frozen=True)
class Session:
    """One run of the program on this history."""

    started: str
    """The start of the session, UTC in ISO 8601."""
    host: str
    command: str
    ranks: int
    program: str
    compiler: str
    libraries: str


@dataclass(frozen=True)
class Generations:
    """The committed generations, from the first; values are those of the first
    objective."""

    first_row: NDArray[np.int64]
    count: NDArray[np.int64]
    """The number of rows of each generation; rows are consecutive."""
    best_row: NDArray[np.int64]
    """The row of the best plant of each generation; -1 if there is none."""
    best: Quantity
    mean: Quantity
    """The mean over the rows that meet all constraints; its standard error is
    not stored."""
    spread: Quantity
    """The standard deviation over the rows that meet all constraints."""
    diversity: Quantity
    """The standard deviation relative to the range, averaged over free
    genes."""
    failures: NDArray[np.int64]
    evaluations: NDArray[np.int64]
    """The number of evaluated rows; rows copied from an equal genome do not
    count."""
    wall_time: Quantity
    """The time since the case began, in all sessions [s]."""
    hypervolume: Quantity | None = None
    """The hypervolume dominated by the Pareto front; only for several
    objectives."""

    def __len__(self) -> int:
        return len(self.best_row)
