"""What a history says."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from conftest import WriterProcess
from ideotype_analysis import open_history
from made_numbers import (
    BASELINE,
    DIAGNOSTICS,
    ERROR,
    FINALISTS,
    HOURS,
    INCIDENT,
    ORIGIN,
    POPULATION,
    TRAITS,
    absorbed,
    baseline_genome,
    final_absorbed,
    genome,
    hour_par,
    leaf_share,
)


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
    assert list(generations.best_slot) == [last, last]
    best = [absorbed(0, last), absorbed(1, last)]
    assert generations.best.values == pytest.approx(best, rel=1e-15)
    assert list(generations.best.standard_error) == [ERROR, ERROR]
    # slot 5 of generation 1 failed
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
    assert np.all(np.isnan(failed.diagnostics.values))
    assert np.all(failed.fitness.values == -np.inf)
    assert np.all(np.isfinite(failed.traits.values))


def test_columns_are_found_by_name_and_know_their_unit(
    finished: Path,
) -> None:
    with open_history(finished) as history:
        rows = history.evaluations(2)
    par = rows["absorbed_par"]
    expected = [absorbed(2, s) for s in range(POPULATION)]
    assert (par.unit, list(par.values)) == ("MJ m-2 day-1", expected)
    assert list(par.standard_error) == [ERROR] * POPULATION
    for name, unit in DIAGNOSTICS:
        assert rows[name].unit == unit
    for name, unit, *_ in TRAITS:
        assert rows[name].unit == unit
    genes = np.array([genome(2, s) for s in range(POPULATION)])
    assert np.array_equal(rows.traits.values, genes)
    width = rows["leaf07_width"].values
    assert np.array_equal(width, genes[:, 6 * 4 + 1])
    assert rows["incident"].values == pytest.approx(INCIDENT)
    with pytest.raises(KeyError, match="biomass"):
        rows["biomass"]


def test_rows_keep_their_descent_and_cost(finished: Path) -> None:
    with open_history(finished) as history:
        rows = history.evaluations()
    assert rows.origin[0] == ORIGIN["baseline"]
    assert np.count_nonzero(rows.origin == ORIGIN["elite"]) == 2 * 5
    assert rows.parents.shape == (len(rows), 2)
    done = rows.done
    assert set(done.worker) == {1, 2}
    assert set(done.attempt) == {1}
    assert (rows.seconds.unit, done.seconds.values[0]) == ("s", 0.25)


def test_finals_decide_over_the_luckiest_of_the_run(finished: Path) -> None:
    with open_history(finished) as history:
        pair = history.comparison()
        assert history.best() is not None
        luckiest = history.evaluations().done.fitness.values.max()
        finalists = history.finalists()
    assert pair is not None and pair.is_final
    assert list(finalists.slot) == list(range(FINALISTS))
    assert pair.best.row.slot == [2]
    assert pair.best.objective.mean == final_absorbed(2) < luckiest
    assert pair.best.objective.standard_error == ERROR / 4
    assert pair.baseline.objective.mean == final_absorbed(0)
    genes = pair.baseline.row.traits.values[0]
    assert np.array_equal(genes, baseline_genome())


def test_gain_has_the_error_of_a_ratio(finished: Path) -> None:
    with open_history(finished) as history:
        pair = history.comparison()
    assert pair is not None
    assert pair.gain.mean == pytest.approx(1.5)
    expected = 100 * ERROR / 4 / BASELINE * math.hypot(1, 1.015)
    assert pair.gain.standard_error == pytest.approx(expected)
    assert pair.gain.unit == "%"


def test_before_the_finals_the_last_complete_generation_decides(
    drained: Path,
) -> None:
    with open_history(drained) as history:
        pair = history.comparison()
    assert pair is not None and not pair.is_final
    assert pair.best.objective.mean == absorbed(1, POPULATION - 1)
    assert pair.baseline.objective.mean == absorbed(0, 0)


def test_incomplete_finals_decide_nothing(writer: WriterProcess) -> None:
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


def test_an_empty_history_compares_nothing(writer: WriterProcess) -> None:
    with open_history(writer.path) as history:
        assert history.best() is None
        assert history.baseline() is None
        assert history.comparison() is None
        assert len(history.evaluations()) == len(history.generations()) == 0
        assert history.evaluations()["absorbed_par"].values.shape == (0,)


def test_all_failed_leaves_no_best(writer: WriterProcess) -> None:
    writer.do("propose 0")
    for slot in range(POPULATION):
        writer.do(f"fail 0 {slot}")
    with open_history(writer.path) as history:
        assert len(history.evaluations().failed) == POPULATION
        assert history.best() is None


def test_hours_are_parsed_and_in_order(finished: Path) -> None:
    with open_history(finished) as history:
        profile = history.best().by_hour()
    assert list(profile.hours) == HOURS
    assert profile.unit == "W m-2"
    total = final_absorbed(2)
    expected = [hour_par(total, hour) for hour in HOURS]
    assert profile.values == pytest.approx(expected)
    error = np.array(expected) * ERROR / 4 / total
    assert profile.standard_error == pytest.approx(error)


def test_leaves_are_parsed_and_in_order(finished: Path) -> None:
    with open_history(finished) as history:
        best = history.best()
    light = best.by_leaf()
    assert list(light.leaves) == list(range(1, 11))
    expected = [leaf_share(n) * final_absorbed(2) for n in range(1, 11)]
    assert light.values == pytest.approx(expected)
    assert light.values.sum() == pytest.approx(best.objective.mean, rel=1e-12)
    lengths = best.by_leaf("length")
    assert lengths.unit == "m"
    assert np.array_equal(lengths.values, best.row.traits.values[0, ::4])
    assert len(best.by_leaf("nothing").leaves) == 0


def test_the_top_are_different_plants_best_first(finished: Path) -> None:
    with open_history(finished) as history:
        latest = history.latest()
    top = latest.top(10)
    # slot 5 failed, so that of twelve the fittest ten are 11 ... 6, 4 ... 1
    assert list(top.slot) == [11, 10, 9, 8, 7, 6, 4, 3, 2, 1]
    assert len(latest.top(100)) == POPULATION - 1
    twice = latest.take(np.array([3, 11, 3, 11, 7]))
    assert list(twice.top(10).slot) == [11, 7, 3]


def test_traits_have_bounds_and_know_the_circle(finished: Path) -> None:
    with open_history(finished) as history:
        traits = history.traits
    columns = traits.columns("azimuth")
    assert list(columns) == list(range(3, 40, 4))
    assert list(traits.leaves("azimuth")) == list(range(1, 11))
    assert list(np.flatnonzero(traits.is_circular)) == list(columns)
    assert set(traits.upper[traits.columns("width")]) == {0.14}
    assert traits.is_free.all()


def test_text_comes_back_as_written(finished: Path) -> None:
    with open_history(finished) as history:
        assert history.attributes["seed"] == 2**63 + 1
        assert history.attributes["latitude"] == 42.0
        assert history.messages() == ["Zeit für Licht"]
        assert history.campaign() == 'name = "made" # source'
        assert history.campaign("resolved").endswith("resolved")
        (session,) = history.sessions()
    assert (session.host, session.ranks) == ("node1", 3)
    assert session.started == "2025-08-07T12:00:00Z"
