# SPDX-License-Identifier: Apache-2.0
"""Are the standard errors of a history those that its rows have?

row_errors.py PROGRAM HISTORY [ROWS] [TOLERANCE]: takes ROWS (50) finished rows at
random and lets PROGRAM, an ideotype executable, look at each again, in the same
field to a relative standard error of TOLERANCE (1e-4). The root mean square of the
deviations should be that of the standard errors."""

from __future__ import annotations

import json
import subprocess
import sys

import numpy as np

from ideotype.analysis import open_history


def main(
    program: str, path: str, count: str = "50", tolerance: str = "1e-4"
) -> None:
    with open_history(path) as history:
        rows = history.evaluations().done
    chosen = np.random.default_rng(1).choice(
        len(rows), int(count), replace=False
    )
    was, deviations, left = [], [], []
    for index in chosen:
        words = [
            f"--generation={rows.generation[index]}",
            f"--slot={rows.slot[index]}",
            f"--tolerance={tolerance}",
            "--json",
        ]
        answer = subprocess.run(
            [program, "evaluate", path, *words],
            check=True,
            capture_output=True,
        )
        row = json.loads(answer.stdout)["row"]
        was.append(row["was"]["standard_error"] / row["was"]["mean"])
        left.append(row["is"]["standard_error"] / row["is"]["mean"])
        deviations.append(row["was"]["mean"] / row["is"]["mean"] - 1)
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
    if not 3 <= len(sys.argv) <= 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
