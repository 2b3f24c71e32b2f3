# SPDX-License-Identifier: Apache-2.0
"""CMA-ES of pycma optimises the plants of a campaign.

Any optimiser may propose plants. All plants of a generation are evaluated with
common random numbers (`seed`), so that noise does not decide their order. The
best is re-evaluated at the end. This example uses bounds and genomes."""

import cma
import matplotlib.pyplot as plt

import ideotype

stand = ideotype.Stand.from_campaign("campaigns/ames.toml")
lower, upper = stand.bounds
start = (stand.start - lower) / (upper - lower)
options = {"bounds": [0, 1], "maxiter": 40, "seed": 1, "verbose": -9}
search = cma.CMAEvolutionStrategy(start, 0.15, options)
means = []
while not search.stop():
    points = search.ask()
    plants = [lower + point * (upper - lower) for point in points]
    results = stand.evaluate(plants, ["absorbed_par"], seed=search.countiter)
    search.tell(points, list(-results.absorbed_par.values))
    means.append(results.absorbed_par.mean().item())
best = lower + search.result.xfavorite * (upper - lower)
baseline, optimised = stand.evaluate(
    [stand.start, best], final=True
).absorbed_par.values
print(f"gain {100 * (optimised / baseline - 1):.1f} %")

plt.figure(figsize=(5, 3.2), layout="constrained")
plt.plot(means)
plt.axhline(baseline, color="0.5", label="baseline")
plt.xlabel("generation")
plt.ylabel("population mean [MJ m$^{-2}$ day$^{-1}$]")
plt.legend()
plt.savefig("10_pycma.png")
