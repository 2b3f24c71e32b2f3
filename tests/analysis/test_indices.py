# SPDX-License-Identifier: Apache-2.0
"""What is read of a sensitivity study, and how a report tells it."""

from __future__ import annotations

import shutil
from pathlib import Path

import h5py
import numpy as np
import pytest
from real_program import output_of

from ideotype.analysis import HistoryError, open_history
from ideotype.analysis.case import Case
from ideotype.analysis.commands import report
from ideotype.analysis.indices import draw_indices

CAMPAIGN = Path(__file__).parents[2] / "campaigns" / "ames_quick.toml"


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


def test_indices_are_read_by_quantity(path: Path) -> None:
    with open_history(path) as history:
        found = history.sensitivity()
        assert history.is_sensitivity
        assert history.genes.names[-1] == "optics.soil_albedo"
        rows = history.evaluations()
    par = found["absorbed_par"]
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
    lai = found["lai"]
    assert lai.unit == "m2 m-2"
    main = lai.index["total" if "total" in lai.index else "mu_star"]
    np.testing.assert_allclose(main[2:], 0, atol=1e-12)
    assert np.all(
        lai.standard_error["total" if "total" in lai.index else "mu_star"][:2]
        > 0
    )


def test_a_damaged_index_is_noticed(path: Path, tmp_path: Path) -> None:
    copy = Path(shutil.copy(path, tmp_path))
    with h5py.File(copy, "r+", libver="latest") as file:
        name = "total" if "total" in file["sensitivity"] else "sigma"
        file[f"sensitivity/{name}"][0, 1] += 1e-9
    with pytest.raises(HistoryError, match="damaged: sensitivity 0"):
        open_history(copy)
    with pytest.raises(AssertionError, match="sensitivity of absorbed_par"):
        output_of("verify", copy)


def test_the_report_draws_them(path: Path, tmp_path: Path) -> None:
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
