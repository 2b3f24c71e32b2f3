# SPDX-License-Identifier: Apache-2.0
"""Several histories are read together."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
from conftest import SHIFTS, WriterProcess
from made_history import MadeHistory
from made_numbers import BASELINE, POPULATION, absorbed, final_absorbed

from ideotype.history import Estimate, HistoryError, open_study
from ideotype.history.interval import interval


@pytest.mark.parametrize("pattern", ["", "*.h5", "ames*_r?.h5"])
def test_a_folder_or_a_pattern_is_opened(sweep: Path, pattern: str) -> None:
    with open_study(sweep / pattern) as study:
        names = [history.path.name for history in study]
    assert names == sorted(names)
    assert len(names) == (2 if pattern.startswith("ames") else 4)


def test_a_file_that_is_named_twice_is_opened_once(sweep: Path) -> None:
    first = min(sweep.iterdir())
    with open_study(first, str(sweep)) as study:
        assert len(study) == 4
        assert study[0].path == first


def test_the_error_names_an_unusable_file_and_a_remedy(
    sweep: Path, tmp_path: Path
) -> None:
    with pytest.raises(HistoryError, match=r"no history .*--out"):
        open_study(tmp_path)
    with pytest.raises(HistoryError, match=r"none\*\.h5: no file matches"):
        open_study(tmp_path / "none*.h5")
    with pytest.raises(
        FileNotFoundError, match="none.h5: there is no such file"
    ):
        open_study(tmp_path / "none.h5")
    good = min(sweep.iterdir())
    shutil.copy(good, tmp_path / "good.h5")
    data = good.read_bytes()
    (tmp_path / "short.h5").write_bytes(data[: len(data) // 2])
    with pytest.raises(
        HistoryError, match=r"short\.h5: this history was cut short"
    ):
        open_study(tmp_path)


def test_replicates_make_a_case(sweep: Path) -> None:
    with open_study(sweep) as study:
        cases = study.cases()
        assert [case.name for case in cases] == [
            "ames_0807_762x152_all",
            "edmonton_0807_762x152_all",
        ]
        assert [len(case.histories) for case in cases] == [2, 2]
        best = cases[0].best_history.attributes["replicate"]
    assert best == 1 + np.argmax(SHIFTS)


def test_cases_of_different_campaigns_are_distinct(tmp_path: Path) -> None:
    for campaign in ("one", "two"):
        place = {"campaign": campaign}
        MadeHistory(tmp_path / f"{campaign}.h5", attributes=place).close()
    with open_study(tmp_path) as study:
        names = [case.name for case in study.cases()]
    assert names == [f"{c}: ames_0807_762x152_all" for c in ("one", "two")]


def test_histories_with_other_objectives_or_optimizers_are_other_cases(
    tmp_path: Path,
) -> None:
    light, area = ("absorbed_par", "maximise"), ("lai", "minimise")
    kinds = [
        ([light], "ga"), ([light], "cma_es"), ([light, area], "nsga2"),
        ([light], "ga"),
    ]  # fmt: skip
    for i, (objectives, optimizer) in enumerate(kinds):
        text = f'[search]\noptimizer = "{optimizer}"'
        path = tmp_path / f"{i}.h5"
        MadeHistory(path, objectives=objectives, resolved=text).close()
    with open_study(tmp_path) as study:
        counts = {case.name: len(case.histories) for case in study.cases()}
        lights = {case.light for case in study.cases()}
    name = "ames_0807_762x152_all"
    assert counts == {
        f"{name} (absorbed_par; ga)": 2,
        f"{name} (absorbed_par; cma_es)": 1,
        f"{name} (absorbed_par, less lai; nsga2)": 1,
    }
    assert lights == {name}


def test_the_interval_of_the_gain_is_from_its_seeds(sweep: Path) -> None:
    with open_study(sweep) as study:
        gain = study.cases()[0].gain()
    seeds = np.array([final_absorbed(2) - BASELINE + s for s in SHIFTS])
    assert gain.mean == pytest.approx(seeds.mean())
    # The interval is Student's t with one degree of freedom.
    half = 12.7062 * seeds.std(ddof=1) / np.sqrt(2)
    assert (gain.below, gain.above) == pytest.approx((half, half), rel=1e-5)
    assert (gain.unit, gain.seeds) == ("MJ m-2 day-1", 2)


def test_seeds_that_agree_by_chance_keep_their_measured_error() -> None:
    same = [Estimate(1.0, 0.1)] * 4
    assert interval(same).below == pytest.approx(1.96 * 0.1 / 2)
    assert interval(same[:1]).below == pytest.approx(1.96 * 0.1)


def test_the_interval_has_the_t_quantile_of_the_number_of_seeds() -> None:
    seeds = [Estimate(float(x), 0.0) for x in range(61)]
    scatter = np.arange(61).std(ddof=1) / np.sqrt(61)
    # The quantile is Student's t with 60 degrees of freedom (NIST/SEMATECH,
    # table 1.3.6.7.2).
    assert interval(seeds).below == pytest.approx(
        2.000 * scatter, abs=5e-4 * scatter
    )


def test_intervals_of_gains_have_95_percent_coverage() -> None:
    draw = np.random.default_rng(1)
    runs = 4000
    hits = 0
    for _ in range(runs):
        seeds = [Estimate(x, 0.0) for x in draw.normal(size=3)]
        found = interval(seeds)
        hits += found.low <= 0 <= found.high
    # The tolerance is four standard errors of a frequency of 0.95.
    assert abs(hits / runs - 0.95) < 4 * np.sqrt(0.95 * 0.05 / runs)


def test_a_saturated_case_is_distinguished_from_one_with_headroom(
    sweep: Path, tmp_path: Path
) -> None:
    with open_study(sweep) as study:
        case = study.cases()[0]
        room = case.headroom()
        stalk, soil, incident = (
            case.best.estimate(name).mean
            for name in ("stalk_fraction", "soil_fraction", "incident")
        )
        assert not case.is_saturated()
    assert room.mean == pytest.approx(incident * (stalk + soil))
    # The leaves absorb so much that stalks and soil absorb less than the
    # standard error.
    path = tmp_path / "full.h5"
    made = MadeHistory(path, shift=12.2 - 0.001 - final_absorbed(2))
    made.evolve(1)
    made.finish()
    made.close()
    with open_study(path) as study:
        assert study.cases()[0].is_saturated()


def test_studies_cases_and_histories_have_a_repr(sweep: Path) -> None:
    with open_study(sweep) as study:
        assert repr(study) == "<Study, histories: 4>"
        assert (
            repr(study.cases()[0]) == "<Case ames_0807_762x152_all, seeds: 2>"
        )
        assert repr(study[0]) == f"<History {study[0].path}>"


def test_an_isolated_plot_has_no_ceiling(tmp_path: Path) -> None:
    path = tmp_path / "plot.h5"
    made = MadeHistory(path, resolved='[field]\nboundary = "isolated"')
    made.evolve(1)
    made.finish()
    made.close()
    with open_study(path) as study:
        (case,) = study.cases()
        assert case.is_isolated and study[0].is_isolated
        with pytest.raises(
            HistoryError, match="receives light from the sides"
        ):
            case.is_saturated()


def test_the_frame_has_every_evaluation_with_units(sweep: Path) -> None:
    with open_study(sweep) as study:
        frame = study.frame()
    assert len(frame) == 4 * 6 * POPULATION
    units = frame.attrs["units"]
    assert units["absorbed_par"] == "MJ m-2 day-1"
    assert units["absorbed_par_standard_error"] == "MJ m-2 day-1"
    assert units["leaf03_azimuth"] == "deg" and units["latitude"] == "deg"
    assert set(units) == set(frame.columns)
    row = frame.query(
        "site == 'edmonton' and replicate == 2 and generation == 3 and slot == 7"
    )
    assert row["absorbed_par"].item() == absorbed(3, 7) + SHIFTS[1]
    failed = frame[frame["status"] == "failed"]
    assert len(failed) == 4 * 3
    assert failed["absorbed_par"].isna().all()


def test_histories_with_other_columns_share_a_frame(
    sweep: Path, finished: Path
) -> None:
    with open_study(sweep, finished) as study:
        frame = study.frame()
    lacks = frame["campaign"] == "made"
    assert lacks.sum() == 6 * POPULATION
    assert frame.loc[lacks, "absorbed_by_layer 0.125"].isna().all()
    assert frame.loc[~lacks & (frame["status"] == "done")].notna().all().all()


def test_results_of_a_live_study_are_provisional(
    writer: WriterProcess,
) -> None:
    with open_study(writer.path) as study:
        (case,) = study.cases()
        assert case.pairs == ()
        with pytest.raises(HistoryError, match="not evaluated yet"):
            case.gain()
    writer.do("evolve 1")
    with open_study(writer.path) as study:
        (case,) = study.cases()
        assert len(case.pairs) == 1 and not case.is_final
