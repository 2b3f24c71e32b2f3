# SPDX-License-Identifier: Apache-2.0
"""The style of all figures. Colours are those of Okabe and Ito, and viridis:
colour-blind people can distinguish the colours of each."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from ..common.labels import unit_label as unit_label
from ..common.labels import words as words
from ..history.estimate import DAILY_ENERGY, NORMAL

BASELINE = "#000000"
BEST = "#0072B2"
MEAN = "#009E73"
ACCENT = "#D55E00"
QUIET = "#8C8C8C"

WIDTH = 4.8
"""The width of figures [inches], at which words are legible on a telephone."""

_SERIES_COLORS = (
    *("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"),
    "#000000",
)
_SERIES_MARKERS = ("o", "s", "^", "D", "v", "P", "X", "*")

RC: dict[Any, Any] = {
    "font.size": 10.0,
    "font.family": "DejaVu Sans",
    "svg.fonttype": "none",
    "legend.fontsize": 9.0,
    "axes.titlesize": 10.0,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#E3E3E3",
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "lines.linewidth": 1.5,
    "lines.markersize": 4.5,
    "errorbar.capsize": 2.0,
    "pdf.fonttype": 42,
}

_LIGHT = (DAILY_ENERGY, "W m-2")
"""The units of light, which is per area of ground, or per area of leaf if the
name says this."""


def set_answer(figure: Figure, text: str) -> None:
    """Stores the sentence that answers the question of a figure."""
    figure.set_label(text)


def get_answer(figure: Figure) -> str:
    """Returns the sentence that answers the question of a figure, or ""."""
    return str(figure.get_label() or "")


def half_width(standard_error: ArrayLike) -> NDArray[np.float64]:
    """Returns half of the 95 % interval of numbers, which error bars show."""
    return NORMAL * np.asarray(standard_error, dtype=float)


def new_figure(width: float, height: float) -> Figure:
    """Returns an empty figure [inches], which belongs to no window and no
    global list."""
    return Figure(figsize=(width, height), layout="constrained")


def pixels(figure: Figure) -> NDArray[np.uint8]:
    """Returns the figure painted, [height, width, 4]."""
    canvas = FigureCanvasAgg(figure)
    canvas.draw()  # type: ignore[no-untyped-call]
    return np.array(canvas.buffer_rgba())  # type: ignore[no-untyped-call]


def axis_label(name: str, unit: str) -> str:
    """Returns "absorbed PAR [MJ m⁻² day⁻¹ of ground]" for a column's name and
    unit."""
    if unit == "1":
        return words(name)
    is_light = unit in _LIGHT
    area = " of leaf" if "leaf_area" in name else " of ground"
    return f"{words(name)} [{unit_label(unit)}{area if is_light else ''}]"


def short(value: float) -> float:
    """Returns a number with as many digits as a drawing in the page needs."""
    return float(f"{value:.7g}")


def series(index: int) -> tuple[str, str]:
    """Returns colour and marker of a line among several; markers distinguish
    lines of the same colour."""
    return (
        _SERIES_COLORS[index % len(_SERIES_COLORS)],
        _SERIES_MARKERS[index % len(_SERIES_MARKERS)],
    )


def organ_color(group: str) -> str:
    """Returns the colour of a group of a mesh that is no leaf: a muted green
    for sheaths and other green organs, grey for all other organs."""
    return "#7E9470" if group.startswith("sheath") else "#969696"


def ordered(count: int) -> list[str]:
    """Returns colours for values in their order, from dark to bright."""
    return [to_hex(color) for color in ranked_colors(count)]


def ranked_colors(count: int) -> NDArray[np.float64]:
    """Returns colours from the fittest, dark, to the least fit, bright; the
    palest end of viridis does not show on white."""
    return colormaps["viridis"](np.linspace(0.0, 0.9, max(count, 1)))
