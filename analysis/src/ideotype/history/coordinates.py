# SPDX-License-Identifier: Apache-2.0
"""Natural order and short forms of the names of cases."""

from __future__ import annotations

import re
from collections.abc import Sequence

from .case import Case

_AXES = ("site", "day", "spacing", "trait_set")


def natural(text: str) -> tuple[tuple[str, float, str], ...]:
    """Returns a key that sorts numbers in names by their value, so that lat8
    comes before lat16."""
    parts = re.findall(r"(\D*)(\d*)", str(text))
    return tuple((word, float(digits or -1), digits) for word, digits in parts)


def short_names(cases: Sequence[Case]) -> dict[str, str]:
    """Returns short names of cases, by their full names. A short name contains
    only those of campaign, site, day, spacing [m] and trait set that differ
    between the cases."""
    coordinates = {case.name: _coordinates(case) for case in cases}
    differ = [
        len(set(values)) > 1
        for values in zip(*coordinates.values(), strict=True)
    ]
    short = {
        name: ", ".join(
            word for word, is_shown in zip(parts, differ) if is_shown and word
        )
        for name, parts in coordinates.items()
    }
    is_unique = len({*short.values()}) == len(short)
    return {name: (short[name] if is_unique else "") or name for name in short}


def _coordinates(case: Case) -> tuple[str, ...]:
    campaign, _, _ = case.name.rpartition(": ")
    has = case.attributes
    site, day, spacing, traits = (str(has.get(axis, "")) for axis in _AXES)
    if {"row_spacing", "plant_spacing"} <= {*has}:
        row, plant = (float(has[f"{x}_spacing"]) for x in ("row", "plant"))
        spacing = f"{row:.4g} × {plant:.4g} m"
    return campaign, site, day, spacing, traits
