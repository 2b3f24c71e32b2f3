#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the bias of uniform stands.

plants_differ.py [--under CAMPAIGN] [--plants N] [--figure FILE.png]

Evaluates N plants of the bounds "breedable", spread evenly, and the baseline
in uniform stands and in variable ones: with the within-line variation of
fields, and with that of the inbred lines of one trial
(docs/campaign_files.md). Prints the absorbed PAR and the net assimilation of
the baseline on the day of CAMPAIGN in each, the rank correlation of plants,
and the loss by choosing the best plant of the uniform stand, relative to the
best one of the variable stand.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from estimates import Estimate, gain, plus_minus, print_table
from scipy.stats import qmc, spearmanr
from shared import (
    CAMPAIGNS,
    FIELD_PLANTS,
    MAIZE,
    MEASURED_LINES,
    Numbers,
    guard,
    light,
    parser_of,
)  # fmt: skip

from ideotype import Stand
from ideotype.figures.style import new_figure

LINES: dict[str, dict[str, Any]] = {
    "alike": {},
    "as in fields": FIELD_PLANTS,
    "as inbred lines": MEASURED_LINES,
}
OBJECTIVES = {
    "absorbed_par": "absorbed PAR",
    "net_assimilation": "net assimilation",
}


def stand(under: Path, objective: str, variation: dict[str, Any]) -> Stand:
    settings = [
        f"objective.maximise={objective}",
        f"plant.baseline={MAIZE}",
        "plant.bounds=breedable",
        "final.randomisations=32",
    ]
    settings += [f"field.variation.{key}={x}" for key, x in variation.items()]
    return Stand.from_campaign(under, settings=settings)


def plants(of: Stand, count: int) -> Numbers:
    """Returns the baseline and then plants that fill the range of the bounds
    evenly."""
    lower, upper = of.bounds
    points = qmc.Sobol(len(lower), seed=1).random(count)
    return np.vstack([of.start, qmc.scale(points, lower, upper)])


def lost(values: Numbers, chosen: int) -> Estimate:
    """Returns the loss due to choosing this plant instead of the best one
    [%]."""
    best = int(values.mean(1).argmax())
    return gain(values[best].tolist(), values[chosen].tolist())


def row(title: str, line: str, alike: Numbers, here: Numbers) -> list[str]:
    change = gain(alike[0].tolist(), here[0].tolist())
    agreement = spearmanr(alike[1:].mean(1), here[1:].mean(1)).statistic
    chosen = int(alike.mean(1).argmax())
    worth = lost(here, chosen)
    return [
        title,
        line,
        plus_minus(change, 2, "+"),
        f"{agreement:.3f}",
        plus_minus(worth, 2, "+"),
    ]


def draw(values: dict[tuple[str, str], Numbers], path: Path) -> None:
    figure = new_figure(8, 4)
    figure.suptitle("Do plants that differ change which plant is best?")
    for axis, (name, title) in zip(
        figure.subplots(1, len(OBJECTIVES)), OBJECTIVES.items(), strict=True
    ):
        alike = values[name, "alike"].mean(1)
        for line in list(LINES)[1:]:
            here = values[name, line].mean(1)
            axis.plot(alike, here / alike, "o", label=line, markersize=3)
        axis.set_xlabel(f"{title}, plants alike")
        axis.set_title(title, fontsize=9)
        axis.legend(fontsize=7)
    figure.axes[0].set_ylabel("plants that differ, relative to alike")
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("--under", type=Path, default=CAMPAIGNS / "ames.toml")
    parser.add_argument("--plants", type=int, default=64)
    parser.add_argument("--figure", type=Path)
    options = parser.parse_args()
    values: dict[tuple[str, str], Any] = {}
    rows = []
    for name, title in OBJECTIVES.items():
        for line, variation in LINES.items():
            here = stand(options.under, name, variation)
            found = light(here, plants(here, options.plants))
            values[name, line] = found
            if line != "alike":
                rows.append(row(title, line, values[name, "alike"], found))
    print_table(
        [
            "objective",
            "plants",
            "baseline, relative to plants alike [%]",
            "rank correlation",
            "loss by choosing among plants alike [%]",
        ],
        rows,
    )
    if options.figure:
        draw(values, options.figure)


if __name__ == "__main__":
    guard(main)
