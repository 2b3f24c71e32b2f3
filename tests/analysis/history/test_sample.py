# SPDX-License-Identifier: Apache-2.0
"""A history that version 0.2.0 wrote (see tests/data/history) is read."""

from __future__ import annotations

from collections.abc import Iterator

import h5py
import numpy as np
import pytest
from real_program import SAMPLE

from ideotype.history import History, open_history, open_study
from ideotype.report.scene import build_plants


@pytest.fixture
def sample() -> Iterator[History]:
    with open_history(SAMPLE) as history:
        assert history.attributes["format_version"] == "2.0"
        yield history


def test_light_per_leaf_area_follows_from_the_exact_leaf_area() -> None:
    with open_history(SAMPLE) as history:
        best = history.best()
    assert best is not None
    lai, light = best.estimate("lai").mean, best.objective
    assert best.per_leaf_area.mean == pytest.approx(light.mean / lai)
    error = best.per_leaf_area.standard_error
    assert error == pytest.approx(light.standard_error / lai)


def test_the_header_of_the_sample_is_read(sample: History) -> None:
    has = sample.attributes
    assert has["case"] == "ames_0807_762x152_all_r1"
    assert has["seed"] == 9750423567162723413
    assert has["latitude"] == 42.0
    assert sample.population == 6
    assert len(sample.genes.names) == 79
    assert sample.genes.names[7] == "leaf02_width"
    assert sample.genes.units[7] == "m"
    assert (sample.genes.lower[7], sample.genes.upper[7]) == (0.05, 0.14)
    assert "# Makes the sample" in sample.campaign()


def test_rows_of_the_sample_are_read(sample: History) -> None:
    rows = sample.evaluations()
    assert len(rows) == len(rows.done) == 24
    assert (rows.generation[22], rows.slot[22]) == (3, 4)
    assert rows.objectives[22, 0] == 10.375314388511304
    assert rows["absorbed_par"].standard_error[22] == 0.3784693418232823
    assert rows.genome[22, 7] == 0.10248987086282312
    assert rows["lai"].values[22] == 5.376479412080126
    assert list(rows.parents[22]) == [12, 14]


def test_summaries_and_finals_of_the_sample_are_read(sample: History) -> None:
    generations = sample.generations()
    assert list(generations.best_row) == [3, 10, 12, 23]
    assert generations.best.values[3] == 10.59557139073501
    assert generations.mean.values[3] == 10.388675979723805
    assert sample.finalists().objectives[2, 0] == 10.274444431028046
    assert str(sample.state()) == "finished (reached stop.generations)"
    (session,) = sample.sessions()
    assert session.command.endswith(
        "ideotype run sample.toml --isa avx2 --out new"
    )
    assert session.ranks == 1
    assert sample.messages() == []


def test_plain_hdf5_opens_it_and_every_dataset_has_a_unit() -> None:
    units: dict[str, object] = {}

    def keep(name: str, entry: h5py.Group | h5py.Dataset) -> None:
        if isinstance(entry, h5py.Dataset):
            units[name] = entry.attrs.get("units")

    with h5py.File(SAMPLE) as file:
        file.visititems(keep)
        genome = file["evaluations/genome"]
        scale = genome.dims[1][0]
        assert scale.name == "/evaluations/gene"
        assert np.shape(genome) == (24, 79)
    assert len(units) > 40
    assert [name for name, unit in units.items() if unit is None] == []


def test_plants_of_the_sample_have_meshes(sample: History) -> None:
    with open_study(sample.path) as study:
        (case,) = study.cases()
        plants, best = build_plants(case), case.best.row.genome[0]
        genes = case.genes
    sizes = (genes.columns("length"), genes.columns("width"))
    for i, (length, width) in enumerate(zip(*sizes), start=1):
        part = plants.best.area(f"leaf{i:02}") / (best[length] * best[width])
        assert 0.5 < part < 0.95
    assert plants.baseline.area("leaf01") != plants.best.area("leaf01")
