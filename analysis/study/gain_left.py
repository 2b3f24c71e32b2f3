#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Calibrates and tests the bound of what a search still gains.

gain_left.py FOLDER [--objective NAME...] [--calibrate N] [--seeds N] [--rough]

Searches by `auto` in two stands of arXiv:2512.06064 (conditions.py) for light
and for net assimilation, and stores in FOLDER the means of the generations and
the returned plant after 250 to 2,000 evaluations. Finished searches are not
repeated, so that several processes may share the work.

Re-evaluates these plants with random numbers that no search used. The gain of
as many further evaluations is compared with the bound of stop.gain_left, after
250, 500, 750 and 1,000 evaluations. Prints the 90 % quantile of gain over bound
in the first N seeds of each stand, by which the factor of the bound would be
multiplied (src/search/stop_rules.cpp), and how many statements hold in the
other seeds [%], with the medians of gain and bound in % of the gain so far.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from itertools import accumulate
from pathlib import Path
from statistics import fmean, median
from typing import Any

import numpy as np
from conditions import CONDITIONS, Condition, campaign
from estimates import print_table
from shared import (
    guard,
    light,
    parser_of_searches,
    say,
    search_by_package,
)

from ideotype import Stand
from ideotype.common.compiled import _core

CHECKPOINTS = (250, 500, 750, 1000, 1500, 2000)
STATED = tuple(n for n in CHECKPOINTS if 2 * n in CHECKPOINTS)
OBJECTIVES = ("absorbed_par", "net_assimilation")
STANDS = ("all", "15x3")
LIGHT = {"candidates": 1, "paths": 1024, "randomisations": 128}
"""The [final] of re-evaluations."""


def search(
    where: Condition, objective: str, seed: int, options: argparse.Namespace
) -> dict[str, Any]:
    """Returns the numbers of evaluations and the means of all generations, and
    the mean objective of the baseline and of the plants at CHECKPOINTS."""
    tables = campaign(where, objective, options.folder, options.rough)
    if not options.rough:
        tables["final"] = LIGHT
    stand = Stand(tables)
    points, generations = search_by_package(stand, seed, CHECKPOINTS)
    plants = np.array([stand.baseline, *(x[2] for x in points)])
    return {
        "evaluations": [len(values) for values in generations],
        "means": [fmean(values) for values in generations],
        "values": light(stand, plants).mean(axis=1).tolist(),
    }


def statements(found: dict[str, Any]) -> list[tuple[float, float, float]]:
    """Returns the gain of as many further evaluations, its bound, and the gain
    so far, at STATED."""
    ends = list(accumulate(found["evaluations"]))
    values = dict(zip(CHECKPOINTS, found["values"][1:], strict=True))
    result = []
    for n in STATED:
        count = next(g for g, end in enumerate(ends, 1) if end >= n)
        bound = _core.most_gain_left(
            found["evaluations"][:count], found["means"][:count], True
        )
        result.append(
            (values[2 * n] - values[n], bound, values[n] - found["values"][0])
        )
    return result


def coverage(each: Sequence[tuple[float, float, float]]) -> str:
    return f"{100 * fmean(gain <= bound for gain, bound, _ in each):.0f}"


def main() -> None:
    parser = parser_of_searches(__doc__, seeds=20)
    parser.add_argument("--calibrate", type=int, default=5, metavar="N")
    parser.add_argument(
        "--objective", nargs="+", choices=OBJECTIVES, default=OBJECTIVES
    )
    options = parser.parse_args()
    calibrating, tested = [], []
    rows = []
    for objective in options.objective:
        for where in CONDITIONS:
            if where.name not in STANDS:
                continue
            here = []
            for seed in range(1, options.seeds + 1):
                name = f"{objective}_{where.name}_s{seed}.json"
                path: Path = options.folder / name
                if not path.exists():
                    say(f"searching: {path.stem}")
                    found = search(where, objective, seed, options)
                    path.write_text(json.dumps(found))
                stated = statements(json.loads(path.read_text()))
                if seed <= options.calibrate:
                    calibrating += stated
                else:
                    here.append(stated)
            tested += here
            cells = [f"{objective}, {where.title}"]
            for i in range(len(STATED)):
                at = [stated[i] for stated in here]
                gained, bound = (
                    100 * median(x[k] / x[2] for x in at) for k in (0, 1)
                )
                cells.append(f"{coverage(at)} ({gained:.1f}, {bound:.1f})")
            rows.append(cells)
    ratios = [gain / max(bound, 1e-300) for gain, bound, _ in calibrating]
    say(
        f"{len(calibrating)} statements calibrate: 90 % quantile of gain over "
        f"bound {np.quantile(ratios, 0.9):.2f}"
    )
    every = [x for stated in tested for x in stated]
    say(f"{len(every)} others: {coverage(every)} % hold")
    print_table(
        ["stand", *(f"after {n:,}" for n in STATED)],
        rows,
    )


if __name__ == "__main__":
    guard(main)
