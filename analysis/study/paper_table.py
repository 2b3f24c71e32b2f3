#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the table of arXiv:2512.06064: gains by condition and search.

paper_table.py FOLDER [--figure FILE.png] [--objective NAME...]
               [--condition NAME...] [--search NAME...] [--evaluations N]
               [--seeds N] [--other-seeds N] [--plant FILE.toml] [--alike]
               [--rough]

Optimises crops/maize.toml under within-line variation, by several searches
with the same number of evaluations. Conditions are four sets of traits, five
latitudes and six spacings, with bounds "paper"; each differs in one property
from the first (all traits, 42 deg north, rows of 30 inches, plants 6 inches
apart). Objectives are absorbed PAR and net assimilation of a clear day, and
the carbon balance of a season. BIPOP-CMA-ES comes from the package cma and
differential evolution from pymoo; both request plants through the Python
module, and run only if --search names them.

Re-evaluates the best plants with common random numbers and prints gains over
the baseline [%] with 95 % intervals, leaf area, and the gain per leaf area;
differences in the unit of the objective where the baseline is not above zero
by three standard errors. For the plants of the last search also prints the
gains without other organs, and the parts of the gain. With --alike searches
have uniform stands; a second table has the gains of their best plants in
variable stands. The first condition has more seeds than the others; a last
table has the gain of each.

