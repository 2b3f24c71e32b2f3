# SPDX-License-Identifier: Apache-2.0
"""Comparisons of plants as a page of text and as HTML."""

from __future__ import annotations

import html
from collections.abc import Sequence

from .compared import Comparison, Quantity
from .compared_cells import aligned, number_of, title_of, told
from .compared_ranks import ranking_of

MATTERS = (
    *("lai", "absorbed_par", "absorbed_light", "intercepted_fraction"),
    *("absorbed_par_per_leaf_area", "net_assimilation", "carbon_balance"),
    *("leaf_nitrogen", "transpiration", "dry_matter"),
)
"""The quantities that the page shows besides objectives, if a campaign
measures them."""

_CASES = 3
"""The number of cases beyond which a page has only a line for each case, and
the number of cases side by side."""

_PLANTS = 3
"""The number of plants beyond which each plant has a line."""


def page_of(found: Comparison, has_all: bool = False, sort: str = "") -> str:
    """Returns a page for one screen: for a few cases the objectives and some
    other quantities in each case, for many cases the first objective; with
    `has_all` every quantity without axes in every case.

    More than three plants, and those that are sorted, are ranked with a line
    each. `sort` is the name of the quantity that ranks them, by default the
    first objective, or of the case that orders them, by default the mean of
    all cases."""
    lines = [_head(found)]
    if sort or len(found.plants) > _PLANTS:
        by_case = sort in found.cases
        name = found.objective.name if by_case or not sort else sort
        case = found.cases.index(sort) if by_case else None
        for quantity in found.quantities:
            if quantity.axis or quantity.names:
                continue
            if has_all or quantity.name == name:
                lines += ["", *ranking_of(found, quantity, case)]
    elif len(found.cases) > _CASES and not has_all:
        lines += ["", *_by_case(found)]
    else:
        for case, name in enumerate(found.cases):
            shown = _shown(found, has_all)
            lines += ["", name, *_of_case(found, case, shown)]
    lines += ["", _notes(found, has_all)]
    return "\n".join(lines)


def _head(found: Comparison) -> str:
    own, others = _reference(found)
    if not others:
        return f"{own}, which is compared with nothing"
    if len(others) > _PLANTS:
        return f"{len(others)} plants compared with {own}"
    names = ", ".join(found.plants[p] for p in others)
    return f"{names} compared with {own}"


def _reference(found: Comparison) -> tuple[str, list[int]]:
    """Returns the name of the reference and the indices of all others."""
    others = [p for p in range(len(found.plants)) if p != found.reference]
    return found.plants[found.reference], others


def _notes(found: Comparison, has_all: bool) -> str:
    note = "± is half of a 95 % confidence interval"
    if len(found.plants) > 1:
        note += ", of differences by pairs: plants share fields and light.\n"
        note += f"Reference: {found.plants[found.reference]}"
        note += "." if found.reference else ", the first; --reference NAME."
    if not has_all:
        note += (
            "\n--all prints every quantity, --csv FILE and --json those by "
            "leaf too."
        )
    return note


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
    increase over the reference [%]."""
    name, others = _reference(found)
    heads = (x for p in others for x in (found.plants[p], "more [%]"))
    rows = [["", name, *heads]]
    for quantity in shown:
        key = quantity.name, 0
        row = [
            title_of(quantity),
            number_of(quantity, found.value(found.reference, case, key)),
        ]
        for plant in others:
            gain = found.gain(plant, case, key)
            row += [
                number_of(quantity, found.value(plant, case, key)),
                told(None if quantity.names else gain, has_sign=True),
            ]
        rows.append(row)
    return rows


def _of_case(
    found: Comparison, case: int, shown: Sequence[Quantity]
) -> list[str]:
    return aligned(_table(found, case, shown))


def _by_case(found: Comparison) -> list[str]:
    name, others = _reference(found)
    heads = (f"{found.plants[p]} more [%]" for p in others)
    rows = [[title_of(found.objective), name, *heads]]
    key = found.objective.name, 0
    for case, title in enumerate(found.cases):
        gains = (
            told(found.gain(plant, case, key), has_sign=True)
            for plant in others
        )
        rows.append(
            [title, told(found.value(found.reference, case, key)), *gains]
        )
    return aligned(rows)


def html_of(found: Comparison) -> str:
    """Returns the page of all cases as tables of HTML, one after another, and
    the ranking of more than three plants as text."""
    if len(found.plants) > _PLANTS:
        return f"<pre>{html.escape(page_of(found))}</pre>"
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
