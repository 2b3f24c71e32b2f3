#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Does a breeder need one plant for each case?

cross_table.py CROSS.json

Prints what `ideotype compare PLANT... --under CAMPAIGN --json` found as a table:
the light of plants bred for one case under that of another, in % of what those
take that were bred for it; means of the seeds and their standard errors.
"""

from __future__ import annotations

import json
import math
import re
import sys
from pathlib import Path
from statistics import fmean, stdev


def case_of(plant: str) -> str:
    """The case that a plant was bred for: its name without campaign and seed."""
    return re.sub(r"^.*/|_r\d+$", "", plant)


def cell(values: list[float]) -> str:
    if len(values) == 1:
        return f"{values[0]:+.2f}"
    return (
        f"{fmean(values):+.2f} ± {stdev(values) / math.sqrt(len(values)):.2f}"
    )


def main(path: str) -> None:
    cross = json.loads(Path(path).read_text())
    means: dict[str, list[list[float]]] = {}
    for plant, row in zip(cross["plants"], cross["mean"], strict=True):
        means.setdefault(case_of(plant), []).append(row)
    cases = cross["cases"]
    own = [
        fmean(row[i] for row in means[case]) if case in means else math.nan
        for i, case in enumerate(cases)
    ]
    print(f"| bred for | {' | '.join(cases)} |\n|---|{'---|' * len(cases)}")
    for origin, rows in means.items():
        cells = [
            cell([100 * (row[i] / own[i] - 1) for row in rows])
            for i in range(len(cases))
        ]
        print(f"| {origin} | {' | '.join(cells)} |")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
