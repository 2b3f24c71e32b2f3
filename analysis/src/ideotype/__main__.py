# SPDX-License-Identifier: Apache-2.0
"""The executable `ideotype` of the Python package. It runs the commands of the
package and passes all others to the compiled program."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

_TEXT = Path(__file__).with_name("commands.txt").read_text()
_ROWS = [line.split(maxsplit=2) for line in _TEXT.splitlines()]
COMMANDS = {name: function for name, function, _ in _ROWS}
"""The module and function of each command. A function takes the words after
the command and returns the exit code. The compiled program reads the same
file."""

_HANDED = "IDEOTYPE_HANDED"
"""Set in the environment when the program has replaced this process."""


def answer(words: Sequence[str]) -> int:
    """Runs the command named by the first word and returns its exit code."""
    module, function = COMMANDS[words[0]].split(":")
    return getattr(import_module(module), function)(words[1:])


def main() -> int:
    """Runs a command of the package, or replaces this process by the compiled
    program."""
    words = sys.argv[1:]
    if words and words[0] in COMMANDS:
        return answer(words)
    # A script on PATH may lead back to this executable.
    if (program := compiled_program()) and not os.environ.get(_HANDED):
        os.execve(program, [program, *words], os.environ | {_HANDED: "1"})
    is_help = words in (["--help"], ["-h"])
    print(
        f"ideotype: only {', '.join(COMMANDS)} are available; other commands "
        "need the compiled program, which is neither $IDEOTYPE_EXECUTABLE nor "
        "on the PATH; ./quickstart.sh in the source folder builds it",
        file=sys.stdout if is_help else sys.stderr,
    )
    return 0 if is_help else 2


def compiled_program() -> str | None:
    """Returns the path of the compiled program: $IDEOTYPE_EXECUTABLE, or the
    first `ideotype` on PATH that is no Python script; None if there is
    none."""
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
