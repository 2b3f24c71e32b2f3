#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the effect of a response anchored in strong light, and of leaf age.

strong_light.py [--only PART] [--rough]

leaf        Net assimilation of a leaf at a PPFD of 500, 1000 and 2000, by the default of the
            program and by crops/maize_hybrid.toml, with the rate measured by Kim and others 2006.
canopy      Gross assimilation of the hybrid at a leaf area index of 5.5 against PPFD, on a clear
            10 July.
efficiency  Gross assimilation per absorbed PAR on a clear day and in the season of Bondville
            2011, where plants grow, with the response and with ageing each changed both ways.
stages      The error of the season's gross assimilation by number of stages, with ageing.
panels      The baseline of agrivoltaic.toml below its modules and without them, by the profile of
            capacity over the canopy. Profiles do not depend on the light below modules; in two
            further rows canopy nitrogen follows the mean light that leaves absorb there.

± is half of a 95 % interval. Evaluations of one table have common random numbers; --rough is for
tests.
"""

from __future__ import annotations

import math
from argparse import Namespace as Options
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from estimates import Estimate, estimate, gain, plus_minus, print_table
from fields import DENSITY, JULY, ROW, Field, crop, density_of, measure
from growing import tables
from measured_seasons import figures_of_light
from panels_front import tables_of
from shared import (
    FIELD_PLANTS,
    ROUGH,
    Numbers,
    guard,
    leaves,
    light,
    parser_of,
    run_parts,
)  # fmt: skip

from ideotype import Stand

FORMER = {"amax": 50, "rd": 2}
"""The response of the crop before it was anchored, with the defaults of the program."""
PHI, THETA, ABSORPTANCE = 0.06, 0.7, 0.91
PPFD_PER_WATT = 4.57
"""Photons of PAR [umol J-1]."""
LEVELS = (350, 670, 990, 1310, 1630, 1950)
EFFICIENCY = "1.96 ± 0.10 (Suyker and Verma 2012)"
KIM = "48.7 (Kim and others 2006)"


def hyperbola(absorbed: float, amax: float) -> float:
    total = PHI * absorbed + amax
    product = 4 * THETA * PHI * absorbed * amax
    return (total - math.sqrt(total**2 - product)) / (2 * THETA)


def amax_for(absorbed: float, rate: float) -> float:
    most = PHI * absorbed
    return rate * (most - THETA * rate) / (most - rate)


def settings(photosynthesis: Mapping[str, float]) -> list[str]:
    return [f"photosynthesis.{k}={v}" for k, v in photosynthesis.items()]


def leaf(options: Options) -> None:
    responses = {
        "default, amax 50": 50.0,
        "rate_2000 = 52": amax_for(2000, 52),
    }
    rows = []
    for name, amax in responses.items():
        rates = [
            hyperbola(ABSORPTANCE * ppfd, amax) - 2
            for ppfd in (500, 1000, 2000)
        ]
        rows.append([name, f"{amax:.1f}", *(f"{x:.1f}" for x in rates)])
    rows.append(["measured", "", "", "", KIM])
    print_table(
        ["leaf at the ear, 30 deg C", "amax", "500", "1000", "2000 [umol m-2 s-1]"],
        rows,
    )  # fmt: skip


def by_light(
    field: Field, more: list[str]
) -> tuple[Numbers, Numbers, Numbers]:
    """Returns PPFD, gross assimilation and its standard error for each half
    hour of a day."""
    stand = Stand(field.tables(), folder=field.campaign.parent, settings=more)
    found = stand.evaluate(
        stand.baseline, ["assimilation_by_hour"], final=True, threads=1
    ).isel(plant=0)
    incident = stand.light_at(stand.baseline, 4.0, fields=2, points=4).incident
    ppfd = PPFD_PER_WATT * incident.values
    order = np.argsort(ppfd)
    return (
        ppfd[order],
        found.assimilation_by_hour.values[order],
        found.assimilation_by_hour_standard_error.values[order],
    )


def canopy(options: Options) -> None:
    field = replace(JULY, density=density_of(5.5))
    accuracy = rough_final(options)
    rows = []
    for name, keys in (("amax = 50", FORMER), ("rate_2000 = 52", {})):
        ppfd, rate, error = by_light(field, [*settings(keys), *accuracy])
        rows.append(
            [
                name,
                *(
                    plus_minus(
                        (np.interp(x, ppfd, rate), np.interp(x, ppfd, error))
                    )
                    for x in LEVELS
                ),
            ]
        )
    titles = [f"{x}" for x in LEVELS]
    print_table(["PPFD, leaf area index 5.5", *titles], rows)


def rough_final(options: Options) -> list[str]:
    final = ROUGH["final"].items() if options.rough else ()
    return [f"final.{key}={value}" for key, value in final]


def clear_day(options: Options) -> list[list[str]]:
    rows = []
    for stage in (1, 1.5, 1.75):
        for name, keys in (("amax = 50", FORMER), ("rate_2000 = 52", {})):
            found = measure(
                Field(
                    ROW, DENSITY,
                    more=(*settings(keys), f"plant.stage={stage}"),
                ),
                rough_final(options),
            )  # fmt: skip
            rows.append(
                [
                    f"clear day, plant.stage = {stage}",
                    name,
                    "",
                    plus_minus(found["light_use_efficiency"], 3),
                    "",
                ]
            )
    return rows


def season(options: Options) -> list[list[str]]:
    seeds = 2 if options.rough else 6
    plain = {
        **tables(paths=256 if options.rough else 4096),
        "field": {"rows": 2, "plants": 2, "variation": FIELD_PLANTS},
    }
    responses: dict[str, dict[str, Any]] = {
        "Collatz": {"model": "collatz"},
        "amax = 50": FORMER,
        "rate_2000 = 52": {},
    }
    found: dict[tuple[str, bool], dict[str, list[float]]] = {}
    for name, keys in responses.items():
        for ages in (False, True):
            campaign = {**plain, "photosynthesis": keys}
            if not ages:
                hybrid = crop("crops/maize_hybrid.toml")
                hybrid["growth"]["ageing"] = [1]
                campaign["plant"] = {**plain["plant"], "baseline": hybrid}
            found[name, ages] = figures_of_light(campaign, seeds)
    first = found["Collatz", False]
    rows = []
    for (name, ages), figures in found.items():
        cells = [estimate(figures["gross_efficiency"])]
        changes = [
            gain(first[x], figures[x]) for x in ("gross_efficiency", "harvest")
        ]
        rows.append(
            [
                "season, plants grow",
                name,
                "ageing" if ages else "no ageing",
                *(plus_minus(x, 3) for x in cells),
                ", ".join(plus_minus(x, sign="+") for x in changes),
            ]
        )
    return rows


def efficiency(options: Options) -> None:
    print_table(
        [
            "light",
            "response",
            "leaves",
            "gross assimilation per absorbed PAR [g C MJ-1]",
            "over the first row of seasons; dry matter at harvest [%]",
        ],
        [
            *clear_day(options),
            *season(options),
            ["measured", "", "", EFFICIENCY, ""],
        ],
    )


def stages(options: Options) -> None:
    counts = (4, 10) if options.rough else (6, 8, 10, 14, 20)
    seeds = 2 if options.rough else 6

    def carbon(ages: list[float], count: int) -> list[float]:
        """Returns the season's gross assimilation for each seed."""
        paths = 64 if options.rough else 2048
        campaign = tables(paths=paths, stages=count, dates=count)
        hybrid = crop("crops/maize_hybrid.toml")
        hybrid["growth"]["ageing"] = ages
        campaign["plant"] = {**campaign["plant"], "baseline": hybrid}
        stand = Stand(campaign)
        found = [
            stand.evaluate(stand.baseline, ["gross_assimilation"], seed=seed)
            for seed in range(1, seeds + 1)
        ]
        return [float(x.gross_assimilation[0]) for x in found]

    rows = []
    for ages in ([1.0], [1, 1, 0.9, 0.7, 0.3]):
        exact = carbon(ages, 40)
        errors = [gain(exact, carbon(ages, count)) for count in counts]
        rows.append([str(ages), *(plus_minus(x, 2, "+") for x in errors)])
    print_table(
        ["error over 40 stages [%], by stages; ageing", *map(str, counts)],
        rows,
    )


