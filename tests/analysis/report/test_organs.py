# SPDX-License-Identifier: Apache-2.0
"""The report shows organs other than leaves."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from ideotype.figures.comparison import compute_shares, draw_energy
from ideotype.history.study import open_study
from ideotype.report.light_tables import tabulate_organs
from ideotype.tools.commands import report


def test_light_by_organ_is_drawn_and_listed(sorghum: list[Path]) -> None:
    with open_study(sorghum[1]) as study:
        cases = study.cases()
        parts = compute_shares(cases[0], "best")
        best, others = cases[0].best, cases[0].light_by_organ("best")
        (table,) = tabulate_organs(cases)
        legend = draw_energy(cases).legends[0].get_texts()
    assert [*parts] == [
        *("leaves", "stalks", "sheaths", "other organs", "soil", "reflected"),
    ]
    assert [text.get_text() for text in legend] == [*parts]
    assert sum(part.mean for part in parts.values()) == pytest.approx(1)
    taken = best.estimate("stalk_fraction").mean
    assert sum(part.mean for part in others.values()) == pytest.approx(taken)
    both = others["peduncle"].mean + others["panicle"].mean
    assert parts["other organs"].mean == pytest.approx(both)
    assert table.header == ("plant", "stalk", "sheath", "peduncle", "panicle")
    assert len(table.rows) == 2
    share = 100 * others["panicle"].mean
    percent = float(table.rows[1][4].split("\u00a0")[0])
    assert percent == pytest.approx(share, abs=0.5)


def test_a_report_of_sorghum_is_complete(
    sorghum: list[Path], tmp_path: Path
) -> None:
    arguments = [sorghum[0].parent, "-o", tmp_path]
    assert report([str(argument) for argument in arguments]) == 0
    figures = {path.stem for path in (tmp_path / "figures").glob("*.svg")}
    for case, own in (("all", "traits"), ("angle_profile", "profiles")):
        for name in (own, "field", "leaves", "azimuths", "parts"):
            assert f"ames_0807_700x143_{case}_{name}" in figures
    text = (tmp_path / "report.html").read_text()
    assert ">panicle</th>" in text
    (found,) = re.findall(r'(?s)id="scene">(.*?)</script>', text)
    scene = json.loads(found)
    for case in scene["cases"]:
        for plant in case["plants"]:
            shape = scene["shapes"][plant["shape"]]
            colors = dict(zip(shape["groups"], shape["colors"]))
            assert {"leaf01", "leaf16", "sheath", "stalk_panicle"} < {*colors}
            red, green, blue = colors["sheath"]
            assert green > max(red, blue)
            assert len(set(colors["stalk_panicle"])) == 1
