# SPDX-License-Identifier: Apache-2.0
"""Makes datasets of the light absorbed by a mesh."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray
from numpy.typing import NDArray

Array = tuple[str, list[str], str, str, NDArray[np.float64]]


def dataset(
    arrays: list[Array], coordinates: dict[str, Any], about: dict[str, Any]
) -> xarray.Dataset:
    """Returns the arrays as a Dataset. An array has a name, dimensions, a
    unit, a meaning and values [n], or values and standard errors [n, 2]."""
    variables: dict[str, Any] = {}
    for name, along, unit, meaning, numbers in arrays:
        # Faces are the only dimension without a coordinate.
        shape = [len(coordinates.get(x, numbers)) for x in along]
        means = numbers if numbers.ndim == 1 else numbers[:, 0]
        described = {"units": unit, "long_name": meaning}
        variables[name] = (along, means.reshape(shape), described)
        # A later array replaces an earlier one with the same name, including
        # its errors.
        variables.pop(f"{name}_standard_error", None)
        if numbers.ndim == 2:
            errors = numbers[:, 1].reshape(shape)
            variables[f"{name}_standard_error"] = (
                along,
                errors,
                {"units": unit},
            )
    if "layer" in coordinates:
        middles = coordinates["layer"]
        coordinates["layer"] = ("layer", middles, {"units": "m"})
    return xarray.Dataset(variables, coordinates, about)
