# SPDX-License-Identifier: Apache-2.0
"""What goes wrong, with messages that are meant for the user."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple


class Error(Exception):
    """What could not be done, why, and what to do."""


class Problem(NamedTuple):
    """One thing that is wrong with an input; line and column count from 1,
    0 where they are not known."""

    file: str
    line: int
    column: int
    what: str


class InputError(Error):
    """Every problem of an input, found in one pass."""

    def __init__(
        self,
        message: str,
        problems: Sequence[tuple[str, int, int, str]] = (),
    ) -> None:
        super().__init__(message)
        self.problems = tuple(Problem(*each) for each in problems)