def nitrogen_response(nitrogen: Numbers) -> Numbers:
    """Returns the photosynthetic capacity of leaves relative to that with 1.8
    g m-2 of nitrogen (Vos and others 2005), as in the program."""

    def capacity(n: Numbers | float) -> Any:
        return 2 / (1 + np.exp(-2.9 * (n - 0.25))) - 1

    return np.maximum(capacity(nitrogen) / capacity(1.8), 0)


def by_mean_light(stand: Stand) -> dict[str, Any]:
    """Returns the photosynthesis of leaves that share a canopy nitrogen of 4.5
    g m-2 in proportion to the square root of the light absorbed per leaf area:
    nitrogen decreases with depth half as fast as light (Hikosaka and others
    2016)."""
    found = stand.evaluate(
        stand.baseline, ["absorbed_by_leaf", "lai"], final=True
    )
    one = leaves(stand, stand.baseline)
    area = (one.length * one.width).to_numpy()
    area = area * float(found.lai[0]) / area.sum()
    root = np.sqrt(found.absorbed_by_leaf[0].values / area)
    factor = nitrogen_response(4.5 * root / (root * area).sum())
    amax = amax_for(2000, 52) * factor
    return {
        "profile": "none",
        "amax": amax.round(4).tolist(),
        "rd": (2 * factor).round(5).tolist(),
    }


