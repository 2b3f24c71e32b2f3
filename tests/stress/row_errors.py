# SPDX-License-Identifier: Apache-2.0
"""Compares the standard errors of a history with those that its rows have.

row_errors.py HISTORY [ROWS] [TOLERANCE]: takes ROWS (50) finished rows at random
and looks at each again, in the same field to a relative standard error of TOLERANCE
(1e-4). The root mean square of the deviations should be that of the standard errors."""

from __future__ import annotations

import sys

import numpy as np

from ideotype import Stand
from ideotype.history import open_history


def main(path: str, count: str = "50", tolerance: str = "1e-4") -> None:
    with open_history(path) as history:
        rows = history.evaluations().done
    chosen = np.random.default_rng(1).choice(
        len(rows), int(count), replace=False
    )
    stand, name = Stand.from_history(path), rows.goals[0].name
    was, deviations, left = [], [], []
    for index in chosen:
        again = stand.evaluate(
            rows.genome[index],
            [name],
            generation=int(rows.generation[index]),
            tolerance=float(tolerance),
        )
        mean, error = again[name][0], again[f"{name}_standard_error"][0]
        before = rows[name]
        was.append(before.standard_error[index] / before.values[index])
        left.append(float(error / mean))
        deviations.append(float(before.values[index] / mean - 1))
        print(
            f"generation {rows.generation[index]:3} slot {rows.slot[index]:3}: "
            f"{deviations[-1]:+.5f}, standard error {was[-1]:.5f}",
            flush=True,
        )

    def rms(values: list[float]) -> float:
        return float(np.sqrt(np.mean(np.square(values))))

    ratio = rms(deviations) / np.hypot(rms(was), rms(left))
    print(
        f"root mean square of {count} rows: deviation {rms(deviations):.5f}, standard "
        f"error {rms(was):.5f}, of the second look {rms(left):.6f}: ratio {ratio:.2f} "
        f"+- {ratio / np.sqrt(2 * len(chosen)):.2f}"
    )


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
