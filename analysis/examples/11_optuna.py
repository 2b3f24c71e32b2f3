# SPDX-License-Identifier: Apache-2.0
"""Optuna optimises insertion angles alone, by CMA-ES.

Fewer traits need fewer evaluations, and gain less. This example uses trait sets,
in which a campaign names the free traits."""

import matplotlib.pyplot as plt
import optuna

import ideotype

angles = {"traits": [{"name": "angles", "free": ["insertion_angle"]}]}
stand = ideotype.Stand.from_campaign("campaigns/ames.toml", settings=angles)
genes = stand.genes[stand.free][["name", "lower", "upper"]].values


def absorbed_par(trial: optuna.Trial) -> float:
    plant = [trial.suggest_float(*gene) for gene in genes]
    return stand.evaluate(plant, seed=trial.number).absorbed_par.item()


optuna.logging.set_verbosity(optuna.logging.WARNING)
sampler = optuna.samplers.CmaEsSampler(seed=1)
study = optuna.create_study(direction="maximize", sampler=sampler)
study.enqueue_trial(dict(zip(genes[:, 0], stand.start)))
study.optimize(absorbed_par, n_trials=300)
best = [study.best_params[name] for name in genes[:, 0]]
baseline, optimised = stand.evaluate(
    [stand.start, best], final=True
).absorbed_par.values
print(f"gain {100 * (optimised / baseline - 1):.1f} %")

plt.figure(figsize=(5, 3.2), layout="constrained")
leaves = range(1, len(best) + 1)
plt.barh(leaves, stand.start, height=0.4, label="baseline")
plt.barh([leaf + 0.4 for leaf in leaves], best, height=0.4, label="optimised")
plt.xlabel("insertion angle [deg]")
plt.ylabel("leaf rank")
plt.legend()
plt.savefig("11_optuna.png")
