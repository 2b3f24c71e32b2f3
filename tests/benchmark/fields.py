#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how much of the noise of a row is the field's, and what an
evaluation costs where plants differ.

fields.py [--objective NAME...] [--plants N] [--seeds N]

Evaluates N plants, the baseline of crops/maize.toml and plants around it as a
search by CMA-ES draws them (a normal deviation of a tenth of the range in each
gene of the bounds "paper"), at 30 x 6 inches, in a field of each of several
seeds, all plants in the same one. Fields are cells of plants that are all
alike, cells of 16, 32 and 64 plants, and four cells of 4 or 8 plants, that differ by the [field.variation] of
campaigns/quickstart.toml, which `ideotype new` writes too. Run it in a Python
that has the package; it takes some ten minutes of one core.

Prints for each objective, cell and tolerance:

* the standard deviation of a row over seeds [%] by its origin, light or field.
  The part of light is the error that a row tells, the field is the rest;
* the same of a difference between two plants in the same field [%]. The part of
  light is how far differences between plants scatter over the randomisations of
  one row. Of four cells both parts are in the error that is told, as "light";
* the processor time of an evaluation [ms];
* the cost at an equal error: the time that an evaluation takes with the
  tolerance that makes differences between plants as sure as they are among
  plants alike with the first tolerance, over the time which that takes. It
  follows from both tolerances: the variance of the light grows with the square
  of a tolerance, the field's does not, and a part of the time falls with that
  square. "-": the field alone makes differences less sure than that.
