# SPDX-License-Identifier: Apache-2.0
"""The map of an atlas: in Python, in the report, and on the page of
`ideotype play`."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import numpy as np
import pytest
from live_browser import click, fits, serious_findings, settle, shown, text
from live_page import served
from real_program import output_of, write_campaign

from ideotype.figures.atlas import draw_atlas
from ideotype.figures.numbers import read_numbers
from ideotype.figures.style import get_answer
from ideotype.history import open_history
from ideotype.history.atlas import Atlas
from ideotype.history.case import Case

ACROSS, UP = (0.0, 8.0, 4), (0.0, 90.0, 3)


def run(folder: Path, *axes: tuple[str, tuple[float, float, int]]) -> Path:
    """Runs a short atlas search of the tiny campaign. Returns its history, and
    stores the output of the program next to it."""
    campaign = write_campaign(folder, 8)
    search = 'population = 12\noptimizer = "atlas"\n' + "".join(
        f'[[search.axes]]\nquantity = "{name}"\n'
        f"range = [{low}, {high}]\ncells = {cells}\n"
        for name, (low, high, cells) in axes
    )
    text = campaign.read_text().replace(
        'optimizer = "ga"\npopulation = 6\n', search
    )
    campaign.write_text(text.replace("candidates = 2\n", ""))
    output = output_of("run", campaign, "--out", folder)
    (path,) = (folder / "tiny").glob("*.h5")
    path.with_suffix(".txt").write_text(output)
    return path


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides an atlas over leaf area and the angle of the top leaves."""
    folder = tmp_path_factory.mktemp("atlas")
    return run(folder, ("lai", ACROSS), ("top_leaf_angle", UP))


def atlas_at(path: Path) -> Atlas:
    with open_history(path) as history:
        found = history.atlas()
    assert found is not None
    return found


def test_each_cell_has_one_leader_and_all_cells_are_counted(
    path: Path,
) -> None:
    atlas = atlas_at(path)
    for k, (name, (low, high, cells)) in enumerate(
        (("lai", ACROSS), ("top_leaf_angle", UP))
    ):
        values = atlas.leaders[name].values
        width = (high - low) / cells
        # Stands are uniform, so that features have no noise.
        np.testing.assert_array_equal(atlas.cells[:, k], values // width)
    assert len(np.unique(atlas.cells, axis=0)) == len(atlas.leaders) > 3
    match = re.search(
        r"best of (\d+) kinds of plants, (\d+) of them confirmed",
        path.with_suffix(".txt").read_text(),
    )
    assert match
    counts = (len(atlas.leaders), int(atlas.is_confirmed.sum()))
    assert tuple(map(int, match.groups())) == counts
    assert counts[1] > 0 and atlas.looks.max() > 2
    with open_history(path) as history:
        rows = history.evaluations()
    genomes = [g.tobytes() for g in rows.genome]
    for i, genome in enumerate(atlas.leaders.genome):
        assert genomes.count(genome.tobytes()) == atlas.looks[i]


def test_other_searches_have_no_atlas(tiny_run: Path) -> None:
    with open_history(tiny_run) as history:
        assert history.atlas() is None


def test_the_atlas_figure_shows_all_leaders(
    path: Path, tmp_path: Path
) -> None:
    atlas = atlas_at(path)
    with open_history(path) as history:
        figure = draw_atlas(Case("atlas", [history]))
    table = np.ma.filled(figure.axes[0].images[0].get_array(), np.nan)
    x, y = atlas.cells.T
    np.testing.assert_array_equal(table[y, x], atlas.leaders.objectives[:, 0])
    assert np.isfinite(table).sum() == len(atlas.leaders)
    assert f"of {len(atlas.leaders)} kinds" in get_answer(figure)
    (tmp_path / "atlas.csv").write_text(read_numbers(figure))
    with (tmp_path / "atlas.csv").open() as file:
        lines = list(csv.DictReader(file))
    series = [line["series"] for line in lines]
    open_ = int((~atlas.is_confirmed).sum())
    assert series.count("not confirmed") == open_
    values = {line["series"]: float(line["x"]) for line in lines[open_:]}
    for (i, j), value in zip(atlas.cells, atlas.leaders.objectives[:, 0]):
        place = f"{2 * i} to {2 * i + 2}, {30 * j} to {30 * j + 30}"
        assert values[place] == pytest.approx(value, rel=1e-6)


@pytest.mark.parametrize("axes", [1, 3])
def test_atlases_with_other_numbers_of_axes_are_drawn(
    axes: int, tmp_path: Path
) -> None:
    every = (("lai", ACROSS), ("plant_height", (0.0, 6.0, 3)))
    third = (("top_leaf_angle", UP),)
    path = run(tmp_path, *(every + third)[:axes])
    atlas = atlas_at(path)
    assert atlas.cells.shape == (len(atlas.leaders), axes)
    shown_ = atlas.on_two_axes()
    best: dict[tuple[int, ...], float] = {}
    for cell, value in zip(atlas.cells, atlas.leaders.objectives[:, 0]):
        key = tuple(cell[:2])
        best[key] = max(best.get(key, -np.inf), value)
    assert sorted(atlas.leaders.objectives[shown_, 0]) == sorted(best.values())
    with open_history(path) as history:
        assert "kinds" in get_answer(draw_atlas(Case("atlas", [history])))


@pytest.mark.long
def test_a_click_on_the_atlas_map_selects_a_plant(
    path: Path, tmp_path: Path
) -> None:
    atlas = atlas_at(path)
    with served("play", path) as page, shown(page, tmp_path) as phone:
        buttons = "document.querySelectorAll('#map button')"
        assert phone.value(f"{buttons}.length") == len(atlas.leaders)
        open_ = phone.value(
            "document.querySelectorAll('#map .is-open').length"
        )
        assert open_ == (~atlas.is_confirmed).sum()
        seen = set()
        for k in (0, len(atlas.leaders) - 1):
            phone.value(f"{buttons}[{k}].id = 'chosen-{k}'")
            click(phone, f"#chosen-{k}")
            settle(phone)
            genome = phone.value("page.shown.genome")
            i = int(np.argmin(abs(atlas.leaders.genome - genome).sum(1)))
            assert genome == pytest.approx(atlas.leaders.genome[i].tolist())
            seen.add(i)
            pressed = f"{buttons}[{k}].getAttribute('aria-pressed')"
            assert phone.value(pressed) == "true"
            area = phone.value("field.numbers.numbers.lai[0]")
            assert area // 2 == atlas.cells[i, 0]
            assert f"lai {2 * atlas.cells[i, 0]} to" in text(
                phone, "#map-text"
            )
        assert len(seen) == 2
        assert fits(phone)
        assert serious_findings(phone) == []


@pytest.mark.long
def test_the_page_of_another_search_has_no_atlas_map(
    tiny_run: Path, tmp_path: Path
) -> None:
    with served("play", tiny_run) as page, shown(page, tmp_path) as phone:
        assert phone.value("byId('map-card').hidden")
