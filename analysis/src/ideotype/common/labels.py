# SPDX-License-Identifier: Apache-2.0
"""Printed names of quantities and units."""

from __future__ import annotations

import re
from collections.abc import Collection

ABBREVIATIONS = {
    "co2": "CO\N{SUBSCRIPT TWO}",
    "fapar": "fAPAR",
    "lai": "LAI",
    "nir": "NIR",
    "par": "PAR",
}
"""Printed forms of abbreviations in names."""

_TERMS = {"carbon_balance": "net carbon balance"}
"""Names of quantities that differ from their terms in print."""

_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def words(name: str) -> str:
    """Returns "absorbed PAR" for "absorbed_par"."""
    return " ".join(ABBREVIATIONS.get(part, part) for part in _parts(name))


def title(name: str) -> str:
    """Returns the words of a name with an initial capital, as in
    "Gross CO\N{SUBSCRIPT TWO}"; abbreviations are unchanged."""
    first, *others = _parts(name)
    first = ABBREVIATIONS.get(first, first[:1].upper() + first[1:])
    return " ".join([first, *map(words, others)])


def _parts(name: str) -> list[str]:
    for key, term in _TERMS.items():
        name = name.replace(key, term)
    return name.replace("_", " ").split(" ")


def describe_span(counts: Collection[int], form: str = "") -> str:
    """Returns the smallest and the largest count, as in "3 to 5", or the only
    one."""
    ends = dict.fromkeys((min(counts), max(counts)))
    return " to ".join(f"{count:{form}}" for count in ends)


def unit_label(unit: str) -> str:
    """Returns the printed form of a unit: "MJ m-2" with superscripts, "°" for
    "deg"."""
    raised = re.sub(
        r"(?<=[A-Za-z])-?\d+", lambda m: m[0].translate(_SUPERSCRIPT), unit
    )
    return re.sub(r"\bdeg\b", "°", raised)
