# SPDX-License-Identifier: Apache-2.0
"""Makes datasets of the light in a mesh."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray


def dataset(found: dict[str, Any], unit: str, scale: float) -> xarray.Dataset:
    """Returns the evaluated light as arrays; `scale` converts numbers to the
    unit."""
    arrays: dict[str, Any] = {}

    def add(
        name: str,
        dims: tuple[str, ...],
        mean: Any,
        error: Any,
        units: str = unit,
        meaning: str = "",
    ) -> None:
        about = {"units": units, "long_name": meaning or name}
        arrays[name] = (dims, mean, about)
        arrays[f"{name}_standard_error"] = (dims, error, {"units": units})

    for name, (mean, error) in found["budget"].items():
        add(name, (), scale * mean, scale * error)
    groups = scale * found["absorbed_by_group"]
    add("absorbed", ("group",), groups[:, 0], groups[:, 1])
    layers = scale * found["absorbed_by_layer"]
    add("absorbed_by_layer", ("layer",), layers[:, 0], layers[:, 1])
    faces = scale * found["absorbed_by_face"]
    if len(faces):
        # Light by face is per one-sided area of the face.
        add("absorbed_by_face", ("face",), faces[:, 0], faces[:, 1])
    for name, units, meaning, mean, error in found["numbers"]:
        add(name, (), mean, error, units, meaning)
    arrays["incident"] = ((), scale * found["incident"], {"units": unit})
    # Incident light is exact.
    arrays.pop("incident_standard_error", None)
    if "gross_assimilation" in found:
        # The light of a single sun or sky is the light of one second [mol].
        is_day = unit.endswith("day-1")
        moles = 1 if is_day else 1e6
        of = "mol m-2 day-1" if is_day else "umol m-2 s-1"
        mean, error = (moles * x for x in found["gross_assimilation"])
        loss = moles * found["net_loss"]
        add("gross_assimilation", (), mean, error, of)
        add("net_assimilation", (), mean - loss, error, of)
    middles = found["layer_thickness"] * (np.arange(len(layers)) + 0.5)
    return xarray.Dataset(
        arrays,
        {
            "group": found["groups"],
            "layer": ("layer", middles, {"units": "m"}),
        },
        {
            "paths": found["paths"],
            "ground_area": found["ground_area"],
            "balance_error": found["balance_error"],
            "is_tolerance_met": not found["is_capped"],
            "warnings": found["warnings"],
        },
    )


def scene_dataset(
    found: dict[str, Any], is_day: bool, is_ppfd: bool
) -> xarray.Dataset:
    """Returns the light and assimilation of a scene file, by band and
    component."""
    unit = "MJ m-2 day-1" if is_day else "umol m-2 s-1" if is_ppfd else "1"
    scale = 1e-6 if is_day else 1.0
    bands = found["bands"]
    arrays: dict[str, Any] = {}

    def add(
        name: str, dims: tuple[str, ...], pairs: Any, units: str, by: float
    ) -> None:
        numbers = by * np.asarray(pairs, float)
        arrays[name] = (dims, numbers[..., 0], {"units": units})
        arrays[f"{name}_standard_error"] = (
            dims,
            numbers[..., 1],
            {"units": units},
        )

    for name, dims in (
        ("soil", ("band",)),
        ("reflected", ("band",)),
        ("absorbed_by_component", ("band", "component")),
        ("absorbed", ("band", "group")),
    ):
        add(name, dims, [band[name] for band in bands], unit, scale)
    incident = [scale * band["incident"] for band in bands]
    arrays["incident"] = (("band",), incident, {"units": unit})
    arrays["lai"] = (("component",), found["lai"], {"units": "m2 m-2"})
    if "gross_assimilation" in found:
        moles = 1 if is_day else 1e6
        of = "mol m-2 day-1" if is_day else "umol m-2 s-1"
        gross = found["gross_assimilation"]
        net = gross - np.array([[lost, 0] for lost in found["respired"]])
        add("gross_assimilation", ("component",), gross, of, moles)
        add("net_assimilation", ("component",), net, of, moles)
    return xarray.Dataset(
        arrays,
        {
            "band": [band["name"] for band in bands],
            "component": found["components"],
            "group": found["groups"],
        },
        {
            "paths": found["paths"],
            "ground_area": found["ground_area"],
            "is_tolerance_met": not found["is_capped"],
            "warnings": found["warnings"],
        },
    )
