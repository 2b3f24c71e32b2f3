#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the table of arXiv:2512.06064: what breeding gains, and by which search.

paper_table.py FOLDER [--figure FILE.png] [--objective NAME...]
               [--condition NAME...] [--search NAME...] [--evaluations N]
               [--seeds N] [--other-seeds N] [--plant FILE.toml] [--alike]
               [--rough]

Breeds crops/maize.toml with four sets of traits, at five latitudes and at six
spacings (bounds "paper"; all else as in the first condition: all traits,
42 deg north, rows of 30 inches, plants 6 inches apart) for absorbed PAR and
net assimilation of a clear day, and for the carbon balance of a season, where
plants differ as those of fields do, by several searches with as many
evaluations each. BIPOP-CMA-ES comes from the package cma and differential
evolution from pymoo; both ask for plants through the Python module, and run
only if --search names them. Evaluates the best plants again, all with the same
random numbers, and prints gains over the baseline [%] with standard errors,
leaf area, and the gain per leaf area. With --alike all plants of a field are
the same while they are bred; a second table tells what those champions gain
where plants differ. Also tells after how many core-seconds (by the clock of
the wall: leave other work aside) the first seed had a plant with 90 % of the
largest gain under the first condition, which has more seeds than the others.

The season is that of Bondville, Illinois, 40 deg north in the place of 42, and
moved to the other latitudes (climates.moved_season).
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from climates import CLEAR_DAY, bondville, moved_season, season, site
from numpy.typing import ArrayLike
from searches import best_until
from shared import (
    MAIZE,
    ROUGH,
    SEVERAL_FIELDS,
    SMALL_FIELD,
    TITLES,
    Estimate,
    Numbers,
    best,
    breed_tables,
    estimate,
    gain,
    guard,
    light,
    mean_over_seeds,
    parser_of_searches,
    print_table,
)  # fmt: skip

from ideotype import Stand
from ideotype.analysis.style import new_figure, series

INCH = 0.0254
AMES = 42.0


@dataclass(frozen=True)
class Condition:
    name: str
    title: str
    latitude: float = AMES
    row: float = 30
    plant: float = 6
    """The distance between plants [inches]."""
    free: tuple[str, ...] = ("insertion_angle", "azimuth", "width", "length")


FIRST = Condition("all", "all traits, 42° N, 30 x 6 inches")
CONDITIONS = (
    FIRST,
    Condition("azimuth", "azimuths", free=("azimuth",)),
    Condition(
        "angles", "angles and azimuths", free=("insertion_angle", "azimuth")
    ),
    Condition(
        "widths",
        "the same and widths",
        free=("insertion_angle", "azimuth", "width"),
    ),
    *(
        Condition(f"{latitude:g}".replace(".", "p"), f"{latitude}° N", latitude)
        for latitude in (7.0, 39.35, 46.8, 56.2)
    ),
    *(
        Condition(f"{row}x{plant}", f"{row} x {plant}", row=row, plant=plant)
        for row, plant in ((15, 3), (15, 6), (20, 3), (20, 6), (30, 3))
    ),
)  # fmt: skip
UNITS = {
    "absorbed_par": "MJ m-2 day-1",
    "net_assimilation": "mol m-2 day-1",
    "carbon_balance": "mol m-2 day-1",
}
TITLES_OF_SEARCHES = {
    "random": "random search",
    "ga": "genetic algorithm",
    "auto": "auto",
    "cma_es": "single CMA-ES",
    "bipop": "BIPOP-CMA-ES",
    "pymoo": "differential evolution",
}
USUAL = ("ga", "auto")


@dataclass(frozen=True)
class Found:
    """The results under one condition and objective."""

    baseline: Estimate
    gains: dict[str, list[Estimate]]
    """The gains of each search and seed [%]."""
    lai: float
    """The leaf area index of the best plant of all."""
    gain_per_leaf_area: Estimate
    """The gain per leaf area of the same plant [%]."""
    varied_gains: dict[str, list[Estimate]]
    """The gains where plants differ, if they do not where they are bred
    [%]."""
    seconds: dict[str, float]
    """The core-seconds of each search until a plant with 90 % of the largest
    gain was known."""


