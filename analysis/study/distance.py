#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts how often three searches bound the distance from the optimum.

distance.py FOLDER [--triples N] [--evaluations N] [--long-evaluations N]
            [--objective NAME] [--rough]

`ideotype summary` and reports print the spread of a case's independent
searches, the gain of the best minus that of the worst, as a bound of the
distance from the optimum. The script optimises maize under within-line
variation (all traits, 42 deg north, rows of 30 inches, plants 6 inches apart)
by N triples of searches of so many evaluations each, and by three searches of
--long-evaluations. All best plants are re-evaluated in the same fields; the
best of them represents the optimum. The script prints how many triples miss
the optimum by no more than their spread, how many include it in the interval
of `ideotype summary`, and for each triple its spread and the gain that it
misses, in percentage points.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from conditions import FIRST, UNITS, campaign
from estimates import print_table
from shared import (
    Numbers,
    best_plants,
    gains_over_baseline,
    guard,
    parser_of_searches,
)

from ideotype import Stand
from ideotype.history import Estimate
from ideotype.history.interval import gain_interval


def main() -> None:
    parser = parser_of_searches(
        __doc__, triples=10, evaluations=600, long_evaluations=2500
    )
    parser.add_argument("--objective", choices=UNITS, default="absorbed_par")
    options = parser.parse_args()
    tables = campaign(FIRST, options.objective, options.folder, options.rough)

    def bred(kind: str, searches: int, evaluations: int) -> list[Numbers]:
        """Returns the best plant of each search."""
        run: dict[str, Any] = {
            **tables,
            "name": f"{tables['name']}_{kind}",
            "replicates": searches,
            "search": {"optimizer": "auto"},
            "stop": {"generations": evaluations, "evaluations": evaluations},
        }
        return best_plants(run, options.folder)

    plants = bred("short", 3 * options.triples, options.evaluations)
    plants += bred("long", 3, options.long_evaluations)
    stand = Stand(tables)
    found = [Estimate(*each) for each in gains_over_baseline(stand, plants)]
    gains = [each.mean for each in found]
    triples = np.array(gains[:-3]).reshape(options.triples, 3)
    missed = max(gains) - triples.max(1)
    spread = np.ptp(triples, axis=1)
    print(
        f"{(missed <= spread).sum()} of {options.triples} triples miss the "
        f"best gain, {max(gains):.1f} %, by no more than their spread"
    )
    intervals = [
        gain_interval(found[k : k + 3], 1)
        for k in range(0, len(plants) - 3, 3)
    ]
    held = sum(each.high >= max(gains) for each in intervals)
    print(f"{held} of {options.triples} have it in the interval of the gain\n")
    print_table(
        ["best of three [%]", "spread [points]", "missed [points]"],
        [
            [f"{x:.2f}" for x in row]
            for row in zip(triples.max(1), spread, missed, strict=True)
        ],
    )


if __name__ == "__main__":
    guard(main)