"""

from __future__ import annotations

import argparse
import time
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import ideotype

CAMPAIGNS = Path(__file__).resolve().parents[2] / "campaigns"
#: The campaign that provides the light of each objective.
OBJECTIVES = {
    "absorbed_par": "ames",
    "net_assimilation": "ames",
    "carbon_balance": "bondville",
}
#: Cells by name: rows, plants per row, whether plants vary, and fields per
#: evaluation.
CELLS: dict[str, tuple[int, int, bool, int]] = {
    "4 x 4, alike": (4, 4, False, 1),
    "4 x 4": (4, 4, True, 1),
    "4 x 8": (4, 8, True, 1),
    "8 x 8": (8, 8, True, 1),
    "4 of 2 x 2": (2, 2, True, 4),
    "4 of 2 x 4": (2, 4, True, 4),
}
TOLERANCES = (0.008, 0.004)
STEP = 0.1

Numbers = NDArray[np.float64]


@dataclass(frozen=True)
class Noise:
    """Variances relative to the squared mean, and the time of an evaluation
    [s]."""

    light_of_row: float
    row: float
    light_of_difference: float
    difference: float
    seconds: float


def stand(objective: str, cell: str, tolerance: float) -> ideotype.Stand:
    rows, plants, differ, fields = CELLS[cell]
    quickstart = tomllib.loads((CAMPAIGNS / "quickstart.toml").read_text())
    field: dict[str, Any] = {"rows": rows, "plants": plants}
    if differ:
        field["variation"] = quickstart["field"]["variation"]
    settings = {
        "field": field,
        "plant": {
            "baseline": str(CAMPAIGNS / "crops" / "maize.toml"),
            "bounds": "paper",
        },
        "objective": {"maximise": objective},
        "light.tolerance": tolerance,
        "light.fields": fields,
        "replicates": 1,
    }
    path = CAMPAIGNS / f"{OBJECTIVES[objective]}.toml"
    return ideotype.Stand.from_campaign(path, settings=settings)


def plants_around(where: ideotype.Stand, count: int) -> Numbers:
    """Returns the baseline and the plants of a generation around it [plants,
    free genes]."""
    lower, upper = where.bounds
    random = np.random.default_rng(1)
    steps = STEP * random.standard_normal((count, len(lower)))
    steps[0] = 0
    return np.clip(where.start + (upper - lower) * steps, lower, upper)


def values(where: ideotype.Stand, plants: Numbers, seed: int) -> Numbers:
    """Returns the objective of each randomisation [plants, randomisations]."""
    evaluated = where.evaluate(plants, [], seed=seed, threads=1)
    if any(evaluated.message.values):
        raise ideotype.Error(evaluated.message.values.max())
    return np.asarray(evaluated.objective_by_randomisation[:, 0])


def noise(draws: Numbers, seconds: float) -> Noise:
    """Returns the noise of `draws` [seeds, plants, randomisations]."""
    seeds, plants, count = draws.shape
    rows = draws.mean(2)
    scale = rows.mean() ** 2

    def of_mean(parts: Numbers) -> float:
        """Returns the variance of a mean over randomisations."""
        return float(parts.var(2, ddof=1).mean() / count)

    # Subtracting the mean over plants removes the noise that all plants of a
    # field share.
    apart = draws - draws.mean(1, keepdims=True)
    residuals = rows - rows.mean(0)
    residuals -= residuals.mean(1, keepdims=True)
    degrees = (seeds - 1) * (plants - 1)
    pair = 2 * plants / (plants - 1)
    return Noise(
        of_mean(draws) / scale,
        float(rows.var(0, ddof=1).mean() / scale),
        pair * of_mean(apart) / scale,
        2 * float((residuals**2).sum() / degrees) / scale,
        seconds,
    )


def measure(objective: str, plants: int, seeds: int) -> dict[Any, Noise]:
    keys = [(cell, each) for each in TOLERANCES for cell in CELLS]
    stands = {key: stand(objective, *key) for key in keys}
    genomes = plants_around(stands[keys[0]], plants)
    draws: dict[Any, list[Numbers]] = {key: [] for key in keys}
    spent: dict[Any, list[float]] = {key: [] for key in keys}
    # Seeds form the outer loop, so that other work on the machine slows all
    # fields equally.
    for seed in range(1, seeds + 1):
        for key in keys:
            began = time.process_time()
            draws[key].append(values(stands[key], genomes, seed))
            spent[key].append((time.process_time() - began) / plants)
    return {
        key: noise(np.array(draws[key]), float(np.median(spent[key])))
        for key in keys
    }


def parts(light: float, whole: float) -> str:
    """Formats standard deviations by origin [%]."""
    field = max(whole - light, 0.0)
    return " | ".join(f"{100 * np.sqrt(x):.2f}" for x in (light, field, whole))


def of_field(fine: Noise) -> float:
    """Returns the variance between fields of a difference between plants,
    which more light paths cannot reduce."""
    return max(fine.difference - fine.light_of_difference, 0.0)


def seconds_for(variance: float, rough: Noise, fine: Noise) -> float:
    """Returns the time of an evaluation in which a difference between plants
    has the given variance."""
    left = variance - of_field(fine)
    if left <= 0:
        return np.inf
    # The factor by which the number of light paths of the first tolerance must
    # increase.
    more = rough.light_of_difference / left
    finer = (TOLERANCES[0] / TOLERANCES[1]) ** 2
    slope = (fine.seconds - rough.seconds) / (finer - 1)
    return rough.seconds + slope * (more - 1)


def tell(objective: str, noise_by_setting: dict[Any, Noise]) -> None:
    first = TOLERANCES[0]
    alike, fine = (
        noise_by_setting[next(iter(CELLS)), each] for each in TOLERANCES
    )
    wanted = alike.light_of_difference + of_field(fine)
    for cell in CELLS:
        both = [noise_by_setting[cell, each] for each in TOLERANCES]
        cost = seconds_for(wanted, *both) / alike.seconds
        for tolerance, noise in zip(TOLERANCES, both, strict=True):
            price = f"{cost:.2f}" if np.isfinite(cost) else "-"
            print(
                f"| {objective} | {cell} | {tolerance} "
                f"| {parts(noise.light_of_row, noise.row)} "
                f"| {parts(noise.light_of_difference, noise.difference)} "
                f"| {1e3 * noise.seconds:.1f} "
                f"| {price if tolerance == first else ''} |",
                flush=True,
            )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument(
        "--objective", nargs="+", choices=OBJECTIVES, default=list(OBJECTIVES)
    )
    parser.add_argument("--plants", type=int, default=8)
    parser.add_argument("--seeds", type=int, default=64)
    options = parser.parse_args()
    titles = ["objective", "plants", "tolerance"]
    for what in ("row", "difference"):
        titles += [f"{what}: light %", "field %", "all %"]
    titles += ["ms", "cost at equal error"]
    print(f"| {' | '.join(titles)} |\n{len(titles) * '|---'}|")
    for objective in options.objective:
        tell(objective, measure(objective, options.plants, options.seeds))


if __name__ == "__main__":
    main()
