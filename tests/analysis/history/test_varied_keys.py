# SPDX-License-Identifier: Apache-2.0
"""Searches whose genes include integers and choices of the campaign."""

from __future__ import annotations

import json
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
from real_program import executable, output_of, run_with, write_campaign

from ideotype.figures.trait_changes import measure_change
from ideotype.history import HistoryError, Rows, open_history
from ideotype.history.frame import make_frame
from ideotype.history.study import open_study
from ideotype.report.report import write_report

KEYS = """
[[search.keys]]
key = "field.rows"
range = [1, 4]

[[search.keys]]
key = "field.boundary"
values = ["periodic", "isolated"]

[[search.keys]]
key = "spacing.density"
range = [5, 12]

[[search.keys]]
key = "day.date"
values = [2025-08-07, 2025-06-21, 2025-07-15]
"""
SETTINGS = ("--set", "search.optimizer=auto", "--set", "search.population=8")


@pytest.fixture(scope="module")
def history_path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Runs a small campaign with varied keys of every kind."""
    return run_with(tmp_path_factory.mktemp("keys"), KEYS)


def rows_of(path: Path) -> Rows:
    with open_history(path) as history:
        return history.evaluations()


def test_a_history_states_kinds_and_values_of_genes(
    history_path: Path,
) -> None:
    genes = rows_of(history_path).genes
    assert genes.names[-4:] == (
        "field.rows",
        "field.boundary",
        "spacing.density",
        "day.date",
    )
    assert genes.kinds[-4:] == ("integer", "choice", "real", "integer")
    assert set(genes.kinds[:-4]) == {"real"}
    assert genes.values[-3] == ('"periodic"', '"isolated"')
    assert genes.values[-1] == ("2025-06-21", "2025-07-15", "2025-08-07")
    assert genes.text(len(genes.names) - 1, 1) == "2025-07-15"


def test_genes_that_are_integers_or_choices_are_whole_numbers(
    history_path: Path,
) -> None:
    rows = rows_of(history_path)
    assert len(rows.failed) == 0
    discrete = [
        i for i in range(len(rows.genes.names)) if rows.genes.is_discrete(i)
    ]
    genome = rows.genome[:, discrete]
    np.testing.assert_array_equal(genome, np.round(genome))
    assert np.all(np.ptp(genome, axis=0) > 0)


def test_a_search_begins_at_the_values_of_the_campaign(
    history_path: Path,
) -> None:
    rows = rows_of(history_path)
    baseline = rows.genome[0, -4:]
    assert baseline == pytest.approx([2, 0, 1 / (0.762 * 0.1524), 2])


def test_a_row_is_recomputed_with_the_same_bits(history_path: Path) -> None:
    rows = rows_of(history_path)
    place = ("--generation", rows.generation[-1], "--slot", rows.slot[-1])
    done = json.loads(output_of("evaluate", history_path, *place, "--json"))
    assert done["row"]["agrees_bit_for_bit"]


def test_tables_figures_and_reports_show_values(
    history_path: Path, tmp_path: Path
) -> None:
    with open_history(history_path) as history:
        frame = make_frame([history])
    assert set(frame["field.boundary"]) <= {'"periodic"', '"isolated"'}
    with open_study(history_path) as study:
        (case,) = study.cases()
        change = measure_change(case, "day.date")
        assert change.text == "unchanged" or " instead of " in change.text
        write_report(study, tmp_path / "report")
    assert (tmp_path / "report").exists()


def test_a_killed_search_resumes_with_the_same_bits(tmp_path: Path) -> None:
    folders = [tmp_path / name for name in ("whole", "killed")]
    for folder in folders:
        folder.mkdir()
        campaign = write_campaign(folder, 200)
        campaign.write_text(campaign.read_text() + KEYS)
    arguments = [executable(), "run", "tiny.toml", "--resume", *SETTINGS]
    whole, killed = (
        subprocess.Popen(
            [*arguments, "--threads", threads, "--out", "."],
            cwd=folder,
            stdout=subprocess.DEVNULL,
        )
        for folder, threads in zip(folders, ("1", "2"))
    )
    while count_rows(folders[1]) < 30:
        assert killed.poll() is None
        time.sleep(0.02)
    killed.kill()
    killed.wait()
    assert whole.wait(300) == 0
    assert count_rows(folders[1]) < count_rows(folders[0])
    subprocess.run(
        [*arguments, "--threads", "1", "--out", "."],
        cwd=folders[1],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    one, other = (rows_of(history_in(folder)) for folder in folders)
    np.testing.assert_array_equal(one.genome, other.genome)
    np.testing.assert_array_equal(one.objectives, other.objectives)


def history_in(folder: Path) -> Path:
    (path,) = (folder / "tiny").glob("*.h5")
    return path


def count_rows(folder: Path) -> int:
    try:
        return len(rows_of(history_in(folder)).done)
    except (ValueError, HistoryError):
        return 0
