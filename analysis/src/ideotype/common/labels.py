# SPDX-License-Identifier: Apache-2.0
"""Names of quantities and units as they are printed."""

from __future__ import annotations

import re

ABBREVIATIONS = {
    "co2": "CO\N{SUBSCRIPT TWO}",
    "fapar": "fAPAR",
    "lai": "LAI",
    "nir": "NIR",
    "par": "PAR",
}
"""Abbreviations in names, as they are printed."""

_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def words(name: str) -> str:
    """Returns "absorbed PAR" for "absorbed_par"."""
    return " ".join(ABBREVIATIONS.get(part, part) for part in _parts(name))


def title(name: str) -> str:
    """Returns the words of a name with a capital at the beginning, as in
    "Gross CO\N{SUBSCRIPT TWO}"; an abbreviation stays as it is."""
    first, *others = _parts(name)
    first = ABBREVIATIONS.get(first, first[:1].upper() + first[1:])
    return " ".join([first, *map(words, others)])


def _parts(name: str) -> list[str]:
    return name.replace("_", " ").split(" ")


def unit_label(unit: str) -> str:
    """Returns a unit as it is printed: "MJ m-2" has a raised -2, "deg" is
    "°"."""
    raised = re.sub(
        r"(?<=[A-Za-z])-?\d+", lambda m: m[0].translate(_SUPERSCRIPT), unit
    )
    return re.sub(r"\bdeg\b", "°", raised)
