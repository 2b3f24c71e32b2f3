#!/usr/bin/env python3
"""Draws the figures of README.md from what benchmarks wrote.

Usage: draw.py CONVERGENCE.json SCALING.json FOLDER, with the output of
`convergence` and of `benchmarks --benchmark_format=json`.
"""
import json
import math
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

FAMILIES = ("plants", "leaves", "faces", "hours", "sites")


def slope(points):
    """Least squares in logarithms: exponent and factor."""
    x = [math.log(a) for a, _ in points]
    y = [math.log(b) for _, b in points]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    found = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum(
        (a - mean_x) ** 2 for a in x
    )
    return found, math.exp(mean_y - found * mean_x)


def milliseconds(setting, goal, randomisations):
    """Time to a relative standard error of the mean of randomisations."""
    points = setting["points"]
    wanted = goal * math.sqrt(randomisations)
    for a, b in zip(points, points[1:]):
        if b["error"] <= wanted:
            part = math.log(a["error"] / wanted) / math.log(
                a["error"] / b["error"]
            )
            paths = a["paths"] * (b["paths"] / a["paths"]) ** part
            light = randomisations * paths * b["seconds_per_path"]
            return 1e3 * (setting["build_seconds"] + light), paths
    return math.nan, math.nan


def draw_convergence(settings, folder):
    figure, axes = plt.subplots(figsize=(6.4, 4.4))
    for setting, colour in zip(settings, ("C0", "C1", "C2", "C3")):
        points = [(p["paths"], p["error"]) for p in setting["points"]]
        whole, upper = slope(points)[0], slope(points[len(points) // 2:])[0]
        plain = setting["plain_deviation"]
        at = dict(points)[4096]
        gained = plain / math.sqrt(4096) / at
        label = (
            f"{setting['cell']} x {setting['cell']}, {setting['light']}: "
            f"{whole:.2f}, upper half {upper:.2f}"
        )
        axes.loglog(*zip(*points), "o-", color=colour, ms=3, label=label)
        axes.loglog(
            [p for p, _ in points],
            [plain / math.sqrt(p) for p, _ in points],
            ":", color=colour, lw=0.8,
        )
        print(
            f"{label}; at 4,096 paths {100 * at:.3f} %, {gained:.2f} times "
            f"less error than plain Monte Carlo, {gained**2:.2f} times less "
            "variance"
        )
        for randomisations in (2, 8):
            time, paths = milliseconds(setting, 1e-3, randomisations)
            print(
                f"    0.1 %: {time:.0f} ms, {randomisations} x {paths:,.0f} "
                f"paths, {1e3 * setting['build_seconds']:.2f} ms of it for "
                "geometry and scene"
            )
    axes.set_xlabel("paths of one randomisation")
    axes.set_ylabel("relative error of the leaves' light")
    axes.set_title("dotted: plain Monte Carlo", fontsize=9)
    axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(f"{folder}/convergence.png", dpi=100)


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
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    convergence, scaling, folder = sys.argv[1:]
    with open(convergence, encoding="utf-8") as file:
        draw_convergence(json.load(file), folder)
    with open(scaling, encoding="utf-8") as file:
        draw_scaling(json.load(file)["benchmarks"], folder)


if __name__ == "__main__":
    main()
