# SPDX-License-Identifier: Apache-2.0
"""CMA-ES of pycma breeds the plants of a campaign."""

import cma

import ideotype

stand = ideotype.Stand.from_campaign("campaigns/ames.toml")
lower, upper = stand.bounds
start = (stand.start - lower) / (upper - lower)
options = {"bounds": [0, 1], "maxiter": 40, "seed": 1, "verbose": -9}
search = cma.CMAEvolutionStrategy(start, 0.15, options)
while not search.stop():
    points = search.ask()
    plants = [lower + point * (upper - lower) for point in points]
    found = stand.evaluate(plants, ["absorbed_par"], seed=search.countiter)
    search.tell(points, list(-found.absorbed_par.values))
best = lower + search.result.xfavorite * (upper - lower)
own, bred = stand.evaluate([stand.start, best], final=True).absorbed_par.values
print(f"gain {100 * (bred / own - 1):.1f} %")
