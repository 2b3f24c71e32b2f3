# SPDX-License-Identifier: Apache-2.0
"""The page of `ideotype play` in a browser: files that are opened and saved,
growing plants, several kinds of plants, and the search."""

from __future__ import annotations

import io
import time
from pathlib import Path

import numpy as np
import pytest
from live_browser import click, move, number, settle, shown, text, view
from live_page import CAMPAIGNS, served
from made_obj import MIDRIBS, obj_of
from PIL import Image

from ideotype import Stand
from ideotype.live.opened import open_place

DAY = CAMPAIGNS / "ames.toml"
HOSTILE = "<img src=x onerror='window.hacked=1'>"


def arrived(folder: Path, pattern: str) -> Path:
    """Waits for a file that the page saves, and returns it."""
    end = time.monotonic() + 30
    while not (found := list(folder.glob(pattern))):
        assert time.monotonic() < end, list(folder.iterdir())
        time.sleep(0.1)
    return found[0]


def test_a_plant_its_field_and_a_picture_are_saved(tmp_path: Path) -> None:
    folder = tmp_path / "saved"
    folder.mkdir()
    with served("play", DAY) as page, shown(page, tmp_path) as phone:
        phone.ask("Page.setDownloadBehavior", behavior="allow",
                  downloadPath=str(folder))  # fmt: skip
        move(phone, "length_profile_2", 0.9)
        click(phone, "[data-tab=stand]")
        move(phone, "density", 0.25)
        genome = phone.value("page.shown.genome")
        density = phone.value("page.shown.conditions.density")
        for form in ("crop", "campaign", "picture"):
            click(phone, "#save-menu summary")
            click(phone, f"[data-save={form}]")
            arrived(folder, "*.png" if form == "picture" else f"*_{form}.toml")
        size = phone.value("[byId('view').width, byId('view').height]")
    crop = open_place(str(arrived(folder, "*_crop.toml")))
    assert crop.genome is not None
    campaign = open_place(str(arrived(folder, "*_campaign.toml")))
    assert campaign.conditions.density == pytest.approx(density)
    first = open_place(str(DAY))
    mesh = Stand(first.base).mesh(np.array(genome))
    for again in (crop, campaign):
        found = Stand(again.base).mesh(again.genome)
        assert found.vertices == pytest.approx(mesh.vertices, abs=1e-5)
    # The browser may still be writing the file.
    picture = arrived(folder, "*.png").read_bytes()
    with Image.open(io.BytesIO(picture)) as image:
        assert image.width == size[0] and image.height > size[1]
        assert len(image.convert("RGB").getcolors(1 << 24)) > 50


@pytest.mark.parametrize("kind", ["csv", "obj", "history", "crop"])
def test_measured_optimised_and_saved_plants_are_opened(
    kind: str, tmp_path: Path, tiny_run: Path
) -> None:
    if kind == "history":
        path = tiny_run
    elif kind == "crop":
        path = CAMPAIGNS / "crops" / "sorghum.toml"
    else:
        path = tmp_path / f"mine.{kind}"
        path.write_text(MIDRIBS if kind == "csv" else obj_of(MIDRIBS))
    expected = {
        "csv": "Measured: 2 leaves",
        "obj": "Measured: 2 leaves",
        "history": "The best plant of",
        "crop": "crop file",
    }[kind]
    with served("play", path) as page, shown(page, tmp_path) as phone:
        assert expected in text(phone, "#about")
        assert number(phone, "absorbed_par")[0] > 0
        name = phone.value("sliders.find((s) => s.index >= 0).input.id")[2:]
        picture = view(phone)
        move(phone, name, 0.95)
        assert view(phone) != picture


