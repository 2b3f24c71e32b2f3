# SPDX-License-Identifier: Apache-2.0
"""Computes the numbers in made histories by formulas."""

from __future__ import annotations

import numpy as np
from made_kinds import Measured

LEAVES = 10
POPULATION = 12
GENERATIONS = 8
FINALISTS = 4
BASELINE = 11.0
"""The absorbed PAR of the baseline in all rows [MJ m-2 day-1]."""
INCIDENT = 12.2
"""The incident PAR [MJ m-2 day-1]."""
ERROR = 0.02
"""The standard error of absorbed PAR; /final has a quarter of it."""
HOURS = [*range(7, 20), 19.5]

KINDS = {
    "length": ("m", 0.40, 1.10),
    "width": ("m", 0.05, 0.14),
    "insertion_angle": ("deg", 10.0, 80.0),
    "azimuth": ("deg", 0.0, 360.0),
}
BASELINE_LEAF = {
    "length": [0.65, 0.71, 0.76, 0.82, 0.80, 0.77, 0.73, 0.66, 0.59, 0.48],
    "width": [
        0.073,
        0.076,
        0.081,
        0.085,
        0.086,
        0.084,
        0.079,
        0.073,
        0.065,
        0.055,
    ],
    "insertion_angle": [
        34.0,
        31.0,
        29.0,
        25.0,
        20.0,
        20.0,
        19.0,
        18.0,
        17.0,
        16.0,
    ],
    "azimuth": [90.0, 270.0] * 5,
}

TRAITS = [
    (f"leaf{leaf:02}_{kind}", *KINDS[kind], kind == "azimuth")
    for leaf in range(1, LEAVES + 1)
    for kind in KINDS
]
"""Name, unit, lower and upper bound of each trait, and whether it is
circular."""

PARTS = ("absorbed", "stalk", "soil", "reflected")
RANDOMISATIONS = 8
"""The number of randomisations of evaluations; finalists have twice as
many."""
COMMON_NOISE = 0.9
"""The part of the variance of a randomisation that rows of a generation
share."""
LABELS = {"leaf": np.arange(1, LEAVES + 1, dtype="i4"), "hour": HOURS}
"""The labels of the axes of quantities."""
QUANTITIES = {
    "absorbed_par": Measured("MJ m-2 day-1"),
    "absorbed_par_per_leaf_area": Measured("MJ m-2 day-1"),
    **{f"{part}_fraction": Measured("1") for part in PARTS},
    "incident": Measured("MJ m-2 day-1", is_exact=True),
    "balance_error": Measured("1", is_exact=True),
    "lai": Measured("m2 m-2", is_exact=True),
    "absorbed_by_leaf": Measured("MJ m-2 day-1", "leaf"),
    "absorbed_by_hour": Measured("W m-2", "hour"),
}
LAI = 3.44


def absorbed(generation: int, slot: int) -> float:
    """Returns the PAR absorbed by leaves [MJ m-2 day-1]; slot 0 of generation
    0 is the baseline."""
    return BASELINE + 0.05 * generation + 0.01 * slot


def final_absorbed(slot: int) -> float:
    """Returns the PAR absorbed by leaves in /final; slot 2 is the best plant,
    1.5 % above the baseline."""
    return BASELINE * (1 + [0.0, 0.010, 0.015, 0.005][slot])


def hypervolume(generation: int) -> float:
    """Returns the hypervolume of a generation's front, for several
    objectives."""
    return 1.0 - 0.5 ** (generation + 1)


def leaf_share(leaf: int) -> float:
    """Returns the fraction of the absorbed PAR that leaf 1 ... LEAVES
    absorbs."""
    return 2 * leaf / (LEAVES * (LEAVES + 1))


def hour_par(total: float, hour: float) -> float:
    """Returns the PAR absorbed at a local time [W m-2] by a canopy with the
    given daily total."""
    return 36.0 * total * np.sin(np.pi * (hour - 6.0) / 15.0)


def quantities(total: float) -> dict[str, float | np.ndarray]:
    """Returns all quantities of a canopy with the given daily total [MJ m-2
    day-1]."""
    fraction = total / INCIDENT
    shares = (fraction, *((1 - fraction) * np.array([0.2, 0.5, 0.3])))
    return {
        "absorbed_par": total,
        "absorbed_par_per_leaf_area": total / LAI,
        **{f"{part}_fraction": x for part, x in zip(PARTS, shares)},
        "incident": INCIDENT,
        "balance_error": 0.0,
        "lai": LAI,
        "absorbed_by_leaf": total
        * np.array([leaf_share(leaf) for leaf in range(1, LEAVES + 1)]),
        "absorbed_by_hour": np.array([hour_par(total, h) for h in HOURS]),
    }


def randomisations(
    total: float, error: float, count: int, generation: int, slot: int
) -> np.ndarray:
    """Generates randomisations with the given mean and standard error; rows of
    a generation share most of their noise."""

    def noise(*seed: int) -> np.ndarray:
        draws = np.random.default_rng(seed).normal(size=count)
        return draws - draws.mean()

    common, single = noise(7, generation), noise(8, generation, slot)
    combined = COMMON_NOISE**0.5 * common + (1 - COMMON_NOISE) ** 0.5 * single
    return total + combined * error * count**0.5 / combined.std(ddof=1)


def baseline_genome() -> np.ndarray:
    """Returns the genome of the baseline."""
    return np.array(
        [BASELINE_LEAF[kind][leaf] for leaf in range(LEAVES) for kind in KINDS]
    )


def genome(generation: int, slot: int) -> np.ndarray:
    """Returns the plant of a row. The azimuth of leaf 1 is 355 + s deg in slot
    s, so that the circular mean is near 0 and not near 180."""
    if generation == 0 and slot == 0:
        return baseline_genome()
    draw = np.random.default_rng([generation, slot])
    genes = baseline_genome()
    for i, (_, _, lower, upper, circular) in enumerate(TRAITS):
        step = draw.normal() * 0.04 * (upper - lower)
        genes[i] += step
        genes[i] = genes[i] % 360 if circular else genes[i].clip(lower, upper)
    genes[3] = (355.0 + slot) % 360
    return genes
