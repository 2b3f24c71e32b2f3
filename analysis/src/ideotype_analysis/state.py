"""What becomes of a case, and what is kept of its generations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .file import Writer
from .table import Quantity


@dataclass(frozen=True)
class State:
    """Where a case stands."""

    writer: Writer
    finished: bool
    reason: str
    """Why it finished, such as "generations"."""
    wall_time: float
    """Of all sessions, as far as they reported [s]."""
    missing_bytes: int
    """By how much the file is shorter than it says."""

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


@dataclass(frozen=True)
class Generations:
    """Committed generations, from the first. Fitness in the unit of the
    first objective."""

    best_slot: NDArray[np.int64]
    best: Quantity
    """Highest fitness, with its standard error."""
    mean: Quantity
    """Mean fitness of all that did not fail; its standard error is not
    stored."""
    spread: Quantity
    """Standard deviation of the fitness of all that did not fail."""
    diversity: Quantity
    """Mean over the free genes of standard deviation over range."""
    failures: NDArray[np.int64]
    evaluations: NDArray[np.int64]
    """Rows evaluated, not copied from a twin."""
    wall_time: Quantity
    """Since the case began, all sessions [s]."""

    def __len__(self) -> int:
        return len(self.best_slot)
