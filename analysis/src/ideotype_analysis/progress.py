"""How far long work has come."""

from __future__ import annotations

import sys
from typing import TextIO


class Progress:
    """On a terminal one live line; in a log a line per part."""

    def __init__(self, total: int, stream: TextIO | None = None) -> None:
        self._total = total
        self._stream = stream if stream is not None else sys.stderr
        self._is_live = self._stream.isatty()
        self._part = 0
        self._name = ""

    def part(self, name: str) -> None:
        """The next part begins."""
        self._part += 1
        self._name = name
        self._show("" if self._is_live else "\n", "")

    def step(self, detail: str) -> None:
        """Something within the part; only a terminal shows it."""
        if self._is_live:
            self._show("", f" {detail}")

    def done(self) -> None:
        """Leaves a clean line."""
        if self._is_live:
            self._stream.write("\r\x1b[K")
            self._stream.flush()

    def _show(self, end: str, detail: str) -> None:
        start = "\r\x1b[K" if self._is_live else ""
        line = f"[{self._part}/{self._total}] {self._name}{detail}"
        self._stream.write(
            start + (line[:78] if self._is_live else line) + end
        )
        self._stream.flush()
