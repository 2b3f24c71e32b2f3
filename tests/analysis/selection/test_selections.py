# SPDX-License-Identifier: Apache-2.0
"""Selections in campaigns: plants of lines, gradients, resuming, files."""

from __future__ import annotations

import csv
import math
import re
import sqlite3
import subprocess
import sys
from contextlib import closing
from pathlib import Path
from time import sleep

import numpy as np
import pandas as pd
import pytest

import ideotype
from ideotype import Error
from ideotype.common.output import OutputRefused
from ideotype.selection import (
    Advice,
    Field,
    Options,
    Plan,
    Population,
    Store,
    Surface,
    make_trial,
    read_lines,
    select,
    write_selection,
)
from ideotype.selection.index import make_index
from ideotype.selection.reach import find_reach, set_targets
from ideotype.selection.results import COLUMNS
from ideotype.selection.surface import explore, paired_difference
from ideotype.tools.select import STORE, main

TOP = Path(__file__).parents[3]
PANEL = TOP / "campaigns/lines/maize_panel.toml"
QUICK = TOP / "campaigns/quickstart.toml"

SMALL = Options(
    plan=Plan(cycles=1, lines=9, parents=3, crosses=3, untested=3),
    repeats=1,
    draws=2,
    line_draws=1,
)


@pytest.fixture(scope="module")
def panel() -> Population:
    return read_lines(PANEL, count=281, draws=50)


@pytest.fixture(scope="module")
def angles(panel: Population) -> Population:
    """The two angles and the height alone."""
    return panel.select([2, 3, 4])


class Made:
    """A field with a known objective instead of traced light."""

    cases = ("made",)

    def __init__(
        self, gradient: np.ndarray, curvature: np.ndarray, centre: np.ndarray
    ) -> None:
        self.gradient, self.curvature, self.centre = (
            gradient, curvature, centre,
        )  # fmt: skip

    def evaluate(
        self, plants: np.ndarray, draws: int = 1, **_: object
    ) -> np.ndarray:
        apart = np.atleast_2d(plants) - self.centre
        value = 50 + apart @ self.gradient
        value += np.einsum("ki,ij,kj->k", apart, self.curvature, apart) / 2
        noise = np.random.default_rng(1).normal(0, 1, 4 * draws)
        return np.asarray(value[:, None, None] + noise)


def test_plants_of_mean_lines_are_at_distance_zero_from_the_lines(
    panel: Population, tmp_path: Path
) -> None:
    """The program measures the distance of the plant in crop files."""
    field = Field(QUICK, panel.traits)
    stand = field.stands[0]

    def distance(name: str, values: np.ndarray) -> float:
        path = tmp_path / name
        path.write_text(stand.crop_file(field.genome(values)))
        lines = ideotype.Stand.from_campaign(
            QUICK,
            settings={
                "feasibility.lines": str(PANEL),
                "plant.baseline": str(path),
            },
        )
        found = lines.evaluate(
            lines.baseline, ["distance_from_lines"], tolerance=0.05
        )
        return float(found["distance_from_lines"].item())

    assert distance("mean.toml", panel.mean) < 0.02
    step = panel.deviation * np.eye(7)[3]
    inverse = np.linalg.inv(panel.genetic)
    expected = math.sqrt(step @ inverse @ step)
    assert distance("angle.toml", panel.mean + step) == pytest.approx(
        expected, rel=0.1
    )
    moved = stand.leaves(field.genome(panel.mean + step))
    assert moved.insertion_angle[9] == pytest.approx(45.1)
    assert moved.insertion_angle[6] == pytest.approx(28.0)


def test_gradients_of_a_quadratic_objective_are_exact(
    angles: Population,
) -> None:
    gradient = np.array([0.5, -0.3, 4.0])
    curvature = np.array([[-0.02, 0.01, 0], [0.01, 0.03, 0.2], [0, 0.2, -9]])
    field = Made(gradient, curvature, angles.mean)
    surface = explore(field, angles, draws=2)  # type: ignore[arg-type]
    percent = 100 / field.evaluate(angles.mean).mean()
    near = 100 / surface.objective.mean()
    assert surface.gradient == pytest.approx(near * gradient)
    assert surface.curvature == pytest.approx(near * curvature, abs=1e-6)
    assert surface.gradient_standard_error.max() < 1e-9 * percent
    # Far from the lines nothing is gained by going further.
    far, farther = (
        angles.mean + size * angles.deviation * [1, 0, 0] for size in (2, 5)
    )
    assert surface.value(far) == pytest.approx(surface.value(farther))
    assert surface.slope(farther)[0] == 0 != surface.slope(far)[0]


