# SPDX-License-Identifier: Apache-2.0
"""The words of names of quantities, with the capitals of abbreviations."""

from __future__ import annotations

ABBREVIATIONS = {
    "co2": "CO\N{SUBSCRIPT TWO}",
    "fapar": "fAPAR",
    "lai": "LAI",
    "nir": "NIR",
    "par": "PAR",
}
"""Abbreviations in names, as they are printed."""


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
