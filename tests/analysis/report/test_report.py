# SPDX-License-Identifier: Apache-2.0
"""The texts and figures of a report are complete and right."""

from __future__ import annotations

import base64
import contextlib
import io
import re
import shutil
import sys
from pathlib import Path

import numpy as np
import pandas
import pytest
from made_history import MadeHistory
from made_numbers import BASELINE, final_absorbed
from made_report import CASES, DRAWN, ELITE, OWN, Made
from PIL import Image

from ideotype.figures.cross import read_cross
from ideotype.history import HistoryError
from ideotype.history.estimate import NORMAL
from ideotype.history.study import open_study
from ideotype.report.tables import tabulate_gains
from ideotype.tools.commands import report


def plain(text: str) -> str:
    """Returns the text of a page without tags."""
    text = re.sub(r"(?s)<(script|style).*?</\1>", "", text)
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", text))


def test_every_figure_is_a_file_and_in_the_page(made: Made) -> None:
    names = {"plants", "gains", "energy", "latitudes", "cross"}
    names |= {f"{case}_{name}" for case in CASES for name in DRAWN}
    names |= {f"{case}_{x}" for case in CASES for x in OWN}
    files = {path.name for path in (made.folder / "figures").iterdir()}
    ends = ("svg", "csv")
    assert files == {f"{name}.{end}" for name in names for end in ends}
    for path in (made.folder / "figures").glob("*.svg"):
        # Words remain text, so that browsers can find them and screen readers
        # can read them.
        assert "<text" in path.read_text()
        assert path.stat().st_size < 300_000
    assert set(re.findall(r"\((\S+)\.svg\)", made.text)) == names


def test_the_numbers_of_a_figure_are_those_of_the_case(
    made: Made, sweep: Path
) -> None:
    table = pandas.read_csv(made.folder / "figures" / "gains.csv")
    results = pandas.read_csv(made.folder / "results.csv")
    shown = table[table.series == "over the baseline"]
    for name in ("", "_low", "_high"):
        np.testing.assert_allclose(
            shown[f"x{name}"], results[f"gain_percent{name}"], rtol=1e-6
        )
    with open_study(sweep) as study:
        hours = study.cases()[0].best.profile("absorbed_by_hour")
    path = made.folder / "figures" / f"{CASES[0]}_hours.csv"
    table = pandas.read_csv(path)
    best = table[(table.series == "best") & (table.x == hours.labels[3])]
    assert best.y.iloc[0] == pytest.approx(hours.values[3], rel=1e-6)
    half = NORMAL * hours.standard_error[3]
    for end, sign in (("low", -1), ("high", 1)):
        found = best[f"y_{end}"].iloc[0]
        assert found == pytest.approx(hours.values[3] + sign * half, rel=1e-6)


def test_each_figure_answers_the_question_above_it(made: Made) -> None:
    figures = re.findall(
        r'(?s)<h3>(.*?)</h3>\s*<p class="text">(.*?)</p>\s*'
        r'<img src="data:image/svg\+xml;base64,(.*?)" alt="(.*?)">',
        made.text,
    )
    assert len(figures) == 5 + len(CASES) * (len(DRAWN) + len(OWN))
    for question, sentence, data, description in figures:
        assert re.fullmatch(r"[A-Z][^.?]+\?", question)
        assert re.fullmatch(r"[A-Z].+\.", sentence)
        assert description == f"{question} {sentence}"
        assert base64.b64decode(data).startswith(b"<?xml")


def test_the_page_begins_with_the_answer(made: Made) -> None:
    words = plain(made.text)
    gain = words.index("absorbed PAR of the best plants over the baseline")
    sure = words.index("How sure")
    cost = words.index("At what cost")
    limits = words.index("Limits of the search")
    plants = words.index("How does the best plant differ")
    assert gain < sure < cost < limits < plants
    assert plants < words.index("Where does the light go?")
    assert re.search(r"\+[\d.]+ to \+[\d.]+ % $", words[:gain])
    for name in ("smallest", "largest"):
        assert re.search(
            rf"{name} gain [\d.]+ ± [\d.]+ % \(", words[sure:cost]
        )
    assert "searches of each case 2 " in words[sure:cost]
    assert re.search(r"evaluations \d+ in 4 searches", words[cost:limits])
    assert "leaf area index +" in words[cost:limits]
    assert words.count("± is half of a 95 % confidence interval") == 1