def test_targets_lose_one_per_cent_at_their_ends(angles: Population) -> None:
    step = angles.deviation
    curvature = np.diag([-2.0, -1.0, -0.5]) / step**2
    field = Made(np.zeros(3), curvature, angles.mean)
    table = set_targets(field, angles, angles.mean, draws=1)  # type: ignore[arg-type]
    objective = field.evaluate(angles.mean).mean()
    for bend, row in zip([2, 1, 0.5], table.itertuples()):
        distance = np.sqrt(2 * objective / 100 / bend)
        i = row.Index
        factor = angles.traits[i].factor
        assert row.highest == pytest.approx(
            factor * (angles.mean[i] + distance * step[i])
        )
        assert row.lowest < row.target < row.highest


def test_differences_are_paired_and_positive_for_improvements() -> None:
    noise = np.random.default_rng(1).normal(0, 1, (2, 50))
    gain, error = paired_difference(11 + noise, 10 + noise)
    assert gain == pytest.approx(100 / (10 + noise.mean()))
    unpaired = 100 * np.sqrt(2) * noise.mean(axis=0).std() / 10 / np.sqrt(50)
    assert 0 < error < unpaired / 4
    assert paired_difference(-9 - noise, -10 - noise)[0] > 0


def test_useless_traits_are_left_alone(angles: Population) -> None:
    step = angles.deviation
    independent = Population(
        **{
            **{f: getattr(angles, f) for f in angles.__dataclass_fields__},
            "genetic": np.diag(step**2),
            "draws": np.empty((0, 3, 3)),
        }
    )
    slopes = np.array([2.0, 0.0, -2.0]) / step
    noise = np.random.default_rng(2).normal(0, 0.02, (1, 40, 3)) / step
    surface = Surface(
        angles.mean, step, np.ones((1, 40)), slopes + noise,
        np.zeros((1, 40, 3, 3)),
    )  # fmt: skip
    index = make_index(
        independent, surface, plots=2, strength=1.7, case="mean"
    )
    assert index.advice == (Advice.more, Advice.alone, Advice.less)
    assert index.gain > index.base_gain * 0.99
    assert abs(index.lost_without[1]) < 0.01 < index.lost_without[0]


@pytest.fixture(scope="module")
def trial(tmp_path_factory: pytest.TempPathFactory, panel: Population) -> Path:
    path = tmp_path_factory.mktemp("made") / "trial.csv"
    table = make_trial(panel, 12, 2, 3)
    table.iloc[:, [0, 1, 2, 5, 6]].to_csv(path, index=False)
    return path


WORDS = [
    *("--cycles", "1", "--tested", "9", "--parents", "3", "--crosses", "3"),
    *("--untested", "3", "--repeats", "1", "--draws", "1"),
    *("--line-draws", "1", "--tolerance", "0.05"),
]


def words(trial: Path, folder: Path) -> list[str]:
    return [str(QUICK), "--trial", str(trial), "-o", str(folder), *WORDS]


def run(trial: Path, folder: Path, *more: str) -> int:
    return main([*words(trial, folder), *more])


