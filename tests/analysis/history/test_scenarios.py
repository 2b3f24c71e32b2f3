# SPDX-License-Identifier: Apache-2.0
"""Plants optimised over several scenarios are reported for each scenario."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from made_campaign import resolved
from made_history import MadeHistory
from made_kinds import Measured
from real_program import output_of, write_campaign

import ideotype
from ideotype.figures.places import draw_latitudes, draw_spacings
from ideotype.history import Case, HistoryError, open_study
from ideotype.history.layout import places
from ideotype.report.scenario_table import tabulate_scenarios
from ideotype.report.scene import build_plants, make_scene

_MORE = """
[[site]]
name = "south"
latitude = 25
longitude = -100
utc_offset = -6

[objective]
over = ["site"]
scenarios = "worst"
"""


def test_evaluate_reproduces_rows_of_scenarios(tmp_path: Path) -> None:
    campaign = write_campaign(tmp_path, 2)
    campaign.write_text(campaign.read_text() + _MORE)
    output_of("run", campaign, "--out", tmp_path)
    (path,) = (tmp_path / "tiny").glob("*.h5")
    assert path.name == "all_0807_762x152_all_r1.h5"
    rows = ideotype.open(path)
    by_scenario = rows.absorbed_par_by_scenario
    assert list(by_scenario.scenario.values) == ["ames", "south"]
    worst = rows.objectives.sel(objective="absorbed_par")
    assert np.array_equal(worst, by_scenario.min("scenario"))
    for which in (["--generation", 1, "--slot", 3], ["--best"]):
        found = output_of("evaluate", path, *which)
        assert "agrees bit for bit" in found
        assert re.search("(?m)^case +south_0807_762x152_all_r1$", found)


CASES = {
    "": "ames_0807_762x152_all",
    "site": "all_0807_762x152_all",
    "day": "ames_all_762x152_all",
    "spacing": "ames_0807_all_all",
}
"""Names of cases by the axis of scenarios."""


def make(folder: Path, over: str = "", **place: float) -> None:
    """Makes a case, optionally with two scenarios; the light of the second is
    half that of the first."""
    made = MadeHistory(
        folder / f"{len([*folder.iterdir()])}.h5",
        resolved=resolved(*[over] * bool(over)),
        attributes={"case": f"{CASES[over]}_r1", **place},
        labels={"scenario": ["dense", "wide"]},
        extra={
            "absorbed_par_by_scenario": (
                Measured("MJ m-2 day-1", "scenario"),
                np.array([1.0, 0.5]),
            )
        }
        if over
        else {},
    )
    made.evolve(1)
    made.finish()
    made.close()


def remembered_cases(folder: Path) -> list[Case]:
    with open_study(folder) as study:
        cases = study.cases()
        for case in cases:
            case.remember()
    return cases


def test_a_report_has_values_for_each_scenario(tmp_path: Path) -> None:
    make(tmp_path, "day")
    make(tmp_path, latitude=50.0)
    cases = remembered_cases(tmp_path)
    (table,) = tabulate_scenarios(cases)
    assert [row[0] for row in table.rows] == [
        f"{CASES['day']}: dense",
        f"{CASES['day']}: wide",
    ]
    assert table.rows[1][1].startswith("5.5000\u00a0±")
    assert table.rows[1][3].startswith("1.50\u00a0±")
    assert table.caption.startswith("Absorbed PAR by scenario [MJ")
    assert "better than the baseline in 2 of 2 scenarios" in table.caption
    with pytest.raises(HistoryError, match="over scenarios"):
        cases[0].headroom()
    assert cases[1].headroom().mean > 0
    # The light of the objective is not the light per leaf area.
    over, one = (case.best_pair.gain_per_leaf_area for case in cases)
    assert over.mean == pytest.approx(one.mean)
    assert over.standard_error > 2 * one.standard_error


def test_properties_that_vary_between_scenarios_are_not_those_of_the_first(
    tmp_path: Path,
) -> None:
    make(tmp_path, "spacing")
    make(tmp_path, "site", latitude=50.0, plant_spacing=0.3)
    cases = remembered_cases(tmp_path)
    assert [len(places(case)) for case in cases] == [1, 9]
    for draw in (draw_latitudes, draw_spacings):
        with pytest.raises(HistoryError, match="all cases have the same"):
            draw(cases)
    with open_study(tmp_path) as study:
        shown = [(case, build_plants(case)) for case in study.cases()]
        scene = json.loads(make_scene(shown))
    assert [len(case["quantities"]) for case in scene["cases"]] == [1, 2]
