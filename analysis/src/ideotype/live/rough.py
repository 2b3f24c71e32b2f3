# SPDX-License-Identifier: Apache-2.0
"""Quick first answers of the live page, for campaigns in which one evaluation
takes longer than the user of a slider should wait.

A coarse stand has fewer pieces per leaf, longer time steps of weather and
fewer ages of growing plants. Its values have errors of several per cent, but
the relative error is nearly the same for different plants. The first answer is
therefore the known value of an anchor plant, times the ratio of both plants'
values in coarse stands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from .conditions import Conditions, Tables
from .numbers import Array, Layout, format_message
from .shapes import grows

_CELLS = 6
"""The number of pieces along a leaf."""

_GROWING_CELLS, _STAGES = 4, 5
"""The numbers of pieces along a leaf and of ages of plants that grow."""

_STEPS = 8
"""The number of steps of weather in a day."""


def coarsen(tables: Tables) -> Tables | None:
    """Returns a campaign for coarse evaluations, or None if the campaign
    itself takes little time, as for a clear day with one kind of plants."""
    if not {"weather", "component", "panel"} & {
        k for k in tables if tables[k]
    }:
        return None
    plant, light, cells = tables["plant"], tables["light"], _CELLS
    if grows(tables):
        cells, light = (
            _GROWING_CELLS,
            light | {"stages": min(_STAGES, light.get("stages", _STAGES))},
        )
    weather = [_thinned(each) for each in tables.get("weather", [])]
    return {
        **tables,
        "plant": plant | {"cells_along": min(cells, plant["cells_along"])},
        "light": light,
        **({"weather": weather} if weather else {}),
    }


def _thinned(weather: Tables) -> Tables:
    """Returns weather with longer time steps, each the mean of several
    steps."""
    steps = len(weather["hours"])
    together = steps // _STEPS if steps % _STEPS == 0 else 1
    count = len(weather["dates"]) * steps

    def mean(value: Any) -> Any:
        if not isinstance(value, list) or len(value) != count:
            return value
        return np.array(value, float).reshape(-1, together).mean(-1).tolist()

    found = {name: mean(value) for name, value in weather.items()}
    return found | {"hours": weather["hours"][::together]}


@dataclass(frozen=True)
class Anchor:
    """A plant with known numbers in a stand, and its numbers in the coarse
    stand."""

    layout: Layout
    known: tuple[Array, Array]
    """Means and standard errors [numbers]."""
    coarse: Array
    """The numbers in the coarse stand [numbers, value and standard error], in
    the layout of the full stand."""
    conditions: Conditions
    """The conditions under which the anchor stands."""
    spread: Array
    """The relative standard deviations among fields that one evaluation does
    not include [numbers]."""

    def message(
        self, mine: Array, reference: Array, conditions: Conditions
    ) -> dict[str, Any]:
        """Returns the message to the page about a plant and its reference,
        from their numbers in a coarse stand under some conditions [numbers,
        value and standard error]."""
        mean, error = self.known
        near = self.coarse[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = mean / near
        # A ratio to a number near zero is useless; the difference is used
        # instead.
        scales = (ratio > 0.5) & (ratio < 2)
        ratio = np.where(scales, ratio, 1.0)
        shift = np.where(scales, 0.0, mean - near)

        # Under the conditions of the anchor, the coarse stand has the same
        # missing plants.
        is_other = conditions != self.conditions
        fields = np.sqrt(2) * self.spread if is_other else 0.0

        def value(found: Array) -> tuple[Array, Array]:
            value = ratio * found[:, 0] + shift
            off = np.hypot(ratio * _apart(found, self.coarse), fields * value)
            return value, np.hypot(error, off)

        apart = ratio * (mine - reference)[:, 0]
        its_error = np.hypot(
            ratio * _apart(mine, reference), self.spread * apart
        )
        content = format_message(
            self.layout, 1, value(mine), value(reference), (apart, its_error)
        )
        return {"is_rough": True, **content}


def _apart(one: Array, other: Array) -> Array:
    """Returns upper bounds of the standard errors of differences between
    plants with common random numbers [numbers]. The difference of equal
    numbers is exact."""
    error = np.hypot(one[:, 1], other[:, 1])
    return np.where(one[:, 0] == other[:, 0], 0.0, error)
