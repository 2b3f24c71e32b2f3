# SPDX-License-Identifier: Apache-2.0
"""The trade of speed for accuracy in a report."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from ideotype.analysis import HistoryError
from ideotype.analysis.fidelity import draw_fidelity, read_fidelity


def estimate(mean: float, error: float) -> dict[str, float]:
    return {"mean": mean, "standard_error": error}


@pytest.fixture
def written(tmp_path: Path) -> Path:
    fronts = [
        {
            "goal": goal,
            "fields": fields,
            "combinations": [
                {"milliseconds": 2.0, "error": 0.01},
                {"milliseconds": 30.0, "error": 0.003},
            ],
        }
        for goal in ("value", "difference")
        for fields in ("one", "each")
    ]
    check = {
        "bias": estimate(-0.003, 0.0004),
        "standard_error": estimate(0.004, 0.0003),
        "milliseconds": 29.0,
    }
    choices = [
        {"goal": "value", "fields": "one", "tolerance": 3e-3, "check": check},
        {"goal": "value", "fields": "one", "tolerance": 1e-3},
    ]
    path = tmp_path / "fidelity.json"
    path.write_text(
        json.dumps({"case": "ames", "fronts": fronts, "choices": choices})
    )
    return path


def test_errors_of_checks_are_bias_and_scatter(written: Path) -> None:
    fidelity = read_fidelity(written)
    assert fidelity.case == "ames"
    (check,) = fidelity.checks
    assert check.error == pytest.approx(0.005)
    # Each part counts by its share: 3/5 of .0004 and 4/5 of .0003.
    assert check.standard_error == pytest.approx(0.00024 * 2**0.5)


def test_both_panels_have_both_fronts_and_the_checks(written: Path) -> None:
    value, difference = draw_fidelity(read_fidelity(written)).axes
    for axes in (value, difference):
        fronts = [line for line in axes.lines if len(line.get_xdata()) == 2]
        assert len(fronts) >= 2
        assert list(fronts[0].get_ydata()) == pytest.approx([1, 0.3])
    assert len(value.containers) == 1
    assert len(difference.containers) == 0


def test_other_files_are_refused_by_name(tmp_path: Path) -> None:
    other = tmp_path / "other.json"
    for text in ("{}", "[]", "not json", '{"case": 1, "fronts": [1]}'):
        other.write_text(text)
        with pytest.raises(HistoryError, match="other.json: not written by"):
            read_fidelity(other)
