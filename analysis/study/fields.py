# SPDX-License-Identifier: Apache-2.0
"""Evaluates the light and the assimilation of maize in fields like those of
experiments."""

from __future__ import annotations

import math
import os
import tomllib
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from estimates import Estimate
from shared import CAMPAIGNS, FIELD_PLANTS, Settings

import ideotype
from ideotype import Stand

DAY, SEASON = CAMPAIGNS / "ames.toml", CAMPAIGNS / "bondville.toml"
SOIL_ALBEDO = 0.1
HOURS = {
    "day": ("07:00:00", "20:00:00"),
    # The sun is highest at 13:20.
    "noon": ("12:20:00", "14:20:00"),
    "whole": ("05:30:00", "21:00:00"),
}
NOON_SECONDS = 7200
QUANTITIES = [
    *("fapar", "extinction_coefficient", "soil_fraction", "lai"),
    *("reflected_fraction", "light_use_efficiency", "absorbed_par"),
    *("gross_assimilation", "dry_matter"),
]
#: The optics of leaves from 700 to 1300 nm by PROSPECT-5 at silking, as docs
#: of the crop tell for PAR; soils reflect twice as much there. Stalks and
#: sheaths are taken for leaves.
NEAR_INFRARED = {
    "leaf_reflectance": 0.45,
    "leaf_transmittance": 0.45,
    "stalk_reflectance": 0.5,
    "stalk_transmittance": 0.4,
    "sheath_reflectance": 0.5,
    "sheath_transmittance": 0.4,
    "soil_albedo": 2 * SOIL_ALBEDO,
}
PAR_SHARE = 0.45
"""The share of PAR in all sunlight; the rest is taken for near infrared."""

Tables = dict[str, Any]


def crop(name: str) -> Tables:
    """Returns the tables of a crop file."""
    return tomllib.loads((CAMPAIGNS / name).read_text())


OLD, NEW = crop("plants/maize_v02.toml"), crop("crops/maize.toml")
HYBRID = crop("crops/maize_hybrid.toml")
HYBRID_1980S = crop("plants/maize_hybrid_1980s.toml")


def with_bends(plant: Tables, factor: float = 1) -> Tables:
    """Returns a plant with the bends of crops/maize.toml or a factor for its
    own bends."""
    plant = deepcopy(plant)
    bends = NEW["leaf"] if factor == 1 else plant["leaf"]
    for leaf, like in zip(plant["leaf"], bends, strict=True):
        leaf["curvature"] = min(factor * like["curvature"], 180)
    return plant


def with_tassel(plant: Tables) -> Tables:
    """Returns a plant with stalk, tassel and ear of crops/maize.toml."""
    return plant | {name: NEW[name] for name in ("organ", "stalk", "sheath")}


#: The one-sided area of the leaves of a plant [m2].
AREAS = {
    "maize": 0.3991,
    "old": 0.3991,
    "hybrid": 0.6308,
    "hybrid of the 1980s": 0.4793,
}
PLANTS: dict[str, Tables] = {
    "old": OLD,
    "maize": NEW,
    "hybrid": HYBRID,
    "hybrid of the 1980s": HYBRID_1980S,
    "bends": with_bends(OLD),
    "optics": OLD | {"optics": NEW["optics"]},
    "capacity": OLD | {"photosynthesis": NEW["photosynthesis"]},
    "tassel": with_tassel(OLD),
    "straight": with_bends(HYBRID, 0),
    "half as bent": with_bends(HYBRID, 0.5),
    "half more bent": with_bends(HYBRID, 1.5),
    "optics of ADEL": HYBRID
    | {"optics": {"leaf_reflectance": 0.09, "leaf_transmittance": 0.04}},
    "leaves alone": {
        key: value
        for key, value in HYBRID.items()
        if key not in {"organ", "sheath"}
    },
}


def part(*names: str) -> Tables:
    """Returns some numbers of the variation between field plants."""
    return {name: FIELD_PLANTS[name] for name in names}


#: The deviation of positions in 354 fields of 1987 to 1996, by distances with a
#: standard deviation of 4.5 inches (Nielsen,
#: kingcorn.org/research/psv/Update2004) [m].
SURVEYED_POSITION = 0.075

VARIATIONS: dict[str, Tables] = {
    "field": FIELD_PLANTS,
    "random": {},
    "across": {"azimuth": 10.0},
    "along": {"azimuth": 10.0},
    "roll and twist": part("roll", "twist"),
    "without roll and twist": {
        key: value
        for key, value in FIELD_PLANTS.items()
        if key not in {"roll", "twist"}
    },
    "azimuths": part("azimuth", "across_row"),
    "all across": FIELD_PLANTS | {"across_row": 1.0},
    "gaps": part("missing", "late"),
    "positions": part("position"),
    "exact positions": FIELD_PLANTS | {"position": 0.0},
    "positions of surveys": FIELD_PLANTS | {"position": SURVEYED_POSITION},
    "without gaps": {
        key: value
        for key, value in FIELD_PLANTS.items()
        if key not in {"missing", "late"}
    },
    "twice the gaps": FIELD_PLANTS | {"missing": 0.09, "late": 0.08},
}


