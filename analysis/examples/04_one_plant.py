# SPDX-License-Identifier: Apache-2.0
"""A plant of a crop file, and the light of each of its leaves.

The plant stands in a field of plants like it. Leaves at the top take most; those
in the middle are larger but shaded. This teaches `Stand`, its genes, and results
by leaf."""

import matplotlib.pyplot as plt

import ideotype

stand = ideotype.Stand.from_campaign("campaigns/ames_quick.toml")
found = stand.evaluate(stand.baseline).isel(plant=0)
by_leaf = found.absorbed_by_leaf
most = int(by_leaf.leaf[by_leaf.argmax()])
share = float(by_leaf.max() / by_leaf.sum())
print(f"leaf {most} takes {100 * share:.0f} % of the light of leaves")

plant = stand.mesh(stand.baseline)
figure, (left, right) = plt.subplots(
    1, 2, figsize=(7, 3.6), layout="constrained"
)
for face, leaf in zip(plant.faces, plant.ranks):
    x, _, z = plant.vertices[list(face)].T
    left.fill(x, z, color="C2" if leaf else "0.6", lw=0)
left.set(xlabel="across the row [m]", ylabel="height [m]", aspect="equal")
right.barh(
    by_leaf.leaf, by_leaf, xerr=2 * found.absorbed_by_leaf_standard_error
)
right.set(
    xlabel="absorbed PAR [MJ m$^{-2}$ day$^{-1}$]", ylabel="leaf, from below"
)
figure.savefig("04_one_plant.png")