The season is that of Bondville, Illinois, 40 deg north instead of 42, and
moved to the other latitudes (climates.moved_season).
"""

from __future__ import annotations

import json
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import xarray
from conditions import (
    AT_SILKING,
    CONDITIONS,
    FIRST,
    UNITS,
    Condition,
    campaign,
)
from estimates import (
    Estimate,
    difference,
    estimate,
    gain,
    half_interval,
    has_percent,
    mean_over_seeds,
    plus_minus,
    print_table,
)
from libraries import LIBRARIES
from shared import (
    MAIZE,
    SMALL_FIELD,
    TITLES,
    Numbers,
    best,
    breed_tables,
    finals,
    guard,
    light,
    objectives,
    parser_of_searches,
    say,
)  # fmt: skip

from ideotype import Stand
from ideotype.figures.style import new_figure, series
from ideotype.report.organ_split import Split, make_variants, split_gain

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
class Gains:
    """The gains of the best plant of each search and seed."""

    by_search: dict[str, list[Estimate]]
    """[%] if `is_percent`, else differences in the unit of the objective."""
    is_percent: bool
    """Whether the baseline is above zero, so that gains have a meaning in per
    cent."""

    def cells(self, unit: str) -> list[str]:
        """Formats the mean over seeds of each search. unit: that of the
        objective."""
        means = map(mean_over_seeds, self.by_search.values())
        if self.is_percent:
            return [plus_minus(each) for each in means]
        symbol = unit.partition(" ")[0]
        return [f"{plus_minus(each, 3, '+')} {symbol}" for each in means]


@dataclass(frozen=True)
class Found:
    """The results for one condition and objective."""

    baseline: Estimate
    gains: Gains
    lai: float
    """The leaf area index of the best plant of all."""
    gain_per_leaf_area: Estimate
    """The gain of the best plant of all per leaf area [%]."""
    varied_gains: Gains | None
    """The gains where plants differ, if plants are alike while they are
    bred."""
    splits: list[Split]
    """The gains of the plants of the last search with and without other
    organs; empty if the plants have no other organs."""


def name_of(tables: dict[str, Any], search: str, seed: int) -> str:
    return f"{tables['name']}_{search}_s{seed}"


def bred(
    tables: dict[str, Any], search: str, seed: int, count: int, folder: Path
) -> Numbers:
    """Returns the genome of the best plant of the given search."""
    if search in LIBRARIES:
        name = name_of(tables, search, seed)
        kept = folder / f"{name}.json"
        if not kept.exists():
            stand = Stand({**tables, "seed": seed})
            found = LIBRARIES[search](stand, seed, count)
            kept.write_text(json.dumps(found.tolist()))
        return np.array(json.loads(kept.read_text()))
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
    return best(breed_tables(run, folder)[0])


def splits_of(stand: Stand, genomes: Numbers, values: Numbers) -> list[Split]:
    """Returns the split of the gain of each plant over the first one. `values`
    are the objective with all organs [plants, randomisations]."""
    resolved = tomllib.loads(stand.campaign)
    variants = make_variants(resolved)
    if not variants:
        return []
    found = [values]
    for variant in variants[1:]:
        changed = Stand(resolved, settings=variant.settings)
        found.append(light(changed, genomes))
    unit = UNITS[next(iter(stand.objectives))]
    return [
        split_gain(variants, [each[[0, k]] for each in found], unit)
        for k in range(1, len(genomes))
    ]


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

    def compared(seen: xarray.Dataset) -> Gains:
        baseline, *others = objectives(seen).tolist()
        is_percent = has_percent(baseline)
        compare = gain if is_percent else difference
        found: dict[str, list[Estimate]] = {search: [] for search in searches}
        for (search, _), each in zip(keys, others, strict=True):
            found[search].append(compare(baseline, each))
        return Gains(found, is_percent)

    seen = finals(stand, genomes, ["lai"])
    values = objectives(seen)
    lai = np.asarray(seen.lai)
    first = int(values[1:].mean(1).argmax()) + 1
    varied = None
    if not tables["field"]:
        field = Stand({**tables, "field": SMALL_FIELD})
        varied = finals(field, genomes)
    last = [0, *range(1 + len(keys) - seeds, 1 + len(keys))]
    return Found(
        baseline=estimate(values[0].tolist()),
        gains=compared(seen),
        lai=float(lai[first]),
        gain_per_leaf_area=gain(
            (values[0] / lai[0]).tolist(),
            (values[first] / lai[first]).tolist(),
        ),
        varied_gains=None if varied is None else compared(varied),
        splits=splits_of(stand, genomes[last], values[last]),
    )


def row(where: Condition, found: Found, unit: str) -> list[str]:
    return [
        where.title,
        plus_minus(found.baseline, 3),
        *found.gains.cells(unit),
        f"{found.lai:.1f}",
        plus_minus(found.gain_per_leaf_area, sign="+")
        if found.gains.is_percent
        else "",
        *parts(found.splits),
    ]


def parts(splits: Sequence[Split]) -> list[str]:
    """Returns means over seeds: the gain in each variant except the first, and
    the differences between successive variants."""
    if not splits:
        return []
    unit = splits[0].unit
    is_percent = unit == "%"
    return [
        plus_minus(
            mean_over_seeds([(x.mean, x.standard_error) for x in each]),
            1 if is_percent else 3,
            "+",
        )
        + ("" if is_percent else f" {unit.partition(' ')[0]}")
        for each in (
            *zip(*(x.gains[1:] for x in splits), strict=True),
            *zip(*(x.parts for x in splits), strict=True),
        )
    ]


def titles_of_parts(splits: Sequence[Split]) -> list[str]:
    """Returns the titles of the columns of parts()."""
    variants = splits[0].variants[1:] if splits else ()
    return [
        *(f"{x.title} [%]" for x in variants),
        *(f"by {x.removed} [points]" for x in variants),
    ]


def tell(results: dict[tuple[str, Condition], Found]) -> None:
    some = next(iter(results.values()))
    searches = [TITLES_OF_SEARCHES[search] for search in some.gains.by_search]
    for objective in dict.fromkeys(name for name, _ in results):
        print(f"**{TITLES[objective]}**\n")
        titles = ["condition", f"baseline [{UNITS[objective]}]"]
        titles += [f"{search} [%]" for search in searches]
        titles += ["LAI of the best", "its gain per leaf area [%]"]
        titles += titles_of_parts(some.splits)
        print_table(
            titles,
            [
                row(where, found, UNITS[objective])
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
                    *found.varied_gains.cells(UNITS[name]),
                ]
                for (name, where), found in results.items()
                if found.varied_gains
            ],
        )
        print()
    print(f"Gain by seed [%], {FIRST.title}\n")
    by_seed = []
    for (objective, where), found in results.items():
        if where == FIRST:
            cells = (
                ", ".join(f"{x:.1f}" for x, _ in each)
                for each in found.gains.by_search.values()
            )
            by_seed.append([TITLES[objective], *cells])
    print_table(["objective", *searches], by_seed)


def draw(results: dict[tuple[str, Condition], Found], path: Path) -> None:
    wheres = list(dict.fromkeys(where for _, where in results))
    names = list(dict.fromkeys(name for name, _ in results))
    figure = new_figure(4 * len(names), 0.5 + 0.4 * len(wheres))
    figure.suptitle("How much can breeding gain, and which search finds it?")
    axes = figure.subplots(1, len(names), sharey=True, squeeze=False)[0]
    for axis, objective in zip(axes, names, strict=True):
        some = results[objective, wheres[0]]
        for number, search in enumerate(some.gains.by_search):
            color, marker = series(number)
            found = {
                place: mean_over_seeds(
                    results[objective, where].gains.by_search[search]
                )
                for place, where in enumerate(wheres)
                if results[objective, where].gains.is_percent
            }
            axis.errorbar(
                [mean for mean, _ in found.values()],
                np.array([*found]) + 0.15 * (number - 1),
                xerr=[half_interval(error) for _, error in found.values()],
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
        __doc__, has_figure=True, evaluations=2500, seeds=3, other_seeds=1
    )
    parser.add_argument("--plant", type=Path, default=MAIZE)
    parser.add_argument("--alike", action="store_true")
    parser.add_argument(
        "--objective", nargs="+", choices=UNITS, default=AT_SILKING
    )
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
        say(f"{objective}: {where.title}")
        results[objective, where] = find(
            campaign(
                where,
                objective,
                options.folder,
                options.rough,
                options.plant.resolve(),
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
