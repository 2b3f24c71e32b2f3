# SPDX-License-Identifier: Apache-2.0
"""A History returns the contents of its file."""

from __future__ import annotations

import math
from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import WriterProcess
from made_history import MadeHistory
from made_kinds import ORIGIN
from made_layout import seal
from made_numbers import (
    BASELINE,
    ERROR,
    FINALISTS,
    HOURS,
    INCIDENT,
    POPULATION,
    QUANTITIES,
    TRAITS,
    absorbed,
    baseline_genome,
    final_absorbed,
    genome,
    hour_par,
    leaf_share,
    randomisations,
)

from ideotype.history import HistoryError, open_history


def test_only_complete_rows_are_evaluations(drained: Path) -> None:
    with open_history(drained) as history:
        rows = history.evaluations()
        third = history.evaluations(2)
    assert len(rows) == 2 * POPULATION + 5
    assert list(third.slot) == [0, 2, 3, 4, 7]
    assert set(third.generation) == {2}
    assert list(third.done.slot) == [0, 2, 3, 7]
    assert list(rows.generation[: POPULATION + 1]) == [0] * POPULATION + [1]


def test_only_committed_generations_count(drained: Path) -> None:
    with open_history(drained) as history:
        generations = history.generations()
    assert len(generations) == 2
    last = POPULATION - 1
    assert list(generations.first_row) == [0, POPULATION]
    assert list(generations.best_row) == [last, POPULATION + last]
    best = [absorbed(0, last), absorbed(1, last)]
    assert generations.best.values == pytest.approx(best, rel=1e-15)
    assert list(generations.best.standard_error) == [ERROR, ERROR]
    # Slot 5 of generation 1 has failed.
    good = [absorbed(1, s) for s in range(POPULATION) if s != 5]
    assert generations.mean.values[1] == pytest.approx(np.mean(good))
    assert generations.spread.values[1] == pytest.approx(np.std(good, ddof=1))
    assert list(generations.failures) == [0, 1]
    assert generations.mean.unit == "MJ m-2 day-1"
    assert generations.wall_time.unit == "s"
    assert list(generations.wall_time.values) == [3.0, 6.0]


def test_failed_rows_have_reasons_and_no_outcome(drained: Path) -> None:
    with open_history(drained) as history:
        failed = history.evaluations().failed
    assert list(zip(failed.generation, failed.slot)) == [(1, 5), (2, 4)]
    assert set(failed.message) == {"leaf 3 folds into itself"}
    assert np.all(np.isnan(failed["absorbed_par"].values))
    for quantity in failed.quantities.values():
        assert np.all(np.isnan(quantity.values)), quantity.name
        assert np.all(np.isnan(quantity.standard_error)), quantity.name
    assert np.all(np.isnan(failed.violation))
    assert np.all(np.isfinite(failed.genome))


def test_quantities_are_found_by_name_with_their_unit(
    finished: Path,
) -> None:
    with open_history(finished) as history:
        rows = history.evaluations(2)
    par = rows["absorbed_par"]
    expected = [absorbed(2, s) for s in range(POPULATION)]
    assert (par.unit, list(par.values)) == ("MJ m-2 day-1", expected)
    assert list(par.standard_error) == [ERROR] * POPULATION
    assert set(rows.quantities) == set(QUANTITIES)
    for name, kind in QUANTITIES.items():
        quantity = rows[name]
        assert quantity.unit == kind.units
        assert (quantity.axis.name if quantity.axis else None) == kind.axis
        if kind.is_exact:
            assert not quantity.standard_error.any()
    for name, unit, *_ in TRAITS:
        assert rows[name].unit == unit
    genes = np.array([genome(2, s) for s in range(POPULATION)])
    assert np.array_equal(rows.genome, genes)
    width = rows["leaf07_width"].values
    assert np.array_equal(width, genes[:, 6 * 4 + 1])
    assert rows["incident"].values == pytest.approx(INCIDENT)
    with pytest.raises(KeyError, match="biomass"):
        rows["biomass"]


def test_rows_have_parents_and_computing_time(finished: Path) -> None:
    with open_history(finished) as history:
        rows = history.evaluations()
    assert rows.origin[0] == ORIGIN["baseline"]
    assert np.count_nonzero(rows.origin == ORIGIN["elite"]) == 2 * 5
    assert rows.parents.shape == (len(rows), 2)
    # Parents are stated as rows, not as slots.
    assert list(rows.parents[2 * POPULATION]) == [POPULATION, POPULATION + 1]
    assert list(rows.parents[0]) == [-1, -1]
    done = rows.done
    assert set(done.worker) == {1, 2}
    assert set(done.attempt) == {1}
    assert done.seconds[0] == 0.25


