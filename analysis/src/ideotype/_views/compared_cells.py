# SPDX-License-Identifier: Apache-2.0
"""Cells of tables of text that compare plants."""

from __future__ import annotations

import math
from collections.abc import Sequence

from .._labels import words
from ..analysis.figures.style import unit_label
from ..analysis.reading.estimate import Estimate
from .compared import Quantity


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


def number_of(quantity: Quantity, figure: Estimate | None) -> str:
    """Returns a number of a quantity, or the name that the number counts."""
    if figure is None or not quantity.names:
        return told(figure)
    place = int(figure.mean)
    return quantity.names[place - 1] if place > 0 else "–"


def title_of(quantity: Quantity) -> str:
    """Returns the words of a quantity, with its unit."""
    unit = unit_label(quantity.unit)
    return words(quantity.name) + ("" if unit == "1" else f" [{unit}]")


def aligned(rows: Sequence[Sequence[str]]) -> list[str]:
    """Returns rows of equal columns as lines; the first column is aligned to
    the left, the others to the right."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(
            cell.ljust(width) if i == 0 else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(row, widths))
        ).rstrip()
        for row in rows
    ]
