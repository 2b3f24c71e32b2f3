# SPDX-License-Identifier: Apache-2.0
"""Crops below rows of modules, for panels.py: the trial under trackers, and
plants optimised for their light."""

from __future__ import annotations

import math
import tomllib
from argparse import Namespace as Options
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w
from estimates import (
    Estimate,
    estimate,
    gain,
    interval_of,
    mean_over_seeds,
    plus_minus,
    print_table,
)
from panels_front import front, tables_of
from shared import FIELD_PLANTS, MAIZE, Numbers, best_plants, light

from ideotype import Stand

PURDUE_HEIGHT = 6.1
"""Height of modules that track in the trial [m]."""


def jackknife(figure: Callable[..., float], *draws: Numbers) -> Estimate:
    """Returns a function of the means of paired draws, with its jackknife
    error."""
    count = len(draws[0])
    without = [
        figure(*(np.delete(x, i, 0) for x in draws)) for i in range(count)
    ]
    return figure(*draws), math.sqrt((count - 1) * np.var(without))


# The trial.


def changed(folder: Path, name: str, height: float, angle: float) -> Path:
    """Writes a crop file of maize with scaled heights and insertion angles,
    and returns its path."""
    crop = tomllib.loads(MAIZE.read_text())
    crop["stalk"]["height"] *= height
    for leaf in crop["leaf"]:
        leaf["insertion_height"] *= height
        leaf["insertion_angle"] *= angle
    path = folder / f"{name.replace(' ', '_')}.toml"
    path.write_text(tomli_w.dumps(crop))
    return path


#: Factors for heights and insertion angles of plants, relative to
#: crops/maize.toml.
PLANTS = {
    "baseline": (1.0, 1.0),
    "shorter by a fifth": (0.8, 1.0),
    "more erect": (1.0, 0.6),
    "shorter and more erect": (0.8, 0.6),
}
#: Number of maize rows between successive rows of modules, width and height of
#: modules [m].
TRACKERS = (
    (9, 1.2, PURDUE_HEIGHT),
    (12, 1.7, PURDUE_HEIGHT),
    (24, 3.4, PURDUE_HEIGHT),
    (12, 1.7, 4.0),
)


def trial(options: Options) -> None:
    crops = {
        name: changed(options.folder, name, *factors)
        for name, factors in PLANTS.items()
    }
    rows = []
    for count, width, height in TRACKERS[:: 3 if options.rough else 1]:
        panel = {
            "width": width,
            "height": height,
            "azimuth": 90,
            "tracks": True,
        }

        def stand_of(
            crop: Path, panels: Sequence[Any], n: int = count
        ) -> Stand:
            return Stand(
                tables_of(
                    "bondville", options,
                    spacing=[
                        {"row": 0.762, "plant": 0.1524, "row_direction": 0}
                    ],
                    field={"rows": n, "plants": 2, "variation": FIELD_PLANTS},
                    plant={"baseline": str(crop)},
                    panel=panels,
                    objective={"maximise": ["carbon_balance", "net_assimilation"]},
                    search={"optimizer": "nsga2"},
                    **({} if options.rough else
                       {"final": {"paths": 4096, "randomisations": 96}}),
                )
            )  # fmt: skip

        stands = {
            name: (stand_of(crop, []), stand_of(crop, [panel]))
            for name, crop in crops.items()
        }
        with ThreadPoolExecutor(2) as pool:
            values = pool.map(
                lambda pair: [carbon_and_net(each) for each in pair],
                stands.values(),
            )
            found = dict(zip(stands, values, strict=True))
        shade = shaded(stands["baseline"][1], options)
        row = [
            f"{count * 0.762:.1f} m",
            f"{width} m",
            f"{height:.1f} m",
            shade,
        ]
        net = gain(*(x[1].tolist() for x in found["baseline"]))
        row.append(tell_gain(net))
        for name, (open_, below) in found.items():
            pair = open_[0], below[0]
            text = tell_gain(gain(*(x.tolist() for x in pair)))
            if name != "baseline":
                than, error = jackknife(
                    less, *pair, *(x[0] for x in found["baseline"])
                )
                text += f" ({tell_gain((than, error))})"
            row.append(text)
        rows.append(row)
    print_table(
        [
            "pitch", "width", "height", "shade [%]",
            "baseline: net assimilation [%]", "carbon [%]", *(f"{x} (over the baseline)" for x in PLANTS if x != "baseline"),
        ],
        rows,
    )  # fmt: skip


def carbon_and_net(stand: Stand) -> Numbers:
    """Returns the carbon balance and the net assimilation of the season [2,
    randomisations]."""
    found = stand.evaluate(stand.baseline, [], final=True)
    return np.asarray(found.objective_by_randomisation[0], float)


def tell_gain(x: Estimate) -> str:
    """Formats a gain with its 95 % interval."""
    return plus_minus(x, sign="+")


def less(open_: Numbers, below: Numbers, *of_baseline: Numbers) -> float:
    """Returns the light loss of the baseline minus that of the plant
    [percentage points]."""
    before, after = of_baseline
    return 100 * float(
        below.mean() / open_.mean() - after.mean() / before.mean()
    )


def shaded(stand: Stand, options: Options) -> str:
    """Returns the fraction of the season's light that the modules intercept
    above the plants [%]."""
    few = {"fields": 2, "points": 8} if options.rough else {"fields": 8}
    found = stand.light_at(stand.baseline, 3.0, **few).isel(sensor=0)
    part = found.incident / found.incident.sum()
    return f"{100 - 100 * float((part * found.fraction).sum()):.1f}"


# Plants optimised for their light.


def bred(options: Options) -> None:
    common: dict[str, Any] = {
        "replicates": options.seeds,
        "search": {},
        "stop": {"evaluations": 24 * options.generations},
    }
    places = {
        "below modules": tables_of("agrivoltaic", options, **common),
        "the open": tables_of("agrivoltaic", options, **common, panel=[]),
    }
    stands = {name: Stand(tables) for name, tables in places.items()}
    plants: dict[str, list[Numbers]] = {
        "baseline": [stands["the open"].baseline]
    }
    for name, tables in places.items():
        named = {**tables, "name": name.replace(" ", "_")}
        plants[name] = best_plants(named, options.folder)
    values = {
        (plant, place): [light(stand, each)[0] for each in genomes]
        for plant, genomes in plants.items()
        for place, stand in stands.items()
    }
    rows = []
    for plant, genomes in plants.items():
        row = [plant]
        for place in places:
            found = values[plant, place]
            row.append(
                plus_minus(
                    mean_over_seeds([estimate(x.tolist()) for x in found]), 3
                )
            )
        areas = stands["the open"].evaluate(np.array(genomes), ["lai"]).lai
        rows.append([*row, ", ".join(f"{x:.1f}" for x in areas.values)])
    titles = ["bred for", *(f"{x} [mol m-2 day-1]" for x in places)]
    print_table([*titles, "leaf area index, by seed"], rows)
    for place, elsewhere in zip(places, reversed(places), strict=True):
        gains = [
            gain(theirs.tolist(), own.tolist())
            for own, theirs in zip(
                values[place, place], values[elsewhere, place], strict=True
            )
        ]
        print(
            f"\n{place.capitalize()}, bred there over bred elsewhere: "
            + interval_of(gains)
        )
    print()
    alone = max(float(x.mean()) for x in values["the open", "the open"])
    front(options, alone)
