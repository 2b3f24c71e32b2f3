# SPDX-License-Identifier: Apache-2.0
"""The commands of campaigns/README.md draw pictures of plants."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image
from real_program import CAMPAIGNS


def draw(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Runs analysis/study/draw_plants.py and returns its output."""
    script = CAMPAIGNS.parent / "analysis" / "study" / "draw_plants.py"
    words = [sys.executable, script, *arguments]
    return subprocess.run(
        [*map(str, words)], capture_output=True, text=True, check=False
    )


def test_baselines_and_optimised_plants_are_drawn(
    sorghum: list[Path], tmp_path: Path
) -> None:
    to, crops = tmp_path / "plants.png", CAMPAIGNS / "crops"
    done = draw("--to", to, crops / "sorghum.toml", f"bred={sorghum[0]}")
    assert done.returncode == 0, done.stderr
    assert to.stat().st_size < 300_000
    with Image.open(to) as image:
        pixels = np.asarray(image.convert("RGB")).astype(int)
    red, green, blue = pixels.transpose(2, 0, 1)
    leaves = (green > red + 30) & (green > blue + 30)
    wood = (red > green + 10) & (green > blue + 10)
    middle = pixels.shape[1] // 2
    # Leaves appear in both columns, and panicles in the upper half.
    assert min(leaves[:, :middle].sum(), leaves[:, middle:].sum()) > 1000
    assert wood[: len(wood) // 2].sum() > 100


def test_the_error_names_a_file_that_is_no_plant(tmp_path: Path) -> None:
    path = tmp_path / "none.toml"
    path.write_text('name = "none"')
    done = draw("--to", tmp_path / "none.png", path)
    assert done.returncode == 1
    assert f"{path}:1:1: missing table [leaf]" in done.stderr
    assert not (tmp_path / "none.png").exists()
