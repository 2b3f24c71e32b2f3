"""The command ideotype-summary."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from .figures import default_folder, draw_figures
from .file import HistoryError
from .history import open_history
from .summary import summarize


def main(arguments: Sequence[str] | None = None) -> int:
    """Prints a summary, draws the figures, and returns the exit code: 0, 1 if
    the file can't be used, 2 for a wrong command line."""
    options = _parser().parse_args(arguments)
    try:
        _run(options)
    except BrokenPipeError:
        # Whoever read our output has seen enough; nothing is left to flush.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except (HistoryError, OSError) as error:
        print(f"ideotype-summary: {error}", file=sys.stderr)
        return 1
    return 0


def _run(options: argparse.Namespace) -> None:
    with open_history(options.file) as history:
        print(summarize(history), flush=True)
        if options.no_figures:
            return
        folder = options.output or default_folder(options.file)
        drawn = draw_figures(history, folder)
    print()
    for path in drawn.paths:
        print(path)
    for name, reason in drawn.missing.items():
        print(f"{name}: not drawn, {reason}")
    sys.stdout.flush()


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="ideotype-summary",
        description="Prints a summary of a history and draws its figures, "
        "also while it is being written.",
    )
    parser.add_argument("file", type=Path, help="a history (.h5)")
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        metavar="DIR",
        help="folder of the figures (default: FILE without .h5, _figures)",
    )
    parser.add_argument(
        "--no-figures", action="store_true", help="print the summary only"
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
