# SPDX-License-Identifier: Apache-2.0
"""A sensitivity study is read, and a report shows its results."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest
from real_program import output_of

from ideotype.figures.indices import draw_indices
from ideotype.history import open_history
from ideotype.history.case import Case
from ideotype.history.indices import indices_of
from ideotype.tools.commands import report
from ideotype.tools.indices import main

CAMPAIGN = Path(__file__).parents[3] / "campaigns" / "ames_quick.toml"


@pytest.fixture(scope="module", params=["sobol", "morris"])
def path(request, tmp_path_factory) -> Path:
    out = tmp_path_factory.mktemp(request.param)
    output_of(
        "sensitivity", CAMPAIGN, "--out", out,
        "--set", f"sensitivity.method={request.param}",
        "--set", "sensitivity.samples=16", "--set", "light.paths=256",
        "--set", 'sensitivity.keys=[{key="optics.soil_albedo", range=[0, 1]}]',
    )  # fmt: skip
    return next(out.glob("*/*.h5"))


def test_indices_are_computed_by_quantity(path: Path) -> None:
    with open_history(path) as history:
        indices = indices_of(history)
        assert history.is_sensitivity
        assert history.genes.names[-1] == "optics.soil_albedo"
        rows = history.evaluations()
    par = indices["absorbed_par"]
    assert par.factors == (
        *("length", "width", "insertion_angle", "azimuth"),
        "optics.soil_albedo",
    )
    assert par.samples == 16
    size = len(rows) // 16
    assert size == len(par.factors) + (2 if "total" in par.index else 1)
    values = rows["absorbed_par"].values
    assert par.mean == pytest.approx(values.mean())
    errors = rows["absorbed_par"].standard_error
    if "total" in par.index:
        a, b = values[::size], values[size - 1 :: size]
        errors = np.concatenate([errors[::size], errors[size - 1 :: size]])
        noise = np.mean(errors**2)
        variance = np.var([a, b]) - noise
        change = values[1::size] - a
        share = np.mean((b - values.mean()) * change) / variance
        assert par.index["first"][0] == pytest.approx(share)
    else:
        assert np.all(np.isnan(par.index["mu"][:4]))
        assert np.all(par.index["mu_star"] > 0)
    assert par.noise == pytest.approx(np.sqrt(np.mean(errors**2)))
    lai = indices["lai"]
    assert lai.unit == "m2 m-2"
    main = lai.index["total" if "total" in lai.index else "mu_star"]
    np.testing.assert_allclose(main[2:], 0, atol=1e-12)
    assert np.all(
        lai.standard_error["total" if "total" in lai.index else "mu_star"][:2]
        > 0
    )


def test_indices_are_printed(
    path: Path, capsys: pytest.CaptureFixture
) -> None:
    assert main([str(path), "--quantity", "lai"]) == 0
    text = capsys.readouterr().out
    assert "absorbed_par [MJ m-2 day-1]: mean" in text
    assert "lai [m2 m-2]: mean" in text
    assert "  optics.soil_albedo " in text
    assert main([str(path), "--json"]) == 0
    table = json.loads(capsys.readouterr().out)["quantities"]
    assert table["lai"]["samples"] == 16
    assert main([str(path), "--quantity", "lay"]) == 1
    assert "there is no 'lay'" in capsys.readouterr().err


def test_without_salib_one_message_states_the_remedy(
    path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture
) -> None:
    monkeypatch.setitem(sys.modules, "SALib", None)
    assert main([str(path)]) == 1
    assert "pip install 'SALib>=1.5'" in capsys.readouterr().err


def test_the_report_draws_sensitivity_indices(
    path: Path, tmp_path: Path
) -> None:
    with open_history(path) as history:
        figure = draw_indices(Case("study", [history]))
        assert len(figure.axes[0].containers) >= 2
        labels = [tick.get_text() for tick in figure.axes[0].get_yticklabels()]
    assert sorted(labels) == [
        *("azimuth", "insertion angle", "length"),
        *("optics.soil albedo", "width"),
    ]
    assert report([str(path), "-o", str(tmp_path)]) == 0
    page = (tmp_path / "report.html").read_text()
    assert "Sensitivity of" in page
    assert list((tmp_path / "figures").glob("*_indices.*"))
