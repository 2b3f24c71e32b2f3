#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the pictures of the manual with plants that the program makes.

draw.py [NAME...]

A picture is docs/figures/NAME.png; without a name all are drawn."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

import matplotlib
from matplotlib.figure import Figure
from PIL import Image

from ideotype.figures.style import RC

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS.parent / "analysis" / "study"))
import drawn_leaves  # noqa: E402
import drawn_light  # noqa: E402
import drawn_plants  # noqa: E402

FIGURES: dict[str, Callable[[drawn_plants.Shapes], Figure]] = {
    "azimuth": drawn_leaves.azimuth,
    "insertion_angle": drawn_leaves.insertion_angle,
    "curvature": drawn_leaves.curvature,
    "folding": drawn_leaves.folding,
    "cell": drawn_plants.cell,
    "traits": drawn_plants.traits,
    "light": drawn_light.light,
    "response": drawn_light.response,
    "agrivoltaics": drawn_light.agrivoltaics,
}


def save(figure: Figure, path: Path) -> None:
    """Saves a figure with few colours, so that it is small."""
    figure.savefig(path, dpi=150, bbox_inches="tight")
    with Image.open(path) as image:
        image.convert("RGB").quantize(96).save(path, optimize=True)


def main() -> None:
    parser = argparse.ArgumentParser(usage=(__doc__ or "").split("\n")[2])
    parser.add_argument("names", nargs="*", choices=[[], *FIGURES])
    options = parser.parse_args()
    (DOCS / "figures").mkdir(exist_ok=True)
    with matplotlib.rc_context(RC):
        for name in options.names or FIGURES:
            save(
                FIGURES[name](drawn_plants.Shapes()),
                DOCS / "figures" / f"{name}.png",
            )


if __name__ == "__main__":
    main()
