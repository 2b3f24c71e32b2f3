"""Cases against each other."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from ideotype_analysis.comparison import draw_energy, draw_spacings
from ideotype_analysis.study import open_study
from made_history import MadeHistory

INCH = 0.0254


def make(path: Path, campaign: bytes = b"", **place: str | float) -> None:
    """A finished history of one generation."""
    made = MadeHistory(path, place={"case": path.stem, **place})
    made.file["campaign/resolved"][()] = campaign
    made.evolve(1)
    made.finish()
    made.close()


def test_spacings_have_a_line_for_each_distance_of_rows(tmp_path: Path) -> None:
    for rows in (15, 30):
        for plants in (3, 6):
            place = {"row_spacing": rows * INCH, "plant_spacing": plants * INCH}
            make(tmp_path / f"{rows}x{plants}_r1.h5", **place)
    with open_study(tmp_path) as study:
        figure = draw_spacings(study.cases())
    (legend,) = figure.legends
    texts = [text.get_text() for text in legend.get_texts()]
    assert [text.split(", ", 1)[1] for text in texts] == [
        f"rows {rows} m, {who}"
        for rows in ("0.381", "0.762")
        for who in ("baseline", "best")
    ]
    lines = [line for line in figure.axes[1].lines if len(line.get_xdata()) == 2]
    # 15 x 6 and 30 x 3 inches have as many plants; no line joins them
    assert all(np.diff(line.get_xdata())[0] > 1 for line in lines)


def test_plots_alone_have_a_panel_of_their_own(tmp_path: Path) -> None:
    make(tmp_path / "stand_r1.h5")
    make(tmp_path / "plot_r1.h5", b'[field]\nboundary = "isolated"')
    with open_study(tmp_path) as study:
        stands, plots = draw_energy(study.cases()).axes
    assert stands.get_xlabel() == "part of the incident PAR"
    assert "alone" in plots.get_xlabel()
    assert [t.get_text() for t in plots.get_yticklabels()] == [
        *("plot baseline", "plot best"),
    ]
