# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype` of the Python package, which answers its own verbs and
leaves the others to the compiled program."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

_TEXT = Path(__file__).with_name("verbs.txt").read_text()
_ROWS = [line.split(maxsplit=2) for line in _TEXT.splitlines()]
VERBS = {name: function for name, function, _ in _ROWS}
"""The module and function of each verb. A function takes the words after the
verb and returns the exit code; the compiled program has the same file."""

_HANDED = "IDEOTYPE_HANDED"
"""The environment variable that marks a program by which this command has
replaced itself."""


def answer(words: Sequence[str]) -> int:
    """Runs the verb that is the first word and returns its exit code."""
    module, function = VERBS[words[0]].split(":")
    return getattr(import_module(module), function)(words[1:])


def main() -> int:
    """Answers the command line, or replaces this process by the compiled
    program, which answers it."""
    words = sys.argv[1:]
    if words and words[0] in VERBS:
        return answer(words)
    # A script on PATH may lead back to this command.
    if (program := compiled_program()) and not os.environ.get(_HANDED):
        os.execve(program, [program, *words], os.environ | {_HANDED: "1"})
    is_help = words in (["--help"], ["-h"])
    print(
        f"ideotype: only {', '.join(VERBS)} can be answered here; other verbs "
        "need the compiled program, which neither $IDEOTYPE_EXECUTABLE nor "
        "the PATH has; ./quickstart.sh in the folder of the sources builds it",
        file=sys.stdout if is_help else sys.stderr,
    )
    return 0 if is_help else 2


def compiled_program() -> str | None:
    """Finds the first `ideotype` on PATH that is not a Python command."""
    named = os.environ.get("IDEOTYPE_EXECUTABLE")
    folders = os.get_exec_path()
    for path in [*filter(None, [named]), *(f"{f}/ideotype" for f in folders)]:
        if os.access(path, os.X_OK) and Path(path).is_file():
            with open(path, "rb") as file:
                head = file.read(256)
            if not (head.startswith(b"#!") and b"python" in head):
                return path
    return None


if __name__ == "__main__":
    sys.exit(main())
