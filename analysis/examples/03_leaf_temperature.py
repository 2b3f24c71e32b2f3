# SPDX-License-Identifier: Apache-2.0
"""Leaf temperature and transpiration at different wind speeds.

A leaf absorbs light and longwave radiation, and loses energy as sensible heat,
latent heat and emitted radiation. In calm air it loses little heat. This example
uses `leaf_energy_balance`, which takes arrays."""

import matplotlib.pyplot as plt
import numpy as np

import ideotype

NOON = {
    "ppfd": 1361, "nir": 162, "longwave": 839, "air": 28.4, "rh": 0.55,
    "co2": 410, "pressure": 99, "width": 0.08,
}  # fmt: skip
wind = np.geomspace(0.1, 10, 40)
c4 = ideotype.leaf_energy_balance(NOON | {"wind": wind})
c3 = ideotype.leaf_energy_balance(NOON | {"wind": wind, "model": "farquhar"})
warming = c4["leaf"] - NOON["air"]
print(f"warmer than the air by {warming[0]:.1f} to {warming[-1]:.1f} deg C")

figure, (left, right) = plt.subplots(
    1, 2, figsize=(7, 3), layout="constrained"
)
for name, leaf in (("C4, maize", c4), ("C3, soybean", c3)):
    left.semilogx(wind, leaf["leaf"] - NOON["air"], label=name)
    right.semilogx(wind, leaf["transpiration"], label=name)
left.set(
    xlabel="wind speed [m s$^{-1}$]", ylabel="leaf − air temperature [°C]"
)
right.set(
    xlabel="wind speed [m s$^{-1}$]",
    ylabel="transpiration [mmol m$^{-2}$ s$^{-1}$]",
)
right.legend()
figure.savefig("03_leaf_temperature.png")
