# SPDX-License-Identifier: Apache-2.0
"""The options of a decision: the evaluated plants of a case with their
management."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import Error
from ..history.case import Case
from ..history.history import History
from ..history.rows import Origin, Rows
from .evaluate import name_in
from .worth import Floats, Rule, Worth


@dataclass(frozen=True)
class Options:
    """The feasible plants of a case that have been evaluated, with the parts
    of their worth in each environment."""

    case: str
    environments: tuple[str, ...]
    weights: Floats
    """The weights of the environments; their sum is 1."""
    worth: Worth
    """What is compared; with the prices of the campaign."""
    rule: Rule
    genomes: tuple[Floats, ...]
    histories: tuple[History, ...]
    """The history of each plant."""
    parts: Floats
    """The parts of the worth [plants, environments, parts]; a campaign without
    panels or soil has no electricity or irrigation."""
    is_baseline: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.genomes)

    def worths(self, prices: Mapping[str, float] | None = None) -> Floats:
        """Returns the worth of all plants in all environments
        [plants, environments], by default at the prices of the campaign."""
        return self.worth.of(self.parts, prices)

    def values(self, prices: Mapping[str, float] | None = None) -> Floats:
        """Returns the values over environments [plants]."""
        return self.rule.value(self.worths(prices), self.weights)

    def keys(self, index: int) -> dict[str, str]:
        """Returns the values of the searched keys of the campaign for a plant,
        as texts: numbers, dates or choices."""
        history, genome = self.histories[index], self.genomes[index]
        keys = history.resolved.get("search", {}).get("keys", [])
        first = len(genome) - len(keys)  # they end the genome
        return {
            each["key"]: history.genes.text(gene, genome[gene])
            for gene, each in enumerate(keys, first)
        }


def find_worth(case: Case) -> Worth | None:
    """Returns what a decision about a case compares: the margin at the prices
    of its campaign, or else the only objective, if it is maximised over
    several scenarios; None if neither exists."""
    if "prices" in case.resolved:
        prices = case.resolved["prices"]
        return Worth.of_prices({key: float(x) for key, x in prices.items()})
    rows = case.best.row
    goal, *others = rows.goals
    if others or goal.sign < 0 or not rows.with_axis("scenario"):
        return None
    unit = rows.quantities[f"{goal.name}_by_scenario"].unit
    return Worth.of_objective(goal.name, unit)


def read_options(case: Case) -> Options:
    """Returns the options of a case: all evaluated plants of all its searches,
    the baseline included.

    Raises Error if the campaign has neither prices nor one maximised objective
    over scenarios, or if no plant is evaluated."""
    worth = find_worth(case)
    if worth is None:
        raise Error(
            f"{case.name}: nothing to decide; the campaign needs [prices], or "
            "one objective that is maximised over several scenarios"
        )
    names: tuple[str, ...] = ("all",)
    weights = np.ones(1)
    genomes: list[Floats] = []
    histories: list[History] = []
    parts, baseline = [], []
    for history in case.histories:
        rows = history.evaluations().done
        rows = rows.take(rows.violation <= 0)
        if not len(rows):
            continue
        names, weights = _environments(rows)
        parts.append(_parts(rows, worth, len(names)))
        genomes += list(rows.genome)
        histories += [history] * len(rows)
        baseline.append(rows.origin == Origin.BASELINE)
    if not parts:
        raise Error(f"{case.name}: no feasible plant is evaluated yet")
    return Options(
        case.name,
        names,
        weights,
        worth,
        Rule.read(case.resolved, worth),
        tuple(genomes),
        tuple(histories),
        np.concatenate(parts),
        np.concatenate(baseline),
    )


def _environments(rows: Rows) -> tuple[tuple[str, ...], Floats]:
    """Returns the names and the weights of the environments."""
    axes = [q.axis for q in rows.with_axis("scenario") if q.axis]
    if not axes:
        return ("all",), np.ones(1)
    names = tuple(str(x) for x in axes[0].labels)
    if "scenario_weight" in rows.quantities:
        return names, rows.quantities["scenario_weight"].values[0]
    return names, np.full(len(names), 1 / len(names))


def _parts(rows: Rows, worth: Worth, environments: int) -> Floats:
    """Returns the parts of the worth [rows, environments, parts]."""
    parts = np.zeros((len(rows), environments, len(worth.parts)))
    for i, part in enumerate(worth.parts):
        name = name_in(rows.quantities, part)
        if name in rows.quantities:
            values = rows.quantities[name].values
            parts[:, :, i] = values.reshape(len(rows), -1)
    return parts
