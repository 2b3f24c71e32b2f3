#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how soon a search gains most of the best known gain.

early_gains.py FOLDER [--label NAME] [--optimizer NAME | --library NAME]
               [--objective NAME...] [--condition NAME...] [--seeds N]
               [--campaign FILE [--set KEY=VALUE]...] [--evaluations N]
               [--rough]

Searches the stands of arXiv:2512.06064 (conditions.py) by an optimizer of the
Python package, and stores the plant that it would return after 100 to N
evaluations, with the processor time until then, in FOLDER. Finished searches
are not repeated. To compare versions of the program, run the script with the
package of each version, and give each another --label. A search by another
package (libraries.py) starts again for each of 100, 300, 1,000 and N
evaluations, always with the same seed. --campaign searches the first case of a
file instead of these stands, with keys of --set.

Re-evaluates the plants of all labels in FOLDER with common random numbers.
Prints for each stand and label the gain over the baseline, the mean of the
seeds with its 95 % interval, and by seed the evaluations and core-seconds
after which the search first returned a plant with 80 and 90 % of the largest
gain of all: [%], or in the unit of the objective where the baseline is not
above zero by three standard errors.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from conditions import AT_SILKING, CONDITIONS, UNITS, campaign
from estimates import (
    Estimate,
    difference,
    gain,
    has_percent,
    mean_over_seeds,
    plus_minus,
    print_table,
)
from libraries import LIBRARIES
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


def until(most: int, checkpoints: Sequence[int]) -> list[int]:
    """Returns the checkpoints below the last one, and the last one."""
    return [*(x for x in checkpoints if x < most), most]


def stands(
    options: argparse.Namespace,
) -> Iterator[tuple[str, str, Stand]]:
    """Yields the name, the title and the stand of each comparison."""
    if options.campaign:
        name = options.campaign.stem
        yield (
            name,
            " ".join([name, *options.set]),
            Stand.from_campaign(options.campaign, settings=options.set),
        )
        return
    for objective in options.objective:
        for where in CONDITIONS:
            if where.name not in options.condition:
                continue
            tables = campaign(where, objective, options.folder, options.rough)
            title = f"{objective}, {where.title}"
            yield tables["name"], title, Stand(tables)


def search(stand: Stand, seed: int, options: argparse.Namespace) -> list[Any]:
    """Returns the number of evaluations, the processor time [s] and the plant
    at each checkpoint."""
    if not options.library:
        checkpoints = until(options.evaluations, CHECKPOINTS)
        found = search_by_package(stand, seed, checkpoints, options.optimizer)
        return found[0]
    points = []
    for count in until(options.evaluations, SHOWN):
        began = process_time()
        plant = LIBRARIES[options.library](stand, seed, count)
        points.append([count, process_time() - began, plant.tolist()])
    return points


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


def compare(
    stand: Stand, found: dict[str, list[Any]], most: int
) -> list[list[str]]:
    """Returns the rows of a stand up to a number of evaluations. `found` are
    the points of each seed by label."""
    plants = [x[2] for seeds in found.values() for run in seeds for x in run]
    baseline, *others = light(
        stand, np.array([stand.baseline, *plants])
    ).tolist()
    is_percent = has_percent(baseline)
    measure, digits = (gain, 1) if is_percent else (difference, 2)
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
        checkpoints = [point[0] for point in runs[0]]
        for shown in until(most, SHOWN):
            if shown not in checkpoints:
                cells.append("")
                continue
            at = [one[checkpoints.index(shown)] for one in gains[label]]
            cells.append(plus_minus(mean_over_seeds(at), digits))
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
    of = parser.add_mutually_exclusive_group()
    of.add_argument("--optimizer", default="auto")
    of.add_argument("--library", choices=LIBRARIES)
    parser.add_argument(
        "--objective", nargs="+", choices=UNITS, default=AT_SILKING
    )
    parser.add_argument(
        "--condition",
        nargs="+",
        choices=[x.name for x in CONDITIONS],
        default=["all", "15x3"],
    )
    parser.add_argument("--campaign", type=Path)
    parser.add_argument("--set", action="append", default=[])
    options = parser.parse_args()
    rows = []
    for name, title, stand in stands(options):
        found: dict[str, list[Any]] = {}
        for seed in range(1, options.seeds + 1):
            path: Path = (
                options.folder / f"{name}_s{seed}_{options.label}.json"
            )
            if not path.exists():
                say(f"searching: {path.stem}")
                points = search(stand, seed, options)
                path.write_text(json.dumps(points))
        begin = f"{name}_s"
        for path in sorted(options.folder.glob(f"{begin}*.json")):
            label = path.stem.removeprefix(begin).partition("_")[2]
            found.setdefault(label, []).append(json.loads(path.read_text()))
        rows += [
            [title, *row] for row in compare(stand, found, options.evaluations)
        ]
    titles = [f"{x:,}" for x in until(options.evaluations, SHOWN)]
    titles += [f"evaluations to {share:.0%}" for share in SHARES]
    print_table(["stand", "search", *titles], rows)


if __name__ == "__main__":
    guard(main)
