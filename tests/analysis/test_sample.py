"""A history that a program of format 1.0 wrote: see tests/data/history. If a
test here fails, the format has changed."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import h5py
import numpy as np
import pytest
from ideotype_analysis import History, open_history

SAMPLE = Path(__file__).parents[1] / "data" / "history" / "format_1_0.h5"


@pytest.fixture
def sample() -> Iterator[History]:
    with open_history(SAMPLE) as history:
        yield history


def test_header_is_read(sample: History) -> None:
    has = sample.attributes
    assert has["format_version"] == "1.0"
    assert has["case"] == "ames_0807_762x152_all_r1"
    assert has["seed"] == 9750423567162723413
    assert has["latitude"] == 42.0
    assert sample.population == 6
    assert len(sample.traits.names) == 40
    assert sample.traits.names[5] == "leaf02_width"
    assert sample.traits.units[5] == "m"
    assert (sample.traits.lower[5], sample.traits.upper[5]) == (0.05, 0.14)
    assert "# Makes the sample" in sample.campaign()


def test_rows_are_read(sample: History) -> None:
    rows = sample.evaluations()
    assert len(rows) == len(rows.done) == 24
    assert (rows.generation[22], rows.slot[22]) == (3, 4)
    assert rows.fitness.values[22] == 10.744309494404982
    assert rows["absorbed_par"].standard_error[22] == 0.20873547851515245
    assert rows.traits.values[22, 5] == 0.10519954041467451
    assert rows["lai"].values[22] == 5.027722268667102
    assert list(rows.parents[22]) == [0, 2]


def test_summaries_and_finals_are_read(sample: History) -> None:
    generations = sample.generations()
    assert list(generations.best_slot) == [3, 5, 3, 2]
    assert generations.best.values[3] == 10.883457089960887
    assert generations.mean.values[3] == 10.67643429556964
    assert sample.finalists().fitness.values[2] == 10.74266804362712
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
