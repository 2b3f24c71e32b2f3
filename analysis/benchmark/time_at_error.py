#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the CPU time of ideotype and of Mitsuba 3 at equal errors.

    python time_at_error.py [--seeds 32]

Each program computes the light that all organs absorb together, for four cases,
several numbers of paths and many seeds, on one thread. Its error is the standard
deviation over seeds. The CPU time at a given error is interpolated between
numbers of paths, on logarithmic scales. Intervals are those of 95 % of bootstrap
samples of seeds.

Building is all that a new scene costs: for ideotype a call with few paths, for
Mitsuba the making of its scene from the mesh in memory. Tracing is the
remainder of a call of ideotype, and a run of the kernel of Mitsuba. Compiling of
this kernel, without those that earlier processes have left, is stated apart:
one kernel serves all scenes with the same kind of light.

ideotype has 16 randomisations of its sequence, which give its standard error.
Mitsuba runs with one, and with as many.
Needs ideotype, and what adapters/mitsuba_paths.py needs."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE / "adapters")]

# Dr.Jit finds no kernels of earlier processes in an empty home directory.
HOME = tempfile.TemporaryDirectory()
os.environ["HOME"] = HOME.name

import drjit  # noqa: E402
import mitsuba_paths  # noqa: E402
import program  # noqa: E402
from cases import Case, read_cases  # noqa: E402

CASES = {
    "maize, PAR, sun": "par-maize-par-soil0.1-sun45_120",
    "maize, PAR, sky": "par-maize-par-soil0.1-uniform",
    "black leaves, sun": "black-spherical-black-sun45_120",
    "panels, sky": "panels-panels_tilted-black-soil0.25-uniform",
}
PATHS = {
    "ideotype": (2**11, 2**14, 2**18),
    "Mitsuba": (2**12, 2**15, 2**19),
    "Mitsuba, 16 shifts": (2**12, 2**15, 2**19),
}
SHIFTS = 16
FEW = 16  # paths of ideotype that take no time
TARGETS = (0.003, 0.001)  # relative errors
SAMPLES = 2000  # of the bootstrap

Measured = dict[str, np.ndarray]


def timed(call: Callable[[], Any]) -> tuple[Any, float]:
    """Returns the result of a call and its CPU seconds."""
    start = process_time()
    return call(), process_time() - start


def time_at(target: float, errors: np.ndarray, times: np.ndarray) -> float:
    """Returns the CPU time at a relative error, between measured ones. Smaller
    errors than any cost time by their inverse square; larger ones cost as much
    as the largest."""
    errors = np.minimum.accumulate(errors)
    if target < errors[-1]:
        return float(times[-1] * (errors[-1] / target) ** 2)
    return float(
        np.exp(np.interp(-np.log(target), -np.log(errors), np.log(times)))
    )


def measure(case: Case, seeds: int) -> tuple[Measured, float]:
    """Returns an array [paths, seed, (light, building, tracing)] for each
    program, with CPU seconds, and the time of compiling."""
    organs = [q for q in case["quantities"] if q not in ("soil", "reflected")]

    def run_ideotype(paths: int, seed: int) -> list[float]:
        _, building = timed(lambda: program.answer(case, FEW, seed))
        found, whole = timed(lambda: program.answer(case, paths, seed))
        light = sum(found[organ][0] for organ in organs)
        return [light, building, max(whole - building, 1e-5)]

    def run_mitsuba(paths: int, seed: int, shifts: int = 1) -> list[float]:
        field, building = timed(lambda: mitsuba_paths.Field(case))
        found, tracing = timed(lambda: field.trace(paths, seed, shifts))
        return [float(found[2:].sum()), building, tracing]

    runs = {
        "ideotype": run_ideotype,
        "Mitsuba": run_mitsuba,
        "Mitsuba, 16 shifts": partial(run_mitsuba, shifts=SHIFTS),
    }
    compiling = run_mitsuba(PATHS["Mitsuba"][0], 0)[2]
    # Programs take turns, so that other work on the machine concerns both. The
    # first turn is not counted.
    turns = [
        {way: [run(n, seed) for n in PATHS[way]] for way, run in runs.items()}
        for seed in range(seeds + 1)
    ]
    found = {
        way: np.array([turn[way] for turn in turns[1:]]).swapaxes(0, 1)
        for way in runs
    }
    return found, compiling - float(found["Mitsuba"][0, :, 2].mean())


def times_at(
    found: Measured, target: float, is_new: bool = True
) -> dict[str, float]:
    """Returns the CPU seconds of each program at an error, for a new scene or
    for tracing alone."""
    times = {}
    for way, data in found.items():
        light, building, tracing = np.moveaxis(data, -1, 0)
        error = light.std(1, ddof=1) / light.mean(1)
        times[way] = time_at(
            target, error, (tracing + building * is_new).mean(1)
        )
    return times


def ratio(found: Measured, target: float, way: str, is_new: bool) -> str:
    """Returns the time of a program over that of ideotype, with its
    interval."""
    random = np.random.default_rng(1)

    def resampled() -> Measured:
        return {
            way: data[:, random.integers(data.shape[1], size=data.shape[1])]
            for way, data in found.items()
        }

    def of(measured: Measured) -> float:
        times = times_at(measured, target, is_new)
        return times[way] / times["ideotype"]

    low, high = np.quantile(
        [of(resampled()) for _ in range(SAMPLES)], [0.025, 0.975]
    )
    return f"{of(found):.2f} ({low:.2f} to {high:.2f})"


def table(header: str, rows: Iterable[list[str]]) -> None:
    print(f"| {header} |\n|{'---|' * (header.count('|') + 1)}")
    for row in rows:
        print(f"| {' | '.join(row)} |")
    print()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=32)
    seeds = parser.parse_args().seeds
    drjit.set_thread_count(1)
    cases = read_cases()
    measured = {
        label: measure(cases[name], seeds) for label, name in CASES.items()
    }
    rows = []
    for label, (found, _) in measured.items():
        for way, data in found.items():
            for paths, each in zip(PATHS[way], data, strict=True):
                light, building, tracing = each.mean(0)
                error = each[:, 0].std(ddof=1) / light
                rows.append(
                    [
                        label,
                        way,
                        f"{paths:,}",
                        f"{light:.5f}",
                        f"{100 * error:.3f} %",
                        f"{1000 * building:.1f}",
                        f"{1000 * tracing:.1f}",
                        f"{1 / (error**2 * (building + tracing)):.1e}",
                        f"{1 / (error**2 * tracing):.1e}",
                    ]
                )
    table(
        "case | program | paths | absorbed | s.e. | building, CPU-ms | tracing, "
        "CPU-ms | 1/(relative variance x CPU-s) | of tracing",
        rows,
    )
    table(
        "case | compiling of Mitsuba where no earlier case did, CPU-ms",
        (
            [label, f"{1000 * max(compiling, 0):.0f}"]
            for label, (_, compiling) in measured.items()
        ),
    )
    rows = []
    for label, (found, _) in measured.items():
        for target in TARGETS:
            times = times_at(found, target)
            for way in list(PATHS)[1:]:
                rows.append(
                    [
                        label,
                        f"{100 * target:g} %",
                        way,
                        f"{1000 * times[way]:.1f}",
                        f"{1000 * times['ideotype']:.1f}",
                        ratio(found, target, way, is_new=True),
                        ratio(found, target, way, is_new=False),
                    ]
                )
    table(
        "case | s.e. | program | CPU-ms | ideotype, CPU-ms | ratio, new scene | "
        "ratio, tracing alone",
        rows,
    )


if __name__ == "__main__":
    main()
