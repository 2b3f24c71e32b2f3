# SPDX-License-Identifier: Apache-2.0
"""Abbreviations in names of quantities are printed in capitals."""

from __future__ import annotations

import re

import pytest
from real_program import CAMPAIGNS

import ideotype
from ideotype.common.labels import ABBREVIATIONS, title, words
from ideotype.live.numbers import Layout


@pytest.mark.parametrize(
    ("name", "inside", "first"),
    [
        ("absorbed_par", "absorbed PAR", "Absorbed PAR"),
        ("gross_co2", "gross CO₂", "Gross CO₂"),
        ("sunlit_lai", "sunlit LAI", "Sunlit LAI"),
        ("lai_by_stage", "LAI by stage", "LAI by stage"),
        ("fapar", "fAPAR", "fAPAR"),
        ("absorbed_nir", "absorbed NIR", "Absorbed NIR"),
        ("leaf_plane", "leaf plane", "Leaf plane"),
        ("spacing.row", "spacing.row", "Spacing.row"),
        ("part", "part", "Part"),
    ],
)
def test_abbreviations_have_their_capitals(
    name: str, inside: str, first: str
) -> None:
    assert words(name) == inside
    assert words(inside) == inside
    assert title(name) == first


def test_the_live_page_has_the_same_labels() -> None:
    stand = ideotype.Stand.from_campaign(
        CAMPAIGNS / "ames.toml",
        settings={"objective.maximise": "carbon_balance"},
    )
    shown = {x["name"]: x["label"] for x in Layout(stand).scalars}
    assert shown["gross_co2"] == "Gross CO₂"
    assert shown["sunlit_lai"] == "Sunlit LAI"
    wrong = re.compile(rf"\b({'|'.join(ABBREVIATIONS)})\b", re.IGNORECASE)
    for label in shown.values():
        for found in wrong.findall(label):
            assert found in ABBREVIATIONS.values(), label
