# SPDX-License-Identifier: Apache-2.0
"""SciPy turns all rows and finds the direction that absorbs most."""

from scipy.optimize import minimize_scalar

import ideotype


def loss(direction: float) -> float:
    stand = ideotype.Stand.from_campaign(
        "campaigns/ames.toml",
        settings=[
            "spacing=[{row = 0.762, plant = 0.1524, "
            f"row_direction = {direction}}}]"
        ],
    )
    found = stand.evaluate(stand.baseline, ["absorbed_par"], tolerance=0.002)
    return -found.absorbed_par.item()


best = minimize_scalar(
    loss, bounds=(0, 180), method="bounded", options={"xatol": 1}
)
print(f"rows at {best.x:.0f} deg absorb {-best.fun:.2f} MJ m-2 day-1")