def test_a_figure_for_a_paper_is_in_the_page_and_in_files(made: Made) -> None:
    assert (made.folder / "figure.pdf").read_bytes().startswith(b"%PDF")
    with Image.open(made.folder / "figure.png") as picture:
        width, height = picture.size
        assert picture.info["dpi"][0] == pytest.approx(300, abs=1)
    assert width > 2000 and height > 700
    words = plain(made.text)
    caption = words[words.index("Figure 1.") :]
    for text in (
        "(a) Baseline and (b) best plant",
        "(c) Gain in absorbed PAR over the baseline",
        "2 independent searches in each case",
        "95 % confidence interval over searches",
        "re-evaluated with independent random numbers",
        "Files: figure.pdf, figure.png.",
    ):
        assert text in caption[:2000]


def test_the_page_needs_nothing_else(made: Made) -> None:
    assert made.page.stat().st_size < 8e6
    loads = re.findall(r'(?:src|href)="([^"#]*)', made.text)
    assert {load.split(",")[0] for load in loads if load} == {
        "data:image/svg+xml;base64",
        "data:",
    }
    assert "default-src 'none'" in made.text
    assert not list(made.folder.glob("*.part"))


def test_the_page_states_the_gain(made: Made) -> None:
    words = plain(made.text).replace("\u00a0", " ")
    # The gains of the two seeds are 1.5 % of 11, and 0.1 more for the second.
    assert re.search(
        r"ames_0807_762x152_all 2 2\.\d+ ± [\d.]+ [\d.]+ \.\. [\d.]+ 11\.00",
        words,
    )
    over_elite = [
        100 * ((final_absorbed(2) + shift) / ELITE - 1) for shift in (0, 0.1)
    ]
    assert f"{sum(over_elite) / 2:.1f} ± 5.7" in words


def test_missing_things_are_plain_sentences(made: Made) -> None:
    words = plain(made.text)
    for trait in ("profile over leaf position", "trait of the whole plant"):
        assert words.count(f"Not drawn: no {trait} is optimised.") == len(
            CASES
        )
    assert (
        "How do absorbed PAR and gain depend on plant density? Not drawn: all cases "
        "have the same plant density." in words
    )
    assert (
        "Where is the gain largest? Not drawn: cases do not differ in two"
        in words
    )
    assert "Saturated" not in words and "Provisional" not in words


def test_the_page_states_its_provenance(made: Made) -> None:
    words = plain(made.text)
    for fact in (
        *("0123456789ab", "avx2", str(2**63 + 1), "ideotype run", "node1"),
        *(
            "Command that made this page: ideotype report",
            "linke_turbidity = 3",
        ),
        *(f"{case}_r{seed}.h5" for case in CASES for seed in (1, 2)),
    ):
        assert fact in words


def test_there_is_no_progress_without_a_terminal(made: Made) -> None:
    assert made.log == ""


def test_figures_of_single_cases_are_drawn_on_request(
    sweep: Path, tmp_path: Path
) -> None:
    arguments = [str(sweep), "-j", "1", "--figures"]
    assert report([*arguments, "edmonton", "-o", str(tmp_path / "one")]) == 0
    drawn = {path.stem for path in (tmp_path / "one/figures").glob("*.svg")}
    assert f"{CASES[1]}_hours" in drawn
    assert not any(name.startswith(CASES[0]) for name in drawn)
    assert report([*arguments, "nowhere", "-o", str(tmp_path / "none")]) == 1


