# SPDX-License-Identifier: Apache-2.0
"""A level leaf over all of the ground, compared with theory.

Soil and leaf reflect light to each other again and again, so the absorbed light
is the sum of a geometric series. The program follows random paths instead and
agrees within its standard errors. This example uses `ideotype.mesh`."""

import matplotlib.pyplot as plt
import numpy as np

import ideotype

CORNERS = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
LEAF = 0.05  # Both reflectance and transmittance.
leaf = ideotype.mesh(CORNERS, [[0, 1, 2, 3]])
albedos = np.linspace(0, 0.9, 10)
results = [
    leaf.evaluate(
        period=(1, 1), sun=(40, 180), leaf=(LEAF, LEAF), soil_albedo=albedo
    )
    for albedo in albedos
]
absorbed = np.array([result.leaves.item() for result in results])
errors = np.array([result.leaves_standard_error.item() for result in results])
below = LEAF * albedos / (1 - LEAF * albedos)  # Light that the soil returns.
theory = (1 - 2 * LEAF) * (1 + below)
print(f"largest difference from theory {abs(absorbed - theory).max():.5f}")

plt.figure(figsize=(5, 3.2), layout="constrained")
plt.plot(albedos, theory, label="theory")
plt.errorbar(
    albedos, absorbed, 1.96 * errors, fmt="o", label="ideotype, 95 % CI"
)
plt.xlabel("soil albedo")
plt.ylabel("absorbed fraction of light")
plt.legend()
plt.savefig("01_sheet.png")