def campaign(
    where: Condition,
    objective: str,
    folder: Path,
    is_rough: bool,
    plant: Path = MAIZE,
    is_alike: bool = False,
) -> dict[str, Any]:
    """Returns the tables of a condition, without a search."""
    tables: dict[str, Any] = {
        "name": f"{objective}_{where.name}",
        "spacing": [
            {
                "name": "stand",
                "row": round(where.row * INCH, 4),
                "plant": round(where.plant * INCH, 4),
            }
        ],
        "traits": [{"name": "free", "free": list(where.free)}],
        "plant": {"baseline": str(plant), "bounds": "paper"},
        "objective": {"maximise": objective},
        "field": {} if is_alike else SMALL_FIELD,
        "light": {} if is_alike else SEVERAL_FIELDS,
        "final": {"candidates": 3, "paths": 4096, "randomisations": 256},
    }
    if objective != "carbon_balance":
        here, light = site(where.latitude), {"day": [CLEAR_DAY]}
    elif where.latitude == AMES:
        here, light = bondville()["site"][0], {"climate": [season()]}
    else:
        moved = moved_season(where.latitude, folder)
        here = site(where.latitude)
        light = {"climate": [{**season(), "file": str(moved)}]}
    return {
        **tables,
        "site": [here],
        **light,
        **(ROUGH if is_rough else {}),
    }


def name_of(tables: dict[str, Any], search: str, seed: int) -> str:
    return f"{tables['name']}_{search}_s{seed}"


def bred(
    tables: dict[str, Any], search: str, seed: int, count: int, folder: Path
) -> Numbers:
    """Returns the genome of the best plant that this search finds."""
    if search in LIBRARIES:
        name = name_of(tables, search, seed)
        kept = folder / f"{name}.json"
        if not kept.exists():
            stand = Stand({**tables, "seed": seed})
            found = LIBRARIES[search](stand, seed, count)
            kept.write_text(json.dumps(found.tolist()))
        return np.array(json.loads(kept.read_text()))
    return best(searched(tables, search, seed, count, folder))


