# SPDX-License-Identifier: Apache-2.0
"""What goes wrong, with messages that are meant for the user."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches
from typing import NamedTuple

_CONTROLS = {i: f"\\x{i:02x}" for i in (*range(32), *range(127, 160))}
_CONTROLS_OF_LINES = _CONTROLS | {ord(c): c for c in "\n\t"}


def printable(text: str) -> str:
    """A text of unknown origin as one line for a terminal, where it can do
    nothing: control characters as \\x1b."""
    return text.translate(_CONTROLS)


def printable_lines(text: str) -> str:
    """As above, of several lines, with tabs."""
    return text.translate(_CONTROLS_OF_LINES)


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


def did_you_mean(word: str, names: Sequence[str]) -> str:
    """ "; did you mean 'x'?", or "" if none is near."""
    near = get_close_matches(word, names, 1, 0.8)
    return f"; did you mean '{near[0]}'?" if near else ""
