"""Plants that are bred for several scenarios."""

from __future__ import annotations

from pathlib import Path

import ideotype_analysis
import numpy as np
from real_program import output_of, write_campaign

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


def test_rows_tell_each_scenario_and_are_found_again(tmp_path: Path) -> None:
    campaign = write_campaign(tmp_path, 2)
    campaign.write_text(campaign.read_text() + _MORE)
    output_of("run", campaign, "--out", tmp_path)
    (path,) = (tmp_path / "tiny").glob("*.h5")
    assert path.name == "all_0807_762x152_all_r1.h5"
    rows = ideotype_analysis.open(path)
    by_scenario = rows.absorbed_par_by_scenario
    assert list(by_scenario.scenario.values) == ["ames", "south"]
    worst = rows.objectives.sel(objective="absorbed_par")
    assert np.array_equal(worst, by_scenario.min("scenario"))
    for which in (["--generation", 1, "--slot", 3], ["--best"]):
        found = output_of("evaluate", path, *which)
        assert "agrees bit for bit" in found
        assert "case south_0807_762x152_all_r1," in found
