# SPDX-License-Identifier: Apache-2.0
"""Optuna breeds insertion angles only; the other traits stay."""

import optuna

import ideotype

angles = 'traits=[{name = "angles", free = ["insertion_angle"]}]'
stand = ideotype.Stand.from_campaign("campaigns/ames.toml", settings=[angles])
genes = stand.genes[stand.genes.is_free]


def absorbed_par(trial: optuna.Trial) -> float:
    plant = [
        trial.suggest_float(gene.name, gene.lower, gene.upper)
        for gene in genes.itertuples()
    ]
    found = stand.evaluate(plant, ["absorbed_par"], seed=trial.number)
    return found.absorbed_par.item()


optuna.logging.set_verbosity(optuna.logging.WARNING)
sampler = optuna.samplers.TPESampler(seed=1)
study = optuna.create_study(direction="maximize", sampler=sampler)
study.enqueue_trial(dict(zip(genes.name, genes.baseline)))
study.optimize(absorbed_par, n_trials=100)
best = [study.best_params[name] for name in genes.name]
pair = [genes.baseline, best]
final = stand.evaluate(pair, ["absorbed_par"], final=True).absorbed_par.values
print(f"gain {100 * (final[1] / final[0] - 1):.1f} %")
