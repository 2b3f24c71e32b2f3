# SPDX-License-Identifier: Apache-2.0
"""What a decision compares, the margin or an objective, and its value over
environments."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

PRICED = {
    "grain": ("grain_yield_moist", 1.0),
    "seed": ("seeds", -1e4),
    "water": ("irrigation", -10.0),
    "electricity": ("electricity", 1e4),
}
"""By the name of a price: the quantity that it multiplies, in its unit per
area [t ha-1, m-2, mm, kWh m-2], and the factor that yields the revenue per
hectare."""

PRICE_UNITS = {
    "grain": "per t",
    "seed": "per plant",
    "water": "per m³",
    "electricity": "per kWh",
    "other": "per ha",
}
_ROUNDING = 1e-9


@dataclass(frozen=True)
class Worth:
    """What a decision compares: a sum of stored quantities, the parts, of which
    more is better. With prices it is the margin, else an objective."""

    name: str
    unit: str
    parts: tuple[str, ...]
    """The names of the quantities."""
    prices: Mapping[str, float]
    """The prices of the margin by name; empty for an objective."""

    @classmethod
    def of_prices(cls, prices: Mapping[str, float]) -> Worth:
        """Returns the margin at prices with the names of [prices]."""
        parts = tuple(name for name, _ in PRICED.values())
        return cls("margin", "currency ha-1", parts, dict(prices))

    @classmethod
    def of_objective(cls, name: str, unit: str) -> Worth:
        """Returns an objective that is maximised."""
        return cls(name, unit, (name,), {})

    def of(
        self, parts: Floats, prices: Mapping[str, float] | None = None
    ) -> Floats:
        """Returns the worth [...] of parts [..., parts], by default at its own
        prices. These have no effect on an objective."""
        if not self.prices:
            return parts[..., 0]
        prices = self.prices if prices is None else prices
        factors = [
            factor * float(prices.get(price, 0))
            for price, (_, factor) in PRICED.items()
        ]
        return np.asarray(parts @ factors - float(prices.get("other", 0)))

    def at(self, price: str, value: float) -> dict[str, float]:
        """Returns the prices with another value of one of them."""
        return {**self.prices, price: value}

    def swept_prices(self, parts: Floats) -> list[str]:
        """Returns the prices above 0 of parts [..., parts] that are not all
        0."""
        return [
            price
            for i, price in enumerate(PRICED)
            if self.prices.get(price, 0) > 0 and parts[..., i].any()
        ]


@dataclass(frozen=True)
class Rule:
    """How values in several environments become one, as `scenarios` of
    [objective] states."""

    name: str = "mean"
    tail: float = 0.2
    threshold: float = 0.0

    @classmethod
    def read(cls, resolved: Mapping[str, Any], worth: Worth) -> Rule:
        """Returns the rule of a resolved campaign: that of its objective if
        this is the worth, else the mean."""
        objective = resolved.get("objective", {})
        if objective.get("maximise") not in (worth.name, [worth.name]):
            return cls()
        return cls(
            objective.get("scenarios", "mean"),
            objective.get("scenario_tail", 0.2),
            objective.get("scenario_threshold", 0.0),
        )

    def __str__(self) -> str:
        if self.name == "quantile":
            return f"quantile {self.tail:g}"
        if self.name == "cvar":
            return f"mean of the worst {100 * self.tail:g} %"
        if self.name == "probability":
            return f"probability of {self.threshold:g} or more"
        return self.name

    def value(self, values: Floats, weights: Floats) -> Floats:
        """Returns the value over environments [...].

        values: values [..., environments].
        weights: weights of environments with a sum of 1."""
        if self.name == "probability":
            return (values >= self.threshold) @ weights
        return (values * self.shares(values, weights)).sum(-1)

    def shares(self, values: Floats, weights: Floats) -> Floats:
        """Returns the weight of each environment in the value
        [..., environments]. The rule `probability` has the weights of
        environments, as for the mean."""
        if self.name in ("mean", "probability"):
            return np.broadcast_to(weights, values.shape)
        order = np.argsort(values, axis=-1, kind="stable")
        sorted_weights = np.take_along_axis(
            np.broadcast_to(weights, values.shape), order, -1
        )
        before = np.cumsum(sorted_weights, -1) - sorted_weights
        if self.name == "worst":
            shares = np.zeros_like(sorted_weights)
            shares[..., 0] = 1
        else:
            part = np.clip(self.tail - before, 0, sorted_weights)
            shares = part / self.tail
            if self.name == "quantile":
                inside = part > _ROUNDING
                last = inside.shape[-1] - 1 - inside[..., ::-1].argmax(-1)
                shares = np.zeros_like(part)
                np.put_along_axis(shares, last[..., None], 1.0, -1)
        result = np.zeros_like(shares)
        np.put_along_axis(result, order, shares, -1)
        return result
