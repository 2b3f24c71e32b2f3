# SPDX-License-Identifier: Apache-2.0
"""The public benchmark: its scorer, its two methods and its theory agree."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from types import ModuleType

import pytest

FOLDER = Path(__file__).parents[3] / "analysis" / "benchmark"
NAMES = (
    "answers",
    "cases",
    "leaf",
    "meshes",
    "plain",
    "program",
    "score",
    "theory",
)


@pytest.fixture(scope="module")
def benchmark() -> ModuleType:
    """Provides the modules of the benchmark, which are scripts outside of any
    package."""
    before = list(sys.path)
    sys.path[:0] = [str(FOLDER), str(FOLDER / "adapters")]
    try:
        benchmark = ModuleType("benchmark")
        for name in NAMES:
            setattr(benchmark, name, __import__(name))
        yield benchmark
    finally:
        sys.path[:] = before
        for name in NAMES:
            sys.modules.pop(name, None)


def write(path: Path, *rows: str, header: str = "") -> Path:
    header = header or "case,quantity,value,standard_error"
    path.write_text("\n".join([header, *rows]) + "\n")
    return path


def test_answers_are_scored(benchmark: ModuleType, tmp_path: Path) -> None:
    score = benchmark.score
    values = {
        ("a", "soil"): (0.5, 0.0),
        ("a", "reflected"): (0.001, 0.0),
        ("b", "leaf"): (20.0, 0.3),
        ("b", "net"): (40.0, 0.0),
    }
    answers = score.read(
        write(
            tmp_path / "a.csv",
            "a,soil,0.51,0.005",
            "a,reflected,0.002,",
            "b,leaf,21,0.4",
        )
    )
    scores = score.score(values, answers, {"a": "black", "b": "energy"})
    assert list(scores) == ["black", "energy", "all"]
    # Errors of small values are relative to a hundredth of the total light.
    assert scores["black"].relative == pytest.approx([0.02, 0.1])
    assert scores["black"].deviations == pytest.approx([2], rel=1e-6)
    assert scores["energy"].relative == pytest.approx([0.05])
    assert scores["energy"].deviations == pytest.approx([2], rel=1e-6)
    assert scores["energy"].asked == 2 and scores["all"].asked == 4
    rows = score.table(scores).splitlines()
    assert rows[2] == (
        "| black | 2 of 2 | 6.000 % | 10.000 % | 0 % | 100 % | 2.0 |"
    )
    assert rows[-1].startswith("| all | 3 of 4 | 5.000 %")


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        (["a,soil,x,"], r"a.csv:2: .*'x'; write a number"),
        (["a,soil,1"], "a.csv:2: 3 columns; write 4"),
        (["a,soil,1,", "a,soil,2,"], "a.csv:3: a soil is answered twice"),
        (["a,soil,nan,"], "a.csv:2: nan .* is no result"),
        (["a,soil,1,-1"], "a.csv:2: 1 ± -1 is no result"),
    ],
)
def test_a_wrong_answer_is_reported(
    benchmark: ModuleType, tmp_path: Path, rows: list[str], words: str
) -> None:
    with pytest.raises(benchmark.score.AnswersError, match=words):
        benchmark.score.read(write(tmp_path / "a.csv", *rows))


def test_an_answer_to_an_unknown_case_is_reported(
    benchmark: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write(tmp_path / "a.csv", "no_case,soil,1,")
    assert benchmark.score.main([str(path)]) == 1
    assert "no case asks for 'soil' of 'no_case'" in capsys.readouterr().err
    write(path, header="case,value")
    assert benchmark.score.main([str(path)]) == 1
    assert "the header is 'case,value'" in capsys.readouterr().err


def test_files_of_cases_agree_with_their_script(
    benchmark: ModuleType, tmp_path: Path
) -> None:
    made = benchmark.cases.all_cases()
    assert json.loads(json.dumps(made)) == benchmark.cases.read_cases()
    assert len(made) > 100
    for name, make in benchmark.meshes.MESHES.items():
        path = tmp_path / "mesh.obj"
        benchmark.meshes.write_obj(make(), path)
        kept = FOLDER / "meshes" / f"{name}.obj"
        assert path.read_text() == kept.read_text()
    values = benchmark.score.read(FOLDER / "values.csv")
    asked = {
        (name, quantity)
        for name, case in made.items()
        for quantity in case["quantities"]
    }
    assert values.keys() == asked


@pytest.mark.parametrize(
    "name",
    [
        "beer-beer4-black-overcast",
        "black-maize-black-sun20_250",
        "nir-flat-nir-soil0.2-sun45_120",
        "panels-panels_tilted-black-soil0.25-uniform",
        "par-mixture-par-soil0.1-overcast",
        "sheets-sheet2-unlike-soil0.3-uniform",
        "strips-walls-black-soil0.3-uniform",
        "assimilation-spherical-black-sun45_120-collatz",
        "assimilation-sheet2-par-soil0.1-sun30_180-farquhar",
        "energy-calm",
    ],
)
def test_both_methods_reproduce_the_values(
    benchmark: ModuleType, name: str
) -> None:
    case = benchmark.cases.read_cases()[name]
    values = benchmark.score.read(FOLDER / "values.csv")
    ways = [
        benchmark.program.answer(case, paths=2**14, seed=91),
        benchmark.plain.answer(case, 2**11, 16, 91),
    ]
    exact = benchmark.theory.answer(case)
    for quantity in case["quantities"]:
        value, error = values[name, quantity]
        if quantity in exact:
            assert value == pytest.approx(exact[quantity], rel=1e-7)
            assert error == 0
        for way in filter(None, ways):
            estimate, uncertain = way[quantity]
            together = (error**2 + uncertain**2) ** 0.5
            # The tolerance is wide because standard errors come from only 16
            # repetitions.
            assert abs(estimate - value) <= 5 * together + 1e-6 * abs(value)
            scale = 50 if case["class"] == "assimilation" else 1
            assert together < 0.02 * scale


def test_stored_values_have_small_errors(benchmark: ModuleType) -> None:
    """Values without theory lie between those of both methods or close to
    them."""
    values = benchmark.score.read(FOLDER / "values.csv")
    for (name, quantity), (value, error) in values.items():
        assert error <= (0.05 if name.startswith("assim") else 1e-3), name
        if quantity == "soil" and not name.startswith("energy"):
            assert 0 <= value < 1


@pytest.mark.parametrize(
    ("program", "answered"), [("ideotype", 613), ("mitsuba", 501)]
)
def test_stored_answers_of_path_tracers_agree_with_the_values(
    benchmark: ModuleType, program: str, answered: int
) -> None:
    """The largest of some 500 deviations, with errors of 16 seeds each, is
    beyond 6 standard errors in 1 % of runs (Student's t)."""
    score = benchmark.score
    scores = score.score(
        score.read(FOLDER / "values.csv"),
        score.read(FOLDER / "answers" / f"{program}.csv"),
        score.classes_of(FOLDER / "cases"),
    )
    assert len(scores["all"].deviations) == answered
    assert max(scores["all"].deviations) < 6
    assert max(scores["all"].relative) < 0.05
