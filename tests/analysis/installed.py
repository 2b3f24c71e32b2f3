# SPDX-License-Identifier: Apache-2.0
"""Runs the installed command, as users do."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

BIN = Path(sys.executable).parent


def summary(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Runs the installed command."""
    return _run("summary", *arguments)


def report(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Runs the installed command."""
    return _run("report", *arguments)


def _run(name: str, *arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(BIN / "ideotype"), name, *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
    )
