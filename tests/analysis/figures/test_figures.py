# SPDX-License-Identifier: Apache-2.0
"""Figures show the numbers of histories."""

from __future__ import annotations

import io
from pathlib import Path

import matplotlib
import numpy as np
import pandas
import pytest
from conftest import SHIFTS
from drawn import bars, horizontal_bars, labels
from made_numbers import (
    BASELINE,
    ERROR,
    HOURS,
    POPULATION,
    absorbed,
    final_absorbed,
    hour_par,
    leaf_share,
)

from ideotype.common.labels import unit_label
from ideotype.figures.azimuths import draw_azimuths
from ideotype.figures.convergence import draw_convergence
from ideotype.figures.numbers import read_numbers
from ideotype.figures.profiles import draw_hours, draw_layers, draw_leaves
from ideotype.figures.shape import draw_traits
from ideotype.figures.shares import draw_parts
from ideotype.figures.style import RC, get_answer
from ideotype.history import HistoryError
from ideotype.history.estimate import NORMAL
from ideotype.history.study import open_study


def test_convergence_shows_best_mean_spread_and_baseline(
    finished: Path,
) -> None:
    with open_study(finished) as study:
        figure = draw_convergence(study.cases()[0])
    axes = figure.axes[0]
    values, errors = bars(axes, "best of its generation (not re-evaluated)")
    expected = [absorbed(g, POPULATION - 1) for g in range(6)]
    assert values == pytest.approx(expected)
    assert errors == pytest.approx([NORMAL * ERROR] * 6)
    again, error = bars(axes, "best plant, re-evaluated")
    assert again == pytest.approx([final_absorbed(2)])
    assert error == pytest.approx([NORMAL * ERROR / 4])
    level = {line.get_label(): line.get_ydata() for line in axes.lines}
    assert level["baseline"][0] == BASELINE
    assert len(level["mean"]) == 6
    light = "absorbed PAR [MJ m⁻² day⁻¹ of ground]"
    assert {"generation", light} <= labels(figure)
    assert "standard deviation about the mean" in labels(figure)


def test_traits_show_ten_plants_and_bounds(finished: Path) -> None:
    with open_study(finished) as study:
        case = study.cases()[0]
        top = case.top(10)
        figure = draw_traits(case)
    length, width, insertion_angle, azimuth = figure.axes
    values, _ = horizontal_bars(length)
    assert values == pytest.approx(top.genome[:, ::4].mean(0))
    assert width.get_xlabel() == "width [m]"
    assert insertion_angle.get_xlabel() == "insertion angle [°]"
    markers = [line.get_marker() for line in length.lines]
    # Ten plants, the baseline and the means are drawn.
    assert [markers.count(marker) for marker in "oD|"] == [10, 1, 1]
    assert length.get_xlim()[0] < 0.40 and length.get_xlim()[1] > 1.10
    # The azimuths of leaf 1 scatter around the row: their mean is near 0, far
    # from 180.
    mean, _ = horizontal_bars(azimuth)
    assert min(mean[0], 360 - mean[0]) < 10
    assert "baseline" in labels(figure) and "bounds" in labels(figure)


def test_the_numbers_file_has_the_ends_of_bounds(finished: Path) -> None:
    with open_study(finished) as study:
        case = study.cases()[0]
        text = read_numbers(draw_traits(case))
        genes = case.genes
    table = pandas.read_csv(io.StringIO(text))
    bounds = table[table.series == "bounds"]
    assert bounds.x.isna().all()
    columns = genes.columns("length")
    length = bounds[bounds.panel.str.contains("length")]
    assert length.x_low.to_numpy() == pytest.approx(genes.lower[columns])
    assert length.x_high.to_numpy() == pytest.approx(genes.upper[columns])


def test_circular_means_and_their_bars_stay_on_the_axis(
    finished: Path,
) -> None:
    with open_study(finished) as study:
        case = study.cases()[0]
        figure = draw_traits(case)
        top = case.top(10).genome[:, 3]
    azimuth = figure.axes[-1]
    means, _ = horizontal_bars(azimuth)
    assert np.all((means >= 0) & (means < 360))
    parts = [
        segment
        for lines in azimuth.collections
        for segment in lines.get_segments()
        if lines.get_segments()
    ]
    ends = np.array(parts)[..., 0]
    assert ends.min() >= 0 and ends.max() <= 360
    # The error bar of leaf 1 crosses 0 deg and is therefore drawn in two
    # parts, with a total length of twice the deviation.
    at = np.array(parts)[:, 0, 1] < 1
    lengths = (ends[:, 1] - ends[:, 0])[at]
    away = (top + 180) % 360 - 180
    assert len(lengths) == 2 and min(lengths) > 0
    assert sum(lengths) == pytest.approx(2 * away.std(), rel=0.01)


def test_standard_deviations_are_drawn_completely(finished: Path) -> None:
    """The plants are at both bounds, so that the deviation extends beyond the
    bounds."""
    with open_study(finished) as study:
        case = study.cases()[0]
        top = case.top(10)
        top.genome[:7, 0] = case.genes.upper[0]
        top.genome[7:, 0] = case.genes.lower[0]
        case.top = lambda count: top
        figure = draw_traits(case)
    means, half = horizontal_bars(figure.axes[0])
    assert means[0] + half[0] > case.genes.upper[0]
    left, right = figure.axes[0].get_xlim()
    assert left < means[0] - half[0] and means[0] + half[0] < right


