#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flips single bits of a finished history and looks at what readers make of it.

    flip.py IDEOTYPE FILE.h5 [FLIPS] [SEED]

Each copy is read by `ideotype verify`, `ideotype status`, `ideotype export
--generations` and `ideotype-summary` (run with this Python), each within a minute. A flip is
noticed if one of them fails or warns, harmless if all say what they say of the
original, and silent if one says something else without a word. None may hang.
"""

from __future__ import annotations

import collections
import random
import subprocess
import sys
import tempfile
from pathlib import Path

LIMIT = 60  # [s]
_SUMMARY = "import sys, ideotype.analysis.commands as c; sys.exit(c.summary())"


def said_of(ideotype: str, path: Path, folder: Path) -> tuple[str, str] | str:
    """What all readers say of a history, and their warnings; or why not."""
    table = folder / "all.csv"
    table.unlink(missing_ok=True)
    readers = (
        [ideotype, "verify", str(path)],
        [ideotype, "status", str(path)],
        [ideotype, "export", str(path), "--generations", "--to", str(table)],
        [sys.executable, "-c", _SUMMARY, str(path)],
    )
    text, warnings = "", ""
    for reader in readers:
        try:
            done = subprocess.run(
                reader,
                capture_output=True,
                text=True,
                errors="replace",
                check=False,
                timeout=LIMIT,
            )
        except subprocess.TimeoutExpired:
            return "hangs"
        if done.returncode != 0:
            return "noticed" if done.returncode > 0 else "crashes"
        text += done.stdout
        warnings += done.stderr
    return text + table.read_text(errors="replace"), warnings


def main() -> None:
    ideotype, original = sys.argv[1], Path(sys.argv[2])
    flips = int(sys.argv[3]) if len(sys.argv) > 3 else 100
    seed = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    content = original.read_bytes()
    chosen = random.Random(seed)
    counts: collections.Counter[str] = collections.Counter()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        path = folder / original.name
        path.write_bytes(content)
        whole = said_of(ideotype, path, folder)
        if isinstance(whole, str):
            sys.exit(f"{original}: {whole}")
        for _ in range(flips):
            place, bit = chosen.randrange(len(content)), chosen.randrange(8)
            damaged = bytearray(content)
            damaged[place] ^= 1 << bit
            path.write_bytes(damaged)
            said = said_of(ideotype, path, folder)
            if not isinstance(said, str):
                silent = "silent" if said[0] != whole[0] else "harmless"
                said = "noticed" if said[1] != whole[1] else silent
            counts[said] += 1
            if said in ("hangs", "crashes"):
                print(f"byte {place}, bit {bit}: {said}", flush=True)
    print(f"{flips} flips (seed {seed}): {dict(sorted(counts.items()))}")


if __name__ == "__main__":
    main()
