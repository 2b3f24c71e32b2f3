#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures what changes if plants respond to the density of their stand.

plasticity.py FOLDER [--only PART] [--evaluations N] [--seeds N] [--rough]

    extinction  k at noon, silking, over the 12 densities of Li and others
                2018 (rows of 0.6 m)
    erect       the leaf area index from which an erect top pays: gross
                assimilation of a clear day, upper leaves at 12 instead of 45
                deg (Winter and Ohlrogge 1973)
    densities   crops/maize_hybrid.toml optimised for a season's carbon at each
                density alone, for the mean of all densities, and for that mean
                with reaction norms as traits: what each plant loses at other
                densities
    narrow      what optimisation gains in rows of 15 inches with 6 and 3
                inches between plants (17 and 34 m-2)

All of them with the hybrid as it is, without its responses, and (extinction
and erect) with all slopes at the ends of their ranges: half or twice as large
for lengths, and those of crops/maize_hybrid.toml for the others. ± is half of
a 95 % interval.
"""

from __future__ import annotations

import argparse
import tomllib
from collections.abc import Sequence
from copy import deepcopy
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w
from climates import CLEAR_DAY, bondville, season
from estimates import (
    Estimate,
    difference,
    estimate,
    gain,
    has_percent,
    mean_over_seeds,
    plus_minus,
    print_table,
    sign_change,
)
from shared import (
    BREEDABLE,
    HYBRID,
    ROUGH,
    Numbers,
    best_plants,
    guard,
    light,
    parser_of_searches,
    run_parts,
    say,
)  # fmt: skip

from ideotype import Stand
from ideotype.validation import compare, read_facts, shipped_facts

INCH = 0.0254
ROW = 0.76
DENSITIES = (5.0, 7.5, 10.5, 14.0)
"""Densities for which plants are optimised [m-2]."""
TREATED = (2.0, 3.0, 4.5, 6.0, 7.5, 9.0, 12.0)
"""Densities at which upper leaves are erect [m-2]."""
UPPER = 5
#: The slope of each measure at the ends of its range, weak and strong.
ENDS = {
    "leaf.length": (0.5, 2.0),  # times that of the file
    "leaf.width": (-0.08, -0.25),
    "stalk.base_diameter": (-0.10, -0.30),
    "stalk.height": (0.0, 0.10),
    "leaf.insertion_angle": (-2.0, -8.0),
}
#: Traits that are reaction norms: slopes of insertion angles and widths.
NORMS: list[dict[str, Any]] = [
    {
        "name": "angle_slope",
        "per": "profile",
        "points": 3,
        "shifts": ["leaf.insertion_angle"],
        "unit": "deg",
        "range": [-15, 15],
        "over_density": True,
        "bred": False,
    },
    {
        "name": "width_slope",
        "per": "profile",
        "points": 3,
        "scales": ["leaf.width"],
        "unit": "1",
        "range": [-0.4, 0.4],
        "over_density": True,
        "bred": False,
    },
]


def hybrid() -> dict[str, Any]:
    return tomllib.loads(HYBRID.read_text(encoding="utf-8"))


def with_slopes(end: int) -> dict[str, Any]:
    """Returns the hybrid with all slopes at the weak (0) or the strong (1)
    ends of their ranges."""
    crop = hybrid()
    for response in crop["response"]:
        measure = (*response.get("scales", []), *response.get("shifts", []))[0]
        slope = ENDS[measure][end]
        if measure == "leaf.length":
            response["slope"] = [slope * x for x in response["slope"]]
        else:
            response["slope"] = slope
    return crop


def rigid() -> dict[str, Any]:
    crop = hybrid()
    del crop["response"], crop["plasticity"]
    return crop


def crops(folder: Path) -> dict[str, Path]:
    """Writes the crop file of each variant."""
    variants = {
        "without responses": rigid(),
        "slopes at weak ends": with_slopes(0),
        "hybrid": hybrid(),
        "slopes at strong ends": with_slopes(1),
    }
    paths = {}
    for name, crop in variants.items():
        paths[name] = folder / f"{name.replace(' ', '_')}.toml"
        paths[name].write_text(tomli_w.dumps(crop), encoding="utf-8")
    return paths


def extinction(options: argparse.Namespace) -> None:
    (fact,) = read_facts(shipped_facts()).named(["k_by_density"])
    seeds = 2 if options.rough else 8
    columns = {
        name: compare(fact, seeds, {"plant.baseline": str(path)}).points
        for name, path in crops(options.folder).items()
    }
    rows = []
    for i, row in enumerate(fact.measurements):
        measured = f"{row.low:.2f}" if row.is_measured else ""
        cells = [
            plus_minus((points[i].computed, points[i].standard_error), 3)
            for points in columns.values()
        ]
        density = row.keys["spacing.density"]
        rows.append([f"{density:g}", measured, *cells])
    print_table(["density [m-2]", "measured", *columns], rows)


def with_top(path: Path, angle: float) -> dict[str, Any]:
    """Returns a crop with another insertion angle of its upper leaves."""
    crop = tomllib.loads(path.read_text(encoding="utf-8"))
    for leaf in crop["leaf"][-UPPER:]:
        leaf["insertion_angle"] = angle
    return crop


def clear_day(
    crop: dict[str, Any], density: float, is_rough: bool
) -> dict[str, Any]:
    """Returns the tables of gross assimilation on a clear day."""
    return {
        "name": "erect",
        "site": [bondville()["site"][0]],
        "day": [CLEAR_DAY],
        "spacing": [{"name": "stand", "row": ROW, "density": density}],
        "field": BREEDABLE["field"],
        "plant": {"baseline": crop},
        "objective": {"maximise": "gross_assimilation"},
        "light": BREEDABLE["light"],
        "final": {"candidates": 1, "paths": 1024, "randomisations": 64},
        **(ROUGH if is_rough else {}),
    }


def erect(options: argparse.Namespace) -> None:
    densities = TREATED[::3] if options.rough else TREATED
    rows, pays = [], []
    variants = crops(options.folder)
    gains: dict[str, list[tuple[float, Estimate]]] = {}
    for name, path in variants.items():
        gains[name] = []
        for density in densities:
            erect_top, flat_top = (
                Stand(clear_day(with_top(path, x), density, options.rough))
                for x in (12.0, 45.0)
            )
            before, after = (
                light(stand, np.array([stand.baseline]))[0].tolist()
                for stand in (flat_top, erect_top)
            )
            grown = flat_top.evaluate(flat_top.baseline, ["lai"], final=True)
            index = float(np.ravel(grown["lai"])[0])
            gains[name].append((index, gain(before, after)))
    for i, density in enumerate(densities):
        cells = [
            f"{plus_minus(found[i][1], 1, '+')} ({found[i][0]:.1f})"
            for found in gains.values()
        ]
        rows.append([f"{density:g}", *cells])
    for found in gains.values():
        pairs = pairwise(found)
        crossing = next(
            (x for x in pairs if x[0][1][0] < 0 <= x[1][1][0]), None
        )
        pays.append(
            plus_minus(sign_change(*crossing))
            if crossing
            else f"below {found[0][0]:.1f}"
        )
    rows.append(["**pays from an index of**", *pays])
    print_table(["density [m-2]", *variants], rows)


def campaign(
    name: str,
    densities: Sequence[float],
    crop: dict[str, Any],
    options: argparse.Namespace,
    has_norms: bool = False,
) -> dict[str, Any]:
    """Returns a search for the mean carbon balance over densities."""
    crop = deepcopy(crop)
    free = [
        rule["trait"] for rule in crop["bounds"] if rule["name"] == "breedable"
    ]
    if has_norms:
        crop["trait"] += NORMS
        free += [norm["name"] for norm in NORMS]
    return {
        **BREEDABLE,
        "name": name,
        "replicates": options.seeds,
        "site": [bondville()["site"][0]],
        "climate": [season()],
        "spacing": [
            {"name": f"d{density:g}".replace(".", "p"), "row": ROW}
            | {"density": density}
            for density in densities
        ],
        "traits": [{"name": "free", "free": free}],
        "plant": {"baseline": crop, "bounds": "breedable"},
        "objective": {"maximise": "carbon_balance", "over": ["spacing"]},
        "stop": {"evaluations": options.evaluations},
        **(ROUGH if options.rough else {}),
    }


def carbon(tables: dict[str, Any], plants: list[Numbers]) -> Numbers:
    """Returns the carbon balance of plants at the density of a campaign, by
    plant and randomisation."""
    return light(Stand(tables), np.array(plants))


def optimised(tables: dict[str, Any], folder: Path) -> list[Numbers]:
    """Returns the best plant of each seed."""
    say(f"optimising {tables['name']}")
    return best_plants(tables, folder)


def densities_table(
    name: str, crop: dict[str, Any], options: argparse.Namespace
) -> None:
    densities = DENSITIES[::3] if options.rough else DENSITIES
    alone = [
        campaign(f"{name}_d{d:g}".replace(".", "p"), [d], crop, options)
        for d in densities
    ]
    found = {
        f"{density:g} m-2": optimised(tables, options.folder)
        for density, tables in zip(densities, alone, strict=True)
    }
    over = campaign(f"{name}_all", densities, crop, options)
    found["all of them"] = optimised(over, options.folder)
    if "plasticity" in crop:
        over = campaign(f"{name}_norm", densities, crop, options, True)
        found["all, reaction norms"] = optimised(over, options.folder)
    rows: dict[str, list[Estimate]] = {
        kind: [] for kind in (*found, "baseline, not bred")
    }
    for density in densities:
        # Plants with norms have more genes, so that all are evaluated with
        # the traits of norms; slopes of 0 have no effect.
        is_long = "plasticity" in crop
        tables = campaign("at", [density], crop, options, is_long)
        baseline = Stand(tables).baseline
        by_seed = []
        for seed in range(options.seeds):
            plants = [
                np.concatenate([x[seed], baseline[len(x[seed]) :]])
                for x in found.values()
            ]
            values = carbon(tables, [*plants, baseline])
            best = values[list(densities).index(density)]
            by_seed.append([gain(best.tolist(), x.tolist()) for x in values])
        for kind, cells in zip(rows, zip(*by_seed, strict=True), strict=True):
            mean, error = mean_over_seeds(cells)
            rows[kind].append((100 + mean, error))
    titles = [f"grown at {d:g} m-2" for d in densities]
    print_table(
        [f"{name}: bred for", *titles, "mean"],
        [
            [kind, *(plus_minus(x) for x in cells), plus_minus(mean_of(cells))]
            for kind, cells in rows.items()
        ],
    )


def mean_of(cells: Sequence[Estimate]) -> Estimate:
    """Returns the mean of a row, with an upper bound of its error."""
    mean, _ = estimate([mean for mean, _ in cells])
    return mean, float(np.mean([error for _, error in cells]))


def at_densities(options: argparse.Namespace) -> None:
    densities_table("plastic", hybrid(), options)
    print()
    densities_table("rigid", rigid(), options)


def in_narrow_rows(
    crop: dict[str, Any],
    inches: int,
    objective: str,
    name: str,
    options: argparse.Namespace,
) -> dict[str, Any]:
    """Returns a search of a clear day in rows of 15 inches."""
    return {
        **BREEDABLE,
        "name": f"{name}_{objective}_{inches}",
        "replicates": options.seeds,
        "site": [bondville()["site"][0]],
        "day": [CLEAR_DAY],
        "spacing": [{"row": 15 * INCH, "plant": inches * INCH}],
        "plant": {"baseline": crop, "bounds": "breedable"},
        "objective": {"maximise": objective},
        "stop": {"evaluations": options.evaluations},
        **(ROUGH if options.rough else {}),
    }


def change(stand: Stand, plants: list[Numbers]) -> str:
    """Formats the mean gain of plants over the baseline in %, or their mean
    difference if a loss of the baseline has no per cents."""
    baseline, *others = light(
        stand, np.array([stand.baseline, *plants])
    ).tolist()
    if has_percent(baseline):
        gains = [gain(baseline, each) for each in others]
        return f"{plus_minus(mean_over_seeds(gains), 1, '+')} %"
    apart = [difference(baseline, each) for each in others]
    return f"{plus_minus(mean_over_seeds(apart), 3, '+')} mol"


def narrow(options: argparse.Namespace) -> None:
    rows = []
    for objective in ("absorbed_par", "net_assimilation"):
        for inches in (6, 3):
            cells = []
            for name, crop in (("rigid", rigid()), ("plastic", hybrid())):
                tables = in_narrow_rows(crop, inches, objective, name, options)
                plants = optimised(tables, options.folder)
                stand = Stand(tables)
                baseline = light(stand, stand.baseline)[0]
                cells += [f"{baseline.mean():.3f}", change(stand, plants)]
            rows.append([objective, f"15 x {inches} inches", *cells])
    print_table(
        [
            *("objective", "spacing"),
            *("baseline, without responses", "gain, without responses"),
            *("baseline, hybrid", "gain, hybrid"),
        ],
        rows,
    )


def main() -> None:
    run_parts(
        parser_of_searches(__doc__, evaluations=800, seeds=1),
        {
            "extinction": extinction,
            "erect": erect,
            "densities": at_densities,
            "narrow": narrow,
        },
    )


if __name__ == "__main__":
    guard(main)