@dataclass(frozen=True)
class Field:
    """A field: distance of rows [m], plants per area [m-2], the plant, the
    differences between plants, the direction of rows from north [deg], and the
    light."""

    row: float
    density: float
    plant: str = "hybrid"
    variation: str = "field"
    direction: int = 90
    hours: str = "day"
    date: str = "2025-08-07"
    campaign: Path = DAY
    band: str = "par"
    more: tuple[str, ...] = ()
    """Further settings of the campaign."""

    def tables(self) -> Tables:
        """Returns the campaign of this field."""
        tables = tomllib.loads(self.campaign.read_text())
        tables["spacing"] = [
            {
                "row": self.row,
                "plant": round(1 / self.density / self.row, 6),
                "row_direction": self.direction,
            }
        ]
        plant = deepcopy(PLANTS[self.plant])
        if self.variation == "along":
            for leaf in plant["leaf"]:
                leaf["azimuth"] = (leaf["azimuth"] + 90) % 360
        own = plant.get("optics", {})
        tables["optics"] = own | {"soil_albedo": SOIL_ALBEDO}
        if self.band == "nir":
            plant["optics"] = {
                key: NEAR_INFRARED[key]
                for key in ("leaf_reflectance", "leaf_transmittance")
            }
            tables["optics"] = NEAR_INFRARED
        tables["plant"] = {"baseline": plant}
        tables["objective"] = {"maximise": "gross_assimilation"}
        variation = VARIATIONS[self.variation]
        # Planes of leaves are random, unless the variation describes them.
        is_told = "across_row" in variation or self.variation in {
            "across",
            "along",
        }
        tables["field"] = {
            "rows": 4,
            "plants": 4,
            "variation": variation,
            "jitter": 10 if is_told else 180,
        }
        if self.campaign == DAY:
            start, end = HOURS[self.hours]
            tables["day"] = [
                tomllib.loads(
                    f"date = {self.date}\nstart = {start}\nend = {end}\n"
                    "step_minutes = 30"
                )
            ]
        return tables


Measured = dict[str, Estimate]


def measure(field: Field, accuracy: Settings = ()) -> Measured:
    """Returns the report of a field, and of light on its way down to the soil:
    `transmitted`, `fipar` = 1 - transmitted, and `k`, -ln(transmitted) / leaf
    area index."""
    stand = Stand(
        field.tables(),
        folder=field.campaign.parent,
        settings=[*field.more, *accuracy],
    )
    names = [
        *QUANTITIES,
        *(["assimilation_by_day"] if field.campaign == SEASON else []),
    ]
    found = stand.evaluate(stand.baseline, names, final=True, threads=1)
    if message := found.message.item():
        raise ideotype.Error(f"{stand.name}: {message}")
    known: Measured = {}
    for name in QUANTITIES:
        error = found.get(f"{name}_standard_error")
        known[name] = found[name].item(), 0 if error is None else error.item()
    albedo = (
        SOIL_ALBEDO if field.band == "par" else NEAR_INFRARED["soil_albedo"]
    )
    soil = scaled(known["soil_fraction"], 1 / (1 - albedo))
    # From t ha-1 in all days to g m-2 in one.
    days = found.sizes.get("day", 1)
    known["daily_dry_matter"] = scaled(known["dry_matter"], 100 / days)
    return known | through(soil, known["lai"])


def through(transmitted: Estimate, lai: Estimate) -> Measured:
    """Returns the figures that follow from the light that reaches the soil."""
    mean, error = transmitted
    return {
        "transmitted": transmitted,
        "fipar": (1 - mean, error),
        "k": (-math.log(mean) / lai[0], error / mean / lai[0]),
    }


def of_sunlight(par: Measured, infrared: Measured) -> Measured:
    """Returns the light of both bands on its way down to the soil."""
    parts = (
        (par["transmitted"], PAR_SHARE),
        (infrared["transmitted"], 1 - PAR_SHARE),
    )
    mean = sum(x[0] * share for x, share in parts)
    error = math.hypot(*(x[1] * share for x, share in parts))
    return through((mean, error), par["lai"])


def measure_all(
    fields: Iterable[Field], accuracy: Settings = ()
) -> dict[Field, Measured]:
    wanted = list(dict.fromkeys(fields))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        found = pool.map(lambda field: measure(field, accuracy), wanted)
        return dict(zip(wanted, found, strict=True))


def scaled(x: Estimate, factor: float) -> Estimate:
    return x[0] * factor, x[1] * factor


def noon_rate(x: Measured) -> Estimate:
    """Returns gross assimilation around noon [umol m-2 s-1]."""
    return scaled(x["gross_assimilation"], 1e6 / NOON_SECONDS)


def dry_matter(x: Measured) -> Estimate:
    """Returns the dry matter per MJ of PAR that leaves absorb [g], if neither
    roots nor growing ears respire."""
    return scaled(x["daily_dry_matter"], 1 / x["absorbed_par"][0])
