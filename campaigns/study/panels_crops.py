# SPDX-License-Identifier: Apache-2.0
"""Crops below rows of modules, for panels.py: the trial under trackers, and plants that are
bred for their place."""

from __future__ import annotations

import math
import tomllib
from argparse import Namespace as Options
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w
from pvlib import pvsystem, temperature
from shared import (
    FIELD_PLANTS,
    MAIZE,
    ROUGH,
    Estimate,
    Numbers,
    best,
    breed_tables,
    campaign_of,
    estimate,
    front_of,
    gain,
    interval_of,
    light,
    mean_over_seeds,
    print_table,
    told,
)  # fmt: skip

from ideotype import Stand
from ideotype.analysis.figures.style import BASELINE, BEST, MEAN, new_figure

PURDUE_HEIGHT = 6.1
"""Height of modules that track in the trial [m]."""


def tables_of(file: str, options: Options, **more: Any) -> dict[str, Any]:
    """Returns a campaign of this project in which some tables are replaced."""
    return campaign_of(file, **{**(ROUGH if options.rough else {}), **more})


def jackknife(figure: Callable[..., float], *draws: Numbers) -> Estimate:
    """Returns a figure over the means of paired draws, and its error."""
    count = len(draws[0])
    without = [
        figure(*(np.delete(x, i, 0) for x in draws)) for i in range(count)
    ]
    return figure(*draws), math.sqrt((count - 1) * np.var(without))


# The trial.


def changed(folder: Path, name: str, height: float, angle: float) -> Path:
    """Returns a crop file of maize with factors for heights and insertion
    angles."""
    crop = tomllib.loads(MAIZE.read_text())
    crop["stalk"]["height"] *= height
    for leaf in crop["leaf"]:
        leaf["insertion_height"] *= height
        leaf["insertion_angle"] *= angle
    path = folder / f"{name.replace(' ', '_')}.toml"
    path.write_text(tomli_w.dumps(crop))
    return path


#: Heights and insertion angles of plants, relative to those of
#: crops/maize.toml.
PLANTS = {
    "baseline": (1.0, 1.0),
    "shorter by a fifth": (0.8, 1.0),
    "more erect": (1.0, 0.6),
    "shorter and more erect": (0.8, 0.6),
}
#: Rows of maize from one row of modules to the next, width and height of modules [m].
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
    """Returns carbon balance and net assimilation of the season [2,
    randomisations]."""
    found = stand.evaluate(stand.baseline, [], final=True)
    return np.asarray(found.objective_by_randomisation[0], float)


def tell_gain(x: Estimate) -> str:
    """Tells a figure with its 95 % interval."""
    return f"{x[0]:+.1f} ± {1.96 * x[1]:.1f}"


def less(open_: Numbers, below: Numbers, *of_baseline: Numbers) -> float:
    """Returns how much less light a plant loses than the baseline [%]."""
    before, after = of_baseline
    return 100 * float(
        below.mean() / open_.mean() - after.mean() / before.mean()
    )


def shaded(stand: Stand, options: Options) -> str:
    """Returns the light of the season that modules keep from plants [%]."""
    few = {"fields": 2, "points": 8} if options.rough else {"fields": 8}
    found = stand.light_at(stand.baseline, 3.0, **few).isel(sensor=0)
    part = found.incident / found.incident.sum()
    return f"{100 - 100 * float((part * found.fraction).sum()):.1f}"


# Plants that are bred for their place.


def bred(options: Options) -> None:
    common: dict[str, Any] = {
        "replicates": options.seeds,
        "stop": {"generations": options.generations},
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
        plants[name] = [
            best(path) for path in breed_tables(named, options.folder)
        ]
    values = {
        (plant, place): [light(stand, each)[0] for each in genomes]
        for plant, genomes in plants.items()
        for place, stand in stands.items()
    }
    rows = []
    for plant in plants:
        row = [plant]
        for place in places:
            found = values[plant, place]
            row.append(
                told(mean_over_seeds([estimate(x.tolist()) for x in found]), 3)
            )
        rows.append(row)
    print_table(
        ["bred for", *(f"{x} [mol m-2 day-1]" for x in places)],
        rows,
    )
    for place in places:
        own = values[place, place]
        other = values[
            "the open" if place != "the open" else "below modules", place
        ]
        gains = [
            gain(b.tolist(), a.tolist())
            for a, b in zip(own, other, strict=True)
        ]
        print(
            f"\n{place.capitalize()}, bred there over bred elsewhere: "
            + interval_of(gains)
        )
    print()
    alone = max(float(x.mean()) for x in values["the open", "the open"])
    front(options, alone)


def electricity(found: Any) -> float:
    """Returns the energy of a day per area of ground [kWh m-2], with pvlib, air of
    25 deg C and almost no wind."""
    light = found.object_light_by_hour.sel(object="panel").sum("band")
    front, back = (light.sel(object_side=side) for side in ("front", "back"))
    used = (front + 0.75 * back).values
    power = pvsystem.pvwatts_dc(
        used, temperature.faiman(used, 25.0), 0.21, -0.0035
    )
    both = float((front + back).sum()) * 3600e-6
    return float(found.panel_light) / both * float(power.sum())


def front(options: Options, alone: float) -> None:
    """Breeds for crop and light on modules, and prints members of the front with
    their land equivalent ratio."""
    tables = tables_of("agrivoltaic", options)
    # Rows of modules are as far apart as the field is wide.
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
                told((crop[i], error[i]), 3), f"{power[i]:.3f}",
                f"{crop[i] / alone:.3f}", f"{power[i] / most:.3f}",
                told((crop[i] / alone + power[i] / most, error[i] / alone), 3),
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
    """Returns the electricity of modules over soil [kWh m-2 day-1]."""
    row = pitch / 4
    stand = Stand(
        {
            **tables,
            "spacing": [{"row": row, "plant": 10, "row_direction": 0}],
            "field": {"rows": 4, "plants": 1},
            "search": {},
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
