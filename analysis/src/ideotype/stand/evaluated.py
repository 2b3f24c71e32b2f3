# SPDX-License-Identifier: Apache-2.0
"""Evaluations of plants as labelled arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray
from numpy.typing import NDArray

from ..common.compiled import _core


@dataclass(frozen=True)
class Evaluated:
    """The numbers of one evaluated plant, without labels."""

    objectives: NDArray[np.float64]
    """[objectives, value and standard error], in the order of
    `Stand.objectives`."""
    violation: float
    """The violation of the constraints; 0: none."""
    numbers: NDArray[np.float64]
    """[numbers, value and standard error]: the quantities in the order of
    `Stand.quantities`, each along its `Stand.axes`, the last axis fastest."""


def make_dataset(
    case: _core.CaseStand,
    evaluations: list[tuple[Any, ...]],
    wanted: list[str],
) -> xarray.Dataset:
    """Returns the evaluations of plants in a case, one tuple for each plant,
    as a Dataset of the wanted quantities."""
    axes = {axis[0]: axis for axis in case.axes}
    messages = [result[1] for result in evaluations]
    numbers = np.array([result[5] for result in evaluations]).reshape(
        len(evaluations), -1, 2
    )
    arrays: dict[str, Any] = {}
    begin = 0
    for name, unit, meaning, along, is_exact, counted in case.quantities:
        shape = tuple(len(axes[axis][3]) for axis in along)
        size = int(np.prod(shape))
        part = numbers[:, begin : begin + size]
        begin += size
        if name not in wanted:
            continue
        dims = ("plant", *along)
        about: dict[str, Any] = {"units": unit, "long_name": meaning}
        if counted:
            about["names"] = list(counted)
        whole = part.reshape(len(evaluations), *shape, 2)
        arrays[name] = (dims, whole[..., 0], about)
        if not is_exact:
            error = {"units": unit, "long_name": "standard error"}
            arrays[f"{name}_standard_error"] = (dims, whole[..., 1], error)
    arrays["violation"] = (
        "plant",
        np.array([result[4] for result in evaluations]),
        {"units": "1", "long_name": "violation of the constraints, 0: none"},
    )
    arrays["message"] = (
        "plant",
        np.array(messages, dtype=object),
        {"long_name": "reason why the evaluation failed"},
    )
    names, units, _ = zip(*case.objectives)
    arrays["objective_by_randomisation"] = (
        ("plant", "objective", "randomisation"),
        np.array([result[3] for result in evaluations]),
        {"units": ", ".join(dict.fromkeys(units)), "long_name": "objective"},
    )
    used = {name for dims, *_ in arrays.values() for name in dims}
    labels = {
        name: (name, axis[3], {"units": axis[1], "long_name": axis[2]})
        for name, axis in axes.items()
        if name in used
    }
    return xarray.Dataset(
        arrays,
        {**labels, "objective": list(names)},
        {"case": case.name, "isa": case.isa},
    )
