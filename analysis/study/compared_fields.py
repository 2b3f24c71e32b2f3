# SPDX-License-Identifier: Apache-2.0
"""Fields whose figures validation.py compares, and the changes of plants there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from fields import AREAS, SEASON, Field
from shared import FIELD_PLANTS

ROWS = (0.20, 0.38, 0.50, 0.76, 1.0)
DENSITY = 7.5
ROW = 0.762
LEAF_AREAS = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
PLANES = ("field", "all across", "along", "random")
LIGHTS = ("day", "noon")

USUAL = Field(ROW, DENSITY)


def density_of(area: float, plant: str = "hybrid") -> float:
    """Returns plants sown per area [m-2] for a leaf area index, with the gaps
    of field plants."""
    return area / AREAS[plant] / (1 - FIELD_PLANTS["missing"])


DENSE = Field(ROW, density_of(6))
JULY = replace(DENSE, hours="whole", date="2025-07-10")
JULY_NOON = replace(JULY, hours="noon")
#: The fields that are compared, by the keys of PUBLISHED whose figures are of
#: one field.
FIELDS = {
    **{f"k {row}": Field(row, DENSITY) for row in (0.2, 0.5, 1.0)},
    "k ceres": USUAL,
    "k muchow": Field(0.75, 7),
    "k dense": replace(DENSE, hours="noon"),
    "fapar": Field(ROW, density_of(5)),
    **{
        f"fipar {density}": Field(0.52, density, hours="noon")
        for density in (4.5, 6.2, 7.3)
    },
    "rows 1.0": Field(1.0, DENSITY, hours="noon"),
    "rows 0.35": Field(0.35, DENSITY, hours="noon"),
    "eight, 0.7": Field(0.7, 8, hours="noon"),
    "eight, 0.35": Field(0.35, 8, hours="noon"),
    "noon": replace(USUAL, hours="noon"),
    "season": replace(USUAL, campaign=SEASON),
    "july": JULY,
    "july noon": JULY_NOON,
}
#: The fields whose k is measured in all sunlight.
OF_SUNLIGHT = ("k 0.2", "k 0.5", "k 1.0", "k muchow")
#: The plants of version 0.2 with each measured input, and with all inputs.
STEPS: dict[str, dict[str, Any]] = {
    "version 0.2": {},
    "bends": {"plant": "bends"},
    "roll and twist": {"variation": "roll and twist"},
    "azimuths and planes": {"variation": "azimuths"},
    "optics of leaves": {"plant": "optics"},
    "capacity by rank": {"plant": "capacity"},
    "stalk, ear and tassel": {"plant": "tassel"},
    "gaps": {"variation": "gaps"},
    "positions": {"variation": "positions"},
    "all together: crops/maize.toml": {"plant": "maize", "variation": "field"},
    "the hybrid": {"plant": "hybrid", "variation": "field"},
}
#: Changes of the hybrid whose effect is shown.
CHANGES: dict[str, dict[str, Any]] = {
    "as it is": {},
    "straight leaves": {"plant": "straight"},
    "leaves half as bent": {"plant": "half as bent"},
    "leaves half more bent": {"plant": "half more bent"},
    "no roll and twist": {"variation": "without roll and twist"},
    "all planes across the row": {"variation": "all across"},
    "rows from north to south": {"direction": 0},
    "no gaps": {"variation": "without gaps"},
    "twice the gaps": {"variation": "twice the gaps"},
    "plants at exact positions": {"variation": "exact positions"},
    "positions of surveys": {"variation": "positions of surveys"},
    "the hybrid of the 1980s": {"plant": "hybrid of the 1980s"},
    "optics of ADEL, 0.09 and 0.04": {"plant": "optics of ADEL"},
    "leaves without other organs": {"plant": "leaves alone"},
    "capacity alike in all leaves": {"more": ("photosynthesis.profile=none",)},
    "amax of 50 umol m-2 s-1 in place of 64": {
        "more": ("photosynthesis.amax=50",)
    },
}


def changed(change: dict[str, Any], steps: bool) -> list[Field]:
    """Returns the fields in which a change is looked at."""
    if steps:
        change = {"plant": "old", "variation": "random"} | change
    area = AREAS.get(
        change.get("plant", "hybrid"), AREAS["old" if steps else "hybrid"]
    )
    dense = replace(DENSE, density=6 / area / (1 - FIELD_PLANTS["missing"]))
    july = replace(JULY_NOON, density=dense.density)
    usual = USUAL, replace(USUAL, band="nir"), replace(USUAL, hours="noon")
    return [replace(field, **change) for field in (*usual, dense, july)]


def by_row(rows: Sequence[float]) -> list[Field]:
    return [
        Field(row, DENSITY, variation=planes, hours=hours)
        for row in rows
        for hours in LIGHTS
        for planes in PLANES
    ]


def by_area(areas: Sequence[float]) -> list[Field]:
    return [
        Field(ROW, density_of(area), hours=hours)
        for area in areas
        for hours in LIGHTS
    ]
