"""The numbers in the made histories: all known from a formula here."""

from __future__ import annotations

import numpy as np

LEAVES = 10
POPULATION = 12
GENERATIONS = 8
FINALISTS = 4
BASELINE = 11.0
"""Absorbed PAR of the baseline, all rows [MJ m-2 day-1]."""
INCIDENT = 12.2
"""[MJ m-2 day-1]"""
ERROR = 0.02
"""Standard error of absorbed PAR; a quarter of it in /final."""
HOURS = list(range(7, 20)) + [19.5]

STATUS = {"empty": 0, "proposed": 1, "done": 2, "failed": 3}
ORIGIN = {"none": 0, "baseline": 1, "random": 2, "elite": 3, "child": 4}

KINDS = {
    "length": ("m", 0.40, 1.10),
    "width": ("m", 0.05, 0.14),
    "insertion_angle": ("deg", 10.0, 80.0),
    "azimuth": ("deg", 0.0, 360.0),
}
BASELINE_LEAF = {
    "length": [0.65, 0.71, 0.76, 0.82, 0.80, 0.77, 0.73, 0.66, 0.59, 0.48],
    "width": [0.073, 0.076, 0.081, 0.085, 0.086]
    + [0.084, 0.079, 0.073, 0.065, 0.055],
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
"""Name, unit, lower and upper bound, is circular."""

HOUR_NAMES = [f"{int(h):02}_{round(h % 1 * 60):02}" for h in HOURS]
FRACTIONS = ["absorbed", "stalk", "soil", "reflected"]
DIAGNOSTICS = [
    *[(f"{name}_fraction", "1") for name in FRACTIONS],
    ("incident", "MJ m-2 day-1"),
    ("balance_error", "1"),
    ("lai", "m2 m-2"),
    *[(f"absorbed_leaf{n:02}", "MJ m-2 day-1") for n in range(1, LEAVES + 1)],
    *[(f"absorbed_hour_{hour}", "W m-2") for hour in HOUR_NAMES],
]
"""Name and unit."""
LAI = [name for name, _ in DIAGNOSTICS].index("lai")
"""Its column, which has no error."""


def absorbed(generation: int, slot: int) -> float:
    """PAR absorbed by the leaves [MJ m-2 day-1]; the baseline is slot 0 of
    generation 0."""
    return BASELINE + 0.05 * generation + 0.01 * slot


def final_absorbed(slot: int) -> float:
    """The same in /final; slot 2 is the best and 1.5 % above the baseline."""
    return BASELINE * (1 + [0.0, 0.010, 0.015, 0.005][slot])


def leaf_share(leaf: int) -> float:
    """Part of the absorbed PAR that leaf 1 ... LEAVES takes."""
    return 2 * leaf / (LEAVES * (LEAVES + 1))


def hour_par(total: float, hour: float) -> float:
    """Absorbed at a local time [W m-2] by a canopy of this daily total."""
    return 36.0 * total * np.sin(np.pi * (hour - 6.0) / 15.0)


def diagnostics(total: float) -> np.ndarray:
    """All diagnostics of a canopy of this total [MJ m-2 day-1]."""
    fraction = total / INCIDENT
    rest = 1 - fraction
    return np.array(
        [fraction, 0.2 * rest, 0.5 * rest, 0.3 * rest, INCIDENT, 0.0, 3.44]
        + [leaf_share(leaf) * total for leaf in range(1, LEAVES + 1)]
        + [hour_par(total, hour) for hour in HOURS]
    )


def baseline_genome() -> np.ndarray:
    """The unbred plant, gene by gene."""
    return np.array(
        [BASELINE_LEAF[kind][leaf] for leaf in range(LEAVES) for kind in KINDS]
    )


def genome(generation: int, slot: int) -> np.ndarray:
    """The plant of a row. Azimuths of leaf 1 lie around north: slot s has
    355 + s deg, so that their circular mean is near 0 and not near 180."""
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
