# SPDX-License-Identifier: Apache-2.0
"""Types that all made histories use."""

from __future__ import annotations

from dataclasses import dataclass

STATUS = {"empty": 0, "proposed": 1, "done": 2, "failed": 3}
ORIGIN = {"none": 0, "baseline": 1, "random": 2, "elite": 3, "child": 4}


@dataclass(frozen=True)
class Measured:
    """A quantity of a row."""

    units: str
    axis: str | None = None
    is_exact: bool = False
