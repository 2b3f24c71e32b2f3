# SPDX-License-Identifier: Apache-2.0
"""More plants on the same ground: how much more light do they take?

Light saturates: plants that stand closer take it from each other, and at last
stalks take it from leaves. Any key of a campaign can be set from Python. This teaches `settings` and `tolerance`."""

import matplotlib.pyplot as plt
import numpy as np

import ideotype

ROW = 0.76
found = []
for plant in np.geomspace(1.2, 0.08, 8):
    stand = ideotype.Stand.from_campaign(
        "campaigns/ames_quick.toml",
        settings={"spacing": [{"row": ROW, "plant": float(plant)}]},
    )
    one = stand.evaluate(stand.baseline, tolerance=0.005).isel(plant=0)
    found.append((1 / (ROW * plant), float(one.absorbed_fraction)))
density, absorbed = np.array(found).T
most = density[absorbed.argmax()]
print(f"leaves take most of the light at {most:.1f} plants m-2")

plt.figure(figsize=(5, 3.2), layout="constrained")
plt.plot(density, absorbed, "o-")
plt.xlabel("plants m$^{-2}$")
plt.ylabel("part of PAR that leaves absorb")
plt.ylim(0, 1)
plt.savefig("06_density.png")
