# SPDX-License-Identifier: Apache-2.0
"""Makes the campaign of made histories, from which plants get their shapes."""

from __future__ import annotations

import tomllib
from functools import cache

from golden import DATA
from real_program import CAMPAIGNS

import ideotype

SITES = {"ames": (42.0, 10), "edmonton": (53.5, 30)}
"""The latitude of each site, and the folding angle of blades there [deg]."""


@cache
def resolved(*over: str, folding_angle: float = 10) -> str:
    """Returns a campaign with every key and two seeds. `over` names the axis
    of scenarios, such as sites."""
    settings = {
        "plant.baseline": str(DATA / "golden" / "pole.toml"),
        "replicates": 2,
        "site": [
            {
                "name": name,
                "latitude": latitude,
                "longitude": -93.6,
                "utc_offset": -5,
            }
            for name, (latitude, _) in SITES.items()
        ],
        "objective.over": list(over),
    }
    campaign = ideotype.Stand.from_campaign(
        CAMPAIGNS / "ames_quick.toml", settings=settings
    ).campaign
    tables = tomllib.loads(campaign)
    tables["plant"]["baseline"]["blade"]["folding_angle"] = folding_angle
    return ideotype.Stand(tables).campaign
