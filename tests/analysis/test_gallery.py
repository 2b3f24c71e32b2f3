# SPDX-License-Identifier: Apache-2.0
"""Figures become files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from PIL import Image

from ideotype.analysis import HistoryError
from ideotype.analysis.blocks import Drawing, Picture, Section
from ideotype.analysis.gallery import draw, draw_all


def test_figures_for_documents_are_small(tmp_path: Path) -> None:
    random = np.random.default_rng(1)

    def noise() -> Figure:
        figure = Figure(figsize=(3, 3))
        figure.add_subplot().imshow(random.random((500, 500)))
        return figure

    picture = draw(
        tmp_path, 1e6, False, Drawing("noise", "Is it noise?", "", noise)
    )
    assert isinstance(picture, Picture)
    assert (tmp_path / "noise.png").stat().st_size <= 150_000
    with Image.open(tmp_path / "noise.png") as image:
        assert image.width == image.height > 200


def test_a_figure_of_any_width_is_painted_upright(tmp_path: Path) -> None:
    def half() -> Figure:
        # The width is 1140 pixels, which is 1139.99... as a product.
        figure = Figure(figsize=(1.9 * 3, 2))
        figure.add_axes(
            (0, 0, 0.5, 1), facecolor="black", xticks=[], yticks=[]
        )
        return figure

    draw(tmp_path, 1e6, False, Drawing("half", "Is it upright?", "", half))
    with Image.open(tmp_path / "half.png") as image:
        assert abs(image.width - 1140) < 2
        grey = np.asarray(image.convert("L"))
    middle = image.width // 2
    assert np.all(grey[60:-4, 4 : middle - 4] == 0)
    assert np.all(grey[60:, middle + 4 :] > 250)


def test_each_part_with_figures_is_told(tmp_path: Path) -> None:
    def missing() -> Figure:
        raise HistoryError("no light")

    parts = [Section("ames"), Section("words alone"), Section("oslo")]
    for part in parts[::2]:
        part.draw("gain", "How much?", "", missing)
    lines: list[str] = []
    assert draw_all(parts, tmp_path, map, lines.append, False) == []
    assert lines == ["[1/2] ames", "[2/2] oslo"]
    assert "Not drawn: no light." in parts[0].blocks[0].text