def panels(options: Options) -> None:
    def stand_at(place: str, keys: dict[str, Any]) -> Stand:
        none: dict[str, Any] = {"panel": []} if place == "open" else {}
        return Stand(
            tables_of("agrivoltaic", options, photosynthesis=keys, **none)
        )

    places = ("open", "below")
    like = {place: by_mean_light(stand_at(place, {})) for place in places}
    profiles: dict[str, dict[str, dict[str, Any]]] = {
        **{
            name: {place: {"profile": name} for place in places}
            for name in ("rank", "none", "exponential", "nitrogen")
        },
        "by mean light in the open": dict.fromkeys(places, like["open"]),
        "by mean light in each place": like,
    }
    found: dict[str, dict[str, list[float]]] = {}
    for name, keys in profiles.items():
        found[name] = {}
        for place in places:
            stand = stand_at(place, keys[place])
            found[name][place] = light(stand, stand.baseline)[0].tolist()
    shipped = found["rank"]
    lost = less(shipped)
    rows = []
    for name, each in found.items():
        than = estimate_of(np.array([lost, less(each)]))
        rows.append(
            [
                name,
                *(plus_minus(estimate(each[x]), 3) for x in places),
                *(
                    plus_minus(gain(shipped[x], each[x]), 2, "+")
                    for x in places
                ),
                plus_minus(gain(each["open"], each["below"]), 2, "+"),
                plus_minus(than, 2, "+"),
            ]
        )
    print_table(
        [
            "profile of capacity",
            *(f"{x} [mol m-2 day-1]" for x in places),
            *(f"{x}, over the shipped profile [%]" for x in places),
            "below over open [%]",
            "difference from the shipped profile [points]",
        ],
        rows,
    )
    print()
    print_table(
        ["amax by mean light, lowest leaf first", "[umol m-2 s-1]"],
        [
            [place, ", ".join(f"{x:.1f}" for x in like[place]["amax"])]
            for place in places
        ],
    )


def less(found: Mapping[str, list[float]]) -> Numbers:
    """Returns the loss below modules [%], omitting each randomisation in
    turn."""
    open_, below = (np.array(found[x]) for x in ("open", "below"))
    return 100 * ((below.sum() - below) / (open_.sum() - open_) - 1)


def estimate_of(without: Numbers) -> Estimate:
    """Returns the difference of two figures by the jackknife."""
    values = without[1] - without[0]
    return float(values.mean()), math.sqrt((values.size - 1) * values.var())


PARTS = {
    "leaf": leaf,
    "canopy": canopy,
    "efficiency": efficiency,
    "stages": stages,
    "panels": panels,
}


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("--rough", action="store_true")
    run_parts(parser, PARTS)


if __name__ == "__main__":
    guard(main)
