#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares maize below rows of photovoltaic modules, and the cost of its light.

panels.py FOLDER [--only PART] [--generations N] [--seeds N] [--figure FILE.png] [--rough]

layouts   The 54 layouts of tutorial 18 of bifacial_radiance, each with maize on a clear day, for a
          standard error of 1 % of the light of maize: time on two cores, and error.
cost      Time of a day with tracking modules relative to fixed ones, at an equal error of absorbed
          PAR; evaluations of both in pairs.
measured  Modules at Foulum, Denmark (measured/README.md), under their measured light.
trial     Loss of maize in a season below tracking modules, 6.1 m up, which shade 20 to 25 %, as in
          the trial at Purdue (Sanchez et al. 2024, SSRN 4807752), where it lost 7.7 % of its yield.
          Pitch and width are not reported: several are computed. The season is that of Bondville,
          130 km away. Intervals are 95 % of randomisations.
bred      A plant optimised below the modules of agrivoltaic.toml and one optimised without modules,
          each evaluated in both places; and the Pareto front, by NSGA-II, of crop and light on
          modules, over the plant, the height of modules and the distance between rows.

Finished searches in FOLDER are not repeated. --figure draws the front of `bred`. --rough is for
tests. IDEOTYPE_EXECUTABLE names the program; without it, the one on PATH is used.
"""

from __future__ import annotations

import itertools
import math
import time
from argparse import Namespace as Options
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from estimates import Estimate, plus_minus, print_table
from panels_crops import bred, jackknife, trial
from pvlib import solarposition
from shared import (
    CAMPAIGNS,
    MAIZE,
    Numbers,
    guard,
    parser_of_searches,
    run_parts,
)  # fmt: skip

from ideotype import Stand

QUICK = CAMPAIGNS / "ames_quick.toml"
MEASURED = Path(__file__).parent / "measured" / "foulum_modules.csv"
FOULUM = (56.497, 9.584)
"""Latitude and longitude [deg]."""
HALF = pd.Timedelta("150s")
"""Half the length of a spell of measurements."""
PAR = 0.45
"""The share of PAR in solar radiation."""
FEET = 0.3048  # [m]


# Layouts and cost.


def layout(clearance: float, gap: float, tilt: float, between: float) -> Any:
    """Returns the settings of a layout: modules of 1.64 x 1 m in landscape
    format, in a cell of one module, with maize along the rows of modules."""
    length, width = 1.64, 1.0
    pitch = width * math.cos(math.radians(tilt)) + between
    rows, plants = (2 if pitch < 2 else 3), round((length + gap) / 0.16)
    panel = {
        "pitch": pitch,
        "height": clearance + width / 2 * math.sin(math.radians(tilt)),
        "width": width,
        "tilt": tilt,
        "azimuth": 180,
        "module_length": length,
        "gap": gap,
    }
    return {
        "spacing": [
            {
                "row": pitch / rows,
                "plant": (length + gap) / plants,
                "row_direction": 90,
            }
        ],
        "field.rows": rows,
        "field.plants": plants,
        "panel": [panel],
    }


def layouts(options: Options) -> None:
    every = [
        layout(clearance * FEET, gap * FEET, tilt, between * FEET)
        for clearance, gap, tilt, between in itertools.product(
            (6, 8, 10), (2, 3, 4), (18, 10), (2, 3, 4)
        )
    ]
    if options.rough:
        every = every[::18]

    def light_of(settings: Any, tolerance: float, draw: int) -> Estimate:
        more = {"light.tolerance": tolerance, "light.paths": 1 << 20}
        stand = Stand.from_campaign(QUICK, settings={**settings, **more})
        found = stand.evaluate(
            stand.baseline, ["absorbed_par"], generation=draw, threads=1
        )
        return (
            float(found.absorbed_par[0]),
            float(found.absorbed_par_standard_error[0]),
        )

    def all_of(tolerance: float, draw: int) -> tuple[Numbers, Sequence[float]]:
        before = time.perf_counter(), time.process_time()
        with ThreadPoolExecutor(2) as pool:
            found = list(
                pool.map(lambda x: light_of(x, tolerance, draw), every)
            )
        after = time.perf_counter(), time.process_time()
        return np.array(found), np.subtract(after, before).tolist()

    found, seconds = all_of(0.01, 0)
    exact, _ = all_of(0.02 if options.rough else 0.003, 1)
    errors = found[:, 1] / found[:, 0]
    off = found[:, 0] / exact[:, 0] - 1
    print_table(
        [
            "layouts",
            "time on two cores [s]",
            "of processors [s]",
            "light of maize [MJ m-2 day-1]",
            "standard error, rms [%]",
            "largest [%]",
            "from another field at 0.3 %, rms [%]",
        ],
        [
            [
                str(len(every)),
                *(f"{x:.1f}" for x in seconds),
                f"{found[:, 0].min():.2f} to {found[:, 0].max():.2f}",
                f"{100 * np.sqrt((errors**2).mean()):.2f}",
                f"{100 * errors.max():.2f}",
                f"{100 * np.sqrt((off**2).mean()):.2f}",
            ]
        ],
    )


def cost(options: Options) -> None:
    panel = {"pitch": 6.096, "height": 4, "width": 2.4, "offset": 3.048}
    kinds = {
        "fixed": {**panel, "tilt": 25, "azimuth": 180},
        "tracked": {**panel, "azimuth": 180, "tracks": True},
    }
    pairs = 4 if options.rough else 40
    rows = []
    for sky in ("uniform", "clear"):
        stands = {
            name: Stand.from_campaign(
                QUICK,
                settings={
                    "field.rows": 8, "light.sky": sky, "panel": [each],
                },
            )
            for name, each in kinds.items()
        }  # fmt: skip
        taken: dict[str, list[tuple[float, float]]] = {x: [] for x in stands}
        for draw, (name, stand) in itertools.product(
            range(-1, pairs), stands.items()
        ):
            before = time.process_time()
            found = stand.evaluate(
                stand.baseline, ["absorbed_par"],
                generation=max(draw, 0), threads=1,
            )  # fmt: skip
            seconds = time.process_time() - before
            error = found.absorbed_par_standard_error / found.absorbed_par
            if draw >= 0:
                taken[name].append((seconds, float(error[0]) ** 2))

        def ratio(fixed: Numbers, tracked: Numbers) -> float:
            return float(np.prod(tracked.mean(0) / fixed.mean(0)))

        both = [np.array(x) for x in taken.values()]
        mean, error = jackknife(ratio, *both)
        rows.append(
            [
                sky,
                *(f"{1e3 * x[:, 0].mean():.0f}" for x in both),
                *(f"{100 * math.sqrt(x[:, 1].mean()):.2f}" for x in both),
                plus_minus((mean, error), 2),
            ]
        )
    print_table(
        [
            "sky",
            "fixed day [ms]",
            "tracked [ms]",
            "error, fixed [%]",
            "tracked [%]",
            f"cost at an equal error, {pairs} pairs",
        ],
        rows,
    )


# Measured modules.


def measured(options: Options) -> None:
    readings = pd.read_csv(MEASURED)
    edge = 1.14 * math.sin(math.radians(25))
    tilted = {
        "name": "tilted", "azimuth": 184, "tilt": 25, "pitch": 12,
        "width": 2.28, "height": 0.8 + edge,
    }  # fmt: skip
    upright = {"azimuth": 276, "tilt": 90, "pitch": 11, "width": 1.1}
    arrays = {
        "tilted": [tilted],
        "vertical": [
            {**upright, "name": "low", "height": 0.75},
            {**upright, "name": "high", "height": 2.05},
        ],
    }
    rows = []
    for reading in readings[:: 8 if options.rough else 1].to_dict("records"):
        row = [str(reading["time"])]
        for name, panels in arrays.items():
            elevation, front, back = sides(options, reading, panels)
            names = (
                ("west", "east") if name == "vertical" else ("front", "back")
            )
            if name == "tilted":
                row.append(f"{elevation:.0f}")
            for side, found in zip(names, (front, back), strict=True):
                value = float(reading[f"{name}_{side}"])
                row.append(f"{value:.0f}: {100 * (found / value - 1):+.1f}")
        rows.append(row)
    print_table(
        [
            "time",
            "sun [deg]",
            "tilted front [W m-2: %]",
            "tilted back",
            "upright west",
            "upright east",
        ],
        rows,
    )


def sides(
    options: Options, reading: Mapping[str, Any], panels: Sequence[Any]
) -> tuple[float, float, float]:
    """Returns the height of the sun [deg], and the light on the front and the
    back of modules during the 5 minutes of a reading [W m-2]."""
    # The light at other times is invented; it has no effect on results.
    end = pd.Timestamp(f"2026-05-10 {reading['time']}", tz="Etc/GMT-2")
    ends = pd.date_range("2026-05-10", periods=288, freq="5min", tz=end.tz)
    suns = solarposition.get_solarposition(ends - HALF, *FOULUM)
    weather = pd.DataFrame({"time": ends.strftime("%Y-%m-%d %H:%M")})
    sines = np.sin(np.radians(suns.elevation.clip(0))).to_numpy()
    weather["global"] = 1000 * sines
    weather["diffuse"] = 150 * sines
    place = ends.get_loc(end)
    for name in ("global", "diffuse"):
        weather.loc[place, name] = float(reading[name])
    path = options.folder / "foulum.csv"
    weather.to_csv(path, index=False)
    pitch, facing = panels[0]["pitch"], panels[0]["azimuth"]
    day = pd.Timestamp(2026, 5, 10).date()
    stand = Stand(
        {
            "name": "foulum",
            "seed": 1,
            "site": [
                {
                    "name": "foulum",
                    "latitude": FOULUM[0],
                    "longitude": FOULUM[1],
                    "utc_offset": 2,
                }
            ],
            "climate": [
                {
                    "file": str(path), "from": day, "to": day,
                    "time": ["time"], "stamp": "end",
                    "global": ["global", "W m-2"],
                    "diffuse": ["diffuse", "W m-2"],
                }
            ],
            # The plants are so far apart that the modules stand over
            # practically bare soil.
            "spacing": [
                {
                    "row": pitch / 2,
                    "plant": 10,
                    "row_direction": facing - 90,
                }
            ],
            "field": {"rows": 2, "plants": 1},
            "plant": {"baseline": str(MAIZE)},
            "optics": {"soil_albedo": float(reading["albedo"])},
            "panel": panels,
            "objective": {"maximise": "absorbed_par"},
            "light": {"paths": 1 << 17, "randomisations": 16},
        }
    )  # fmt: skip
    found = stand.evaluate(stand.baseline).isel(plant=0)
    middle = end - HALF
    hour = middle.hour + middle.minute / 60 + middle.second / 3600
    light = found.object_light_by_hour.sel(hour=hour, method="nearest")
    front, back = (light.mean("object") / PAR).values.tolist()
    return float(suns.elevation.iloc[place]), front, back


PARTS = {
    "layouts": layouts,
    "cost": cost,
    "measured": measured,
    "trial": trial,
    "bred": bred,
}


def main() -> None:
    parser = parser_of_searches(
        __doc__, has_figure=True, generations=20, seeds=3
    )
    run_parts(parser, PARTS)


if __name__ == "__main__":
    guard(main)
