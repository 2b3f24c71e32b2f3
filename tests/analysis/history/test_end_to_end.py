# SPDX-License-Identifier: Apache-2.0
"""The package reads a file of the program itself.

IDEOTYPE_EXECUTABLE names the built program: a tiny campaign is run with it.
IDEOTYPE_SAMPLE_HISTORY names a finished history that is tested instead; tests
that need the program are then skipped if the program is not given too."""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from real_program import start

from ideotype.history import HistoryError, Rows, open_history
from ideotype.history.study import open_study
from ideotype.report.scene import build_plants

PROMISED = {
    *("program", "program_version", "git_sha", "git_dirty"),
    *("compiler", "build_type", "isa", "maths"),
    *("embree_version", "hdf5_version", "mpi_version"),
    *("campaign", "campaign_sha256", "case", "created"),
    *("site", "day", "spacing", "trait_set", "replicate"),
    *("latitude", "longitude", "row_spacing", "plant_spacing"),
}
"""Root attributes of FORMAT.md that readers can do without."""


@pytest.fixture(scope="session", params=["tiny_run", "sorghum"])
def sample(request: pytest.FixtureRequest) -> Path:
    """Provides the given history, or else a new history and a history of
    sorghum."""
    if given := os.environ.get("IDEOTYPE_SAMPLE_HISTORY"):
        return Path(given)
    found = request.getfixturevalue(request.param)
    return found[0] if isinstance(found, list) else found


@pytest.fixture(params=["evaluations", "finalists"])
def rows(request: pytest.FixtureRequest, sample: Path) -> Rows:
    """Provides the successful rows of the run and of the final evaluations."""
    with open_history(sample) as history:
        found = getattr(history, request.param)().done
    assert len(found) > 0
    return found


def test_a_real_history_follows_the_format(sample: Path) -> None:
    with open_history(sample) as history:
        has = history.attributes
        assert str(history.state()).startswith("finished (")
        assert len(history.sessions()) >= 1
        assert history.genes.is_free.any()
        assert has["campaign"] in history.campaign("resolved")
    assert sorted(PROMISED - has.keys()) == []


def test_light_by_leaf_sums_to_absorbed_par(rows: Rows) -> None:
    leaves = rows["absorbed_by_leaf"]
    count = rows.genes.leaves.max()
    assert list(leaves.axis.labels) == list(range(1, count + 1))
    total = leaves.values.sum(1)
    assert total == pytest.approx(rows["absorbed_par"].values, rel=1e-9)


def test_the_energy_balance_closes(rows: Rows) -> None:
    parts = ("absorbed", "stalk", "soil", "reflected")
    fractions = [rows[f"{part}_fraction"].values for part in parts]
    assert np.sum(fractions, axis=0) == pytest.approx(1.0, rel=1e-9)
    assert np.all(np.abs(rows["balance_error"].values) < 1e-9)
    assert np.all(np.array(fractions) >= 0)
    absorbed = fractions[0] * rows["incident"].values
    assert absorbed == pytest.approx(rows["absorbed_par"].values, rel=1e-9)


def test_light_by_organ_sums_to_the_light_of_plants(rows: Rows) -> None:
    organs = rows["absorbed_by_organ"]
    leaves, *others = organs.axis.labels
    assert leaves == "leaves" and others[0] == "stalk"
    assert organs.values[:, 0] == pytest.approx(rows["absorbed_par"].values)
    taken = rows["stalk_fraction"].values * rows["incident"].values
    assert organs.values[:, 1:].sum(1) == pytest.approx(taken, rel=1e-9)


def test_standard_errors_are_finite_and_small(rows: Rows) -> None:
    relative = rows["absorbed_par"].standard_error / rows.objectives[:, 0]
    assert np.all((relative > 0) & (relative < 0.08))
    assert rows.objectives[:, 0] == pytest.approx(rows["absorbed_par"].values)


