# SPDX-License-Identifier: Apache-2.0
"""Maps show gains over latitude and plant density."""

from __future__ import annotations

import numpy as np
import pytest
from made_history import MadeHistory
from made_numbers import BASELINE, final_absorbed

from ideotype.figures.gain_maps import draw_gain_map, draw_set_map, find_sets
from ideotype.figures.style import get_answer
from ideotype.history import HistoryError, Study, open_study

LATITUDES, PLANTS = (10.0, 50.0), (0.1, 0.2)
SETS = ("erect", "flat")


def shift(trait_set: str, latitude: float, plant: float) -> float:
    """Returns the additional light absorbed by optimised plants [MJ m-2
    day-1]: erect plants gain only in the dense stand."""
    if trait_set == "flat":
        return 0.0
    return (0.3 if plant == PLANTS[0] else -0.1) + latitude / 1000


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Study:
    folder = tmp_path_factory.mktemp("maps")
    for trait_set in SETS:
        for latitude in LATITUDES:
            for plant in PLANTS:
                place = f"at{latitude:.0f}_{1000 * plant:.0f}"
                made = MadeHistory(
                    folder / f"{place}_{trait_set}.h5",
                    attributes={
                        "case": f"{place}_{trait_set}_r1",
                        "site": f"at{latitude:.0f}",
                        "spacing": f"{1000 * plant:.0f}",
                        "trait_set": trait_set,
                        "latitude": latitude,
                        "row_spacing": 0.5,
                        "plant_spacing": plant,
                    },
                    shift=shift(trait_set, latitude, plant),
                )
                made.evolve(1)
                made.finish()
                made.close()
    with open_study(folder) as found:
        yield found


def best(trait_set: str, latitude: float, plant: float) -> float:
    return final_absorbed(2) + shift(trait_set, latitude, plant)


def test_gains_are_mapped_for_each_trait_set(study: Study) -> None:
    figure = draw_gain_map(study.cases())
    assert get_answer(figure)
    panels = [axes for axes in figure.axes if axes.images]
    assert [axes.get_title().split()[-1] for axes in panels] == [*SETS]
    for axes, trait_set in zip(panels, SETS):
        (image,) = axes.images
        # Axes begin with the lowest plant density and the southernmost site.
        expected = [
            [
                100 * (best(trait_set, latitude, plant) / BASELINE - 1)
                for plant in reversed(PLANTS)
            ]
            for latitude in LATITUDES
        ]
        assert np.asarray(image.get_array()) == pytest.approx(
            np.array(expected)
        )
        assert axes.get_xlabel() == "plant density [m⁻²]"
        assert axes.get_ylabel() == "latitude [°N]"
        assert [t.get_text() for t in axes.get_xticklabels()] == ["10", "20"]
        assert [t.get_text() for t in axes.get_yticklabels()] == ["10", "50"]
        numbers = [text.get_text().split("\n")[0] for text in axes.texts]
        assert any(
            float(x.replace("−", "-"))
            == pytest.approx(expected[0][0], abs=0.05)
            for x in numbers
        )


def test_two_trait_sets_have_a_line_where_they_are_equal(
    study: Study,
) -> None:
    assert find_sets(study.cases()) == SETS
    figure = draw_set_map(study.cases(), SETS)
    assert get_answer(figure)
    axes = figure.axes[0]
    shown = np.asarray(axes.images[0].get_array())
    expected = 100 * (best("erect", 50.0, 0.1) / best("flat", 50.0, 0.1) - 1)
    assert shown[1, 1] == pytest.approx(expected)
    assert np.all(shown[:, 0] < 0) and np.all(shown[:, 1] > 0)
    (line,) = axes.collections
    (path,) = line.get_paths()
    # At all latitudes the line lies between the low and the high density.
    at = path.vertices[path.vertices[:, 1] == 1.0][0]
    left, right = shown[1]
    assert at[0] == pytest.approx(-left / (right - left))


def test_a_single_trait_set_or_axis_has_no_map(study: Study) -> None:
    flat = [case for case in study.cases() if "flat" in case.name]
    assert find_sets(flat) is None
    with pytest.raises(HistoryError, match="do not differ in two of"):
        draw_gain_map(flat[:1])
    along = [case for case in flat if case.attributes["latitude"] == 10.0]
    with pytest.raises(HistoryError, match="do not differ in two of"):
        draw_gain_map(along)
