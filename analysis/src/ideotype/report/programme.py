# SPDX-License-Identifier: Apache-2.0
"""The table of a breeding programme that `ideotype select` simulated."""

from __future__ import annotations

from pathlib import Path

from ..common.arrays import read_columns
from ..errors import Error
from ..history.estimate import Estimate
from .blocks import Table


def tabulate_reach(folder: Path) -> Table:
    """Returns the gain of a programme compared with that of its ideotype, from
    the folder of a selection.

    Raises Error if it has no table `reach`."""
    path = folder / "reach.csv"
    table = read_columns(path)
    needed = {"method", "cycles", "gain", "ceiling", "half_cycles"}
    if absent := sorted(needed - set(table.columns)):
        raise Error(
            f"{path}: there is no column '{absent[0]}'; name a folder that "
            "ideotype select has written"
        )

    def cell(row: object, name: str) -> str:
        error = getattr(row, f"{name}_standard_error", float("nan"))
        return Estimate(getattr(row, name), error).interval_text()

    return Table(
        ("selection by", "cycles", "gain of lines [%]", "gain of the ideotype "
         "[%]", "cycles to half of it"),
        [
            [
                str(row.method),
                str(row.cycles),
                cell(row, "gain"),
                cell(row, "ceiling") if row.ceiling == row.ceiling else "-",
                f"{row.half_cycles:.1f}"
                if row.half_cycles == row.half_cycles
                else "-",
            ]
            for row in table.itertuples()
        ],
        "Gains of a simulated programme over the mean plant of the lines, and "
        "that of the ideotype over the same plant "
        f"({folder / 'selection.md'}).",
    )  # fmt: skip
