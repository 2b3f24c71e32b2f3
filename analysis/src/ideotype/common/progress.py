# SPDX-License-Identifier: Apache-2.0
"""A progress bar for terminals."""

from __future__ import annotations

import shutil
import sys
import time
from threading import Lock
from typing import Self, TextIO


class Progress:
    """A progress bar that fits the width of the terminal and disappears at the
    end. Nothing is written if the stream is no terminal."""

    def __init__(self, participle: str, stream: TextIO | None = None) -> None:
        """Begins a bar. participle: word for finished steps, such as
        "drawn"."""
        self._participle = participle
        self._stream = stream or sys.stderr
        self._is_shown = self._stream.isatty()
        self._started = time.monotonic()
        self._lock = Lock()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._write("")

    def show(self, done: int, count: int, about: str = "") -> None:
        """Shows the number of finished steps, `done` of `count`, and the name
        of the present step."""
        spent = time.monotonic() - self._started
        left = spent / done * (count - done) if done else 0
        self._write(
            bar(
                done, count, f"{done} of {count} {self._participle}", left, about,
                shutil.get_terminal_size().columns - 1,
            )
        )  # fmt: skip

    def _write(self, text: str) -> None:
        if not self._is_shown:
            return
        with self._lock:
            self._stream.write(f"\r\x1b[K{text}")
            self._stream.flush()


def bar(
    done: int, count: int, words: str, left: float, about: str, columns: int
) -> str:
    """Returns a line of at most the given number of columns: a bar, words, the
    remaining seconds and the present step, which is left out first."""
    if left >= 1:
        words += f", {int(left) // 60}:{int(left) % 60:02} left"
    whole = f"{words}  {about}" if about else words
    label = whole if len(whole) + 12 <= columns else words
    width = min(columns - len(label) - 3, 40)
    if width < 5:
        return label[:columns]
    full = round(width * done / max(count, 1))
    return f"[{'#' * full}{'.' * (width - full)}] {label}"
