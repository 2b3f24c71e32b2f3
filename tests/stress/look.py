# SPDX-License-Identifier: Apache-2.0
"""Reads the history of a killed run like a reader of the analysis.

look.py WHOLE KILLED REPORTED: WHOLE is the history of an uninterrupted run and
REPORTED the number of generations that the killed one's log reported.
Exit codes: 0 all is well, 1 unreadable, 3 a row differs, 4 a row is lost."""

from __future__ import annotations

import sys

import numpy as np

from ideotype.history import Rows, open_history


def values(rows: Rows) -> list[np.ndarray]:
    """Returns all numbers of complete rows, which no kill may change."""
    arrays = [
        rows.row,
        rows.generation,
        rows.status,
        rows.parents,
        rows.genome,
        rows.objectives,
        rows.objectives_standard_error,
        rows.randomisations,
        rows.violation,
    ]
    for quantity in rows.quantities.values():
        arrays += [quantity.values, quantity.standard_error]
    return arrays


def main() -> int:
    whole_path, killed_path, reported = sys.argv[1:]
    with (
        open_history(whole_path) as whole,
        open_history(killed_path) as killed,
    ):
        expected, kept = whole.evaluations(), killed.evaluations()
        count = whole.generations().count
        committed = len(killed.generations())
    if len(kept) < max(int(reported), count[:committed].sum()):
        print(f"lost: {len(kept)} rows, {reported} plants reported")
        return 4
    same = values(expected.take(kept.row))
    for a, b in zip(same, values(kept), strict=True):
        if a.tobytes() != b.tobytes():
            print("a row differs from that of the uninterrupted run")
            return 3
    return 0


sys.exit(main())
