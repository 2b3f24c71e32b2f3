#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how fast Python evaluates plants compared with `ideotype run`.

python_rate.py [CAMPAIGN] [PAIRS]

Each pair runs a random search of 1,000 plants with one rank, and then evaluates
the same plants in Python with one thread, generation by generation. Prints
plants per second of processor time, which other work on the machine hardly
changes. To that of the program belong its start, breeding and a durable
history; to that of Python the Datasets. IDEOTYPE_EXECUTABLE names the program,
else it is that on PATH.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

import numpy as np

import ideotype

PROGRAM = os.environ.get("IDEOTYPE_EXECUTABLE", "ideotype")
CAMPAIGN = Path(__file__).parents[2] / "campaigns" / "ames.toml"
PLANTS = 1000
POPULATION = 100
SETTINGS = (
    f'search={{optimizer="random", population={POPULATION}}}',
    f"stop={{generations={PLANTS // POPULATION}}}",
    "final={candidates=1, paths=16, randomisations=2}",
    "replicates=1",
)


def run(campaign: str, folder: str) -> tuple[Path, float]:
    """Returns the history, and what it took [s of the processor]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    settings = [word for x in SETTINGS for word in ("--set", x)]
    subprocess.run(
        [PROGRAM, "run", campaign, "--out", folder, *settings],
        check=True,
        capture_output=True,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime - before.ru_utime
    seconds += after.ru_stime - before.ru_stime
    return next(Path(folder).glob("*/*.h5")), seconds


def measure(campaign: str) -> tuple[float, float]:
    """Returns plants per second of the program and of Python."""
    with tempfile.TemporaryDirectory() as folder:
        history, seconds = run(campaign, folder)
        rows = ideotype.open(history)
        stand = ideotype.Stand.from_history(history)
    genomes = rows.genome.values.reshape(-1, POPULATION, rows.sizes["gene"])
    objective = next(iter(stand.objectives))
    began = time.process_time()
    evaluated = [
        stand.evaluate(plants, [objective], generation=g, threads=1)
        for g, plants in enumerate(genomes)
    ]
    python = time.process_time() - began
    again = np.concatenate([x[objective].values for x in evaluated])
    np.testing.assert_array_equal(again, rows[objective].values)
    return PLANTS / seconds, PLANTS / python


def main() -> None:
    campaign = sys.argv[1] if len(sys.argv) > 1 else str(CAMPAIGN)
    pairs = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    print("plants per second: run, Python, Python relative to run")
    ratios = []
    for _ in range(pairs):
        own, python = measure(campaign)
        ratios.append(python / own)
        print(f"{own:8.1f} {python:8.1f} {ratios[-1]:8.3f}", flush=True)
    print(f"median {median(ratios):.3f}")


if __name__ == "__main__":
    main()
