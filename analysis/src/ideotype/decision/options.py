# SPDX-License-Identifier: Apache-2.0
"""The options of a decision: the evaluated plants of a case with their
management."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Error
from ..history.case import Case
from ..history.history import History
from ..history.rows import Origin, Rows
from .margin import PARTS, Floats, Rule, weights_of_prices


@dataclass(frozen=True)
class Options:
    """The feasible plants of a case that have been evaluated, with the parts
    of their margins in each environment."""

    case: str
    environments: tuple[str, ...]
    weights: Floats
    """The weights of the environments; their sum is 1."""
    prices: Mapping[str, float]
    """The prices of the campaign."""
    rule: Rule
    genomes: tuple[Floats, ...]
    histories: tuple[History, ...]
    """The history of each plant."""
    parts: Floats
    """The parts [plants, environments, parts] in the order of PARTS; a
    campaign without panels or soil has no electricity or irrigation."""
    is_baseline: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.genomes)

    def margins(self, prices: Mapping[str, float] | None = None) -> Floats:
        """Returns the margins of all plants in all environments
        [plants, environments], by default at the prices of the campaign."""
        factors, fixed = weights_of_prices(prices or self.prices)
        return self.parts @ factors + fixed

    def values(self, prices: Mapping[str, float] | None = None) -> Floats:
        """Returns the values over environments [plants]."""
        return self.rule.value(self.margins(prices), self.weights)

    def keys(self, index: int) -> dict[str, float]:
        """Returns the searched keys of the campaign of a plant."""
        return keys_of(self.histories[index], self.genomes[index])


def keys_of(history: History, genome: Floats) -> dict[str, float]:
    """Returns the values of the searched keys at the end of a genome."""
    keys = history.resolved.get("search", {}).get("keys", [])
    if not keys:
        return {}
    values = genome[len(genome) - len(keys) :]
    return {x["key"]: float(v) for x, v in zip(keys, values)}


def has_prices(case: Case) -> bool:
    """Returns whether the campaign of a case has prices."""
    return "prices" in case.resolved


def read_options(case: Case) -> Options:
    """Returns the options of a case with prices: all evaluated plants of all
    its searches, the baseline included.

    Raises Error if the campaign has no prices, or no plant is evaluated."""
    if not has_prices(case):
        raise Error(f"{case.name}: the campaign has no [prices]; add them")
    resolved = case.resolved
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
        parts.append(_parts(rows))
        genomes += list(rows.genome)
        histories += [history] * len(rows)
        baseline.append(rows.origin == Origin.BASELINE)
    if not parts:
        raise Error(f"{case.name}: no feasible plant is evaluated yet")
    return Options(
        case.name,
        names,
        weights,
        _prices(resolved),
        Rule.read(resolved),
        tuple(genomes),
        tuple(histories),
        np.concatenate(parts),
        np.concatenate(baseline),
    )


def _prices(resolved: Mapping[str, Any]) -> dict[str, float]:
    return {name: float(x) for name, x in resolved["prices"].items()}


def _environments(rows: Rows) -> tuple[tuple[str, ...], Floats]:
    """Returns the names and the weights of the environments."""
    axes = [q.axis for q in rows.with_axis("scenario") if q.axis]
    if not axes:
        return ("all",), np.ones(1)
    names = tuple(str(x) for x in axes[0].labels)
    if "scenario_weight" in rows.quantities:
        return names, rows.quantities["scenario_weight"].values[0]
    return names, np.full(len(names), 1 / len(names))


def _parts(rows: Rows) -> Floats:
    """Returns the parts of the margins [rows, environments, parts]."""
    names = [name for name, _ in PARTS.values()]
    count = len(_environments(rows)[0])
    parts = np.zeros((len(rows), count, len(names)))
    for i, name in enumerate(names):
        by_scenario = f"{name}_by_scenario"
        found = by_scenario if by_scenario in rows.quantities else name
        if found in rows.quantities:
            values = rows.quantities[found].values
            parts[:, :, i] = values.reshape(len(rows), -1)
    return parts
