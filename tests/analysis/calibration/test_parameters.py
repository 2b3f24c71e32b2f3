# SPDX-License-Identifier: Apache-2.0
"""Priors are read from files of priors and from the estimates of crop files."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import ideotype
from ideotype.calibration import Parameter, estimates, read_parameters

TOP = Path(__file__).parents[3]

UNIFORM = Parameter("photosynthesis.theta", 0.5, 0.9)
CUT = Parameter("photosynthesis.amax", 40, math.inf, 50, 10)


@pytest.mark.parametrize("parameter", (UNIFORM, CUT), ids=("uniform", "cut"))
def test_values_are_quantiles_of_the_prior(parameter: Parameter) -> None:
    z = np.linspace(-3, 3, 13)
    values = parameter.value(z)
    assert np.all(np.diff(values) > 0)
    assert np.all(values >= parameter.low) and np.all(values <= parameter.high)
    assert parameter.z(values) == pytest.approx(z, abs=1e-6)


def test_a_cut_normal_prior_has_its_mean() -> None:
    z = np.random.default_rng(1).normal(size=200_000)
    values = CUT.value(z)
    # The mean of a normal distribution cut off at one deviation below its
    # mean: mu + sd phi(1) / Phi(1).
    expected = 50 + 10 * 0.241971 / 0.841345
    assert values.mean() == pytest.approx(expected, abs=0.1)


def test_a_file_of_priors_is_read(tmp_path: Path) -> None:
    path = tmp_path / "priors.toml"
    path.write_text(
        '[[parameter]]\nkey = "photosynthesis.theta"\nrange = [0.5, 0.9]\n'
        'source = "doi:10.1"\n'
        '[[parameter]]\nkey = "leaf.all.length"\nfactor = true\n'
        "mean = 1\ndeviation = 0.1\n"
    )
    first, second = read_parameters(path)
    assert first.is_uniform and (first.low, first.high) == (0.5, 0.9)
    assert first.source == "doi:10.1"
    assert second.setting(1.1) == {"times": 1.1} and not second.is_uniform


def test_all_problems_of_a_file_of_priors_are_reported(tmp_path: Path) -> None:
    path = tmp_path / "priors.toml"
    path.write_text(
        '[[parameter]]\nkey = "theta"\nrange = [0.9, 0.5]\n'
        '[[parameter]]\nkey = "photosynthesis.theta"\n'
        '[[parameter]]\nkey = "photosynthesis.amax"\nmean = 50\n'
        '[[parameter]]\nkey = "a.b"\nrnage = [0, 1]\n'
        '[[parameter]]\nkey = "a.c"\nmean = 5\ndeviation = 1\nrange = [6, 7]\n'
        "[other]\n"
    )
    with pytest.raises(ideotype.Error) as caught:
        read_parameters(path)
    text = str(caught.value)
    for line, words in (
        (1, "key is 'theta'"),
        (1, "low < high"),
        (4, "there is no prior"),
        (6, "deviation None"),
        (9, "did you mean 'range'"),
        (12, "outside of the range"),
    ):
        assert any(
            x.startswith(f"{path}:{line}: ") and words in x
            for x in text.splitlines()
        ), words
    assert "there is no table 'other'" in text


def test_estimates_of_a_crop_file_have_priors() -> None:
    crop = TOP / "campaigns/crops/maize_hybrid.toml"
    found = {p.key: (p.low, p.high) for p in estimates(crop)}
    assert found["crop.growth.root_share"] == (0.10, 0.20)
    assert found["crop.grain.kernels"] == (385, 600)
    assert found["photosynthesis.leaf_days"] == (90, 130)
    assert found["crop.response.2.slope"] == (-0.25, -0.08)
    # An estimate without a range has none.
    assert "crop.stalk.base_diameter" not in found
