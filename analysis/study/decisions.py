#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decides between plants and managements by the margin of years at Champaign.

decisions.py FOLDER --years FOLDER [--only PART] [--rough]

* years: the mean margin of random plants over all 29 years, compared with that
  of k representative years with weights, and of k years that are drawn; and the
  time of an evaluation.
* prices: plants, densities and row distances by brute force, at two prices of
  seed and water; and prices at which the decision changes, in two independent
  evaluations.
* regret: a plant that is optimised for representative years, and plants of
  single years, in all 29 years.

--years is a folder with champaign_1995_2023_may_sep.csv.gz, made from
cmi_weather_data of the R package BioCro (b8ed268); the project does not contain
it. The season ends on 29 September, since 30 September of leap years is not
measured. All prices are examples."""

from __future__ import annotations

import argparse
import gzip
from collections.abc import Mapping, Sequence
from datetime import date
from itertools import product
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from climates import growing_season
from estimates import plus_minus, print_table
from shared import (
    ROUGH,
    Numbers,
    best_plants,
    guard,
    parser_of_searches,
    run_parts,
)  # fmt: skip

import ideotype
from ideotype import Stand
from ideotype.decision import Rule, Worth
from ideotype.decision.decision import mean_over_environments
from ideotype.environments import (
    Representatives,
    choose_representatives,
    read_features,
)

YEARS = tuple(range(1995, 2024))
COUNTS = (3, 5, 8)
PLANTS = 20
DRAWS = 1000
PRICES = {"grain": 190.0, "seed": 0.0035, "other": 900.0}


def champaign(
    options: argparse.Namespace,
    years: Sequence[int] = YEARS,
    weights: Sequence[float] = (),
    **tables: Any,
) -> dict[str, Any]:
    """Returns the campaign of a rain-fed hybrid in years at Champaign, with
    the margin as objective."""
    path = options.folder / "champaign.csv"
    if not path.exists():
        name = "champaign_1995_2023_may_sep.csv.gz"
        with gzip.open(options.years / name, "rb") as file:
            path.write_bytes(file.read())
    first = years[0]
    climate = {
        "name": "champaign",
        "file": str(path),
        "from": date(first, 5, 1),
        "to": date(first, 9, 29),
        "emergence": date(first, 5, 15),
        "years": list(years),
        "time": ["time"],
        "stamp": "middle",
        "global": ["ppfd_umol", "umol/m2/s"],
        "temperature": ["temp_c", "C"],
        "humidity": ["rh", "1"],
        "rain": ["rain_mm", "mm"],
    }
    if len(weights):
        climate["weights"] = [float(x) for x in weights]
    light = ROUGH if options.rough else {"light": {"tolerance": 0.01}}
    return growing_season(
        **{
            **light,
            "water": {},
            "soil": {"texture": "silt_loam"},
            "prices": PRICES,
            **tables,
        }
    ) | {
        "climate": [climate],
        "objective": {"maximise": "margin", "over": ["climate"]},
    }


def representatives(
    options: argparse.Namespace, count: int
) -> Representatives:
    """Returns representative years of the record."""
    import tomli_w

    path = options.folder / "record.toml"
    path.write_text(tomli_w.dumps(champaign(options)), encoding="utf-8")
    return choose_representatives(read_features(path), count)


def years_of(chosen: Representatives) -> list[int]:
    """Returns the numbers of the chosen years."""
    return [int(name.rpartition("_")[2]) for name in chosen.names]


def random_plants(stand: Stand, count: int) -> Numbers:
    """Returns plants with traits uniform between their bounds
    [plants, genes]."""
    low, high = stand.bounds
    plants = np.repeat(stand.baseline[None], count, 0)
    draw = np.random.default_rng(1).random((count, len(low)))
    plants[:, stand.free] = low + draw * (high - low)
    return plants


def evaluate(
    stand: Stand, plants: Numbers, names: Sequence[str], seed: int
) -> Numbers:
    """Returns quantities in each environment
    [plants, environments, quantities]."""
    by_scenario = [f"{name}_by_scenario" for name in names]
    found = stand.evaluate(plants, by_scenario, seed=seed, threads=1)
    for message in found.message.values:
        if message:
            raise ideotype.Error(f"{stand.name}: {message}")
    return np.stack([found[name].values for name in by_scenario], -1)


def compare_years(options: argparse.Namespace) -> None:
    """Prints the error of representative and of drawn years."""
    stand = Stand(champaign(options))
    plants = random_plants(stand, 4 if options.rough else PLANTS)
    before = process_time()
    margins = evaluate(stand, plants, ["margin"], 1)[..., 0]
    seconds = (process_time() - before) / len(plants)
    whole = margins.mean(1)
    rows = [["all 29", "0", "0", "0", "0", f"{seconds:.2f}"]]
    draw = np.random.default_rng(2)
    for count in COUNTS:
        chosen = representatives(options, count)
        index = [YEARS.index(year) for year in years_of(chosen)]
        few = Stand(champaign(options, years_of(chosen), chosen.weights))
        before = process_time()
        again = evaluate(few, plants, ["margin"], 1)[..., 0]
        seconds = (process_time() - before) / len(plants)
        values = again @ chosen.weights
        drawn = [
            margins[:, draw.choice(len(YEARS), count, replace=False)].mean(1)
            for _ in range(DRAWS)
        ]
        off = float(np.abs(again - margins[:, index]).max())
        rows.append(
            [
                f"{count}: " + ", ".join(map(str, years_of(chosen))),
                *describe_errors([values], whole),
                f"{seconds:.2f} (years by themselves: {off:.2g})",
            ]
        )
        rows.append([f"{count} drawn", *describe_errors(drawn, whole), ""])
    spread = whole.std(ddof=1)
    print(
        f"{len(plants)} plants, margin {whole.mean():.0f}, standard deviation "
        f"between plants {spread:.0f}, between years "
        f"{margins.mean(0).std(ddof=1):.0f} per ha\n"
    )
    print_table(
        [
            "years", "error of the mean plant", "error of differences",
            "rank correlation lost", "loss by choosing the best",
            "CPU s per plant",
        ],
        rows,
    )  # fmt: skip


def describe_errors(values: Sequence[Numbers], whole: Numbers) -> list[str]:
    """Returns root mean squares over choices of years: of the error of the
    mean over plants, and of the errors of plants less that mean; the mean loss
    of rank correlation; and the mean loss if the best plant is chosen."""
    errors = np.array(values) - whole
    mean = errors.mean(1)
    differences = (errors - mean[:, None]).std(1, ddof=1)
    ranks = whole.argsort().argsort()
    lost = [
        1 - np.corrcoef(x.argsort().argsort(), ranks)[0, 1] for x in values
    ]
    loss = [whole.max() - whole[x.argmax()] for x in values]
    return [
        f"{(mean**2).mean() ** 0.5:.0f}",
        f"{(differences**2).mean() ** 0.5:.1f}",
        f"{np.mean(lost):.3f}",
        f"{np.mean(loss):.1f}",
    ]


DENSITIES = (4.0, 6.0, 8.0, 10.0)
ROWS = (0.38, 0.762)
SEED_PRICES = (0.001, 0.012)
WATER_PRICES = (0.05, 0.6)


def managed(
    options: argparse.Namespace,
    chosen: Representatives,
    density: float,
    row: float,
) -> Stand:
    """Returns irrigated fields in representative years."""
    return Stand(
        champaign(
            options,
            years_of(chosen),
            chosen.weights,
            irrigation={"depletion": 0.6, "amount": 25},
            prices={**PRICES, "water": 0.15},
            spacing=[{"row": row, "density": density}],
            **(
                {}
                if options.rough
                else {"light": {"tolerance": 0.01, "fields": 4}}
            ),
        )
    )


def compare_prices(options: argparse.Namespace) -> None:
    """Prints decisions by brute force, and prices at which they change."""
    chosen = representatives(options, 3)
    stand = managed(options, chosen, 7.5, 0.762)
    angle = (stand.genes.trait == "insertion_angle").to_numpy()
    plants = {
        "hybrid": stand.baseline,
        "13 deg more erect": stand.baseline - 13 * angle,
    }
    genomes = np.array(list(plants.values()))
    fields = list(product(DENSITIES, ROWS))
    choices = [(name, *field) for field in fields for name in plants]
    worth = Worth.of_prices(PRICES)
    names = [name for name in worth.parts if name != "electricity"]
    found = [
        [evaluate(managed(options, chosen, *field), genomes, names, seed)
         for field in fields]
        for seed in (1, 2)
    ]  # fmt: skip
    parts = [
        np.einsum("pen,e->pn", np.concatenate(x), chosen.weights)
        for x in found
    ]

    def values(of: Numbers, seed: float, water: float) -> Numbers:
        prices = {**PRICES, "seed": seed, "water": water}
        return worth.of(np.pad(of, ((0, 0), (0, 1))), prices)

    def describe(index: int) -> str:
        name, density, row = choices[index]
        return f"{name}, {density:g} m-2, {row:g} m"

    rows = []
    for seed, water in product(SEED_PRICES, WATER_PRICES):
        first, second = (values(x, seed, water) for x in parts)
        best = int(first.argmax())
        rows.append(
            [
                f"{seed:g}", f"{water:g}", describe(best),
                f"{first[best]:.0f}", describe(int(second.argmax())),
                f"{second.max() - second[best]:.1f}",
            ]
        )  # fmt: skip
    print_table(
        [
            "seed [per plant]", "water [per m3]", "best", "margin per ha",
            "best with other random numbers", "its advantage then",
        ],
        rows,
    )  # fmt: skip
    print()
    rows = []
    for name, prices, other in (
        ("seed", np.linspace(0, 0.015, 301), {"water": 0.15}),
        ("water", np.linspace(0, 1, 301), {"seed": PRICES["seed"]}),
    ):
        for number, of in enumerate(parts, 1):
            best_at = [
                int(values(of, **{name: float(x), **other}).argmax())
                for x in prices
            ]
            changes = [
                f"{prices[i]:.3g}: {describe(best_at[i])}"
                for i in range(1, len(prices))
                if best_at[i] != best_at[i - 1]
            ]
            rows.append(
                [
                    name, str(number), describe(best_at[0]),
                    "; ".join(changes) or "none",
                ]
            )  # fmt: skip
    print_table(
        ["price of", "random numbers", "best without it", "from a price on"],
        rows,
    )


def compare_regret(options: argparse.Namespace) -> None:
    """Prints the regret of plants of several and of single years in all."""
    chosen = representatives(options, 3)
    few = years_of(chosen)
    search: Mapping[str, Any] = {
        "stop": {"evaluations": 12 if options.rough else 192},
    }
    campaigns = {
        "3 years": champaign(options, few, chosen.weights, **search),
        **{str(x): champaign(options, [x], **search) for x in few},
    }
    stand = Stand(champaign(options))
    plants = {"hybrid": stand.baseline}
    for name, campaign in campaigns.items():
        campaign["name"] = "for_" + name.replace(" ", "_")
        (plants[f"for {name}"],) = best_plants(campaign, options.folder)
    margins = evaluate(stand, np.array(list(plants.values())), ["margin"], 3)[
        ..., 0
    ]
    weights = np.full(len(YEARS), 1 / len(YEARS))
    regrets = margins.max(0) - margins
    robust = list(plants).index("for 3 years")
    worst = Rule("cvar", 0.2)
    rows = []
    for i, name in enumerate(plants):
        regret = mean_over_environments(regrets[i], weights)
        over = mean_over_environments(margins[i] - margins[robust], weights)
        rows.append(
            [
                name,
                f"{margins[i].mean():.0f}",
                f"{float(worst.value(margins[i], weights)):.0f}",
                plus_minus(regret, 0),
                f"{regrets[i].max():.0f} in {YEARS[regrets[i].argmax()]}",
                "-" if i == robust else plus_minus(over, 0, "+"),
            ]
        )
    print_table(
        [
            "plant", "mean margin", "worst fifth", "mean regret",
            "largest regret", "less the plant for 3 years",
        ],
        rows,
    )  # fmt: skip


def main() -> None:
    parser = parser_of_searches(__doc__)
    parser.add_argument("--years", type=Path, required=True)
    run_parts(
        parser,
        {
            "years": compare_years,
            "prices": compare_prices,
            "regret": compare_regret,
        },
    )


if __name__ == "__main__":
    guard(main)
