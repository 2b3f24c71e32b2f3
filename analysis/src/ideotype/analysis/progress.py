# SPDX-License-Identifier: Apache-2.0
"""How far long work has come."""

from __future__ import annotations

import sys
from typing import TextIO

from .._errors import printable


class Progress:
    """On a terminal one live line; in a log a line per part."""

    def __init__(self, stream: TextIO | None = None) -> None:
        self._stream = stream if stream is not None else sys.stderr
        self._is_live = self._stream.isatty()
        self._total = 0
        self._part = 0

    def start(self, total: int) -> None:
        """So many parts are to come."""
        self._total = total
        self._part = 0

    def part(self, name: str) -> None:
        """The next part begins."""
        self._part += 1
        line = f"[{self._part}/{self._total}] {printable(name)}"
        self._stream.write(
            f"\r\x1b[K{line[:78]}" if self._is_live else f"{line}\n"
        )
        self._stream.flush()

    def done(self) -> None:
        """Leaves a clean line."""
        if self._is_live:
            self._stream.write("\r\x1b[K")
            self._stream.flush()
