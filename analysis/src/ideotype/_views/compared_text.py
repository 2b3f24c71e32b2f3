# SPDX-License-Identifier: Apache-2.0
"""Comparisons of plants as a page of text and as HTML."""

from __future__ import annotations

import html
import math
from collections.abc import Sequence

from ..analysis.figures.style import unit_label, words
from ..analysis.reading.estimate import Estimate
from .compared import Comparison, Quantity

MATTERS = (
    *("lai", "absorbed_par", "absorbed_light", "intercepted_fraction"),
    *("absorbed_par_per_leaf_area", "net_assimilation", "carbon_balance"),
    *("leaf_nitrogen", "transpiration", "dry_matter"),
)
"""The quantities that the page shows besides objectives, if a campaign
measures them."""

_CASES = 3
"""The number of cases beyond which a page has only a line for each case."""


def page_of(found: Comparison, has_all: bool = False) -> str:
    """Returns a page for one screen: for a few cases the objectives and some
    other quantities in each case, for many cases the first objective; with
    `has_all` every quantity without axes in every case."""
    lines = [_head(found)]
    shown = _shown(found, has_all)
    if len(found.cases) > _CASES and not has_all:
        lines += ["", *_by_case(found)]
    else:
        for case, name in enumerate(found.cases):
            lines += ["", name, *_of_case(found, case, shown)]
    lines += ["", _notes(found, has_all)]
    return "\n".join(lines)


def _head(found: Comparison) -> str:
    first, *others = found.plants
    return (
        f"{', '.join(others)} compared with {first}"
        if others
        else f"{first}, which is compared with nothing"
    )


def _notes(found: Comparison, has_all: bool) -> str:
    told = "± is half of a 95 % interval"
    if len(found.plants) > 1:
        told += ", of differences by pairs: plants share fields and light."
    rest = "" if has_all else "\n--all prints every quantity, "
    return told + (
        f"{rest}{'' if has_all else '--csv FILE and --json those by leaf too.'}"
    )


def _shown(found: Comparison, has_all: bool) -> list[Quantity]:
    numbers = [each for each in found.quantities if not each.axis]
    if has_all:
        return numbers
    objectives = set(found.objectives)
    return [
        each
        for each in numbers
        if each.name in objectives or each.name in MATTERS
    ]


def _table(
    found: Comparison, case: int, shown: Sequence[Quantity]
) -> list[list[str]]:
    """Returns a line for each quantity: the number of each plant, and the
    increase over the first plant [%]."""
    first, *others = found.plants
    rows = [["", first, *(x for name in others for x in (name, "more [%]"))]]
    for quantity in shown:
        key = quantity.name, 0
        row = [_title(quantity), told(found.value(0, case, key))]
        for plant in range(1, len(found.plants)):
            row += [
                told(found.value(plant, case, key)),
                told(found.gain(plant, case, key), has_sign=True),
            ]
        rows.append(row)
    return rows


def _of_case(
    found: Comparison, case: int, shown: Sequence[Quantity]
) -> list[str]:
    return _aligned(_table(found, case, shown))


def _by_case(found: Comparison) -> list[str]:
    title = _title(found.objective)
    rows = [
        [title, found.plants[0], *(f"{x} more [%]" for x in found.plants[1:])]
    ]
    key = found.objective.name, 0
    for case, name in enumerate(found.cases):
        gains = (
            told(found.gain(plant, case, key), has_sign=True)
            for plant in range(1, len(found.plants))
        )
        rows.append([name, told(found.value(0, case, key)), *gains])
    return _aligned(rows)


def _aligned(rows: Sequence[Sequence[str]]) -> list[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(
            cell.ljust(width) if i == 0 else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(row, widths))
        ).rstrip()
        for row in rows
    ]


def _title(quantity: Quantity) -> str:
    unit = unit_label(quantity.unit)
    return words(quantity.name) + ("" if unit == "1" else f" [{unit}]")


def told(figure: Estimate | None, has_sign: bool = False) -> str:
    """Returns a number with half of its 95 % interval; an exact number has no
    interval."""
    if figure is None or not math.isfinite(figure.mean):
        return "–"
    text = figure.interval_text()
    if has_sign and figure.standard_error == 0:
        text = f"{figure.mean:.2f}"
    is_plus = has_sign and figure.mean > 0 and text.strip("0.") != ""
    return f"+{text}" if is_plus else text


def html_of(found: Comparison) -> str:
    """Returns the page of all cases as tables of HTML, one after another."""
    parts = [f"<p>{html.escape(_head(found))}</p>"]
    for case, name in enumerate(found.cases):
        head, *rows = _table(found, case, _shown(found, False))
        cells = "".join(f"<th>{html.escape(x)}</th>" for x in head)
        lines = "".join(
            "<tr>"
            + "".join(f"<td>{html.escape(x)}</td>" for x in row)
            + "</tr>"
            for row in rows
        )
        parts.append(
            f"<table><caption>{html.escape(name)}</caption>"
            f"<thead><tr>{cells}</tr></thead><tbody>{lines}</tbody></table>"
        )
    parts.append(f"<p>{html.escape(_notes(found, True))}</p>")
    return "".join(parts)
