# SPDX-License-Identifier: Apache-2.0
"""The water balance of a column of soil, day by day."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import real_within
from ..common.compiled import _core
from ..errors import Error, did_you_mean

#: Decides about a day of a season, see Stand.season().
Control = Callable[[dict[str, Any]], Mapping[str, float] | None]

# Smallest and largest value of each parameter of the soil, in the column order
# of the compiled module.
_SOIL = {
    "theta_fc": (0, 1),
    "theta_wp": (0, 1),
    "tew": (0, 1e3),
    "rew": (0, 1e3),
    "p": (0, 1),
}
_INITIAL = {
    "initial_depletion": (0, 1e5),
    "initial_evaporable_depletion": (0, 1e3),
}
_DAYS = {
    "potential_transpiration": (0, 1e4),
    "potential_evaporation": (0, 1e4),
    "rain": (0, 1e5),
    "irrigation": (0, 1e5),
    "root_depth": (0, 100),
}
# The results, in the order of the compiled module.
_RESULTS = (
    "transpiration",
    "evaporation",
    "drainage",
    "depletion",
    "evaporable_depletion",
)


def soil_water_balance(
    inputs: Mapping[str, Any],
) -> dict[str, NDArray[np.float64]]:
    """Computes the daily water balance of a column of soil after FAO-56 (Allen
    and others 1998, chapters 7 and 8): an evaporable layer, a root zone and
    drainage, without runoff and water that rises. The header soil_water.hpp
    states the equations.

    inputs: `soil`, a dict with the water content at field capacity `theta_fc`
        and at the wilting point `theta_wp` [m3 m-3], the evaporable water
        `tew` and the readily evaporable water `rew` [mm], the fraction `p` of
        the available water that roots take up without stress, and
        `initial_depletion` and `initial_evaporable_depletion` [mm] (0 by
        default). Arrays by day: `potential_transpiration`,
        `potential_evaporation`, `rain` and `irrigation` [mm], and
        `root_depth` [m]. Other entries of `inputs` are ignored, so that a
        record with a name and expected results may be passed.

    Returns arrays by day [mm]: `transpiration`, `evaporation`, `drainage`, and
    at the end of the day the `depletion` of the root zone and the
    `evaporable_depletion` of the upper layer.

    Raises Error if inputs are missing or out of range."""
    soil = inputs.get("soil")
    if not isinstance(soil, Mapping):
        raise Error("the inputs lack the dictionary soil; give it")
    known = [*_SOIL, *_INITIAL]
    for name in soil:
        if name not in known:
            raise Error(
                f"soil has no parameter {name!r}{did_you_mean(name, known)}"
            )
    _require(_SOIL, soil, "soil lacks")
    _require(_DAYS, inputs, "the inputs lack")
    parameters = [_numbers(n, soil[n], _SOIL[n], 0) for n in _SOIL]
    initial = [
        _numbers(n, soil.get(n, 0.0), limits, 0)
        for n, limits in _INITIAL.items()
    ]
    if not parameters[0] > parameters[1]:
        raise Error(
            f"theta_fc is {parameters[0]:g}, at most theta_wp, "
            f"{parameters[1]:g}; field capacity must be wetter"
        )
    if parameters[3] > parameters[2]:
        raise Error(
            f"rew is {parameters[3]:g}, more than tew, {parameters[2]:g}; "
            "give at most tew"
        )
    days = [_numbers(n, inputs[n], _DAYS[n], 1) for n in _DAYS]
    lengths = {n: len(x) for n, x in zip(_DAYS, days, strict=True)}
    if len(set(lengths.values())) > 1:
        raise Error(f"the days differ in number: {lengths}; give equal ones")
    balance = _core.soil_water_balance(
        np.array(parameters, float),
        np.array(initial, float),
        np.ascontiguousarray(np.stack(days, axis=-1)),
    )
    return dict(zip(_RESULTS, balance.T.copy(), strict=True))


def _require(
    names: Mapping[str, Any], given: Mapping[str, Any], lack: str
) -> None:
    if missing := [name for name in names if name not in given]:
        raise Error(f"{lack} {', '.join(missing)}; give them")


def _numbers(
    name: str, given: Any, limits: tuple[float, float], dimensions: int
) -> Any:
    numbers = real_within(given, name, *limits)
    if numbers.ndim != dimensions:
        kind = "one number for each day" if dimensions else "a number"
        raise Error(f"{name} has the shape {numbers.shape}; give {kind}")
    return numbers


def answer_by(
    control: Control,
) -> Callable[[dict[str, Any]], tuple[float | None, float | None]]:
    """Returns a function that returns the answer of `control` as the pair of
    stress and irrigation, None where it leaves one out.

    Raises Error if the answer has other entries or is out of range."""
    limits = {"stress": (0, 1), "irrigation": (0, 1e4)}

    def ask(day: dict[str, Any]) -> tuple[float | None, float | None]:
        answer = control(day) or {}
        for name in answer:
            if name not in limits:
                raise Error(
                    f"control returned {name!r}{did_you_mean(name, list(limits))}"
                )
        stress, irrigation = (
            float(_numbers(name, answer[name], limits[name], 0))
            if name in answer
            else None
            for name in limits
        )
        return stress, irrigation

    return ask
