# SPDX-License-Identifier: Apache-2.0
"""Energy balances of points on leaves."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import real_within
from ..common.compiled import _core
from ..errors import Error, did_you_mean

_NONE = np.nan  # This marks a parameter without a default.

# Default, minimum and maximum, in the column order of the compiled module.
_SURROUNDINGS = {
    "ppfd": (_NONE, 0, 1e5),
    "nir": (_NONE, 0, 1e5),
    "longwave": (_NONE, 0, 1e5),
    "air": (_NONE, -90, 80),
    "rh": (_NONE, 0, 1),
    "co2": (_NONE, 1, 1e6),
    "pressure": (_NONE, 1, 1e3),
    "wind": (_NONE, 0, 1e3),
    "width": (_NONE, 1e-4, 100),
}
_BODY = {"emissivity": (0.96, 0.01, 1), "ratio": (1, 0, np.inf)}
_STOMATA = {
    "medlyn": {"g0": (0.01, 0, 100), "g1": (1.6, 0, 1e3)},
    "ball-berry": {"b0": (0.017, 0, 100), "b1": (4.53, 0, 1e3)},
}
_RATES = {
    "collatz": {
        "vmax": (39, 0, 1e6),
        "alpha": (0.067, 0, 1),
        "theta": (0.83, 0, 1),
        "beta": (0.93, 0, 1),
        "k": (0.7, 0, 100),
        "rd": (0.8, 0, 1e3),
    },
    "farquhar": {
        "vcmax": (110, 0, 1e6),
        "jmax": (195, 0, 1e6),
        "tpu": (13, 0, 1e6),
        "theta": (0.97875, 0, 1),
        "beta": (0.98, 0, 1),
        "rd": (1.28, 0, 1e3),
    },
}
_C3_SLOPE = {"g1": (5.79, 0, 1e3)}
_KEYS = (
    "leaf",
    "net",
    "gs",
    "ci",
    "transpiration",
    "latent",
    "sensible",
    "net_radiation",
    "boundary_heat",
    "roots",
)


def leaf_energy_balance(
    inputs: Mapping[str, Any], *, roots: bool = False
) -> dict[str, Any]:
    """Solves the energy balance of points on leaves, coupled to photosynthesis
    and stomata: net radiation = sensible + latent heat, with the boundary
    layer of Campbell and Norman (1998). The header energy_balance.hpp states
    the equations, and docs/photosynthesis.md describes the models.

    inputs: numbers, or arrays of one shape, by name. Absorbed radiation, the
        sum of both faces per leaf area: `ppfd` [umol m-2 s-1], `nir` and
        `longwave` [W m-2]. Air at the leaf: `air` [deg C], `rh` (0 to 1),
        `co2` [umol mol-1], `pressure` [kPa] and `wind` [m s-1]. Width of the
        blade: `width` [m]. Parameters, here or in a dict `parameters`, which
        takes precedence: `model`, "collatz" (C4) or "farquhar" (C3), with the
        keys of the model in a [photosynthesis] table (`vmax`, ...);
        `stomata`, "medlyn" with `g0` and `g1` or "ball-berry" with `b0` and
        `b1`; `emissivity`; and `ratio`, the stomatal conductance of the lower
        face relative to the upper face.
    roots: whether to return the number of solutions of each balance.

    Returns per leaf area, with the shape of the inputs: temperature `leaf`
    [deg C], net assimilation `net` [umol m-2 s-1], stomatal conductance `gs`
    [mol m-2 s-1], intercellular CO2 `ci` [umol mol-1], `transpiration` [mmol
    m-2 s-1], `latent`, `sensible` and `net_radiation` [W m-2], and the
    boundary-layer conductance of one face for heat, `boundary_heat` [mol m-2
    s-1]. Of several solutions the coolest is returned.

    Raises Error if inputs are missing, unknown or out of range."""
    given = dict(inputs)
    nested = given.pop("parameters", {})
    if not isinstance(nested, Mapping):
        raise Error("parameters is no dictionary; give names and numbers")
    given |= nested
    model = given.pop("model", "collatz")
    if not isinstance(model, str) or model not in _RATES:
        raise Error(f"model is {model!r}; use one of {', '.join(_RATES)}")
    _check_names(given, model)
    choice = _choices(given.pop("stomata", "medlyn"))
    stomata = _STOMATA | {
        "medlyn": _STOMATA["medlyn"]
        | (_C3_SLOPE if model == "farquhar" else {})
    }
    ranges = _SURROUNDINGS | _BODY | _RATES[model]
    for parameters in stomata.values():
        ranges = ranges | parameters
    arrays = {
        name: real_within(given.get(name, initial), name, lower, upper)
        for name, (initial, lower, upper) in ranges.items()
    }
    try:
        shape = np.broadcast_shapes(
            choice.shape, *(x.shape for x in arrays.values())
        )
    except ValueError as error:
        shapes = {n: x.shape for n, x in arrays.items() if x.ndim}
        raise Error(
            f"the inputs have shapes that do not fit: {shapes}; give "
            "numbers, or arrays of one shape"
        ) from error
    columns = [arrays[name] for name in _SURROUNDINGS] + [choice]
    for first, second in zip(*(x for x in stomata.values()), strict=True):
        columns.append(np.where(choice == 0, arrays[first], arrays[second]))
    columns += [arrays[name] for name in (*_BODY, *_RATES[model])]
    points = np.stack(
        [np.broadcast_to(x, shape).ravel() for x in columns], axis=-1
    )
    balances = _core.energy_balances(points, model == "farquhar")
    results: dict[str, Any] = {}
    for name, values in zip(_KEYS, balances.T, strict=True):
        results[name] = values.reshape(shape) if shape else values.item()
    count = results.pop("roots")
    if roots:
        results["roots"] = np.asarray(count, int) if shape else int(count)
    return results


def _check_names(given: Mapping[str, Any], model: str) -> None:
    known = [*_SURROUNDINGS, "parameters", "model", "stomata", *_BODY]
    known += [key for keys in _STOMATA.values() for key in keys]
    # A dict of C4 defaults may also be given for a C3 leaf.
    known += [*_RATES["collatz"], *_RATES[model]]
    for name in given:
        if name not in known:
            raise Error(
                f"a leaf has no input {name!r}"
                f"{did_you_mean(str(name), known)} (model {model!r} has "
                f"{', '.join(dict.fromkeys(known))})"
            )
    missing = [name for name in _SURROUNDINGS if name not in given]
    if missing:
        raise Error(f"the inputs lack {', '.join(missing)}; give them")


def _choices(given: Any) -> NDArray[np.float64]:
    names = list(_STOMATA)
    chosen = np.asarray(given)
    for name in chosen.ravel().tolist():
        if name not in names:
            raise Error(f"stomata is {name!r}; use one of {', '.join(names)}")
    return np.asarray(chosen == names[1], float)