def test_names_are_no_html(tmp_path: Path) -> None:
    path = tmp_path / f"{HOSTILE}.csv"
    path.write_text(MIDRIBS)
    with served("play", path) as page, shown(page, tmp_path) as phone:
        assert HOSTILE in text(phone, "#title")
        assert HOSTILE in text(phone, "#about")
        assert HOSTILE in phone.value("document.title")
        click(phone, "#keep")
        settle(phone)
        assert phone.value("window.hacked") is None
        assert phone.value("document.images.length") == 0


def test_each_kind_of_plant_has_its_sliders(tmp_path: Path) -> None:
    campaign = CAMPAIGNS / "intercrop.toml"
    with served("play", campaign) as page, shown(page, tmp_path) as phone:
        assert phone.value("byId('component').length") == 2
        assert text(phone, "#traits").count("Internode") == 0
        maize = view(phone)
        phone.value("byId('component').selectedIndex = 1;"
                    "byId('component').dispatchEvent(new Event('change'))")  # fmt: skip
        settle(phone)
        assert view(phone) != maize
        name = phone.value(
            "sliders.find((s) => s.index >= 0 && s.label.startsWith("
            "page.hello.components[1])).input.id"
        )[2:]
        before = view(phone)
        move(phone, name, 0.9)
        assert view(phone) != before


def test_a_plant_is_seen_day_by_day(tmp_path: Path) -> None:
    campaign = CAMPAIGNS / "growing_season.toml"
    with served("play", campaign) as page, shown(page, tmp_path) as phone:
        click(phone, "[data-tab=stand]")
        grown = view(phone)
        tall = []
        for part in (0.1, 0.3, 0.5):
            move(phone, "age", part)
            assert "days after emergence" in text(phone, "#day-text")
            tall.append(phone.value("field.plants[1].tall"))
        assert tall == sorted(tall) and tall[0] < 0.5 * tall[-1]
        assert "June" in text(phone, "#titles") or "July" in text(
            phone, "#titles"
        )
        assert view(phone) != grown
        assert "days after emergence" in text(phone, ".charts")


def test_prices_and_seasons_change_the_margin(tmp_path: Path) -> None:
    campaign = CAMPAIGNS / "maize_belt.toml"
    with served("play", campaign) as page, shown(page, tmp_path) as phone:
        click(phone, "[data-tab=stand]")
        assert "Margin" in text(phone, "#numbers")
        assert text(phone, "#prices").count("per ") >= 4
        before, grain = (
            number(phone, name)[0] for name in ("margin", "grain_yield_moist")
        )
        move(phone, "price_grain", 0.5)
        after = number(phone, "margin")[0]
        price = phone.value("page.shown.conditions.price_grain")
        assert price == pytest.approx(285, abs=5)
        # The page has more random numbers than a moment ago.
        assert after - before == pytest.approx((price - 190) * grain, rel=0.2)
        move(phone, "season", 1)
        assert "made_2094" in text(phone, "#f-season")
        assert number(phone, "margin")[0] != after
        # Prices and soil need a season.
        is_hidden = "document.querySelector('[data-when=day]').hidden"
        assert phone.value(is_hidden) is True


def test_a_search_is_watched_and_undone(tmp_path: Path) -> None:
    with served("play", DAY) as page, shown(page, tmp_path) as phone:
        picture, genome = view(phone), phone.value("page.shown.genome")
        phone.value("byId('goal').value = 'absorbed_par'")
        click(phone, "#improve")
        phone.wait("byId('progress').value > 20", 120)
        assert view(phone) != picture
        phone.wait("byId('improve').textContent === 'Improve from here'", 300)
        settle(phone)
        message = text(phone, "#improve-text")
        assert (
            message.startswith("+")
            and "±" in message
            and "200 evaluations" in message
        )
        click(phone, "#undo")
        settle(phone)
        assert phone.value("page.shown.genome") == genome
        click(phone, "#improve")
        phone.wait("byId('progress').value > 0", 60)
        click(phone, "#improve")
        phone.wait("byId('improve').textContent === 'Improve from here'", 120)
        assert "200 evaluations" not in text(phone, "#improve-text")
