#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures what accuracy costs: the error of the difference between two plants
against the time of an evaluation, for each objective.

    trade.py [--draws N] [--figure FILE] [NAME...]

A row has a tolerance of the light and a number of fields. The two plants are
those of `ideotype fidelity`; each draw has another field and other paths, which
both plants share. The noise of a difference is its standard deviation over the
draws, in % of the baseline's mean at the last tolerance. Time is the median
processor time of an evaluation, on one thread. The cost of a search is time
times the square of the noise. Run it in a Python that has the package.
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from statistics import fmean, median, stdev
from typing import NamedTuple

from ideotype.tools.fidelity import Evaluator

CAMPAIGNS = Path(__file__).resolve().parents[2] / "campaigns"
TOLERANCES = (0.05, 0.02, 0.01, 0.005, 0.0025, 0.00125)
FIELDS = (1, 4)


class Objective(NamedTuple):
    campaign: str
    settings: tuple[str, ...] = ()
    draws: int = 24


OBJECTIVES = {
    "absorbed PAR": Objective("ames_quick"),
    "net assimilation": Objective(
        "ames_quick", ('objective={maximise="net_assimilation"}',)
    ),
    "season": Objective("quickstart"),
    "strip": Objective("strip", (), 12),
    "panels": Objective("agrivoltaic", (), 12),
    "growing": Objective("growing_season", (), 12),
    "growing, water": Objective("growing_season", ("water={}",), 8),
}


class Row(NamedTuple):
    tolerance: float
    fields: int
    milliseconds: float
    noise: float  # [%]

    @property
    def cost(self) -> float:
        return self.milliseconds * self.noise**2


def measured(of: Objective, draws: int) -> list[Row]:
    """Returns a row for each tolerance and number of fields."""
    evaluator = Evaluator(CAMPAIGNS / f"{of.campaign}.toml", 0, of.settings)
    found = {
        (tolerance, fields): [
            evaluator.draw(
                (("light.tolerance", tolerance), ("light.fields", fields)),
                number,
            )
            for number in range(draws)
        ]
        for fields in FIELDS
        for tolerance in TOLERANCES
    }
    scale = abs(fmean(x.value for x in found[TOLERANCES[-1], FIELDS[-1]]))
    return [
        Row(
            *setting,
            1e3 * median(x.seconds for x in all_draws),
            100 * stdev(x.difference for x in all_draws) / scale,
        )
        for setting, all_draws in found.items()
    ]


def table(name: str, of: Objective, rows: list[Row], draws: int) -> str:
    """Returns a table of costs relative to those of 4 fields and 0.005."""
    own = next(r for r in rows if (r.tolerance, r.fields) == (0.005, 4))
    error = 2 * 1.96 / math.sqrt(2 * draws - 2) * math.sqrt(2)
    lines = [
        f"{name} ({of.campaign}, {draws} draws, costs ± {100 * error:.0f} %)",
        "| fields | tolerance | ms | noise % | cost |",
        "|---|---|---|---|---|",
    ]
    lines += [
        f"| {r.fields} | {r.tolerance} | {r.milliseconds:.1f} | "
        f"{r.noise:.2f} | {r.cost / own.cost:.2f} |"
        for r in rows
    ]
    return "\n".join(lines)


def draw_figure(all_rows: dict[str, list[Row]], path: Path) -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot as plt

    figure, axes = plt.subplots(figsize=(7, 5))
    for number, (name, rows) in enumerate(all_rows.items()):
        for fields, style in zip(FIELDS, (":", "-"), strict=True):
            line = [r for r in rows if r.fields == fields]
            axes.loglog(
                [r.milliseconds for r in line],
                [r.noise for r in line],
                style,
                color=f"C{number}",
                marker="o",
                markersize=3,
                label=name if fields == FIELDS[-1] else None,
            )
        own = [r for r in rows if (r.tolerance, r.fields) == (0.005, 4)]
        axes.loglog(
            [r.milliseconds for r in own],
            [r.noise for r in own],
            "o",
            color=f"C{number}",
            markersize=9,
            fillstyle="none",
        )
    axes.set_xlabel("processor time of an evaluation [ms]")
    axes.set_ylabel("noise of the difference of two plants [%]")
    axes.set_title(
        "dotted: 1 field, lines: 4; circles: tolerance 0.005, 4 fields",
        fontsize=9,
    )
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=100)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("name", nargs="*", choices=[[], *OBJECTIVES])
    parser.add_argument("--draws", type=int, help="instead of 8 to 24")
    parser.add_argument("--figure", type=Path)
    options = parser.parse_args()
    all_rows = {}
    for name in options.name or OBJECTIVES:
        of = OBJECTIVES[name]
        draws = options.draws or of.draws
        all_rows[name] = measured(of, draws)
        print(table(name, of, all_rows[name], draws), flush=True)
        print(flush=True)
    if options.figure:
        draw_figure(all_rows, options.figure)


if __name__ == "__main__":
    main()
