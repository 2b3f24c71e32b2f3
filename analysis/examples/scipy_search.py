# SPDX-License-Identifier: Apache-2.0
"""SciPy turns all rows and finds the direction that absorbs most."""

from scipy.optimize import minimize_scalar

import ideotype

CAMPAIGN = "campaigns/ames.toml"


def loss(direction: float) -> float:
    spacing = {"row": 0.762, "plant": 0.1524, "row_direction": direction}
    stand = ideotype.Stand.from_campaign(
        CAMPAIGN, settings={"spacing": [spacing]}
    )
    found = stand.evaluate(stand.baseline, tolerance=0.002)
    return -found.absorbed_par.item()


best = minimize_scalar(loss, bounds=(0, 180), options={"xatol": 1})
print(f"rows at {best.x:.0f} deg absorb {-best.fun:.2f} MJ m-2 day-1")
