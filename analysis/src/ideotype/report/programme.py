# SPDX-License-Identifier: Apache-2.0
"""The table of a breeding programme that `ideotype select` simulated."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pandas as pd

from ..common.arrays import read_columns
from ..errors import Error
from ..history.estimate import Estimate
from .blocks import Table


def _read_reach(folder: Path) -> pd.DataFrame:
    path = folder / "reach.csv"
    table = read_columns(path)
    needed = {"method", "cycles", "gain", "ceiling", "half_cycles"}
    if absent := sorted(needed - set(table.columns)):
        raise Error(
            f"{path}: there is no column '{absent[0]}'; name a folder that "
            "ideotype select has written"
        )
    return table


def _interval(row: Any, name: str) -> str:
    error = getattr(row, f"{name}_standard_error", math.nan)
    return Estimate(getattr(row, name), error).interval_text()


def describe_reach(folder: Path) -> str:
    """Returns a sentence for each method of a programme: the gain of lines
    and, if the selection knows it, that of the ideotype, both over the mean
    plant of the lines. The argument and errors are those of
    `tabulate_reach`."""
    sentences = []
    for row in _read_reach(folder).itertuples():
        text = (
            f"Selection of measured lines by {row.method} gains "
            f"{_interval(row, 'gain')} % in {row.cycles} cycles"
        )
        if not math.isnan(row.ceiling):
            text += f"; the ideotype gains {_interval(row, 'ceiling')} %"
        sentences.append(text + ".")
    return " ".join(sentences)


def tabulate_reach(folder: Path) -> Table:
    """Returns the gain of a programme compared with that of its ideotype, from
    the folder of a selection.

    Raises Error if it has no table `reach`."""
    return Table(
        ("selection by", "cycles", "gain of lines [%]", "gain of the ideotype "
         "[%]", "cycles to half of it"),
        [
            [
                str(row.method),
                str(row.cycles),
                _interval(row, "gain"),
                "-" if math.isnan(row.ceiling) else _interval(row, "ceiling"),
                "-" if math.isnan(row.half_cycles) else f"{row.half_cycles:.1f}",
            ]
            for row in _read_reach(folder).itertuples()
        ],
        "Gains of a simulated programme over the mean plant of the lines, and "
        "that of the ideotype over the same plant "
        f"({folder / 'selection.md'}).",
    )  # fmt: skip
