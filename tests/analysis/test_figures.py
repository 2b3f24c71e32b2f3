"""What the figures show."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import WriterProcess
from ideotype_analysis import open_history
from ideotype_analysis.convergence import draw_convergence
from ideotype_analysis.figures import (
    FIGURES,
    default_folder,
    draw_figures,
)
from ideotype_analysis.hours import draw_hours
from ideotype_analysis.shape import draw_azimuths, draw_traits
from ideotype_analysis.style import unit_label
from made_numbers import (
    BASELINE,
    ERROR,
    HOURS,
    POPULATION,
    absorbed,
    final_absorbed,
    hour_par,
)
from matplotlib.axes import Axes
from matplotlib.figure import Figure


def bars(axes: Axes, label: str) -> tuple[np.ndarray, np.ndarray]:
    """Values and half-lengths of the vertical bars of that label."""
    (found,) = [
        c for c in axes.containers if (c.get_label() or "_").startswith(label)
    ]
    line, _, (segments,) = found.lines
    ends = np.array(segments.get_segments())
    return line.get_ydata(), (ends[:, 1, 1] - ends[:, 0, 1]) / 2


def labels(figure: Figure) -> set[str]:
    """All labels of all legends and axes."""
    found = {t for a in figure.axes for t in (a.get_xlabel(), a.get_ylabel())}
    legends = [*figure.legends, *(a.get_legend() for a in figure.axes)]
    for legend in filter(None, legends):
        found |= {text.get_text() for text in legend.get_texts()}
    return found


def test_all_figures_are_files(finished: Path, tmp_path: Path) -> None:
    with open_history(finished) as history:
        drawn = draw_figures(history, tmp_path / "new" / "folder")
    assert drawn.missing == {}
    names = {f"{name}.{end}" for name in FIGURES for end in ("png", "pdf")}
    assert {path.name for path in drawn.paths} == names
    for path in drawn.paths:
        start = b"\x89PNG" if path.suffix == ".png" else b"%PDF"
        assert path.read_bytes().startswith(start)
        assert path.stat().st_size > 5000


def test_convergence_shows_best_mean_spread_and_baseline(
    finished: Path,
) -> None:
    with open_history(finished) as history:
        figure = draw_convergence(history)
    axes = figure.axes[0]
    values, errors = bars(axes, "best of its generation")
    expected = [absorbed(g, POPULATION - 1) for g in range(6)]
    assert values == pytest.approx(expected)
    assert errors == pytest.approx([ERROR] * 6)
    anew, error = bars(axes, "best plant, evaluated anew")
    assert anew == pytest.approx([final_absorbed(2)])
    assert error == pytest.approx([ERROR / 4])
    level = {line.get_label(): line.get_ydata() for line in axes.lines}
    assert level["baseline ± standard error"][0] == BASELINE
    assert len(level["mean"]) == 6
    assert {"generation", "absorbed PAR [MJ m⁻² day⁻¹]"} <= labels(figure)
    assert "mean ± standard deviation" in labels(figure)


def test_traits_show_ten_plants_and_bounds(finished: Path) -> None:
    with open_history(finished) as history:
        top = history.latest().top(10)
        figure = draw_traits(history)
    length, width, inclination, azimuth = figure.axes
    values, _ = horizontal_bars(length)
    assert values == pytest.approx(top.traits.values[:, ::4].mean(0))
    assert width.get_xlabel() == "width [m]"
    assert inclination.get_xlabel() == "inclination [°]"
    markers = [line.get_marker() for line in length.lines]
    # ten plants and the entry of the legend, the baseline, the means
    assert [markers.count(marker) for marker in "oD|"] == [10 + 1, 1, 1]
    assert length.get_xlim()[0] < 0.40 and length.get_xlim()[1] > 1.10
    # leaf 1 lies around north: its mean is near 0, far from 180
    shown = [horizontal_bars(azimuth, turn)[0][0] for turn in range(3)]
    assert min(abs(np.array(shown))) < 10
    assert "baseline" in labels(figure) and "bounds" in labels(figure)


def horizontal_bars(axes: Axes, turn: int = 0) -> tuple[np.ndarray, ...]:
    """Means by leaf and half-lengths of their bars; turn chooses one of the
    copies of a circular trait."""
    from matplotlib.container import ErrorbarContainer

    found = [c for c in axes.containers if isinstance(c, ErrorbarContainer)]
    line, _, (segments,) = found[turn].lines
    ends = np.array(segments.get_segments())
    return line.get_xdata(), (ends[:, 1, 0] - ends[:, 0, 0]) / 2


def test_azimuths_are_polar_and_averaged_on_the_circle(
    finished: Path,
) -> None:
    with open_history(finished) as history:
        figure = draw_azimuths(history)
    (axes,) = figure.axes
    assert axes.name == "polar"
    (mean,) = [
        line
        for line in axes.lines
        if line.get_label() == "circular mean ± deviation"
    ]
    first = np.rad2deg(mean.get_xdata()[0])
    # slots 11 ... 6 and 4 ... 1 at 355 + slot deg
    slots = [11, 10, 9, 8, 7, 6, 4, 3, 2, 1]
    assert (first + 180) % 360 - 180 == pytest.approx(
        355 + np.mean(slots) - 360, abs=0.05
    )
    assert "one plant (dark: fitter)" in labels(figure)


def test_hours_show_both_plants_and_their_difference(
    finished: Path,
) -> None:
    with open_history(finished) as history:
        figure = draw_hours(history)
    upper, lower = figure.axes
    best, error = bars(upper, "best")
    total = final_absorbed(2)
    expected = np.array([hour_par(total, h) for h in HOURS])
    assert best == pytest.approx(expected)
    assert error == pytest.approx(expected * ERROR / 4 / total)
    baseline, baseline_error = bars(upper, "baseline")
    difference, difference_error = bars(lower, "_")
    assert difference == pytest.approx(best - baseline)
    assert difference_error == pytest.approx(np.hypot(error, baseline_error))
    assert "1.500 ± 0.065 %" in upper.get_title()


def test_a_young_history_lacks_figures_and_says_why(
    writer: WriterProcess, tmp_path: Path
) -> None:
    with open_history(writer.path) as history:
        drawn = draw_figures(history, tmp_path)
    assert drawn.paths == []
    assert drawn.missing["traits"] == "no plant is evaluated yet"
    assert drawn.missing.keys() == FIGURES.keys()
    writer.do("propose 0")
    writer.do("record 0 0")
    with open_history(writer.path) as history:
        drawn = draw_figures(history, tmp_path)
    assert drawn.missing == {"convergence": "no generation is complete yet"}


def test_one_generation_is_enough(
    writer: WriterProcess, tmp_path: Path
) -> None:
    writer.do("evolve 1")
    with open_history(writer.path) as history:
        assert draw_figures(history, tmp_path).missing == {}


def test_units_are_printed_with_raised_exponents() -> None:
    assert unit_label("MJ m-2 day-1") == "MJ m⁻² day⁻¹"
    assert unit_label("deg") == "°"
    assert unit_label("m2 m-2") == "m² m⁻²"


def test_figures_lie_beside_the_history() -> None:
    assert default_folder("a/case.r1.h5") == Path("a/case.r1_figures")
    assert default_folder("a/case.r1") == Path("a/case.r1_figures")
