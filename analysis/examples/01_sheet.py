# SPDX-License-Identifier: Apache-2.0
"""One level leaf over all of the ground, where theory knows the answer.

Light that the soil reflects comes back from below the leaf, again and again: a
geometric series. The program follows paths and knows nothing of series. This
teaches `ideotype.mesh` and what standard errors mean."""

import matplotlib.pyplot as plt
import numpy as np

import ideotype

CORNERS = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
LEAF = 0.05  # Both reflectance and transmittance.
leaf = ideotype.mesh(CORNERS, [[0, 1, 2, 3]])
albedos = np.linspace(0, 0.9, 10)
found = [
    leaf.evaluate(
        period=(1, 1), sun=(40, 180), leaf=(LEAF, LEAF), soil_albedo=albedo
    )
    for albedo in albedos
]
absorbed = np.array([each.leaves.item() for each in found])
errors = np.array([each.leaves_standard_error.item() for each in found])
below = LEAF * albedos / (1 - LEAF * albedos)  # Light that the soil returns.
theory = (1 - 2 * LEAF) * (1 + below)
print(f"largest difference from theory {abs(absorbed - theory).max():.5f}")

plt.figure(figsize=(5, 3.2), layout="constrained")
plt.plot(albedos, theory, label="theory")
plt.errorbar(albedos, absorbed, 2 * errors, fmt="o", label="traced, 2 s.e.")
plt.xlabel("albedo of the soil")
plt.ylabel("absorbed by the leaf")
plt.legend()
plt.savefig("01_sheet.png")
