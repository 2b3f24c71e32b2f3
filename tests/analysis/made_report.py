# SPDX-License-Identifier: Apache-2.0
"""The report of a sweep of two cases with two seeds each."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ideotype.figures.case import CASE_FIGURES

CASES = ("ames_0807_762x152_all", "edmonton_0807_762x152_all")
DRAWN = CASE_FIGURES.keys() - {
    *("profiles", "plant_traits", "sunlit", "assimilation", "days"),
    *("leaf_area", "carbon"),
}
"""The figures of each case, which breeds traits of leaves for the light of a
day."""
OWN = ("field", "importance")
"""Further figures of each case, which need the compiled module."""
ELITE = 11.08
"""The absorbed PAR of the elite plant of the cross-evaluation."""


@dataclass(frozen=True)
class Made:
    """A report that the command has written."""

    folder: Path
    log: str

    @property
    def page(self) -> Path:
        return self.folder / "report.html"

    @property
    def text(self) -> str:
        return self.page.read_text(encoding="utf-8")
