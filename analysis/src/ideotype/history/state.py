# SPDX-License-Identifier: Apache-2.0
"""The state of a case, and the summaries of its generations."""

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
}
"""The reasons for an end in words, as in the state of a file. An optimiser with
generations of changing sizes may fill the room of its file before the number
of generations is reached."""


@dataclass(frozen=True)
class State:
    """The state of a case."""

    writer: Writer
    finished: bool
    reason: str
    """The reason why the case finished, such as "generations"."""
    wall_time: float
    """The time of all sessions up to their last report [s]."""

    def __str__(self) -> str:
        if self.finished:
            return f"finished ({_REASONS.get(self.reason, self.reason)})"
        return {
            Writer.WRITING: "running",
            Writer.CLOSED: "stopped; ideotype run --resume goes on with it",
            Writer.GONE: (
                "interrupted; its writer was killed, or runs where this "
                "machine can't see it"
            ),
        }[self.writer]


@dataclass(frozen=True)
class Session:
    """One start of the program on this history."""

    started: str
    """The time when the session started, UTC in ISO 8601."""
    host: str
    command: str
    ranks: int
    program: str
    compiler: str
    libraries: str


@dataclass(frozen=True)
class Generations:
    """Committed generations, from the first. Values are those of the first
    objective."""

    first_row: NDArray[np.int64]
    count: NDArray[np.int64]
    """The number of rows of each generation; rows are consecutive."""
    best_row: NDArray[np.int64]
    """The row of the best plant of each generation; -1: none."""
    best: Quantity
    mean: Quantity
    """The mean over the rows that meet all constraints, if there is such a
    row; the standard error of the mean is not stored."""
    spread: Quantity
    """The standard deviation over the rows that meet all constraints."""
    diversity: Quantity
    """The mean over the free genes of standard deviation over range."""
    failures: NDArray[np.int64]
    evaluations: NDArray[np.int64]
    """The number of rows that were evaluated, and not copied from a row with
    an equal genome."""
    wall_time: Quantity
    """The time since the case began, in all sessions [s]."""
    hypervolume: Quantity | None = None
    """The hypervolume that the front dominates; only for several
    objectives."""

    def __len__(self) -> int:
        return len(self.best_row)
