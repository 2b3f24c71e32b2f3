#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the effect of each organ on light and on gains.

organs.py [--full] [--traits SET...] [--seeds N] FOLDER

Runs ames_quick.toml (with --full also ames.toml) in FOLDER with plants that
have more and more organs, with all traits and with azimuths alone. Prints the
distribution of the light of the baseline, the gain of the same three plants
over the baseline with these organs, and the gains of plants optimised with
them. Finished histories are not repeated. IDEOTYPE_EXECUTABLE names the
program; without it, the one on PATH is used.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
from estimates import Estimate, gain, mean_over_seeds, plus_minus
from shared import (
    CAMPAIGNS,
    Numbers,
    best,
    breed,
    guard,
    light,
    parser_of,
)  # fmt: skip

from ideotype import Stand

QUICK = CAMPAIGNS / "ames_quick.toml"
TASSEL = ["peduncle", "tassel_spike", "tassel_branches"]

#: Plants by name: crop file and organs other than leaves.
PLANTS = {
    "tapered stalk": ("crops/maize.toml", ["stalk"]),
    "and sheaths": ("crops/maize.toml", ["stalk", "sheath"]),
    "and peduncle": ("crops/maize.toml", ["stalk", "sheath", "peduncle"]),
    "and tassel": ("crops/maize.toml", ["stalk", "sheath", *TASSEL]),
    "and ear": ("crops/maize.toml", ["stalk", "sheath", *TASSEL, "ear"]),
}
TRAITS = ("all", "azimuth")


def settings(plant: str, traits: str = "all") -> list[str]:
    crop, organs = PLANTS[plant]
    keys = [
        f"plant.baseline={CAMPAIGNS.resolve() / crop}",
        f"plant.organs={json.dumps(organs)}",
    ]
    if traits == "azimuth":
        keys.append('traits=[{name = "azimuth", free = ["azimuth"]}]')
    return keys


def bred(
    campaign: Path, plant: str, traits: str, seeds: int, folder: Path
) -> list[Numbers]:
    """Returns the baseline and the best plant of each seed."""
    name = re.sub(r"[^a-z0-9]+", "_", f"{campaign.stem} {plant} {traits}")[:60]
    keys = [*settings(plant, traits), f"replicates={seeds}"]
    histories = breed(campaign, name, keys, folder)
    baseline = Stand.from_campaign(campaign, settings=keys).baseline
    return [baseline, *map(best, histories)]


def gains(
    plants: list[Numbers], campaign: Path, keys: list[str]
) -> list[Estimate]:
    """Returns the gain of each plant over the first plant [%]."""
    stand = Stand.from_campaign(campaign, settings=keys)
    first, *others = light(stand, np.array(plants)).tolist()
    return [gain(first, other) for other in others]


def parts(plant: str) -> list[str]:
    """Formats the distribution of the light in the stand of the baseline [% of
    incident]."""
    stand = Stand.from_campaign(QUICK, settings=settings(plant))
    found = stand.evaluate(stand.baseline, final=True).isel(plant=0)
    organs = (found.absorbed_by_organ / found.incident).to_series()

    def of(test: str) -> float:
        return float(organs[organs.index.str.fullmatch(test)].sum())

    shares = [of("leaves"), of("stalk"), of("sheath")]
    shares += [of("(peduncle|tassel).*"), of("ear")]
    shares += [found.soil_fraction.item(), found.reflected_fraction.item()]
    return [f"{100 * share:.2f}" for share in shares]


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument(
        "--full", action="store_true", help="also run ames.toml"
    )
    parser.add_argument(
        "--traits", nargs="+", choices=TRAITS, default=TRAITS, metavar="SET"
    )
    parser.add_argument("--seeds", type=int, default=3, metavar="N")
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    options = parser.parse_args()
    campaigns = [QUICK, *([CAMPAIGNS / "ames.toml"] if options.full else [])]
    head = [
        "plant",
        "leaves",
        "stalk",
        "sheath",
        "tassel",
        "ear",
        "soil",
        "reflected",
    ]
    head += ["same plants"]
    head += [f"{c.stem}, {t}" for c in campaigns for t in options.traits]
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head), flush=True)

    same = bred(QUICK, "and sheaths", "all", options.seeds, options.folder)
    for name, (crop, _) in PLANTS.items():
        cells = parts(name)
        exact = [*settings(name), "final.paths=131072"]
        is_maize = crop == "crops/maize.toml"
        own = gains(same, QUICK, exact) if is_maize else []
        cells.append(", ".join(plus_minus(x, 2) for x in own))
        for campaign in campaigns:
            for traits in options.traits:
                plants = bred(
                    campaign, name, traits, options.seeds, options.folder
                )
                own = gains(plants, campaign, settings(name, traits))
                cells.append(plus_minus(mean_over_seeds(own), 2))
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    guard(main)
