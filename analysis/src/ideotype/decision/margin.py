# SPDX-License-Identifier: Apache-2.0
"""The margin as a sum of physical parts and prices, and its value over
environments."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

PARTS = {
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


def weights_of_prices(prices: Mapping[str, float]) -> tuple[Floats, float]:
    """Returns the factors of the parts in the order of PARTS, and the sum that
    no part changes [currency ha-1]: margin = parts @ factors + sum."""
    factors = [
        factor * float(prices.get(price, 0))
        for price, (_, factor) in PARTS.items()
    ]
    return np.array(factors), -float(prices.get("other", 0))


@dataclass(frozen=True)
class Rule:
    """How values in several environments become one, as `scenarios` of
    [objective] states."""

    name: str = "mean"
    tail: float = 0.2
    threshold: float = 0.0

    @classmethod
    def read(cls, resolved: Mapping[str, Any]) -> Rule:
        """Returns the rule of a resolved campaign: that of its objective if
        this is the margin, else the mean."""
        objective = resolved.get("objective", {})
        if objective.get("maximise") not in ("margin", ["margin"]):
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

    def value(self, margins: Floats, weights: Floats) -> Floats:
        """Returns the value over environments [...].

        margins: margins [..., environments].
        weights: weights of environments with a sum of 1."""
        if self.name == "probability":
            return (margins >= self.threshold) @ weights
        return (margins * self.shares(margins, weights)).sum(-1)

    def shares(self, margins: Floats, weights: Floats) -> Floats:
        """Returns the weight of each environment in the value
        [..., environments]. The rule `probability` has the weights of
        environments, as for the mean."""
        if self.name in ("mean", "probability"):
            return np.broadcast_to(weights, margins.shape)
        order = np.argsort(margins, axis=-1, kind="stable")
        sorted_weights = np.take_along_axis(
            np.broadcast_to(weights, margins.shape), order, -1
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
