# SPDX-License-Identifier: Apache-2.0
"""Figures are written as files, with their numbers as CSV."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from ideotype.common.progress import bar
from ideotype.figures.numbers import HEADER, read_numbers
from ideotype.figures.style import set_answer
from ideotype.history import HistoryError
from ideotype.report.blocks import Drawing, Picture, Section
from ideotype.report.gallery import draw, draw_all


def test_a_figure_is_a_vector_file_that_is_the_same_again(
    tmp_path: Path,
) -> None:
    def make() -> Figure:
        figure = Figure(figsize=(3, 3))
        axes = figure.add_subplot()
        axes.plot([0, 1], [2, 3])
        axes.set_xlabel("leaf area")
        axes.imshow(np.random.default_rng(1).random((300, 300)))
        set_answer(figure, "Yes.")
        return figure

    texts = []
    for _ in range(2):
        drawing = Drawing("some", "Is it?", "", make)
        picture = draw(tmp_path, False, drawing)
        assert isinstance(picture, Picture) and picture.answer == "Yes."
        texts.append((tmp_path / "some.svg").read_text())
    assert texts[0] == texts[1]
    assert "leaf area</text>" in texts[0]
    # As PNG, painted parts would be several times larger.
    assert "data:image/webp" in texts[0] and len(texts[0]) < 200_000
    draw(tmp_path, True, Drawing("some", "Is it?", "", make))
    assert (tmp_path / "some.pdf").read_bytes().startswith(b"%PDF")


def test_words_of_a_figure_keep_their_digits(tmp_path: Path) -> None:
    def make() -> Figure:
        figure = Figure()
        axes = figure.add_subplot()
        axes.set_title("0.8012 ± 0.0039")
        axes.set_xticks([0.0, 0.125, 0.25])
        return figure

    picture = draw(tmp_path, False, Drawing("some", "Is it?", "", make))
    assert isinstance(picture, Picture)
    text = (tmp_path / "some.svg").read_text()
    assert ">0.8012 ± 0.0039</text>" in text
    assert ">0.125</text>" in text
    assert not re.search(r'="[^"<>]*\d\.\d{3,}', text)


def test_csv_files_have_the_numbers_of_each_kind_of_mark(
    tmp_path: Path,
) -> None:
    figure = Figure()
    first, second = figure.subplots(1, 2)
    first.errorbar([1, 2], [3, 4], [0.1, 0.2], [0.3, 0.4], label="bars")
    first.plot([5, 6], [7, 8], label="line")
    second.barh([0, 1], [0.25, 0.5], label="parts")
    second.set_yticks([0, 1], ["ames", "oslo"])
    (tmp_path / "numbers.csv").write_text(read_numbers(figure))
    with (tmp_path / "numbers.csv").open() as file:
        header, *rows = csv.reader(file)
    assert tuple(header) == HEADER
    found = {
        series: [row[2:] for row in rows if row[1] == series]
        for series in ("bars", "line", "parts")
    }
    bars = np.array(found["bars"], float)
    assert bars == pytest.approx(
        np.array([[1, 3, 0.7, 1.3, 2.9, 3.1], [2, 4, 1.6, 2.4, 3.8, 4.2]])
    )
    assert [row[:2] for row in found["line"]] == [["5", "7"], ["6", "8"]]
    assert found["parts"] == [
        ["0.25", "ames", "", "", "", ""],
        ["0.5", "oslo", "", "", "", ""],
    ]


def test_progress_reports_each_figure(tmp_path: Path) -> None:
    def missing() -> Figure:
        raise HistoryError("no light")

    parts = [Section("ames"), Section("words alone"), Section("oslo")]
    for part in parts[::2]:
        part.draw("gain", "How much?", "", missing)
    progress: list[tuple[int, int, str]] = []
    files = draw_all(
        parts, tmp_path, map, lambda *words: progress.append(words), False
    )
    assert files == []
    assert progress == [(1, 2, "ames"), (2, 2, "oslo")]
    assert "Not drawn: no light." in parts[0].blocks[0].text


@pytest.mark.parametrize("columns", [20, 60, 80, 200])
def test_a_bar_fits_the_width(columns: int) -> None:
    line = bar(12, 40, "12 of 40 figures drawn", 180, "ames", columns)
    assert len(line) <= columns
    if columns >= 60:
        assert "12 of 40 figures drawn, 3:00 left" in line
        assert (
            0.2 < line.count("#") / (line.count("#") + line.count(".")) < 0.4
        )
