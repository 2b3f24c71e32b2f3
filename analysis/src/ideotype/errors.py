# SPDX-License-Identifier: Apache-2.0
"""Errors with messages for the user."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches
from typing import NamedTuple

_CONTROLS = {i: f"\\x{i:02x}" for i in (*range(32), *range(127, 160))}
_CONTROLS_OF_LINES = _CONTROLS | {ord(c): c for c in "\n\t"}


def printable(text: str) -> str:
    """Returns a text of unknown origin as one line that cannot harm a
    terminal: control characters become \\x1b and the like."""
    return text.translate(_CONTROLS)


def printable_lines(text: str) -> str:
    """Returns a text of unknown origin for a terminal with its lines and tabs;
    other control characters become \\x1b and the like."""
    return text.translate(_CONTROLS_OF_LINES)


class Error(Exception):
    """An error; its message states the failure, the cause and the remedy."""


class NotCompiled(Error, ImportError):
    """The error raised if the installation lacks the compiled module."""


class Problem(NamedTuple):
    """One problem of an input. Lines and columns count from 1; 0 means
    unknown. `what` describes the problem. `key` is the path of the key in a
    campaign or crop file, such as "spacing.row", or "" if no key is concerned.
    `code` is the kind of problem, as in `ideotype check --json`."""

    file: str
    line: int
    column: int
    what: str
    key: str = ""
    code: str = "data"


class InputError(Error):
    """An error with every problem of an input, found in one pass."""

    def __init__(
        self,
        message: str,
        problems: Sequence[tuple[str, int, int, str, str, str]] = (),
    ) -> None:
        super().__init__(message)
        self.problems = tuple(Problem(*fields) for fields in problems)


def did_you_mean(word: str, names: Sequence[str]) -> str:
    """Returns "; did you mean 'x'?", or "" if no name resembles the word."""
    near = get_close_matches(word, names, 1, 0.8)
    return f"; did you mean '{near[0]}'?" if near else ""
