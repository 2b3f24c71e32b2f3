# SPDX-License-Identifier: Apache-2.0
"""The numbers of the live page: means over repeated evaluations, their
standard errors, and differences from another plant."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.labels import title
from ..stand.stand import Stand

Array = NDArray[np.float64]

_AREAS = ("lai", "plant_area_index", "respiration")
"""The quantities that are exact for the field of an evaluation, and that fall
with each missing plant of the field."""

ENOUGH = 6
"""The number of evaluations from which on their spread gives the standard
error; fewer evaluations use their own standard errors."""

_CURVES = (
    "absorbed_by_layer", "assimilation_by_layer",
    "absorbed_by_hour", "assimilation_by_hour",
    "absorbed_by_leaf", "net_assimilation_by_leaf",
    "lai_by_stage", "fapar_by_stage", "absorbed_par_by_stage",
    "net_assimilation_by_stage", "day_of_stage",
)  # fmt: skip

_HIDDEN = {"balance_error", "paths", "capped"}

KEYS = {
    "absorbed_par": "Absorbed PAR",
    "fapar": "Fraction of PAR absorbed",
    "net_assimilation": "Net assimilation",
    "carbon_balance": "Net carbon balance",
    "dry_matter": "Dry matter",
    "transpiration": "Transpiration",
    "water_use_efficiency": "Water use efficiency",
    "margin": "Margin",
    "grain_yield_moist": "Grain yield (15.5 % water)",
    "lai": "Leaf area index",
    "distance_from_lines": "Distance from measured lines",
}
"""The quantities that are shown first, and their names on the page."""


class Layout:
    """The positions of quantities in the numbers of an evaluation."""

    def __init__(self, stand: Stand) -> None:
        self.axes = stand.axes
        self.places: dict[str, tuple[slice, tuple[str, ...]]] = {}
        self.about: dict[str, dict[str, str]] = {}
        begin = 0
        listed = stand.quantities.itertuples(index=False)
        for name, unit, meaning, axes, _ in listed:
            size = int(np.prod([len(self.axes[axis]) for axis in axes]))
            self.places[name] = slice(begin, begin + size), tuple(axes)
            self.about[name] = {"unit": unit, "meaning": meaning}
            begin += size

    @cached_property
    def scalars(self) -> list[dict[str, str]]:
        """The single numbers: name, label, unit, meaning."""
        single = [
            name
            for name, (_, axes) in self.places.items()
            if not axes and name not in _HIDDEN
        ]
        single.sort(
            key=lambda name: [*KEYS].index(name) if name in KEYS else len(KEYS)
        )
        return [
            {
                "name": name,
                "label": KEYS.get(name, title(name)),
                "is_key": name in KEYS,  # type: ignore[dict-item]
                **self.about[name],
            }
            for name in single
        ]

    def like(self, other: Layout, numbers: Array) -> Array:
        """Returns numbers of another layout [numbers, value and standard
        error] in this layout; numbers that the first layout lacks or divides
        differently are NaN."""
        size = max(place.stop for place, _ in self.places.values())
        converted = np.full((size, 2), np.nan)
        for name, (place, _) in self.places.items():
            its = other.places.get(name, (slice(0, 0),))[0]
            if its.stop - its.start == place.stop - place.start:
                converted[place] = numbers[its]
        return converted

    def spread_of_fields(self, field: dict[str, Any]) -> Array:
        """Returns the relative standard deviations among fields [numbers] that
        one evaluation does not include: areas vary, as the number of missing
        plants is binomial.

        field: the table [field] of a campaign."""
        spread = np.zeros(max(place.stop for place, _ in self.places.values()))
        missing = field.get("variation", {}).get("missing", 0.0)
        plants = field["rows"] * field["plants"]
        for name in _AREAS:
            if name in self.places:
                spread[self.places[name][0]] = np.sqrt(
                    missing / (1 - missing) / plants
                )
        return spread

    def scalar(self, numbers: Array, name: str) -> float:
        """Returns the value of a single number of an evaluation."""
        return float(numbers[self.places[name][0].start, 0])


class Samples:
    """Evaluations of one plant with independent random numbers.

    spread: relative standard deviations among fields that one evaluation does
    not include [numbers]."""

    def __init__(self, spread: Array | float = 0.0) -> None:
        self.by_seed: dict[int, Array] = {}
        self._spread = spread

    def together(self, seeds: list[int]) -> tuple[Array, Array]:
        """Returns means and standard errors [numbers] over seeds."""
        every = np.array([self.by_seed[seed] for seed in seeds])
        return self._mean(every[..., 0], every[..., 1])

    def less(self, other: Samples, seeds: list[int]) -> tuple[Array, Array]:
        """Returns differences from another plant with paired standard errors
        [numbers], over seeds with common random numbers."""
        mine = np.array([self.by_seed[seed] for seed in seeds])
        others = np.array([other.by_seed[seed] for seed in seeds])
        apart = mine[..., 0] - others[..., 0]
        # The difference of a plant from itself is exact.
        errors = np.hypot(mine[..., 1], others[..., 1]) * (apart != 0)
        return self._mean(apart, errors)

    def _mean(self, values: Array, errors: Array) -> tuple[Array, Array]:
        count, mean = len(values), values.mean(axis=0)
        error = values.std(axis=0, ddof=1) / np.sqrt(count) if count > 1 else 0
        single = np.abs(self._spread * values)
        if count < ENOUGH:
            single = np.hypot(np.nan_to_num(errors), single)
        error = np.maximum(np.sqrt((single**2).sum(axis=0)) / count, error)
        # Exact numbers differ only in their last digits.
        return mean, np.where(error > 1e-9 * np.abs(mean), error, 0.0)


Estimates = tuple[Array, Array]
"""Values and their standard errors [numbers]."""


def make_message(
    layout: Layout, mine: Samples, reference: Samples, seeds: list[int]
) -> dict[str, Any]:
    """Returns the message to the page about a plant and its reference plant,
    over the seeds that both plants have."""
    both = [seed for seed in seeds if seed in reference.by_seed]
    others = (
        (reference.together(both), mine.less(reference, both)) if both else ()
    )
    return format_message(layout, len(seeds), mine.together(seeds), *others)


def format_message(
    layout: Layout,
    evaluations: int,
    mine: Estimates,
    reference: Estimates | None = None,
    apart: Estimates | None = None,
) -> dict[str, Any]:
    """Returns the message to the page about a plant, its reference plant and
    their difference."""
    message: dict[str, Any] = {"evaluations": evaluations}
    for kind, estimates in (
        ("numbers", mine),
        ("reference", reference),
        ("differences", apart),
    ):
        if estimates is not None:
            message[kind] = {
                each["name"]: _pair(layout, each["name"], *estimates)
                for each in layout.scalars
            }
    message["curves"] = _curves(layout, *mine)
    if reference is not None:
        message["reference_curves"] = _curves(layout, *reference)
    return message


def _pair(
    layout: Layout, name: str, mean: Array, error: Array
) -> list[float | None]:
    place = layout.places[name][0].start
    return [_json(mean[place]), _json(error[place])]


def _curves(layout: Layout, mean: Array, error: Array) -> dict[str, Any]:
    return {
        name: {
            "at": list(layout.axes[layout.places[name][1][0]]),
            "values": [_json(v) for v in mean[layout.places[name][0]]],
            "standard_errors": [
                _json(v) for v in error[layout.places[name][0]]
            ],
            "unit": layout.about[name]["unit"],
        }
        for name in _CURVES
        if name in layout.places
        and len(layout.places[name][1]) == 1
        and np.isfinite(mean[layout.places[name][0]]).any()
    }


def _json(value: float) -> float | None:
    """Returns a number that JSON can represent, to seven digits."""
    return float(f"{value:.7g}") if np.isfinite(value) else None
