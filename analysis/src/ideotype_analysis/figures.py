"""All figures of a history, as files."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import matplotlib
from matplotlib.figure import Figure

from .convergence import draw_convergence
from .file import HistoryError
from .history import History
from .hours import draw_hours
from .shape import draw_azimuths, draw_traits
from .style import RC

FIGURES: dict[str, Callable[[History], Figure]] = {
    "convergence": draw_convergence,
    "traits": draw_traits,
    "azimuths": draw_azimuths,
    "hours": draw_hours,
}
"""Name of the file and what draws it. Figures are drawn without a window."""

FORMATS = ("png", "pdf")


@dataclass
class Drawn:
    """What became of the figures."""

    paths: list[Path] = field(default_factory=list)
    missing: dict[str, str] = field(default_factory=dict)
    """Why a figure was not drawn, by its name."""


def default_folder(history: str | Path) -> Path:
    """results/case.h5 -> results/case_figures"""
    path = Path(history)
    stem = path.stem if path.suffix in (".h5", ".hdf5") else path.name
    return path.with_name(f"{stem}_figures")


def draw_figures(history: History, folder: str | Path) -> Drawn:
    """Writes each figure as PNG and PDF; one that the history has no data for
    yet is left out."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    drawn = Drawn()
    for name, draw in FIGURES.items():
        with matplotlib.rc_context(RC):
            try:
                figure = draw(history)
            except HistoryError as reason:
                drawn.missing[name] = str(reason)
                continue
            for suffix in FORMATS:
                path = folder / f"{name}.{suffix}"
                figure.savefig(path)
                drawn.paths.append(path)
    return drawn
