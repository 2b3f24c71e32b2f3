# SPDX-License-Identifier: Apache-2.0
"""A generator of libEnsemble proposes plants, and its workers evaluate them.

libEnsemble distributes evaluations over the nodes of a cluster; here it uses
three processes of one machine. This example uses `ideotype.search.gest`, which
describes genes and objectives in the standard of gest-api."""

import cma
import matplotlib.pyplot as plt
import numpy as np
from gest_api import Generator
from gest_api.vocs import VOCS
from libensemble import Ensemble
from libensemble.alloc_funcs.start_only_persistent import only_persistent_gens
from libensemble.specs import (
    AllocSpecs,
    ExitCriteria,
    GenSpecs,
    LibeSpecs,
    SimSpecs,
)

import ideotype
from ideotype.search.gest import Evaluator, vocs

POPULATION = 16


class CmaEs(Generator):
    """Proposes plants for one objective by CMA-ES of pycma (gest-api)."""

    def __init__(self, vocs: VOCS, start: dict[str, float]) -> None:
        super().__init__(vocs)
        self._names = list(vocs.variables)
        domains = [vocs.variables[name].domain for name in self._names]
        self._lower, self._upper = np.array(domains).T
        self._objective = vocs.objective_names[0]
        width = self._upper - self._lower
        start_point = (
            np.array([start[name] for name in self._names]) - self._lower
        ) / width
        options = {"bounds": [0, 1], "popsize": POPULATION, "verbose": -9}
        self._cma = cma.CMAEvolutionStrategy(
            start_point, 0.15, options | {"seed": 1}
        )

    def _validate_vocs(self, vocs: VOCS) -> None:
        if len(vocs.objectives) != 1:
            raise ValueError("CMA-ES has one objective")

    def suggest(self, num_points: int) -> list[dict[str, float]]:
        width = self._upper - self._lower
        points = self._cma.ask(num_points)
        plants = [self._lower + point * width for point in points]
        return [dict(zip(self._names, plant)) for plant in plants]

    def ingest(self, results: list[dict[str, float]]) -> None:
        if len(results) < POPULATION:
            return  # The run ends here.
        plants = np.array([[x[name] for name in self._names] for x in results])
        points = (plants - self._lower) / (self._upper - self._lower)
        values = [-x[self._objective] for x in results]
        self._cma.tell(list(points), values)


def main() -> None:
    stand = ideotype.Stand.from_campaign("campaigns/ames.toml")
    space = vocs(stand)
    start = dict(zip(stand.genes.name, stand.baseline))
    ensemble = Ensemble(
        libE_specs=LibeSpecs(
            comms="local",
            nworkers=3,
            disable_log_files=True,
        ),
        gen_specs=GenSpecs(
            generator=CmaEs(space, start),
            vocs=space,
            initial_batch_size=POPULATION,
            batch_size=POPULATION,
        ),
        sim_specs=SimSpecs(simulator=Evaluator(stand, seed=1), vocs=space),
        alloc_specs=AllocSpecs(alloc_f=only_persistent_gens),
        exit_criteria=ExitCriteria(sim_max=10 * POPULATION),
    )
    history, _, _ = ensemble.run()
    done = history[history["sim_ended"]]
    best = done[done["absorbed_par"].argmax()]
    free = stand.genes.name[stand.free]
    pair = [stand.start, [best[name] for name in free]]
    baseline, optimised = stand.evaluate(pair, final=True).absorbed_par.values
    print(f"{len(done)} plants, gain {100 * (optimised / baseline - 1):.1f} %")
    plt.figure(figsize=(5, 3.2), layout="constrained")
    order = np.argsort(done["sim_ended_time"])
    light = done["absorbed_par"][order]
    plt.plot(light, ".", label="plants")
    plt.plot(np.maximum.accumulate(light), label="best so far")
    plt.xlabel("evaluations")
    plt.ylabel("absorbed PAR [MJ m$^{-2}$ day$^{-1}$]")
    plt.legend()
    plt.savefig("17_libensemble.png")


if __name__ == "__main__":
    main()
