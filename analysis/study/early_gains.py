#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how soon a search gains most of the best known gain.

early_gains.py FOLDER [--label NAME] [--optimizer NAME] [--objective NAME...]
               [--condition NAME...] [--seeds N] [--evaluations N] [--rough]

Searches the stands of arXiv:2512.06064 (conditions.py) by an optimizer of the
Python package, and stores the plant that it would return after 100 to N
evaluations, with the processor time until then, in FOLDER. Finished searches
are not repeated. To compare versions of the program, run the script with the
package of each version, and give each another --label.

Re-evaluates the plants of all labels in FOLDER with common random numbers.
Prints for each stand and label the gain over the baseline, the mean of the
seeds with its 95 % interval, and by seed the evaluations and core-seconds
after which the search first returned a plant with 80 and 90 % of the largest
gain of all: [%], or in the unit of the objective where the baseline is not
above zero by three standard errors.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from conditions import CONDITIONS, UNITS, campaign
from estimates import (
    Estimate,
    difference,
    gain,
    has_percent,
    mean_over_seeds,
    plus_minus,
    print_table,
)
from shared import (
    guard,
    light,
    parser_of_searches,
    say,
    search_by_package,
)

from ideotype import Stand

CHECKPOINTS = (
    *(100, 150, 200, 300, 400, 500, 700),
    *(1000, 1250, 1500, 2000, 2500),
)
SHOWN = (100, 300, 1000, 2500)
SHARES = (0.8, 0.9)


def first_reached(
    points: Sequence[Any], gains: Sequence[Estimate], least: float
) -> str:
    """Formats the evaluations and core-seconds until a gain is reached."""
    for (evaluations, seconds, _), (mean, _) in zip(
        points, gains, strict=True
    ):
        if mean >= least:
            return f"{evaluations:,} ({seconds:.1f} s)"
    return "-"


def compare(stand: Stand, found: dict[str, list[Any]]) -> list[list[str]]:
    """Returns the rows of a stand. `found` are the points of each seed by
    label, all at the same checkpoints."""
    checkpoints = [point[0] for point in next(iter(found.values()))[0]]
    plants = [x[2] for seeds in found.values() for run in seeds for x in run]
    baseline, *others = light(
        stand, np.array([stand.baseline, *plants])
    ).tolist()
    measure = gain if has_percent(baseline) else difference
    every = iter([measure(baseline, values) for values in others])
    gains = {
        label: [[next(every) for _ in run] for run in seeds]
        for label, seeds in found.items()
    }
    largest = max(
        mean for runs in gains.values() for run in runs for mean, _ in run[-1:]
    )
    rows = []
    for label, runs in found.items():
        cells = []
        for shown in (x for x in SHOWN if x <= checkpoints[-1]):
            at = [one[checkpoints.index(shown)] for one in gains[label]]
            cells.append(plus_minus(mean_over_seeds(at)))
        for share in SHARES:
            reached = [
                first_reached(run, one, share * largest)
                for run, one in zip(runs, gains[label], strict=True)
            ]
            cells.append(", ".join(reached))
        rows.append([label, *cells])
    return rows


def main() -> None:
    parser = parser_of_searches(__doc__, seeds=3, evaluations=2500)
    parser.add_argument("--label", default="auto")
    parser.add_argument("--optimizer", default="auto")
    parser.add_argument(
        "--objective", nargs="+", choices=UNITS, default=list(UNITS)
    )
    parser.add_argument(
        "--condition",
        nargs="+",
        choices=[x.name for x in CONDITIONS],
        default=["all", "15x3"],
    )
    options = parser.parse_args()
    rows = []
    for objective in options.objective:
        for where in CONDITIONS:
            if where.name not in options.condition:
                continue
            tables = campaign(where, objective, options.folder, options.rough)
            stand = Stand(tables)
            found: dict[str, list[Any]] = {}
            for seed in range(1, options.seeds + 1):
                name = f"{tables['name']}_s{seed}_{options.label}.json"
                path: Path = options.folder / name
                if not path.exists():
                    say(f"searching: {path.stem}")
                    points, _ = search_by_package(
                        stand,
                        seed,
                        [x for x in CHECKPOINTS if x <= options.evaluations],
                        options.optimizer,
                    )
                    path.write_text(json.dumps(points))
            begin = f"{tables['name']}_s"
            for path in sorted(options.folder.glob(f"{begin}*.json")):
                label = path.stem.removeprefix(begin).partition("_")[2]
                found.setdefault(label, []).append(
                    json.loads(path.read_text())
                )
            title = f"{objective}, {where.title}"
            rows += [[title, *row] for row in compare(stand, found)]
    titles = [f"{x:,}" for x in SHOWN if x <= options.evaluations]
    titles += [f"evaluations to {share:.0%}" for share in SHARES]
    print_table(["stand", "search", *titles], rows)


if __name__ == "__main__":
    guard(main)
