"""Cases against each other."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from ideotype_analysis.comparison import draw_energy, draw_spacings
from ideotype_analysis.cross import Cross, draw_cross
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


def test_seeds_are_put_together_in_a_cross_evaluation() -> None:
    plants = ("ames_all_r1", "ames_all_r2", "oslo_all_r1", "b73")
    mean = np.array([[11.0, 10.0], [11.2, 10.2], [np.nan, 10.3], [9.0, 8.0]])
    cross = Cross(plants, ("ames", "oslo"), mean, np.full((4, 2), 0.01))
    (ames, bred), (oslo, lonely), (b73, _) = cross.seeds_together()
    assert (ames, oslo, b73) == ("ames_all", "oslo_all_r1", "b73")
    assert bred[0] is not None and bred[0].mean == pytest.approx(11.1)
    # Student's t with one degree of freedom, times the standard error
    assert bred[0].half_width == pytest.approx(12.7062 * 0.1)
    assert lonely[0] is None and lonely[1] is not None
    assert lonely[1].half_width == pytest.approx(0.0196)
    axes, _ = draw_cross(cross).axes
    texts = [text.get_text() for text in axes.texts]
    assert texts[0] == "100.00\n±11.45" and len(texts) == 5
