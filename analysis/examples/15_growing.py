# SPDX-License-Identifier: Apache-2.0
"""Sorghum grows: its leaves appear and die in thermal time.

Thermal time is the sum of temperatures above a base from emergence on. This
example uses `Crop` without a campaign: plants of any age, and the leaf area of a
stand day by day."""

import matplotlib.pyplot as plt
import numpy as np

import ideotype

crop = ideotype.Crop.from_file("campaigns/crops/sorghum.toml")
figure, (left, right) = plt.subplots(
    1, 2, figsize=(8, 3.4), layout="constrained"
)
ages = np.array([0.25, 0.5, 0.75, 1.0, 1.5]) * crop.silking
for i, age in enumerate(ages):
    plant = crop.mesh(age)
    for face, leaf in zip(plant.faces, plant.ranks):
        x, _, z = plant.vertices[list(face)].T
        colour = "C2" if leaf else "0.6"
        left.fill(x + 1.2 * i, z, color=colour, lw=0)
left.set(
    xticks=1.2 * np.arange(5),
    xticklabels=[f"{age:.0f}" for age in ages],
    xlabel="thermal time [°C d]",
    ylabel="height [m]",
    aspect="equal",
)
days, hours = np.arange(130), np.arange(24)
seasonal = 21 + 4 * np.sin(np.pi * days / 130)[:, None]
daily = 6 * np.sin(2 * np.pi * (hours - 9) / 24)
season = crop.season("2025-05-10", (seasonal + daily).ravel(), density=8)
right.plot(season.day, season.leaf_area_index, label="green")
right.plot(season.day, season.dead_area_index, label="dead")
right.set(ylabel="leaf area index")
right.tick_params("x", rotation=30)
right.legend()
print(f"maximum leaf area index {float(season.leaf_area_index.max()):.1f}")
figure.savefig("15_growing.png")
