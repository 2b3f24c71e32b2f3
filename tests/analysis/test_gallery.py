# SPDX-License-Identifier: Apache-2.0
"""Figures as files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from PIL import Image

from ideotype.analysis.blocks import Drawing, Picture
from ideotype.analysis.gallery import draw


def test_figures_for_documents_are_small(tmp_path: Path) -> None:
    random = np.random.default_rng(1)

    def noise() -> Figure:
        figure = Figure(figsize=(3, 3))
        figure.add_subplot().imshow(random.random((500, 500)))
        return figure

    picture = draw(tmp_path, 1e6, Drawing("noise", "Is it noise?", "", noise))
    assert isinstance(picture, Picture)
    assert (tmp_path / "noise.png").stat().st_size <= 150_000
    with Image.open(tmp_path / "noise.png") as image:
        assert image.width == image.height > 200
