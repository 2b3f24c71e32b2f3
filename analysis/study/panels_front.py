# SPDX-License-Identifier: Apache-2.0
"""The Pareto front of crop and electricity below rows of modules, for panels.py."""

from __future__ import annotations

from argparse import Namespace as Options
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from estimates import plus_minus, print_table
from pvlib import pvsystem, temperature
from shared import (
    ROUGH,
    Numbers,
    breed_tables,
    campaign_of,
    front_of,
)  # fmt: skip

from ideotype import Stand
from ideotype.figures.style import BASELINE, BEST, MEAN, new_figure


def tables_of(file: str, options: Options, **more: Any) -> dict[str, Any]:
    """Returns a campaign of this project with some tables replaced."""
    return campaign_of(file, **{**(ROUGH if options.rough else {}), **more})


def electricity(found: Any) -> float:
    """Returns the daily electric energy per ground area [kWh m-2] by pvlib,
    for air of 25 deg C and almost no wind."""
    light = found.object_light_by_hour.sel(object="panel").sum("band")
    front, back = (light.sel(object_side=side) for side in ("front", "back"))
    used = (front + 0.75 * back).values
    power = pvsystem.pvwatts_dc(
        used, temperature.faiman(used, 25.0), 0.21, -0.0035
    )
    both = float((front + back).sum()) * 3600e-6
    return float(found.panel_light) / both * float(power.sum())


def front(options: Options, alone: float) -> None:
    """Optimises crop and light on modules, and prints members of the Pareto
    front with their land equivalent ratios."""
    tables = tables_of("agrivoltaic", options)
    # The distance between rows of modules is the width of the field.
    del tables["panel"][0]["pitch"]
    tables |= {
        "name": "front",
        "stop": {"generations": options.generations},
        "search": {"optimizer": "nsga2", "population": 24},
        "objective": {"maximise": ["net_assimilation", "panel_light"]},
    }
    keys = [
        {"key": "spacing.row", "range": [0.4, 1.2]},
        {"key": "panel.height", "range": [3, 6]},
    ]
    searched = {**tables, "search": {**tables["search"], "keys": keys}}
    (history,) = breed_tables(searched, options.folder)
    members = front_of(history)
    row, height = members[:, -2:].T
    single = {
        **tables,
        "objective": {"maximise": "net_assimilation"},
        "search": {},
        "stop": {},
    }
    grown = [
        Stand(
            single,
            settings=[f"spacing.row={a:.9g}", f"panel.height={b:.9g}"],
        )
        .evaluate(member[:-2], final=True)
        .isel(plant=0)
        for member, a, b in zip(members, row, height, strict=True)
    ]
    crop = np.array([float(x.net_assimilation) for x in grown])
    error = [float(x.net_assimilation_standard_error) for x in grown]
    power = np.array([electricity(x) for x in grown])
    pitches = np.arange(2.5, 9.1, 0.5 if not options.rough else 3)
    over_soil = [power_over_soil(tables, pitch) for pitch in pitches]
    most = max(over_soil)
    own = float(pitches[int(np.argmax(over_soil))])
    order = np.argsort(power)
    shown = order[
        np.unique(np.linspace(0, len(order) - 1, 8).round().astype(int))
    ]
    print_table(
        [
            "pitch [m]", "height [m]", "net assimilation [mol m-2 day-1]",
            "electricity [kWh m-2 day-1]", "crop over the open",
            "electricity over its best", "land equivalent ratio",
        ],
        [
            [
                f"{8 * row[i]:.1f}", f"{height[i]:.1f}",
                plus_minus((crop[i], error[i]), 3), f"{power[i]:.3f}",
                f"{crop[i] / alone:.3f}", f"{power[i] / most:.3f}",
                plus_minus(
                    (crop[i] / alone + power[i] / most, error[i] / alone), 3
                ),
            ]
            for i in shown
        ],
    )  # fmt: skip
    print(
        f"\nThe best pitch of modules over soil is {own:.1f} m of "
        f"{pitches[0]:.1f} to {pitches[-1]:.1f} m: {most:.3f} kWh m-2 day-1; "
        f"the best crop in the open has {alone:.3f} mol m-2 day-1."
    )
    if options.figure:
        draw(options.figure, 8 * row, crop / alone, power / most)


def power_over_soil(tables: Mapping[str, Any], pitch: float) -> float:
    """Returns the electricity of modules over bare soil [kWh m-2 day-1]."""
    row = pitch / 4
    stand = Stand(
        {
            **tables,
            "spacing": [{"row": row, "plant": 10, "row_direction": 0}],
            "field": {"rows": 4, "plants": 1},
            "search": {},
            "stop": {},
            "objective": {"maximise": "net_assimilation"},
        }
    )
    found = stand.evaluate(stand.baseline)
    return electricity(found.isel(plant=0))


def draw(path: Path, pitch: Numbers, crop: Numbers, power: Numbers) -> None:
    figure = new_figure(9, 3.6)
    axes, ratio = figure.subplots(1, 2)
    axes.scatter(power, crop, color=BEST)
    axes.plot([0, 1], [1, 0], color=BASELINE, label="land that is shared out")
    axes.set_xlabel("electricity over that of modules alone")
    axes.set_ylabel("crop over that of the best in the open")
    axes.legend()
    ratio.scatter(pitch, crop + power, color=BEST, label="both")
    ratio.scatter(pitch, crop, color=MEAN, label="crop")
    ratio.scatter(pitch, power, color=BASELINE, label="electricity")
    ratio.set_xlabel("distance between rows of modules [m]")
    ratio.set_ylabel("land equivalent ratio")
    ratio.set_ylim(0, 1.3)
    ratio.legend(loc="upper center", ncols=3)
    figure.suptitle("Crop and electricity of the same land")
    figure.savefig(path, dpi=110)