def test_the_page_reports_missing_data_and_saturation(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The compiled module is missing in this installation.
    monkeypatch.setitem(sys.modules, "ideotype._core", None)
    compiled = ("ideotype.common.compiled", "ideotype.stand")
    for name in [x for x in sys.modules if x.startswith(compiled)]:
        monkeypatch.delitem(sys.modules, name)
    path = tmp_path / "<full>.h5"
    made = MadeHistory(path, shift=12.2 - 0.001 - final_absorbed(2))
    made.evolve(1)
    made.finish()
    made.close()
    # The report is made by a single process, because other processes would not
    # see the changes of this test.
    assert report([str(path), "-o", str(tmp_path / "out"), "-j", "1"]) == 0
    text = (tmp_path / "out" / "report.html").read_text()
    assert "&lt;full&gt;.h5" in text and "<full>" not in text
    words = plain(text)
    assert re.search(
        r"Saturated: the best plant is [^.]*: ames_0807_762x152_all", words
    )
    assert "Plants are not drawn: this needs the compiled module" in words
    assert "No plants are shown" in words and "<canvas" not in text
    assert "the history has no quantities by height layer" in words
    assert "the history does not distinguish parts of the light" in words


def test_an_unfinished_run_is_provisional(drained: Path) -> None:
    with open_study(drained) as study:
        notes = [b.text for b in tabulate_gains(study.cases(), None)[1:]]
    (note,) = [note for note in notes if note.startswith("Provisional")]
    assert note.endswith(": ames_0807_762x152_all.")


def test_three_searches_bound_the_distance_of_the_optimum(
    sweep: Path, tmp_path: Path
) -> None:
    shifts = (0.1, 0.4, 0.2)
    for seed, shift in enumerate(shifts):
        made = MadeHistory(tmp_path / f"{seed}.h5", shift=shift)
        made.evolve(1)
        made.finish()
        made.close()
    remarks = []
    for folder in (sweep, tmp_path):
        with open_study(folder) as study:
            notes = [b.text for b in tabulate_gains(study.cases(), None)[1:]]
        # The note about intervals appears once and covers all cases.
        remarks.append([note for note in notes[1:] if "optimum" in note])
    (two,), (three,) = remarks
    assert two.startswith("Three searches (replicates = 3) would show")
    lowest, *_, highest = sorted(
        100 * ((final_absorbed(2) + shift) / BASELINE - 1) for shift in shifts
    )
    assert f"a spread of {highest - lowest:.1f} percentage points" in three
    assert (
        f"3 independent searches gained {lowest:.1f} to {highest:.1f} %"
        in three
    )


def test_a_cross_evaluation_is_json_or_csv(
    cross: Path, sweep: Path, tmp_path: Path
) -> None:
    table = tmp_path / "cross.csv"
    table.write_text(
        "plant,case,mean,standard_error\n"
        f"elite,{CASES[0]},{ELITE},0.005\n"
        f"best of ames,{CASES[0]},11.16,0.005\n"
        f"best of ames,{CASES[1]},11.05,0.006\n"
    )
    for path in (cross, table):
        found = read_cross(path)
        assert found.plants == ("elite", "best of ames")
        assert found.cases == CASES
        best = found.estimate("best of ames", CASES[1])
        assert best is not None and best.mean == 11.05
        assert found.estimate("elite", CASES[1]) is None
        with open_study(sweep) as study:
            elite = [found.relative_gain(c, "elite") for c in study.cases()]
        assert elite[0] is not None and elite[1] is None
    table.write_text("plant,case\nelite,ames\n")
    with pytest.raises(
        HistoryError, match="cross.csv: this is no cross-evalua"
    ):
        read_cross(table)


def test_the_examples_of_the_guide_run(
    sweep: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    guide = Path(__file__).parents[3] / "analysis" / "README.md"
    examples = re.findall(r"(?s)```python\n(.*?)```", guide.read_text())
    assert len(examples) == 4
    (tmp_path / "results").mkdir()
    name = f"{CASES[0]}_r1.h5"
    shutil.copy(sweep / name, tmp_path / "results" / "CASE.h5")
    monkeypatch.chdir(tmp_path)
    output = io.StringIO()
    with contextlib.redirect_stdout(output):
        exec("\n".join(examples), {})
    printed = output.getvalue().split("\n")
    assert printed[0].startswith(f"{CASES[0]} 0.165 ± 0.065 MJ m-2 day-1")
    assert "MJ m-2 day-1" in printed
    assert re.fullmatch(r"report/report\.html \d+", printed[-2])
