# SPDX-License-Identifier: Apache-2.0
"""Histories that were modified after they were written are detected."""

from __future__ import annotations

import shutil
import time
from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import WriterProcess
from made_history import MadeHistory
from made_layout import seal

from ideotype.history import HistoryError, open_history, open_study


@pytest.mark.parametrize(
    ("place", "index", "part"),
    [
        ("evaluations/absorbed_by_leaf", (40, 3), "generation 3"),
        ("evaluations/genome", (71, 39), "generation 5"),
        ("evaluations/message", 17, "generation 1"),
        ("generations/mean", 2, "generation 2"),
        ("generations/count", 4, "generation 4"),
        ("final/objectives_by_randomisation", (1, 0, 5), "finalist 1"),
        ("final/status", 3, "finalist 3"),
        ("genes/upper", 7, "the header"),
        ("genes/trait", 7, "the header"),
        ("evaluations/hour", 2, "the header"),
        ("campaign/source", (), "the header"),
    ],
)
def test_a_changed_value_is_named(
    finished: Path, tmp_path: Path, place: str, index: object, part: str
) -> None:
    path = tmp_path / "damaged.h5"
    shutil.copy(finished, path)
    with h5py.File(path, "r+") as file:
        value = file[place][index]
        is_text = isinstance(value, bytes)
        file[place][index] = b"x" + value if is_text else value + 1
    expected = f"damaged.h5: damaged: {part} does not have its checksum; copy"
    with pytest.raises(HistoryError, match=expected):
        open_history(path)
    shutil.copy(finished, tmp_path / "good.h5")
    with open_study(tmp_path, skip_damaged=True) as study:
        assert [history.path.name for history in study] == ["good.h5"]
        (error,) = study.damaged
    assert part in str(error)


@pytest.mark.parametrize(
    ("place", "index", "part"),
    [
        ("generations/committed", 5, "the mark of generation 5"),
        ("generations/committed", 2, "the mark of generation 2"),
        ("final/status", 2, "finalist 2"),
    ],
)
def test_a_removed_mark_of_completion_is_noticed(
    finished: Path, tmp_path: Path, place: str, index: int, part: str
) -> None:
    path = tmp_path / "damaged.h5"
    shutil.copy(finished, path)
    with h5py.File(path, "r+") as file:
        file[place][index] = 0
    with pytest.raises(HistoryError, match=f"damaged: {part} does not have"):
        open_history(path)


def test_a_changed_attribute_is_noticed(
    finished: Path, tmp_path: Path
) -> None:
    path = tmp_path / "damaged.h5"
    shutil.copy(finished, path)
    with h5py.File(path, "r+") as file:
        file.attrs["latitude"] = 43.0
    with pytest.raises(HistoryError, match="the header does not have"):
        open_history(path)


def test_uncommitted_data_may_change(drained: Path, tmp_path: Path) -> None:
    path = tmp_path / "case.h5"
    shutil.copy(drained, path)
    with h5py.File(path, "r+") as file:
        file["evaluations/absorbed_par"][24] += 1
        file["state/wall_time"][()] += 1
    with open_history(path) as history:
        assert len(history.generations()) == 2


def test_checksums_of_live_and_killed_files_are_verified(
    writer: WriterProcess,
) -> None:
    writer.do("evolve 2")
    writer.do("propose_final")
    writer.do("record_final 1")
    open_history(writer.path).close()
    writer.kill()
    open_history(writer.path).close()


def test_verifying_checksums_takes_little_time(tmp_path: Path) -> None:
    """Verification reads at least 50 MB per second, measured on quantities of
    20 MB."""
    path = tmp_path / "large.h5"
    made = MadeHistory(path)
    made.evolve(8)
    made.close()
    with h5py.File(path, "r+") as file:
        rows = file["evaluations"]
        scale = file.create_dataset("evaluations/wide", data=np.arange(25_000))
        scale.make_scale("wide")
        values = np.random.default_rng(1).random((96, 25_000))
        wide = rows.create_dataset("wide_quantity", data=values)
        wide.dims[0].attach_scale(rows["row"])
        wide.dims[1].attach_scale(scale)
        seal(file)
    assert path.stat().st_size > 19e6
    with open_history(path) as history:
        begin = time.process_time()
        history.verify()
        assert time.process_time() - begin < 0.4
