# SPDX-License-Identifier: Apache-2.0
"""Traits of trials, and the measures of plants that they stand for."""

from __future__ import annotations

import math
import re
import tomllib
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

from ..errors import Error, did_you_mean
from ..validation.table import factor_to

EAR = "ear"
"""The leaf that was measured if a column names none."""

_HORIZONTAL = re.compile(r"\b(?:(?:from|to|above) )?(?:the )?horizontal\b")
_STALK = re.compile(r"\b(?:from|to) (?:the )?(?:stalk|stem|vertical)\b")


@dataclass(frozen=True)
class Trait:
    """A measured trait of lines."""

    name: str
    """The name in tables, such as "upper leaf angle"."""
    measure: str
    """The measure of a plant, such as "leaf.insertion_angle"; "": none, as of
    yield."""
    leaf: str = ""
    """The leaf with this measure, such as "ear" or "top-1"; "": none."""
    unit: str = "1"
    """The unit of the measure, in which values are stored."""
    show: str = "1"
    """The unit of pages and tables."""
    heritability: tuple[float, float] = (1.0, 1.0)
    """The assumed heritability of a mean over a trial and of a plot, where a
    trial gives none."""
    limits: tuple[float, float] = (-math.inf, math.inf)
    """The smallest and the largest possible value, in the unit."""

    @property
    def factor(self) -> float:
        """The factor from the unit of the measure to that of pages."""
        return factor_to(self.unit, self.show) if self.measure else 1.0

    @property
    def column(self) -> str:
        """A name of a column that find_trait() recognises, such as "upper leaf
        angle [deg]"."""
        words = [
            row["words"][0]
            for row in _names()["position"]
            if row["leaf"] == self.leaf
        ]
        name = self.name.removesuffix(f" {self.leaf}")
        return " ".join([*words, name, f"[{self.show}]"])

    @property
    def label(self) -> str:
        """The name with the unit of pages."""
        return f"{self.name} [{self.show}]" if self.show else self.name


@cache
def _names() -> dict[str, Any]:
    text = files(__package__).joinpath("trait_names.toml").read_text("utf-8")
    return tomllib.loads(text)


def find_factor(name: str) -> str:
    """Returns the factor of a design that a column has, "line", "environment",
    "replicate", "block" or "plot"; "" if it has none."""
    text = _words(name)
    for factor in _names()["factor"]:
        if text in factor["names"]:
            return str(factor["name"])
    return ""


def trait_of_measure(measure: str, leaf: str) -> Trait:
    """Returns the trait with a measure of a plant, for files of lines and for
    columns that the user assigns. Raises Error for unknown measures."""
    for row in _names()["trait"]:
        if row["measure"] == measure:
            return _make(row, leaf)
    known = [row["measure"] for row in _names()["trait"] if row["measure"]]
    raise Error(
        f"there is no measure '{measure}'"
        + (did_you_mean(measure, known) or f"; use one of {', '.join(known)}")
    )


@dataclass(frozen=True)
class Column:
    """A column of a trial that was recognised as a trait."""

    trait: Trait
    unit: str
    """The unit of the column; "": none is stated."""
    is_from_horizontal: bool = False


def find_trait(name: str) -> Column | None:
    """Returns the trait that a column name stands for, with the unit that it
    states, as in "Upper leaf angle (deg)" or "plant_height_cm"; None if it
    resembles no trait.

    Raises Error if the name resembles that of a trait without being one."""
    text, unit = split_unit(name)
    words = _words(text)
    is_from_horizontal = bool(_HORIZONTAL.search(words))
    plain = _HORIZONTAL.sub(" ", _STALK.sub(" ", words))
    base, leaf = _split_position(" ".join(plain.split()))
    for row in _names()["trait"]:
        for candidate, position in ((plain.strip(), ""), (base, leaf)):
            if candidate in row["names"]:
                return Column(_make(row, position), unit, is_from_horizontal)
    known = [x for row in _names()["trait"] for x in row["names"]]
    if near := did_you_mean(base, known):
        raise Error(f"there is no trait '{name}'{near}")
    return None


def split_unit(name: str) -> tuple[str, str]:
    """Returns a column name without its unit, and the unit: in parentheses or
    brackets, or the last word if it is a unit of length or angle."""
    match = re.fullmatch(r"(.*?)\s*[(\[]([^()\[\]]*)[)\]]\s*", name)
    if match:
        return match[1], match[2].strip()
    match = re.fullmatch(r"(.+?)[\s_.,|]+([A-Za-z°]+)\s*", name)
    if match and any(is_unit(match[2], to) for to in ("m", "deg")):
        return re.sub(r"[\s_]in$", "", match[1]), match[2]
    return name, ""


def is_unit(unit: str, to: str) -> bool:
    """Returns whether a unit converts to another."""
    try:
        read_unit(unit, to)
    except Error:
        return False
    return True


def read_unit(unit: str, to: str) -> float:
    """Returns the conversion factor of a unit in any usual spelling, such as
    "CM", "cm." or "degrees". Raises Error for unknown units."""
    plain = unit.strip().rstrip(".")
    try:
        return factor_to(plain, to)
    except Error:
        if plain.lower() == plain:
            raise
        return factor_to(plain.lower(), to)


def _words(name: str) -> str:
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name.strip())
    return " ".join(re.sub(r"[\W_]+", " ", spaced).lower().split())


def _split_position(words: str) -> tuple[str, str]:
    """Returns the words without those that name a leaf, and the leaf."""
    choices = [
        (text, row["leaf"])
        for row in _names()["position"]
        for text in row["words"]
    ]
    for text, leaf in sorted(choices, key=lambda x: -len(x[0])):
        if re.search(rf"\b{text}\b", words):
            rest = re.sub(rf"\b{text}(?: leaf)?\b", " ", words, count=1)
            rest = " ".join(rest.split())
            if rest.split(" ")[0] in ("length", "width", "angle"):
                rest = f"leaf {rest}"
            return rest, str(leaf)
    return words, ""


def _make(row: dict[str, Any], leaf: str) -> Trait:
    is_of_leaves = row.get("is_of_leaves", False)
    place = (leaf or EAR) if is_of_leaves else ""
    name = row["name"] + (f" {place}" if is_of_leaves else "")
    return Trait(
        name,
        row["measure"],
        place,
        row["unit"],
        row["show"],
        tuple(row["heritability"]),
        tuple(row.get("limits", (-math.inf, math.inf))),
    )


def yield_trait() -> Trait:
    """Returns yield, with its usual heritability."""
    (row,) = (row for row in _names()["trait"] if not row["measure"])
    return _make(row, "")
