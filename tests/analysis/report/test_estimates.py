# SPDX-License-Identifier: Apache-2.0
"""A report states the gain under draws of the estimates of a crop."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import ideotype
from ideotype.calibration import Parameter, estimates, read_priors
from ideotype.history import open_study
from ideotype.report.blocks import Note
from ideotype.report.estimates import (
    DrawnGains,
    describe_drawn,
    evaluate_draws,
)
from ideotype.tools.commands import report

CROP = Path(__file__).parents[3] / "campaigns/crops/maize_hybrid.toml"
NOTHING = Parameter("optics.soil_albedo", 0.1, 0.1 + 1e-9)
PRIORS = """
[[parameter]]
key = "optics.leaf_transmittance"
range = [0.02, 0.2]

[[parameter]]
key = "crop.stalk.base_diameter"
factor = true
range = [0.5, 1.5]
"""


def test_draws_without_a_width_have_the_gain_of_the_search(
    tiny_run: Path,
) -> None:
    with open_study(tiny_run) as study:
        (case,) = study.cases()
        found = evaluate_draws(case, [NOTHING], draws=2)
        gain = case.best_pair.gain.mean
        wide = Parameter("optics.leaf_transmittance", 0.02, 0.2)
        wider = evaluate_draws(case, [NOTHING, wide], draws=3)
        wrong = evaluate_draws(case, [Parameter("optics.none", 0, 1)])
    assert isinstance(found, DrawnGains) and isinstance(wider, DrawnGains)
    # The optics of the crop replace the albedo of the tiny campaign, 0.1.
    assert np.ptp(found.gains) < 1e-6
    assert found.gains[0] == pytest.approx(gain, abs=1e-6)
    assert np.ptp(wider.gains) > 0.01
    assert isinstance(wrong, Note) and "is not known" in wrong.text


def test_the_report_states_the_range_of_gains(
    tiny_run: Path, tmp_path: Path
) -> None:
    path = tmp_path / "priors.toml"
    path.write_text(PRIORS)
    with open_study(tiny_run) as study:
        (case,) = study.cases()
        found = evaluate_draws(case, read_priors(path))
    assert isinstance(found, DrawnGains) and len(found.gains) == 20
    (fact,) = describe_drawn({case.name: found})
    low, high = f"{min(found.gains):.1f}", f"{max(found.gains):.1f}"
    assert low in fact.value.replace("\N{MINUS SIGN}", "-")
    assert f"{high} % (20 draws of 2 estimates)" in fact.value
    words = [str(tiny_run), "-o", str(tmp_path / "out"), "--no-split", "-j1"]
    assert report([*words, "--estimates", str(path)]) == 0
    page = (tmp_path / "out/report.html").read_text(encoding="utf-8")
    assert "estimates were off by their stated errors" in page


def test_priors_are_those_of_a_file_or_of_a_crop(tmp_path: Path) -> None:
    path = tmp_path / "priors.toml"
    path.write_text(PRIORS)
    assert [p.is_factor for p in read_priors(path)] == [False, True]
    assert read_priors(CROP) == estimates(CROP) != []
    with pytest.raises(ideotype.Error, match="there is no such file"):
        read_priors(tmp_path / "none.toml")
