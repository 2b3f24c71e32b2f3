# SPDX-License-Identifier: Apache-2.0
"""Cases are compared with each other."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
from made_history import MadeHistory
from made_layout import seal
from made_numbers import final_absorbed

from ideotype.figures.comparison import ELITE, draw_energy
from ideotype.figures.cross import Cross, draw_cross
from ideotype.figures.places import draw_latitudes, draw_spacings
from ideotype.history import HistoryError
from ideotype.history.coordinates import short_names
from ideotype.history.estimate import NORMAL
from ideotype.history.study import open_study
from ideotype.report.tables import tabulate_gains

INCH = 0.0254


def make(
    path: Path,
    campaign: str = "",
    campaign_name: str = "made",
    **place: str | float,
) -> None:
    """Makes a finished history of one generation."""
    place = {"case": path.stem, "campaign": campaign_name, **place}
    made = MadeHistory(path, attributes=place, resolved=campaign)
    made.evolve(1)
    made.finish()
    made.close()


def test_spacings_have_a_line_for_each_distance_of_rows(
    tmp_path: Path,
) -> None:
    for rows in (15, 30):
        for plants in (3, 6):
            place = {
                "row_spacing": rows * INCH,
                "plant_spacing": plants * INCH,
            }
            make(tmp_path / f"{rows}x{plants}_r1.h5", **place)
    with open_study(tmp_path) as study:
        figure = draw_spacings(study.cases())
    (legend,) = figure.legends
    texts = [text.get_text() for text in legend.get_texts()]
    assert [text.split(", ", 1)[1] for text in texts] == [
        f"rows {rows} m" for rows in ("0.381", "0.762")
    ]
    lines = [
        line for line in figure.axes[1].lines if len(line.get_xdata()) == 2
    ]
    # 15 x 6 and 30 x 3 inches have equal plant densities; no line joins them.
    assert all(np.diff(line.get_xdata())[0] > 1 for line in lines)


def test_the_table_has_leaf_area_and_gain_per_leaf_area(
    tmp_path: Path,
) -> None:
    lais = (6.0, 5.0)
    for seed, lai in enumerate(lais, start=1):
        path = tmp_path / f"seed{seed}.h5"
        make(path, case=f"a_r{seed}")
        with h5py.File(path, "r+") as file:
            file["final/lai"][2] = lai
            light = file["final/absorbed_par"][2]
            file["final/absorbed_par_per_leaf_area"][2] = light / lai
            seal(file)
    with open_study(tmp_path) as study:
        (case,) = study.cases()
        pair = case.pairs[0]
        table, *_ = tabulate_gains([case], None)
        best = case.best.estimate("lai").mean
    ratio = 1.015 * 3.44 / np.array(lais)
    assert pair.gain_per_leaf_area.mean == pytest.approx(100 * (ratio[0] - 1))
    # Leaf area is exact, so that only the light contributes to the error.
    error = pair.gain.standard_error * 3.44 / 6.0
    assert pair.gain_per_leaf_area.standard_error == pytest.approx(error)
    found = dict(zip(table.header, table.rows[0]))
    assert found["LAI baseline"] == "3.44"
    # The table refers only to the best plant.
    assert found["LAI best"] == f"{best:.2f}"
    mean = case.gain_per_leaf_area().mean
    assert mean == pytest.approx(100 * (ratio.mean() - 1))
    assert found["gain per leaf area [%]"].startswith(
        f"{mean:.0f}\u00a0±".replace("-", "\N{MINUS SIGN}")
    )


def test_results_have_a_line_for_each_case_in_natural_order(
    tmp_path: Path,
) -> None:
    sites = ("lat0", "lat8", "lat16", "lat60s")
    for site in sites:
        attributes = {"site": site, "latitude": 1.0, "case": f"{site}_r1"}
        make(tmp_path / f"{site}_r1.h5", **attributes)
    with open_study(tmp_path) as study:
        table = study.results()
        (case, *_) = study.cases()
        best = case.best.objective
    assert [*table.site] == [*sites]
    first = table.iloc[0]
    assert first.best == best.mean
    assert first.best_high - first.best == pytest.approx(
        NORMAL * best.standard_error
    )
    assert first.gain == pytest.approx(first.best - first.baseline)
    assert first.searches == 1 and first.best_lai > 0 and first.is_final
    assert first.evaluations > 0
    assert table.attrs["units"]["gain_percent"] == "%"


def test_cases_are_named_by_their_differences(tmp_path: Path) -> None:
    for site in ("ames", "edmonton"):
        attributes = {"site": site, "case": f"{site}_all_r1"}
        make(tmp_path / f"{site}_all_r1.h5", **attributes)
    with open_study(tmp_path) as study:
        names = short_names(study.cases())
    assert names == {"ames_all": "ames", "edmonton_all": "edmonton"}


def test_an_objective_per_leaf_area_is_its_own_gain(tmp_path: Path) -> None:
    objective = ("absorbed_par_per_leaf_area", "maximise")
    path = tmp_path / "a_r1.h5"
    made = MadeHistory(path, objectives=[objective])
    made.evolve(1)
    made.finish()
    made.close()
    with h5py.File(path, "r+") as file:
        # The objective and its error are already per leaf area, and must not
        # be divided by leaf area again.
        file["final/lai"][2] = 6.0
        seal(file)
    with open_study(tmp_path) as study:
        (pair,) = study.cases()[0].pairs
    assert pair.gain_per_leaf_area == pair.gain
    assert pair.gain.mean == pytest.approx(1.5)


def test_histories_without_leaf_area_say_so(tmp_path: Path) -> None:
    make(tmp_path / "a_r1.h5")
    with h5py.File(tmp_path / "a_r1.h5", "r+") as file:
        for group in ("evaluations", "final"):
            for end in ("", "_standard_error"):
                del file[f"{group}/absorbed_par_per_leaf_area{end}"]
            del file[f"{group}/lai"]
        seal(file)
    with open_study(tmp_path) as study:
        table, *_ = tabulate_gains(study.cases(), None)
        with pytest.raises(HistoryError, match="has no absorbed_par_per"):
            study.cases()[0].gain_per_leaf_area()
    found = dict(zip(table.header, table.rows[0]))
    assert {found[name] for name in found if "LAI" in name} == {"–"}
    assert found["gain per leaf area [%]"] == "–"


def test_groups_at_two_latitudes_are_points(tmp_path: Path) -> None:
    north = {"latitude": 51.0, "day": "2025-07-15", "site": "calgary"}
    south = {"latitude": -34.0, "day": "2025-01-15", "site": "pergamino"}
    make(tmp_path / "north_r1.h5", **north)
    with (
        open_study(tmp_path) as study,
        pytest.raises(HistoryError, match="^all cases have the same lat"),
    ):
        draw_latitudes(study.cases())
    make(tmp_path / "south_r1.h5", campaign_name="other", **south)
    with open_study(tmp_path) as study:
        left, right = draw_latitudes(study.cases()).axes
    drawn = [bar.lines[0] for bar in right.containers]
    assert [line.get_xdata().tolist() for line in drawn] == [[51.0], [-34.0]]
    assert [line.get_linestyle() for line in drawn] == ["None", "None"]
    assert [bar.get_label() for bar in left.containers] == [
        f"{place} 30x6 all, {who}"
        for place in ("made: 2025-07-15", "other: 2025-01-15")
        for who in ("baseline", "best")
    ]


def test_a_latitude_that_no_line_shows_is_a_point(tmp_path: Path) -> None:
    for site, latitude in (("ames", 42.0), ("edmonton", 53.5)):
        make(tmp_path / f"{site}_r1.h5", latitude=latitude, site=site)
    for site, latitude in (("ames", 42.0), ("pergamino", -34.0)):
        place = {"latitude": latitude, "site": site, "day": f"{site}-day"}
        make(tmp_path / f"{site}_winter_r1.h5", **place)
    with open_study(tmp_path) as study:
        _, right = draw_latitudes(study.cases()).axes
    drawn = [bar.lines[0].get_xdata().tolist() for bar in right.containers]
    assert drawn == [[42.0, 53.5], [-34.0]]


def test_a_cross_evaluation_serves_two_campaigns(tmp_path: Path) -> None:
    for campaign, names in (("one", "ac"), ("two", "bc")):
        for name in names:
            path = tmp_path / f"{campaign}_{name}.h5"
            make(path, campaign_name=campaign, case=f"{name}_r1")
    mean = np.array([[10.0, 11.0, 10.5, 10.8]])
    lights = ("a", "b", "c", "two: c")
    cross = Cross((ELITE,), lights, mean, np.zeros_like(mean))
    with open_study(tmp_path) as study:
        over = {c.name: cross.relative_gain(c, ELITE) for c in study.cases()}
        table, *notes = tabulate_gains(study.cases(), cross)
    best = final_absorbed(2)
    # Both campaigns have a case "c", so that the name is ambiguous.
    assert over.pop("one: c") is None
    assert {name: gain and gain.mean for name, gain in over.items()} == {
        "one: a": pytest.approx(100 * (best / 10.0 - 1)),
        "two: b": pytest.approx(100 * (best / 11.0 - 1)),
        "two: c": pytest.approx(100 * (best / 10.8 - 1)),
    }
    column = table.header.index("over elite [%]")
    assert [row[column] for row in table.rows].count("–") == 1
    (note,) = [n.text for n in notes if "not known" in n.text]
    assert note.endswith(": one: c.")
    independent = [n.text for n in notes if "as independent" in n.text]
    assert len(independent) == 1 and "over the elite plant" in independent[0]


def test_isolated_plots_have_a_separate_panel(tmp_path: Path) -> None:
    make(tmp_path / "stand_r1.h5")
    make(tmp_path / "plot_r1.h5", '[field]\nboundary = "isolated"')
    with open_study(tmp_path) as study:
        stands, plots = draw_energy(study.cases()).axes
    assert stands.get_xlabel() == "fraction of incident PAR"
    assert "isolated plot" in plots.get_xlabel()
    assert [t.get_text() for t in plots.get_yticklabels()] == [
        *("plot\nbaseline", "best"),
    ]


def test_seeds_are_put_together_in_a_cross_evaluation() -> None:
    plants = ("ames_all_r1", "ames_all_r2", "oslo_all_r1", "b73")
    mean = np.array([[11.0, 10.0], [11.2, 10.2], [np.nan, 10.3], [9.0, 8.0]])
    cross = Cross(plants, ("ames", "oslo"), mean, np.full((4, 2), 0.01))
    (ames, bred), (oslo, lonely), (b73, _) = cross.seeds_together()
    assert (ames, oslo, b73) == ("ames_all", "oslo_all_r1", "b73")
    assert bred[0] is not None and bred[0].mean == pytest.approx(11.1)
    # The interval is Student's t with one degree of freedom times the standard
    # error.
    assert bred[0].below == pytest.approx(12.7062 * 0.1)
    assert lonely[0] is None and lonely[1] is not None
    assert lonely[1].below == pytest.approx(0.0196)
    axes, _ = draw_cross(cross).axes
    texts = [text.get_text() for text in axes.texts]
    assert texts[0] == "100\n±11" and len(texts) == 5
