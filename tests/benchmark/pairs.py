#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how much noise cancels between two plants that share their random
numbers.

    pairs.py [--draws N] [--distance SHARE...] [--set KEY=VALUE] [NAME...]

The baseline and a plant that differs from it by a share of the range of each
free gene are evaluated with the settings of trade.py. Each draw has another
field and other paths, which both plants share. Prints for each distance the
median processor time of an evaluation, on one thread, the noise of a plant and
of the difference, in % of the baseline, the factor by which the variance of a
difference would be larger with independent random numbers, and the cost of a
search: time times the square of the noise of the difference. To compare
versions, run the script with the package of each.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from statistics import median
from time import process_time

import numpy as np
from trade import CAMPAIGNS, OBJECTIVES

from ideotype import Stand


def moved(stand: Stand, distance: float) -> np.ndarray:
    """Returns the baseline with all free genes moved, down where there is no
    room above."""
    genes = stand.genes
    lower, upper, baseline = (
        genes[name].to_numpy() for name in ("lower", "upper", "baseline")
    )
    step = distance * (upper - lower)
    step[baseline + step > upper] *= -1
    return np.where(genes["is_free"], baseline + step, baseline)


def measured(path: Path, settings: list[str], distance: float, draws: int):
    """Returns the values of both plants [draw, plant] and the median time of an
    evaluation [ms]."""
    stand = Stand.from_campaign(path, settings=settings)
    plants = np.array([stand.baseline, moved(stand, distance)])
    values, times = [], []
    for seed in range(draws):
        began = process_time()
        found = stand.evaluate(plants, [], generation=1, seed=seed, threads=1)
        times.append((process_time() - began) / len(plants))
        values.append(found.objective_by_randomisation[:, 0].mean(axis=1))
    return np.array(values), 1e3 * median(times)


def row(values: np.ndarray, milliseconds: float) -> str:
    first, second = values.T
    scale = 100 / abs(first.mean())
    difference = second - first
    noise = scale * difference.std(ddof=1)
    factor = (first.var() + second.var()) / difference.var()
    return (
        f"{milliseconds:.1f} | {scale * difference.mean():.2f} | "
        f"{scale * first.std(ddof=1):.2f} | {noise:.2f} | {factor:.2f} | "
        f"{milliseconds * noise**2:.3g}"
    )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("name", nargs="*", choices=[[], *OBJECTIVES])
    parser.add_argument("--draws", type=int, default=100)
    parser.add_argument(
        "--distance", type=float, nargs="+", default=[0.1, 0.02]
    )
    parser.add_argument("--set", action="append", default=[])
    options = parser.parse_args()
    print(
        "| objective | distance | ms | difference % | noise of a plant % | "
        "noise of the difference % | factor | cost |\n" + 8 * "|---" + "|"
    )
    for name in options.name or OBJECTIVES:
        of = OBJECTIVES[name]
        path = CAMPAIGNS / f"{of.campaign}.toml"
        for distance in options.distance:
            values, time = measured(
                path, [*of.settings, *options.set], distance, options.draws
            )
            print(f"| {name} | {distance} | {row(values, time)} |", flush=True)


if __name__ == "__main__":
    main()