def test_the_legend_of_many_seeds_fits(sweep: Path) -> None:
    with matplotlib.rc_context(RC), open_study(sweep) as study:
        figure = draw_convergence(study.cases()[0])
        figure.draw_without_rendering()
    (legend,) = figure.legends
    box = legend.get_window_extent()
    assert box.x0 >= 0 and box.x1 <= figure.bbox.width


def test_azimuths_are_polar_and_averaged_on_the_circle(
    finished: Path,
) -> None:
    with open_study(finished) as study:
        figure = draw_azimuths(study.cases()[0])
    axes, _ = figure.axes
    assert axes.name == "polar"
    (mean,) = [
        line
        for line in axes.lines
        if line.get_label() == "circular mean and deviation"
    ]
    first = np.rad2deg(mean.get_xdata()[0])
    # The azimuth of leaf 1 in slots 11 ... 6 and 4 ... 1 is 355 + slot [deg].
    slots = [11, 10, 9, 8, 7, 6, 4, 3, 2, 1]
    assert (first + 180) % 360 - 180 == pytest.approx(
        355 + np.mean(slots) - 360, abs=0.05
    )
    assert "single plant (darker: fitter)" in labels(figure)


def test_hours_show_both_plants_and_their_difference(
    finished: Path,
) -> None:
    with open_study(finished) as study:
        figure = draw_hours(study.cases()[0])
    upper, lower = figure.axes
    best, error = bars(upper, "best")
    total = final_absorbed(2)
    expected = np.array([hour_par(total, h) for h in HOURS])
    assert best == pytest.approx(expected)
    assert error == pytest.approx(NORMAL * expected * ERROR / 4 / total)
    baseline, baseline_error = bars(upper, "baseline")
    difference, difference_error = bars(lower, "_")
    assert difference == pytest.approx(best - baseline)
    assert difference_error == pytest.approx(np.hypot(error, baseline_error))
    assert get_answer(figure).startswith("The largest difference is at ")


def test_units_are_printed_with_raised_exponents() -> None:
    assert unit_label("MJ m-2 day-1") == "MJ m⁻² day⁻¹"
    assert unit_label("deg") == "°"
    assert unit_label("m2 m-2") == "m² m⁻²"


def test_several_seeds_are_drawn_as_a_band(sweep: Path) -> None:
    with open_study(sweep) as study:
        figure = draw_convergence(study.cases()[0])
    axes = figure.axes[0]
    lines = {line.get_label(): line.get_ydata() for line in axes.lines}
    highest = np.array([absorbed(g, POPULATION - 1) for g in range(6)])
    best = lines["best of its generation (not re-evaluated), mean of seeds"]
    assert best == pytest.approx(highest + np.mean(SHIFTS))
    (band,) = [
        c
        for c in axes.collections
        if c.get_label()
        == "best of its generation (not re-evaluated), range of seeds"
    ]
    edges = band.get_paths()[0].vertices
    at_start = edges[edges[:, 0] == 0, 1]
    assert at_start.min() == pytest.approx(highest[0] + SHIFTS[0])
    assert at_start.max() == pytest.approx(highest[0] + SHIFTS[1])
    again, _ = bars(axes, "best plant, re-evaluated")
    expected = [final_absorbed(2) + shift for shift in SHIFTS]
    assert again == pytest.approx(expected)


def test_the_ten_best_plants_are_from_all_seeds(sweep: Path) -> None:
    with open_study(sweep) as study:
        case = study.cases()[0]
        top, seeds = case.top(10), case.seeds_of_top(10)
    # Both seeds have the same plants; those of the second seed are better by
    # the shift.
    expected = sorted(
        (absorbed(5, s) + max(SHIFTS) for s in range(POPULATION) if s != 5),
        reverse=True,
    )
    assert top.objectives[:, 0] == pytest.approx(expected[:10])
    assert seeds == 1


def test_light_is_drawn_by_rank_layer_and_origin(sweep: Path) -> None:
    with open_study(sweep) as study:
        case = study.cases()[0]
        total = case.best.objective.mean
        ranks, layers = draw_leaves(case), draw_layers(case)
        parts = draw_parts(case)
    best, _ = horizontal_bars(ranks.axes[0], 1)
    assert best == pytest.approx([leaf_share(n) * total for n in range(1, 11)])
    best, error = horizontal_bars(layers.axes[0], 1)
    assert best == pytest.approx([total / 3] * 3)
    assert error == pytest.approx([NORMAL * ERROR / 4 / 3] * 3)
    middle = layers.axes[0].lines[-1].get_ydata()
    assert middle == pytest.approx([0.125, 0.375, 0.75])
    best, _ = horizontal_bars(parts.axes[0], 1)
    assert best == pytest.approx([0.75 * total, 0.25 * total])
    words = [t.get_text() for t in parts.axes[0].get_yticklabels()]
    assert words == ["beam", "sky"]


def test_a_missing_column_is_named(finished: Path) -> None:
    with (
        open_study(finished) as study,
        pytest.raises(HistoryError, match="by height layer"),
    ):
        draw_layers(study.cases()[0])
