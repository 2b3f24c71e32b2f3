# SPDX-License-Identifier: Apache-2.0
"""The commands of campaigns/README.md draw pictures of fields."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image
from real_program import CAMPAIGNS


def test_a_field_is_drawn_at_eye_height_and_from_above(
    tmp_path: Path,
) -> None:
    to = tmp_path / "field.png"
    script = CAMPAIGNS.parent / "analysis" / "study" / "draw_field.py"
    words = [
        script,
        "--to",
        to,
        CAMPAIGNS / "crops" / "maize.toml",
        "--spacing",
        0.7,
        0.2,
    ]
    subprocess.run([sys.executable, *map(str, words)], check=True)
    assert to.stat().st_size < 300_000
    with Image.open(to) as image:
        pixels = np.asarray(image.convert("RGB")).astype(int)
    red, green, blue = pixels.transpose(2, 0, 1)
    sky = (blue > red + 40) & (red > 120) & (green > red)
    soil = (red > green + 10) & (green > blue + 10) & (red < 210)
    bright = (green > blue + 60) & (green > 120)
    dark = (blue > green + 40) & (red < 90)
    half = len(pixels) // 2
    # The sky appears only at eye height; soil and leaves appear in both views.
    assert sky[: half // 2].sum() > 3000 > 100 > sky[half:].sum()
    for view in (slice(None, half), slice(half, int(0.85 * len(pixels)))):
        assert soil[view].sum() > 3000
        assert bright[view].sum() > 300 and dark[view].sum() > 300