@pytest.fixture(scope="module")
def done(trial: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("select") / "out"
    assert run(trial, folder, "--threads", "1") == 0
    return folder


def test_columns_of_all_tables_are_documented(done: Path) -> None:
    cases = r"gain_bondville\w*"
    for path in done.glob("*.csv"):
        if path.stem == "columns":
            continue
        with path.open() as file:
            names = next(csv.reader(file))
        known = COLUMNS[path.stem]
        for name in names:
            is_trait = path.stem == "programme" and re.search(r"\[.*\]$", name)
            assert name in known or re.fullmatch(cases, name) or is_trait
    assert {path.stem for path in done.glob("*.csv")} == {*COLUMNS, "columns"}


def count_rows(store: Path) -> int:
    """Returns the number of evaluations in a store, 0 if there is none yet."""
    if not store.is_file():
        return 0
    with closing(sqlite3.connect(store)) as file:
        try:
            (count,) = file.execute(
                "SELECT count(*) FROM evaluation"
            ).fetchone()
        except sqlite3.OperationalError:  # Its table is not there yet.
            return 0
    return int(count)


def test_a_killed_selection_resumes_to_the_same_bits(
    trial: Path, done: Path, tmp_path: Path
) -> None:
    """It is killed after some evaluations; another number of threads evaluates
    the rest."""
    folder = tmp_path / "out"
    whole = count_rows(done / STORE)
    command = [sys.executable, "-m", "ideotype.tools.select"]
    with subprocess.Popen(
        [*command, *words(trial, folder), "--threads", "2"],
        stdout=subprocess.DEVNULL,
    ) as process:
        while process.poll() is None and count_rows(folder / STORE) < 20:
            sleep(0.01)
        process.kill()
    kept = count_rows(folder / STORE)
    assert 20 <= kept < whole
    assert not (folder / "selection.md").exists()
    assert run(trial, folder, "--threads", "3") == 0
    assert count_rows(folder / STORE) == whole
    for path in done.glob("*.csv"):
        assert path.read_bytes() == (folder / path.name).read_bytes()


def test_folders_of_other_selections_are_refused(
    trial: Path, done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = {path: path.read_bytes() for path in done.iterdir()}
    assert run(trial, done, "--seed", "2") == 4
    assert "selection of another trial" in capsys.readouterr().err
    assert before == {path: path.read_bytes() for path in done.iterdir()}
    (tmp_path / "letter.txt").write_text("mine")
    assert run(trial, tmp_path) == 4


def test_wrong_inputs_have_messages(
    trial: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path / "none.csv", tmp_path / "a") == 3
    assert "there is no such file" in capsys.readouterr().err
    assert run(trial, tmp_path / "b", "--set", "light.path=3") == 3
    assert "light.path" in capsys.readouterr().err


def test_campaigns_without_the_plants_of_lines_are_refused(
    panel: Population,
) -> None:
    campaigns = TOP / "campaigns"
    with pytest.raises(Error, match="several sets of traits"):
        Field(campaigns / "trait_sets.toml", panel.traits)
    with pytest.raises(Error, match="has no tassel_spike.length"):
        Field(campaigns / "sorghum.toml", panel.traits)
    settings = {
        "objective.maximise": ["absorbed_par", "carbon_balance"],
        "search.optimizer": "nsga2",
    }
    with pytest.raises(Error, match="several objectives; choose one"):
        Field(QUICK, panel.traits, settings=settings)


def test_a_store_refuses_files_of_other_kinds(tmp_path: Path) -> None:
    path = tmp_path / "evaluations.sqlite"
    path.write_text("no database, but some text that is long enough")
    with pytest.raises(OutputRefused, match="choose another folder"):
        Store(path)


def test_lines_and_history_give_a_ceiling(
    panel: Population, tmp_path: Path
) -> None:
    """The best plant of a file, here the crop itself, is the ceiling."""
    few = panel.select([3, 4])
    field = Field(
        QUICK, few.traits, tolerance=0.05, settings={"final.randomisations": 4}
    )
    found = select(
        few, field, SMALL, history=TOP / "campaigns/crops/maize.toml"
    )
    reach = found.reaches["index"]
    assert np.isfinite([reach.ceiling, reach.ceiling_standard_error]).all()
    assert f"more than the {reach.ceiling:.1f} ±" in reach.sentence()
    paths = write_selection(found, tmp_path)
    assert tmp_path / "reach.png" in paths
    assert "lines" not in found.tables
    targets = pd.read_csv(tmp_path / "targets.csv")
    assert targets["unit"].tolist() == ["deg", "cm"]


def test_quadratic_values_state_their_error(
    trial: Path, tmp_path: Path
) -> None:
    assert run(trial, tmp_path / "out", "--values", "quadratic") == 0
    page = (tmp_path / "out/selection.md").read_text()
    assert "it differs from traced light by at most" in page
    programme = pd.read_csv(tmp_path / "out/programme.csv")
    assert set(programme["method"]) == {"yield", "index", "genomic"}
    assert programme["cycle"].max() == 1


def test_sentences_compare_the_programme_with_the_ideotype() -> None:
    def sentence(ceiling: float) -> str:
        runs = pd.DataFrame(
            {
                "method": "index",
                "repeat": [0, 0, 0, 1, 1, 1],
                "cycle": [0, 1, 2, 0, 1, 2],
                "gain": [0, 2, 3, 0, 2, 3.2],
            }
        )
        return find_reach(runs, "index", (ceiling, 0.5)).sentence()

    # Student's interval of two programmes is 12.7 standard errors of 0.1.
    assert sentence(8).startswith(
        "Standing variation gives 3.1 ± 1.3 of 8.00 ± 0.98 points in 2 "
        "cycles (half of that is not reached in 2 cycles); the rest needs"
    )
    assert "(half of that takes 1.5 cycles); the rest" in sentence(5.1)
    assert "more than the 2.00 ± 0.98 % of the ideotype" in sentence(2)
    assert "there is no ideotype" in sentence(math.nan)
