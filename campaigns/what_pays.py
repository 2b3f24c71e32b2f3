#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What has been bred, do the seeds agree, and what do its parts pay?

what_pays.py --under CAMPAIGN HISTORY...

Prints the traits of the best plant of each history and how alike they are. Then
undoes one feature at a time, looks at all variants under the light of CAMPAIGN,
and prints what the canopy loses, in % of the light that its leaves absorb, with
standard errors. Histories should be the seeds of one case.
IDEOTYPE_EXECUTABLE names the program, else it is that on PATH.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Callable
from pathlib import Path
from itertools import combinations
from statistics import correlation, fmean, stdev

PROGRAM = os.environ.get("IDEOTYPE_EXECUTABLE", "ideotype")
Values = list[float]
Leaf = dict[str, float]


def mean_of(values: Values) -> Values:
    return [fmean(values)] * len(values)


#: What is undone: a trait, and its new values from the old ones and the baseline's.
VARIANTS: dict[str, tuple[str, Callable[[Values, Values], Values]]] = {
    "azimuths of the baseline, all across the row": (
        "azimuth",
        lambda _, b: b,
    ),
    "all leaves along the row": (
        "azimuth",
        lambda _, b: [(azimuth + 90) % 360 for azimuth in b],
    ),
    "inclinations of the baseline": ("insertion_angle", lambda _, b: b),
    "the mean insertion_angle for all leaves": (
        "insertion_angle",
        lambda own, _: mean_of(own),
    ),
    "inclinations upside down": ("insertion_angle", lambda own, _: own[::-1]),
    "widths of the baseline": ("width", lambda _, b: b),
    "lengths of the baseline": ("length", lambda _, b: b),
}


def ideotype(*words: object) -> str:
    done = subprocess.run(
        [PROGRAM, *map(str, words)], check=True, capture_output=True, text=True
    )
    return done.stdout


def leaves(path: Path) -> list[Leaf]:
    return tomllib.loads(path.read_text())["leaf"]


def with_values(text: str, trait: str, values: Values) -> str:
    """A crop file in which the leaves have these values."""
    head, *tables = text.split("[[leaf]]")
    # other organs, which follow the last leaf, have lengths too
    parts = (
        re.sub(
            rf"^{trait} = .*$",
            f"{trait} = {value}",
            table,
            count=1,
            flags=re.M,
        )
        for table, value in zip(tables, values, strict=True)
    )
    return "[[leaf]]".join([head, *parts])


def write_variants(
    history: Path, baseline: list[Leaf], folder: Path
) -> list[Path]:
    """The best plant, and then each variant."""
    best = folder / "best.toml"
    ideotype("export", history, "--best", "--to", best)
    own, paths = leaves(best), [best]
    for i, (trait, change) in enumerate(VARIANTS.values()):
        values = change([x[trait] for x in own], [x[trait] for x in baseline])
        paths.append(folder / f"variant{i}.toml")
        paths[-1].write_text(with_values(best.read_text(), trait, values))
    return paths


def alike(trait: str, a: Values, b: Values) -> float:
    """1: the same; 0: unrelated. Azimuths count as axes, without a direction."""
    if trait != "azimuth":
        return correlation(a, b) if min(stdev(a), stdev(b)) > 0 else math.nan
    return fmean(
        math.cos(2 * math.radians(x - y)) for x, y in zip(a, b, strict=True)
    )


def print_traits(plants: list[list[Leaf]]) -> None:
    """A row per leaf, the plants beside each other."""
    form = {"length": "{:.2f}", "width": "{:.3f}", "insertion_angle": "{:.0f}"}
    names = [*form, "azimuth"]
    print("| leaf | length m | width m | insertion_angle deg | azimuth deg |")
    print("|---|---|---|---|---|")
    for rank, same in enumerate(zip(*plants, strict=True), start=1):
        cells = (
            ", ".join(
                form.get(name, "{:.0f}").format(leaf[name]) for leaf in same
            )
            for name in names
        )
        print(f"| {rank} | {' | '.join(cells)} |")
    pairs = list(combinations(plants, 2))
    if pairs:
        cells = (
            "{:+.2f}".format(
                fmean(
                    alike(
                        name, *([leaf[name] for leaf in one] for one in pair)
                    )
                    for pair in pairs
                )
            )
            for name in names
        )
        print(f"| alike | {' | '.join(cells)} |")


def study(
    history: Path, baseline: list[Leaf], under: Path
) -> tuple[list[Leaf], list[tuple[float, float]]]:
    """The best plant, and what each variant loses, with its standard error [%]."""
    with tempfile.TemporaryDirectory() as folder:
        paths = write_variants(history, baseline, Path(folder))
        best = leaves(paths[0])
        found = json.loads(
            ideotype("evaluate", *paths, "--under", under, "--json")
        )
    means = [row[0] for row in found["mean"]]
    errors = [row[0] for row in found["standard_error"]]
    return best, [
        (
            100 * (mean / means[0] - 1),
            100 / means[0] * math.hypot(error, errors[0]),
        )
        for mean, error in zip(means[1:], errors[1:], strict=True)
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument(
        "--under", type=Path, required=True, metavar="CAMPAIGN"
    )
    parser.add_argument("histories", nargs="+", type=Path, metavar="HISTORY")
    options = parser.parse_args()
    baseline = leaves(Path(__file__).parent / "crops" / "maize.toml")
    plants, seeds = zip(
        *(study(path, baseline, options.under) for path in options.histories),
        strict=True,
    )
    print_traits(list(plants))
    print("\n| instead of what evolved | light [%] | by seed |\n|---|---|---|")
    for name, each in zip(VARIANTS, zip(*seeds, strict=True), strict=True):
        mean = fmean(x for x, _ in each)
        error = math.hypot(*(e for _, e in each)) / len(each)
        if len(each) > 1:
            error = max(
                error, stdev(x for x, _ in each) / math.sqrt(len(each))
            )
        by_seed = ", ".join(f"{x:+.2f} ± {e:.2f}" for x, e in each)
        print(
            f"| {name} | {mean:+.2f} ± {error:.2f} | {by_seed} |", flush=True
        )


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(error.stderr.strip())
