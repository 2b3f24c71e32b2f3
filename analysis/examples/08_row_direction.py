# SPDX-License-Identifier: Apache-2.0
"""SciPy optimises the row direction for absorbed light.

A search may change the field as well as the plant. The noise is smaller than the
effect of the direction. This example optimises a single number with any
optimiser."""

import matplotlib.pyplot as plt
from scipy.optimize import minimize_scalar

import ideotype

CAMPAIGN = "campaigns/ames.toml"
tried: list[tuple[float, float]] = []


def loss(direction: float) -> float:
    spacing = {"row": 0.762, "plant": 0.1524, "row_direction": direction}
    stand = ideotype.Stand.from_campaign(
        CAMPAIGN, settings={"spacing": [spacing]}
    )
    result = stand.evaluate(stand.baseline, tolerance=0.002)
    tried.append((direction, result.absorbed_par.item()))
    return -tried[-1][1]


best = minimize_scalar(loss, bounds=(0, 180), options={"xatol": 1})
print(f"rows at {best.x:.0f} deg absorb {-best.fun:.2f} MJ m-2 day-1")

plt.figure(figsize=(5, 3.2), layout="constrained")
plt.plot(*zip(*sorted(tried)), "o-")
plt.xlabel("row direction, clockwise from north [deg]")
plt.ylabel("absorbed PAR [MJ m$^{-2}$ day$^{-1}$]")
plt.savefig("08_row_direction.png")
