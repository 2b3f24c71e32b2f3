#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds the best maize of each type: leaf area by the angle of the top.

atlas.py FOLDER [--figure FILE.png] [--generations N] [--rough]

Runs atlas.toml, a search that keeps the best plant of each type, and prints
the carbon balance of the leaders on a clear day, re-evaluated with independent
random numbers. A "?" marks a leader that was evaluated only once in the search.
± is half of a 95 % interval.
"""

from __future__ import annotations

import matplotlib
from estimates import plus_minus, print_table
from shared import (
    ROUGH,
    breed_tables,
    campaign_of,
    guard,
    parser_of_searches,
)  # fmt: skip

from ideotype import Error
from ideotype.figures.atlas import draw_atlas
from ideotype.figures.style import RC
from ideotype.history import Case, open_history
from ideotype.history.atlas import Atlas


def table_of(atlas: Atlas) -> tuple[list[str], list[list[str]]]:
    """Returns titles and one row per angle, the flattest angle first."""
    across, up = atlas.axes
    leaders = atlas.leaders
    cells = [["" for _ in across.spans()] for _ in up.spans()]
    for i, (x, y) in enumerate(atlas.cells):
        one = (
            float(leaders.objectives[i, 0]),
            float(leaders.objectives_standard_error[i, 0]),
        )
        mark = "" if atlas.is_confirmed[i] else " ?"
        cells[y][x] = plus_minus(one, 3) + mark
    titles = [f"top [deg] / {across.name}", *across.spans()]
    rows = [[span, *row] for span, row in zip(up.spans(), cells, strict=True)]
    return titles, rows[::-1]


def main() -> None:
    parser = parser_of_searches(__doc__, has_figure=True, generations=50)
    options = parser.parse_args()
    tables = campaign_of("atlas", stop={"generations": options.generations})
    if options.rough:
        tables |= {"light": ROUGH["light"], "final": {"paths": 64}}
    (path,) = breed_tables(tables, options.folder)
    with open_history(path) as history:
        atlas, best = history.atlas(), history.comparison()
        if atlas is None or best is None:
            raise Error(f"{path}: its leaders are not evaluated yet")
        kinds = atlas.axes[0].cells * atlas.axes[1].cells
        print(
            f"{len(atlas.leaders)} of {kinds} kinds have a leader, and "
            f"{atlas.is_confirmed.sum()} leaders are confirmed; the median one "
            f"was evaluated {int(sorted(atlas.looks)[len(atlas.looks) // 2])} "
            f"times in the search of {len(history.evaluations())} evaluations."
            "\nThe best has "
            f"{plus_minus((best.gain.mean, best.gain.standard_error))}"
            " % more than the baseline.\n"
        )
        print_table(*table_of(atlas))
        if options.figure:
            with matplotlib.rc_context(RC):
                figure = draw_atlas(Case("atlas", [history]))
                figure.savefig(options.figure, dpi=110)


if __name__ == "__main__":
    guard(main)