def test_the_best_plant_is_that_of_the_finals(finished: Path) -> None:
    with open_history(finished) as history:
        pair = history.comparison()
        assert history.best() is not None
        luckiest = history.evaluations().done.objectives.max()
        finalists = history.finalists()
    assert pair is not None and pair.is_final
    assert list(finalists.slot) == list(range(FINALISTS))
    assert pair.best.row.slot == [2]
    assert pair.best.objective.mean == final_absorbed(2) < luckiest
    assert pair.best.objective.standard_error == ERROR / 4
    assert pair.baseline.objective.mean == final_absorbed(0)
    genes = pair.baseline.row.genome[0]
    assert np.array_equal(genes, baseline_genome())


def test_the_gain_has_a_paired_standard_error(finished: Path) -> None:
    with open_history(finished) as history:
        pair = history.comparison()
    assert pair is not None and pair.is_paired
    draws = [
        randomisations(final_absorbed(slot), ERROR / 4, 16, 999, slot)
        for slot in (0, 2)
    ]
    assert pair.gain.mean == pytest.approx(1.5)
    assert pair.gain.unit == "%"
    for gain, factor, scale in (
        (pair.difference, 1.0, 1.0),
        (pair.gain, 1.015, 100 / BASELINE),
        (pair.gain_per_leaf_area, 1.015, 100 / BASELINE),
    ):
        each = draws[1] - factor * draws[0]
        expected = scale * each.std(ddof=1) / np.sqrt(16)
        assert gain.standard_error == pytest.approx(expected)
    apart = ERROR / 4 * math.hypot(1, 1)
    assert pair.difference.standard_error < 0.5 * apart


def test_without_common_randomisations_errors_are_independent(
    drained: Path,
) -> None:
    with open_history(drained) as history:
        # The pair consists of the baseline of generation 0 and the best plant
        # of generation 1.
        pair = history.comparison()
    assert pair is not None and not pair.is_paired
    expected = math.hypot(ERROR, ERROR)
    assert pair.difference.standard_error == pytest.approx(expected)


def test_rows_are_ranked_by_failure_violation_and_objective(
    tmp_path: Path,
) -> None:
    for sense, better in (("maximise", 3), ("minimise", 1)):
        path = tmp_path / f"{sense}.h5"
        made = MadeHistory(path, objectives=[("absorbed_par", sense)])
        made.propose(0)
        for slot in range(6):
            (made.fail if slot == 5 else made.record)(0, slot)
        rows = made.file["evaluations"]
        rows["objectives"][:5, 0] = [9.0, -2.0, 0.5, 4.0, -9.0]
        # A constraint violation takes precedence over all objectives.
        rows["violation"][:5] = [0.3, 0.0, 0.0, 0.0, 0.1]
        made.close()
        with open_history(path) as history:
            evaluations = history.evaluations()
            best = history.best()
        assert list(evaluations.ranking(9)) == [better, 2, 4 - better, 4, 0]
        assert best is not None and best.row.row == [better]
        assert np.isnan(evaluations.violation[5])


def test_generations_may_differ_in_size(tmp_path: Path) -> None:
    made = MadeHistory(tmp_path / "sizes.h5")
    made.evolve(3)
    made.close()
    with h5py.File(tmp_path / "sizes.h5", "r+") as file:
        # The last two rows of generation 1 now belong to generation 2.
        file["generations/count"][:3] = [12, 10, 14]
        file["generations/first_row"][2] = 22
        seal(file)
    with open_history(tmp_path / "sizes.h5") as history:
        rows = history.evaluations()
        assert [len(history.evaluations(g)) for g in range(4)] == [
            12,
            10,
            14,
            0,
        ]
    assert list(np.bincount(rows.generation)) == [12, 10, 14]
    assert list(rows.slot[20:24]) == [8, 9, 0, 1]


def test_before_the_finals_the_best_plant_is_that_of_the_last_generation(
    drained: Path,
) -> None:
    with open_history(drained) as history:
        pair = history.comparison()
    assert pair is not None and not pair.is_final
    assert pair.best.objective.mean == absorbed(1, POPULATION - 1)
    assert pair.baseline.objective.mean == absorbed(0, 0)


