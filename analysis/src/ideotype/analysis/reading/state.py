# SPDX-License-Identifier: Apache-2.0
"""The state of a case, and what is kept of its generations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .file import Writer
from .quantity import Quantity


@dataclass(frozen=True)
class State:
    """The state of a case."""

    writer: Writer
    finished: bool
    reason: str
    """The reason why it finished, such as "generations"."""
    wall_time: float
    """The time of all sessions, as far as they reported [s]."""

    def __str__(self) -> str:
        if self.finished:
            return f"finished ({self.reason})"
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
    """The time when it started, UTC in ISO 8601."""
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
    """The number of rows of a generation, which stand one after the other."""
    best_row: NDArray[np.int64]
    """The row of the best; -1: none."""
    best: Quantity
    mean: Quantity
    """The mean over the rows that keep all constraints, once there is one; its
    standard error is not stored."""
    spread: Quantity
    """The standard deviation over the same rows."""
    diversity: Quantity
    """The mean over the free genes of standard deviation over range."""
    failures: NDArray[np.int64]
    evaluations: NDArray[np.int64]
    """The number of rows that were evaluated, and not copied from one with the
    same genome."""
    wall_time: Quantity
    """The time since the case began, in all sessions [s]."""
    hypervolume: Quantity | None = None
    """The hypervolume that the front dominates, for several objectives
    only."""

    def __len__(self) -> int:
        return len(self.best_row)
