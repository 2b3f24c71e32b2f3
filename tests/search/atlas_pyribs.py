#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the atlas with pyribs on few noisy evaluations.

    atlas_pyribs.py [--evaluations N] [--seeds N]

The benchmark is that of tests/analysis/atlas_benchmark.py. Prints the QD score,
the sum of the noise-free objectives of all leaders, and the number of cells
with a leader, for several standard deviations of the noise; means of the seeds, ± half of a 95 %
interval. Emitters of pyribs are IsoLineEmitter, GaussianEmitter and
EvolutionStrategyEmitter (CMA-ME), with batches of 36 or 100 points. It needs the
packages ribs (0.12) and ideotype.
"""

from __future__ import annotations

import argparse
import math
import sys
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
from ribs.archives import GridArchive
from ribs.emitters import (
    EvolutionStrategyEmitter,
    GaussianEmitter,
    IsoLineEmitter,
)
from ribs.schedulers import Scheduler
from scipy.stats import t as student

sys.path.insert(0, str(Path(__file__).parents[1] / "analysis"))
from atlas_benchmark import (
    BOUND,
    CELLS,
    GENES,
    REACH,
    by_atlas,
    features,
    worth,
)

NOISE = (0, 5, 10, 20)


def emitters(kind: str, archive: GridArchive, seed: int, batch: int) -> list:
    common = {"x0": np.zeros(GENES), "bounds": [(-BOUND, BOUND)] * GENES}
    if kind == "lines":
        return [
            IsoLineEmitter(
                archive,
                iso_sigma=0.1024,
                line_sigma=0.2,
                batch_size=batch,
                seed=seed,
                **common,
            )
        ]
    if kind == "Gaussian":
        return [
            GaussianEmitter(
                archive, sigma=0.5, batch_size=batch, seed=seed, **common
            )
        ]
    return [
        EvolutionStrategyEmitter(
            archive,
            sigma0=0.5,
            ranker="2imp",
            batch_size=batch // 2,
            seed=seed + i,
            **common,
        )
        for i in range(2)
    ]


def by_pyribs(
    kind: str, noise: float, seed: int, batch: int, evaluations: int
):
    """Returns the leaders."""
    archive = GridArchive(
        solution_dim=GENES,
        dims=[CELLS, CELLS],
        ranges=[(-REACH, REACH)] * 2,
        seed=seed,
    )
    scheduler = Scheduler(archive, emitters(kind, archive, seed, batch))
    random, count = np.random.default_rng(seed), 0
    while count < evaluations:
        points = np.asarray(scheduler.ask())
        luck = noise * random.standard_normal(len(points))
        scheduler.tell(worth(points) + luck, features(points))
        count += len(points)
    return np.asarray(archive.data("solution"))


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--evaluations", type=int, default=3000)
    parser.add_argument("--seeds", type=int, default=5)
    options = parser.parse_args()
    # Emitters warn that points reach the bounds.
    warnings.simplefilter("ignore")
    searches: dict[str, Callable[..., np.ndarray]] = {"atlas": by_atlas}
    for kind in ("lines", "Gaussian", "CMA-ME"):
        searches[f"pyribs, {kind}"] = lambda *x, kind=kind: by_pyribs(kind, *x)
    print("| search | batch |" + "".join(f" noise {x} |" for x in NOISE))
    print("|---|---|" + len(NOISE) * "---|")
    reach = student.ppf(0.975, options.seeds - 1) / math.sqrt(options.seeds)
    for name, search in searches.items():
        for batch in (36, 100):
            cells = []
            for noise in NOISE:
                found = [
                    search(noise, seed, batch, options.evaluations)
                    for seed in range(1, options.seeds + 1)
                ]
                scores = [worth(leaders).sum() for leaders in found]
                count = np.mean([len(leaders) for leaders in found])
                cells.append(
                    f"{np.mean(scores):,.0f} ± "
                    f"{reach * np.std(scores, ddof=1):,.0f} ({count:.0f})"
                )
            print(f"| {name} | {batch} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
