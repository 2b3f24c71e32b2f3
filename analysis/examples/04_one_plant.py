# SPDX-License-Identifier: Apache-2.0
"""A plant of a crop file, and the light that each leaf absorbs.

The plant stands in a uniform field. Upper leaves absorb most; those in the
middle are larger but shaded. This example uses `Stand`, its genes and results by
leaf."""

import matplotlib.pyplot as plt

import ideotype

stand = ideotype.Stand.from_campaign("campaigns/ames_quick.toml")
result = stand.evaluate(stand.baseline).isel(plant=0)
by_leaf = result.absorbed_by_leaf
best = int(by_leaf.leaf[by_leaf.argmax()])
share = float(by_leaf.max() / by_leaf.sum())
print(f"leaf {best} absorbs {100 * share:.0f} % of the light on leaves")

plant = stand.mesh(stand.baseline)
figure, (left, right) = plt.subplots(
    1, 2, figsize=(7, 3.6), layout="constrained"
)
for face, leaf in zip(plant.faces, plant.ranks):
    x, _, z = plant.vertices[list(face)].T
    left.fill(x, z, color="C2" if leaf else "0.6", lw=0)
left.set(xlabel="across the row [m]", ylabel="height [m]", aspect="equal")
right.barh(
    by_leaf.leaf,
    by_leaf,
    xerr=1.96 * result.absorbed_by_leaf_standard_error,
)
right.set(xlabel="absorbed PAR [MJ m$^{-2}$ day$^{-1}$]", ylabel="leaf rank")
figure.savefig("04_one_plant.png")
