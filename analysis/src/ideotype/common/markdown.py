# SPDX-License-Identifier: Apache-2.0
"""Formats tables in Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Sequence


def markdown_table(
    header: Sequence[str],
    rows: Iterable[Sequence[str]],
    *,
    is_padded: bool = False,
) -> list[str]:
    """Returns the lines of a table. is_padded: whether cells are padded to the
    width of their column, for tables that are read as text."""
    lines = [header, *rows]
    if not is_padded:
        lines.insert(1, ["---"] * len(header))
        return [f"| {' | '.join(cells)} |" for cells in lines]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|"
    first, *others = (
        f"| {' | '.join(map(str.ljust, cells, widths))} |" for cells in lines
    )
    return [first, rule, *others]
