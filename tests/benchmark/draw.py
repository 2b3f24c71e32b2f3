#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the figures of README.md from what benchmarks wrote.

Usage: draw.py accuracy BEFORE AFTER FOLDER, with the tables of `accuracy`,
       draw.py scaling SCALING.json FOLDER, with the output of
           `benchmarks --benchmark_format=json`.
"""

import json
import math
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt

FAMILIES = ("plants", "leaves", "faces", "hours", "sites")


def slope(points):
    """Returns exponent and factor by least squares in logarithms."""
    x = [math.log(a) for a, _ in points]
    y = [math.log(b) for _, b in points]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    slope = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum(
        (a - mean_x) ** 2 for a in x
    )
    return slope, math.exp(mean_y - slope * mean_x)


def rows(path):
    """Returns rows of a table that `accuracy` printed, by plants and light."""
    points = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            cells = [cell.strip() for cell in line.split("|")[1:-1]]
            if len(cells) < 7 or not cells[2].isdigit():
                continue
            point = (float(cells[6]), float(cells[4]))
            points.setdefault(f"{cells[0]}, {cells[1]}", []).append(point)
    return points


def draw_accuracy(before, after, folder):
    figure, axes = plt.subplots(figsize=(6.4, 4.4))
    for number, (name, points) in enumerate(after.items()):
        colour = f"C{number}"
        axes.loglog(*zip(*points), "o-", color=colour, ms=3, label=name)
        axes.loglog(
            *zip(*before.get(name, [])), "s:", color=colour, ms=3, lw=0.8
        )
    axes.set_xlabel("time of the processor for an evaluation [ms]")
    axes.set_ylabel("standard error of the leaves' light [%]")
    axes.set_title("dotted: v0.1.1", fontsize=9)
    axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(f"{folder}/accuracy.png", dpi=100)


def draw_scaling(runs, folder):
    figure, axes = plt.subplots(figsize=(6.4, 4.4))
    for family in FAMILIES:
        points = sorted(
            (run["size"], run["cpu_time"])
            for run in runs
            if run["name"].startswith(f"{family}/")
        )
        exponent = slope(points)[0]
        axes.loglog(
            *zip(*points), "o-", ms=3, label=f"{family}: {exponent:.2f}"
        )
        print(f"{family}: cost to the power {exponent:.2f}")
    axes.set_xlabel("how many")
    axes.set_ylabel("time of the processor [ms]")
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(f"{folder}/scaling.png", dpi=100)


def main():
    if sys.argv[1:2] == ["accuracy"] and len(sys.argv) == 5:
        draw_accuracy(rows(sys.argv[2]), rows(sys.argv[3]), sys.argv[4])
    elif sys.argv[1:2] == ["scaling"] and len(sys.argv) == 4:
        with open(sys.argv[2], encoding="utf-8") as file:
            draw_scaling(json.load(file)["benchmarks"], sys.argv[3])
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