def test_genomes_are_within_their_bounds(rows: Rows, sample: Path) -> None:
    with open_history(sample) as history:
        lower, upper = history.genes.lower, history.genes.upper
    assert np.all((rows.genome >= lower) & (rows.genome <= upper))


def test_generations_summarize_their_rows(sample: Path) -> None:
    with open_history(sample) as history:
        generations, everything = history.generations(), history.evaluations()
    assert len(generations) > 0
    for g in range(len(generations)):
        rows = everything.take(everything.generation == g)
        values = rows.done.objectives[:, 0]
        (best,) = rows.objectives[rows.row == generations.best_row[g], 0]
        assert generations.best.values[g] == values.max() == best
        assert generations.mean.values[g] == pytest.approx(values.mean())
        assert generations.failures[g] == len(rows.failed)


def test_hourly_light_integrates_to_the_day(tiny_run: Path) -> None:
    with open_history(tiny_run) as history:
        best = history.best()
    assert best is not None and best.is_final
    profile = best.profile("absorbed_by_hour")
    # The daily sum follows by the trapezoidal rule, because at Ames the sun is
    # up from the first to the last hour.
    assert list(profile.labels) == list(range(7, 21))
    ends = profile.values[0] + profile.values[-1]
    joules = 3600 * (profile.values.sum() - ends / 2)
    assert joules / 1e6 == pytest.approx(best.objective.mean, rel=1e-9)


def test_meshes_of_a_report_have_the_lengths_of_their_genes(
    tiny_run: Path,
) -> None:
    with open_study(tiny_run) as study:
        (case,) = study.cases()
        plants = build_plants(case)
        best, genes = case.best, case.genes
    leaves = [f"leaf{leaf:02}" for leaf in range(1, 11)]
    for mesh in (plants.baseline, plants.best):
        assert list(dict.fromkeys(mesh.groups))[:11] == [*leaves, "stalk"]
    lengths = best.row.genome[0, genes.columns("length")]
    widths = best.row.genome[0, genes.columns("width")]
    for leaf, length, width in zip(leaves, lengths, widths):
        part = plants.best.area(leaf) / (length * width)
        # A blade covers a part of its bounding rectangle.
        assert 0.5 < part < 0.95
    assert plants.baseline.area("leaf01") != plants.best.area("leaf01")


@pytest.fixture
def running(tmp_path: Path) -> Iterator[tuple[subprocess.Popen[str], Path]]:
    """Provides a run that does not end by itself, and its history."""
    run = start(tmp_path, 10_000)
    deadline = time.monotonic() + 60
    while not (histories := list((tmp_path / "tiny").glob("*.h5"))):
        assert run.poll() is None, run.communicate()[0]
        assert time.monotonic() < deadline, "no history within a minute"
        time.sleep(0.01)
    yield run, histories[0]
    run.kill()
    run.wait()


def test_a_run_is_followed_and_survives_its_kill(
    running: tuple[subprocess.Popen[str], Path],
) -> None:
    run, path = running
    seen = 0
    with open_history(path) as history:
        deadline = time.monotonic() + 60
        # A new file is visible shortly before the program opens it for
        # writing.
        while str(history.state()) != "running":
            assert time.monotonic() < deadline, str(history.state())
            time.sleep(0.01)
        while seen < 20:
            assert time.monotonic() < deadline, f"only {seen} rows"
            rows = history.evaluations()
            assert len(rows) >= seen
            for quantity in rows.done.quantities.values():
                assert np.all(np.isfinite(quantity.values))
            seen = len(rows)
    run.kill()
    run.wait()
    with open_history(path) as history:
        assert len(history.evaluations()) >= seen
        assert str(history.state()).startswith("interrupted")


def test_a_real_file_that_was_cut_short_is_refused(
    tiny_run: Path, tmp_path: Path
) -> None:
    data = tiny_run.read_bytes()
    (tmp_path / "cut.h5").write_bytes(data[: len(data) // 2])
    with pytest.raises(HistoryError, match="cut short"):
        open_history(tmp_path / "cut.h5")
