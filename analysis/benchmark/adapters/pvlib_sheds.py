#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Answers of pvlib's infinite sheds to cases with black panels."""

from __future__ import annotations

import numpy as np
import pvlib
from answers import write_answers
from cases import Case, mesh_of


def answer(case: Case) -> dict[str, tuple[float, float | None]]:
    if case["class"] != "panels" or any(case["materials"][""]):
        return {}
    corners = mesh_of(case).corners[0]
    rise, run = corners[1, 2] - corners[0, 2], corners[1, 0] - corners[0, 0]
    width, pitch = np.hypot(rise, run), case["period"][0]
    height = corners[:, 2].mean()
    elevation, azimuth = case["light"].get("sun", (45, 270))
    is_sun = "sun" in case["light"]
    found = pvlib.bifacial.infinite_sheds.get_irradiance(
        surface_tilt=np.degrees(np.arctan2(rise, run)),
        surface_azimuth=270,
        solar_zenith=90 - elevation,
        solar_azimuth=azimuth,
        gcr=width / pitch,
        height=height,
        pitch=pitch,
        ghi=1.0,
        dhi=0.0 if is_sun else 1.0,
        dni=1 / np.sin(np.radians(elevation)) if is_sun else 0.0,
        albedo=case["soil_albedo"],
        model="isotropic",
        iam_front=1.0,
        iam_back=1.0,
        bifaciality=1.0,
    )
    panel = float(np.ravel(found["poa_global"])[0]) * width / pitch
    return {"panel": (panel, None)}


if __name__ == "__main__":
    write_answers("pvlib", answer)
