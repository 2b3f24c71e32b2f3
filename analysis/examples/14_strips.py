# SPDX-License-Identifier: Apache-2.0
"""Two crops in strips: which row has how much?

Maize in rows beside soybean takes light from over its neighbours, and the row of
soybean beside maize pays. This teaches components of a campaign and results by
row and component."""

import matplotlib.pyplot as plt

import ideotype

stand = ideotype.Stand.from_campaign("campaigns/strip.toml")
found = stand.evaluate(stand.baseline, tolerance=0.01).isel(plant=0)
rows, error = (
    found[f"net_assimilation_by_row{end}"] for end in ("", "_standard_error")
)
print(
    f"the row beside maize has {float(rows[2] / rows[3]):.2f} of what the "
    "middle row of soybean has"
)

plt.figure(figsize=(5, 3.2), layout="constrained")
colours = ["C2", "C2", "C1", "C1", "C1"]
plt.bar(range(1, 6), rows, yerr=2 * error, color=colours)
plt.xlabel("row: maize (green), soybean (orange)")
plt.ylabel(f"net assimilation [{rows.units}]")
plt.savefig("14_strips.png")
