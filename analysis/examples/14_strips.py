# SPDX-License-Identifier: Apache-2.0
"""Net assimilation of each row in strips of maize and soybean.

Maize shades the soybean rows next to it, which assimilate less than the middle
row. This example uses components of a campaign and results by row."""

import matplotlib.pyplot as plt

import ideotype

stand = ideotype.Stand.from_campaign("campaigns/strip.toml")
result = stand.evaluate(stand.baseline, tolerance=0.01).isel(plant=0)
rows, error = (
    result[f"net_assimilation_by_row{end}"] for end in ("", "_standard_error")
)
print(
    "soybean next to maize assimilates "
    f"{float(rows[2] / rows[3]):.2f} times as much as the middle row"
)

plt.figure(figsize=(5, 3.2), layout="constrained")
colours = ["C2", "C2", "C1", "C1", "C1"]
plt.bar(range(1, 6), rows, yerr=1.96 * error, color=colours)
plt.xlabel("row: maize (green), soybean (orange)")
plt.ylabel(f"net assimilation [{rows.units}]")
plt.savefig("14_strips.png")