def searched(
    tables: dict[str, Any], search: str, seed: int, count: int, folder: Path
) -> Path:
    """Returns the history of a search by the program."""
    limits = {"generations": count // 10 + 1, "evaluations": count}
    settings: dict[str, Any] = {"optimizer": search}
    if search in ("random", "ga"):
        settings["population"] = min(100, count)
    run = {
        **tables,
        "name": name_of(tables, search, seed),
        "seed": seed,
        "search": settings,
        "stop": limits,
    }
    return breed_tables(run, folder)[0]


class Function:
    """A function that a library looks for the smallest value of, from free
    genes that run from 0 to 1. Each generation has fields and random numbers
    of its own."""

    def __init__(self, stand: Stand) -> None:
        genes = stand.genes
        self._stand, self._free = stand, np.asarray(stand.free)
        self._lower = genes.lower.to_numpy()[self._free]
        self._range = genes.upper.to_numpy()[self._free] - self._lower
        self.start = (stand.baseline[self._free] - self._lower) / self._range
        self.evaluations = self._generation = 0

    def plants(self, points: ArrayLike) -> Numbers:
        shares = np.atleast_2d(np.asarray(points, float))
        plants = np.tile(self._stand.baseline, (len(shares), 1))
        plants[:, self._free] = self._lower + self._range * shares
        return plants

    def __call__(self, points: ArrayLike) -> list[float]:
        self._generation += 1
        plants = self.plants(points)
        self.evaluations += len(plants)
        found = self._stand.evaluate(plants, [], generation=self._generation)
        values = np.asarray(found.objective_by_randomisation[:, 0])
        return [-x for x in values.mean(axis=1).tolist()]


def by_bipop(stand: Stand, seed: int, count: int) -> Numbers:
    """Searches by BIPOP-CMA-ES of the package cma (Hansen 2009,
    doi:10.1145/1570256.1570333)."""
    import cma

    function = Function(stand)
    options = {
        "bounds": [0, 1],
        "seed": seed,
        "maxfevals": count,
        "verbose": -9,
        "verb_log": 0,
    }
    _, search = cma.fmin2(
        None,
        function.start.clip(0.02, 0.98),
        0.2,
        options,
        restarts=9,
        bipop=True,
        parallel_objective=function,
    )
    return function.plants(search.result.xfavorite)[0]


def by_pymoo(stand: Stand, seed: int, count: int) -> Numbers:
    """Searches by differential evolution of pymoo."""
    from pymoo.algorithms.soo.nonconvex.de import DE
    from pymoo.core.problem import Problem
    from pymoo.problems.static import StaticProblem

    function = Function(stand)
    genes = len(function.start)
    problem = Problem(n_var=genes, n_obj=1, xl=0.0, xu=1.0)
    search = DE(pop_size=50)
    search.setup(problem, termination=("n_eval", count), seed=seed)
    while search.has_next():
        asked = search.ask()
        values = np.array(function(asked.get("X")))[:, None]
        search.evaluator.eval(StaticProblem(problem, F=values), asked)
        search.tell(infills=asked)
    return function.plants(search.result().X)[0]


LIBRARIES = {"bipop": by_bipop, "pymoo": by_pymoo}


def seconds_until(history: Path, stand: Stand, least: float) -> float:
    """Returns the core-seconds of all evaluations until a search had a plant
    that gains so much [%] when it is evaluated again; NaN if it has none."""
    points = best_until(history, list(range(50, 10**6, 50)))
    genomes = np.array([stand.baseline, *(plant for plant, _ in points)])
    baseline, *others = light(stand, genomes).tolist()
    for (_, seconds), values in zip(points, others, strict=True):
        if gain(baseline, values)[0] >= least:
            return seconds
    return math.nan


def find(
    tables: dict[str, Any],
    folder: Path,
    count: int,
    seeds: int,
    searches: Sequence[str],
) -> Found:
    """Finds the best plants of a campaign by each search and seed."""
    keys = list(product(searches, range(1, seeds + 1)))
    plants = [bred(tables, *key, count, folder) for key in keys]
    stand = Stand(tables)
    genomes = np.array([stand.baseline, *plants])

    def gains(values: Numbers) -> dict[str, list[Estimate]]:
        baseline, *others = values.tolist()
        found: dict[str, list[Estimate]] = {search: [] for search in searches}
        for (search, _), each in zip(keys, others, strict=True):
            found[search].append(gain(baseline, each))
        return found

    seen = stand.evaluate(genomes, ["lai"], final=True)
    values = np.asarray(seen.objective_by_randomisation[:, 0])
    lai = np.asarray(seen.lai)
    first = int(values[1:].mean(1).argmax()) + 1
    varied = None
    if not tables["field"]:
        field = Stand({**tables, "field": SMALL_FIELD})
        varied = field.evaluate(genomes, [], final=True)
    found = gains(values)
    least = 0.9 * max(mean for each in found.values() for mean, _ in each)
    return Found(
        baseline=estimate(values[0].tolist()),
        gains=found,
        lai=float(lai[first]),
        gain_per_leaf_area=gain(
            (values[0] / lai[0]).tolist(),
            (values[first] / lai[first]).tolist(),
        ),
        varied_gains={}
        if varied is None
        else gains(np.asarray(varied.objective_by_randomisation[:, 0])),
        seconds={
            search: seconds_until(
                searched(tables, search, 1, count, folder), stand, least
            )
            for search in searches
            if search not in LIBRARIES and tables["name"].endswith(FIRST.name)
        },
    )


def told(values: list[Estimate]) -> str:
    mean, error = mean_over_seeds(values)
    return f"{mean:.1f} ± {error:.1f}"


def row(where: Condition, found: Found) -> list[str]:
    return [
        where.title,
        "{:.3f} ± {:.3f}".format(*found.baseline),
        *(told(each) for each in found.gains.values()),
        f"{found.lai:.1f}",
        "{:+.1f} ± {:.1f}".format(*found.gain_per_leaf_area),
    ]


def tell(results: dict[tuple[str, Condition], Found]) -> None:
    some = next(iter(results.values()))
    searches = [TITLES_OF_SEARCHES[search] for search in some.gains]
    for objective in dict.fromkeys(name for name, _ in results):
        print(f"**{TITLES[objective]}**\n")
        titles = ["condition", f"baseline [{UNITS[objective]}]"]
        titles += [f"{search} [%]" for search in searches]
        titles += ["LAI of the best", "its gain per leaf area [%]"]
        print_table(
            titles,
            [
                row(where, found)
                for (name, where), found in results.items()
                if name == objective
            ],
        )
        print()
    if some.varied_gains:
        print("Gain where plants differ [%]\n")
        print_table(
            ["objective", "condition", *searches],
            [
                [
                    TITLES[name],
                    where.title,
                    *map(told, found.varied_gains.values()),
                ]
                for (name, where), found in results.items()
            ],
        )
        print()
    print(f"Gain by seed [%], {FIRST.title}\n")
    by_seed = []
    for (objective, where), found in results.items():
        if where == FIRST:
            cells = (
                ", ".join(f"{x:.1f}" for x, _ in each)
                for each in found.gains.values()
            )
            by_seed.append([TITLES[objective], *cells])
    print_table(["objective", *searches], by_seed)
    print(f"\nCore-seconds until 90 % of the largest gain, {FIRST.title}\n")
    print_table(
        ["objective", *searches],
        [
            [
                TITLES[objective],
                *(
                    f"{found.seconds[x]:.0f}"
                    if found.seconds.get(x, math.nan) < math.inf
                    else "not reached"
                    for x in found.gains
                ),
            ]
            for (objective, where), found in results.items()
            if where == FIRST
        ],
    )


def draw(results: dict[tuple[str, Condition], Found], path: Path) -> None:
    wheres = list(dict.fromkeys(where for _, where in results))
    names = list(dict.fromkeys(name for name, _ in results))
    figure = new_figure(4 * len(names), 0.5 + 0.4 * len(wheres))
    figure.suptitle("How much can breeding gain, and which search finds it?")
    axes = figure.subplots(1, len(names), sharey=True, squeeze=False)[0]
    for axis, objective in zip(axes, names, strict=True):
        some = results[objective, wheres[0]]
        for number, search in enumerate(some.gains):
            color, marker = series(number)
            found = [
                mean_over_seeds(results[objective, where].gains[search])
                for where in wheres
            ]
            axis.errorbar(
                [mean for mean, _ in found],
                np.arange(len(wheres)) + 0.15 * (number - 1),
                xerr=[error for _, error in found],
                linestyle="",
                color=color,
                marker=marker,
                label=TITLES_OF_SEARCHES[search],
            )
        axis.set_title(TITLES[objective], fontsize=9)
        axis.set_xlabel("gain over the baseline [%]")
        axis.set_xscale("symlog", linthresh=30)
        highest = axis.get_xlim()[1]
        ticks = [x for x in (0, 10, 20, 30, 50, 100, 300) if x < highest]
        axis.set_xticks(ticks, [f"{x}" for x in ticks])
        axis.minorticks_off()
    axes[0].set_yticks(range(len(wheres)), [x.title for x in wheres])
    axes[0].invert_yaxis()
    axes[0].legend(fontsize=7)
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = parser_of_searches(
        __doc__, evaluations=2500, seeds=3, other_seeds=1
    )
    parser.add_argument("--figure", type=Path)
    parser.add_argument("--plant", type=Path, default=MAIZE)
    parser.add_argument("--alike", action="store_true")
    parser.add_argument("--objective", nargs="+", choices=UNITS, default=UNITS)
    parser.add_argument(
        "--condition", nargs="+", choices=[x.name for x in CONDITIONS]
    )
    parser.add_argument(
        "--search", nargs="+", choices=TITLES_OF_SEARCHES, default=USUAL
    )
    options = parser.parse_args()
    wheres = [
        where
        for where in CONDITIONS
        if not options.condition or where.name in options.condition
    ]
    results = {}
    for objective, where in product(options.objective, wheres):
        print(f"{objective}: {where.title}", file=sys.stderr, flush=True)
        results[objective, where] = find(
            campaign(
                where,
                objective,
                options.folder,
                options.rough,
                options.plant,
                options.alike,
            ),
            options.folder,
            options.evaluations,
            options.seeds if where == FIRST else options.other_seeds,
            options.search,
        )
    tell(results)
    if options.figure:
        draw(results, options.figure)


if __name__ == "__main__":
    guard(main)
