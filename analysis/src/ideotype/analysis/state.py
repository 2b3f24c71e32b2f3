# SPDX-License-Identifier: Apache-2.0
"""What becomes of a case, and what is kept of its generations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .file import Writer
from .quantity import Quantity


@dataclass(frozen=True)
class State:
    """Where a case stands."""

    writer: Writer
    finished: bool
    reason: str
    """Why it finished, such as "generations"."""
    wall_time: float
    """Of all sessions, as far as they reported [s]."""

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
    """UTC, ISO 8601."""
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
    """Rows of a generation, which stand one after the other."""
    best_row: NDArray[np.int64]
    """-1: none."""
    best: Quantity
    mean: Quantity
    """Over the rows that keep all constraints, once there is one; its
    standard error is not stored."""
    spread: Quantity
    """Standard deviation over the same rows."""
    diversity: Quantity
    """Mean over the free genes of standard deviation over range."""
    failures: NDArray[np.int64]
    evaluations: NDArray[np.int64]
    """Rows evaluated, not copied from one with the same genome."""
    wall_time: Quantity
    """Since the case began, all sessions [s]."""
    hypervolume: Quantity | None = None
    """What the front dominates; only of several objectives."""

    def __len__(self) -> int:
        return len(self.best_row)
