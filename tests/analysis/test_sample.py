# SPDX-License-Identifier: Apache-2.0
"""A history that a program of format 1.0 wrote (see tests/data/history), and
the same in format 2.0: both read the same."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path

import h5py
import numpy as np
import pytest
from convert import convert

import ideotype
from ideotype.analysis import History, open_history, open_study
from ideotype.analysis.scene import build_plants
from ideotype.analysis.summary import summarize
from ideotype.analysis.tables import gains

SAMPLE = Path(__file__).parents[1] / "data" / "history" / "format_1_0.h5"


@pytest.fixture(scope="module")
def converted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return convert(SAMPLE, tmp_path_factory.mktemp("converted") / "2_0.h5")


@pytest.fixture(params=["1.0", "2.0"])
def sample(
    request: pytest.FixtureRequest, converted: Path
) -> Iterator[History]:
    path = SAMPLE if request.param == "1.0" else converted
    with open_history(path) as history:
        assert history.attributes["format_version"] == request.param
        yield history


def test_both_formats_have_the_same_figures(converted: Path) -> None:
    with open_history(SAMPLE) as old, open_history(converted) as new:
        assert summarize(old) == summarize(new)
        for read in (History.evaluations, History.finalists):
            was, now = read(old), read(new)
            assert was.quantities.keys() == now.quantities.keys()
            for name, quantity in now.quantities.items():
                assert was[name].axis == quantity.axis, name
                assert was[name].unit == quantity.unit, name
                for what in ("values", "standard_error"):
                    expected = getattr(quantity, what)
                    assert np.array_equal(getattr(was[name], what), expected)
            for field in fields(was)[3:]:
                found = getattr(was, field.name)
                assert np.array_equal(found, getattr(now, field.name)), (
                    field.name
                )
        was, now = old.generations(), new.generations()
        assert list(was.first_row) == list(now.first_row)
        assert list(was.best_row) == list(now.best_row)
        assert list(was.best.values) == list(now.best.values)
    for group in (
        "evaluations",
        "final",
        "generations",
        "genes",
        "objectives",
    ):
        for name, array in ideotype.open(converted, group).variables.items():
            if name == "checksum":
                continue
            same = ideotype.open(SAMPLE, group).variables[name]
            assert array.dims == same.dims, name
            assert np.array_equal(array.values, same.values), name


def test_a_table_says_that_errors_are_not_paired() -> None:
    with open_study(SAMPLE) as study:
        notes = [block.text for block in gains(study.cases(), None)[1:]]
    (note,) = [note for note in notes if "as independent" in note]
    assert note.startswith(
        "Errors of gains take baseline and best as independent"
    )


def test_light_per_leaf_area_follows_from_the_exact_leaf_area() -> None:
    with open_history(SAMPLE) as history:
        best = history.best()
    assert best is not None
    lai, light = best.estimate("lai").mean, best.objective
    assert best.per_leaf_area.mean == pytest.approx(light.mean / lai)
    error = best.per_leaf_area.standard_error
    assert error == pytest.approx(light.standard_error / lai)


def test_header_is_read(sample: History) -> None:
    has = sample.attributes
    assert has["case"] == "ames_0807_762x152_all_r1"
    assert has["seed"] == 9750423567162723413
    assert has["latitude"] == 42.0
    assert sample.population == 6
    assert len(sample.genes.names) == 40
    assert sample.genes.names[5] == "leaf02_width"
    assert sample.genes.units[5] == "m"
    assert (sample.genes.lower[5], sample.genes.upper[5]) == (0.05, 0.14)
    assert "# Makes the sample" in sample.campaign()


def test_rows_are_read(sample: History) -> None:
    rows = sample.evaluations()
    assert len(rows) == len(rows.done) == 24
    assert (rows.generation[22], rows.slot[22]) == (3, 4)
    assert rows.objectives[22, 0] == 10.744309494404982
    assert rows["absorbed_par"].standard_error[22] == 0.20873547851515245
    assert rows.genome[22, 5] == 0.10519954041467451
    assert rows["lai"].values[22] == 5.027722268667102
    assert list(rows.parents[22]) == [12, 14]


def test_summaries_and_finals_are_read(sample: History) -> None:
    generations = sample.generations()
    assert list(generations.best_row) == [3, 11, 15, 20]
    assert generations.best.values[3] == 10.883457089960887
    assert generations.mean.values[3] == 10.67643429556964
    assert sample.finalists().objectives[2, 0] == 10.74266804362712
    assert str(sample.state()) == "finished (generations)"
    (session,) = sample.sessions()
    assert session.command.endswith("ideotype run sample.toml --out new")
    assert session.ranks == 1
    assert sample.messages() == []


def test_plain_hdf5_opens_it_and_every_dataset_has_a_unit() -> None:
    found: dict[str, object] = {}

    def keep(name: str, entry: h5py.Group | h5py.Dataset) -> None:
        if isinstance(entry, h5py.Dataset):
            found[name] = entry.attrs.get("unit")

    with h5py.File(SAMPLE) as file:
        file.visititems(keep)
        genome = file["evaluations/genome"]
        scale = genome.dims[1][0]
        assert scale.name == "/traits/name"
        assert np.shape(genome) == (24, 40)
    assert len(found) > 40
    assert [name for name, unit in found.items() if unit is None] == []


def test_plants_of_both_formats_have_shapes(sample: History) -> None:
    with open_study(sample.path) as study:
        (case,) = study.cases()
        plants, best = build_plants(case), case.best.row.genome[0]
        genes = case.genes
    sizes = (genes.columns("length"), genes.columns("width"))
    for i, (length, width) in enumerate(zip(*sizes), start=1):
        part = plants.best.area(f"leaf{i:02}") / (best[length] * best[width])
        assert 0.5 < part < 0.95
    assert plants.baseline.area("leaf01") != plants.best.area("leaf01")
