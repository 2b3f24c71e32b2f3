# SPDX-License-Identifier: Apache-2.0
"""Histories in any state can be read as labelled arrays."""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np
import pytest
import xarray
from conftest import WriterProcess
from made_numbers import HOURS, POPULATION, QUANTITIES, absorbed, hour_par
from real_program import SAMPLE, start

import ideotype


def test_a_finished_file_is_labelled(finished: Path) -> None:
    rows = ideotype.open(finished)
    assert rows.sizes["row"] == 6 * POPULATION
    for name, kind in QUANTITIES.items():
        array = rows[name]
        assert array.dims == ("row", kind.axis) if kind.axis else ("row",)
        assert array.attrs["units"] == kind.units
        assert array.attrs["long_name"] == name.replace("_", " ")
    assert list(rows.hour.values) == HOURS and rows.hour.units == "h"
    noon = rows.absorbed_by_hour.sel(row=14, hour=12)
    assert noon == pytest.approx(hour_par(absorbed(1, 2), 12))
    width = rows.genome.sel(gene="leaf07_width")
    assert width.dims == ("row",)
    assert rows.message.sel(row=17).item() == "leaf 3 folds into itself"
    assert rows.message.sel(row=16).item() == ""
    draws = rows.objectives_by_randomisation.sel(objective="absorbed_par")
    light = rows.objectives.sel(objective="absorbed_par")
    assert np.allclose(draws.mean("randomisation"), light, equal_nan=True)
    genes = ideotype.open(finished, "genes")
    assert genes.trait.sel(gene="leaf07_width").item() == "width"
    finalists = ideotype.open(finished, "final")
    assert finalists.objectives.dims == ("finalist", "objective")


def test_the_error_names_a_missing_group(finished: Path) -> None:
    for path in (finished, SAMPLE):
        with pytest.raises(KeyError, match="has no evaluation"):
            ideotype.open(path, "evaluation")


def test_xarray_opens_a_history_directly(finished: Path) -> None:
    with xarray.open_dataset(finished, group="evaluations") as rows:
        assert rows.absorbed_by_leaf.dims == ("row", "leaf")


def test_open_reads_only_recorded_rows_of_live_and_killed_files(
    writer: WriterProcess,
) -> None:
    writer.do("evolve 1")
    writer.do("propose 1")
    writer.do("record 1 3")
    for _ in range(2):
        rows = ideotype.open(writer.path)
        expected = [*range(POPULATION), POPULATION + 3]
        assert list(rows.row.values) == expected
        assert rows.unchecked_rows == 1
        assert rows.absorbed_par.values[-1] == absorbed(1, 3)
        everything = ideotype.open(writer.path, all_rows=True)
        assert everything.sizes["row"] > 2 * POPULATION
        assert set(everything.status.values[POPULATION:]) == {0, 1, 2}
        writer.kill()


def test_the_sample_is_labelled() -> None:
    rows = ideotype.open(SAMPLE)
    assert rows.absorbed_by_layer.dims == ("row", "layer")
    assert list(rows.layer.values[:2]) == [0.125, 0.375]
    assert list(rows.light_source.values) == ["beam", "sky", "scattered"]
    parts = rows.absorbed_by_source.sum("light_source")
    assert np.allclose(parts, rows.absorbed_par)
    assert rows.absorbed_by_leaf.units == "MJ m-2 day-1"
    assert list(rows.parents.sel(row=22).values) == [12, 14]


def test_a_real_run_is_opened_while_it_runs_and_after_its_kill(
    tmp_path: Path,
) -> None:
    run = start(tmp_path, 10_000)
    try:
        deadline, count = time.monotonic() + 60, 0
        while count < 10:
            assert time.monotonic() < deadline and run.poll() is None
            for path in (tmp_path / "tiny").glob("*.h5"):
                count = ideotype.open(path).sizes["row"]
    finally:
        run.kill()
        run.wait()
    rows = ideotype.open(path)
    assert rows.sizes["row"] >= count
    assert rows.absorbed_by_leaf.notnull().all()
    total = rows.absorbed_by_leaf.sum("leaf")
    assert np.allclose(total, rows.absorbed_par)
