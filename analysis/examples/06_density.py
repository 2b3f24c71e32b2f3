# SPDX-License-Identifier: Apache-2.0
"""Absorbed light at increasing plant density.

Absorption saturates: plants shade each other, and at high density stalks shade
leaves. Any key of a campaign can be set from Python. This example uses
`settings` and `tolerance`."""

import matplotlib.pyplot as plt
import numpy as np

import ideotype

ROW = 0.76
points = []
for plant in np.geomspace(1.2, 0.08, 8):
    stand = ideotype.Stand.from_campaign(
        "campaigns/ames_quick.toml",
        settings={"spacing": [{"row": ROW, "plant": float(plant)}]},
    )
    result = stand.evaluate(stand.baseline, tolerance=0.005).isel(plant=0)
    points.append((1 / (ROW * plant), float(result.absorbed_fraction)))
density, absorbed = np.array(points).T
best = density[absorbed.argmax()]
print(f"leaves absorb most of the light at {best:.1f} plants m-2")

plt.figure(figsize=(5, 3.2), layout="constrained")
plt.plot(density, absorbed, "o-")
plt.xlabel("plant density [m$^{-2}$]")
plt.ylabel("fraction of PAR absorbed by leaves")
plt.ylim(0, 1)
plt.savefig("06_density.png")