def test_incomplete_finals_do_not_count(writer: WriterProcess) -> None:
    writer.do("evolve 1")
    writer.do("propose_final")
    with open_history(writer.path) as history:
        for slot in range(FINALISTS):
            pair = history.comparison()
            assert pair is not None and not pair.is_final
            assert len(history.finalists()) == slot
            writer.do(f"record_final {slot}")
        pair = history.comparison()
        assert pair is not None and pair.is_final


def test_an_empty_history_has_no_comparison(writer: WriterProcess) -> None:
    with open_history(writer.path) as history:
        assert history.best() is None
        assert history.baseline() is None
        assert history.comparison() is None
        assert len(history.evaluations()) == len(history.generations()) == 0
        assert history.evaluations()["absorbed_par"].values.shape == (0,)


def test_a_history_of_failed_rows_has_no_best_plant(
    writer: WriterProcess,
) -> None:
    writer.do("propose 0")
    for slot in range(POPULATION):
        writer.do(f"fail 0 {slot}")
    with open_history(writer.path) as history:
        assert len(history.evaluations().failed) == POPULATION
        assert history.best() is None


def test_light_by_hour_has_an_axis(finished: Path) -> None:
    with open_history(finished) as history:
        profile = history.best().profile("absorbed_by_hour")
    assert list(profile.labels) == HOURS
    assert profile.unit == "W m-2"
    total = final_absorbed(2)
    expected = [hour_par(total, hour) for hour in HOURS]
    assert profile.values == pytest.approx(expected)
    error = np.array(expected) * ERROR / 4 / total
    assert profile.standard_error == pytest.approx(error)


def test_light_by_leaf_has_an_axis(finished: Path) -> None:
    with open_history(finished) as history:
        best = history.best()
    light = best.profile("absorbed_by_leaf")
    assert list(light.labels) == list(range(1, 11))
    expected = [leaf_share(n) * final_absorbed(2) for n in range(1, 11)]
    assert light.values == pytest.approx(expected)
    assert light.values.sum() == pytest.approx(best.objective.mean, rel=1e-12)
    for name in ("nothing", "lai"):
        with pytest.raises(HistoryError, match=f"has no {name}"):
            best.profile(name)


def test_the_error_for_a_misspelt_name_suggests_the_nearest(
    finished: Path,
) -> None:
    with open_history(finished) as history:
        best, rows = history.best(), history.finalists()
    meant = "did you mean 'absorbed_by_leaf'"
    with pytest.raises(HistoryError, match=meant):
        best.profile("absorbed_by_laef")
    with pytest.raises(HistoryError, match="did you mean 'absorbed_fraction'"):
        best.estimate("absorbed_fracton")
    with pytest.raises(KeyError, match="did you mean 'lai'"):
        rows["lais"]
    with pytest.raises(KeyError, match="is called nothing'"):
        rows["nothing"]


def test_the_best_plants_are_distinct_and_sorted(finished: Path) -> None:
    with open_history(finished) as history:
        latest = history.latest()
    top = latest.top(10)
    # Slot 5 failed, so that the fittest ten of the twelve plants are in slots
    # 11 ... 6 and 4 ... 1.
    assert list(top.slot) == [11, 10, 9, 8, 7, 6, 4, 3, 2, 1]
    assert len(latest.top(100)) == POPULATION - 1
    twice = latest.take(np.array([3, 11, 3, 11, 7]))
    assert list(twice.top(10).slot) == [11, 7, 3]


def test_genes_have_bounds_and_circular_ones_are_marked(
    finished: Path,
) -> None:
    with open_history(finished) as history:
        genes = history.genes
    columns = genes.columns("azimuth")
    assert list(columns) == list(range(3, 40, 4))
    assert list(genes.leaves[columns]) == list(range(1, 11))
    assert list(np.flatnonzero(genes.is_circular)) == list(columns)
    assert set(genes.upper[genes.columns("width")]) == {0.14}
    assert genes.is_free.all()


def test_texts_of_a_history_are_read_as_written(finished: Path) -> None:
    with open_history(finished) as history:
        assert history.attributes["seed"] == 2**63 + 1
        assert history.attributes["latitude"] == 42.0
        assert history.messages() == ["Zeit für Licht"]
        assert history.campaign() == 'name = "made" # source'
        assert history.campaign("resolved").endswith("resolved")
        (session,) = history.sessions()
    assert (session.host, session.ranks) == ("node1", 3)
    assert session.libraries == "HDF5 1.10.8"
    assert session.started == "2025-08-07T12:00:00Z"
