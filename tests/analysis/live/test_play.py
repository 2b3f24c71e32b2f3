# SPDX-License-Identifier: Apache-2.0
"""The page of `ideotype play` in a browser: its views, changes and saved
files. test_live.py and test_live_talk.py communicate with the program without
a page."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from live_browser import (
    WIDTHS,
    bare,
    click,
    fits,
    move,
    number,
    serious_findings,
    settle,
    shown,
    text,
    view,
)
from live_page import Served
from phone import Phone

SHAPE = "length_profile_2"


@pytest.fixture(params=WIDTHS)
def phone(
    day: Served, tmp_path: Path, request: pytest.FixtureRequest
) -> Iterator[Phone]:
    """Provides the page at each width."""
    with shown(day, tmp_path, request.param) as found:
        yield found


def key(phone: Phone, name: str, modifiers: int = 0, code: int = 0) -> None:
    for kind in ("rawKeyDown", "keyUp"):
        phone.ask(
            "Input.dispatchKeyEvent", type=kind, key=name, modifiers=modifiers,
            code=name, windowsVirtualKeyCode=code,
        )  # fmt: skip


def test_plants_and_numbers_with_errors_are_seen(phone: Phone) -> None:
    assert fits(phone)
    assert 0.1 < bare(phone) < 0.95
    numbers = text(phone, "#numbers")
    assert (
        "Absorbed PAR" in numbers
        and numbers.count("±") == 2
        and numbers.count("no difference") == 3
    )
    assert "NaN" not in numbers and "undefined" not in numbers
    assert phone.value("document.querySelectorAll('.chart .line').length") >= 3
    assert "ames" in phone.value("document.title")


def test_a_slider_moves_shape_and_light_and_is_undone(phone: Phone) -> None:
    area, picture = number(phone, "lai")[0], view(phone)
    genome = phone.value("page.shown.genome")
    move(phone, SHAPE, 0.95)
    moved = number(phone, "lai")[0]
    assert view(phone) != picture and moved > 1.02 * area
    assert number(phone, "absorbed_par")[1] > 0
    row = text(phone, "#numbers [data-name=absorbed_par]")
    assert row.count("±") == 2 and "%" in row
    assert "+" in text(phone, "#numbers [data-name=lai] .apart.clear")
    click(phone, "#undo")
    settle(phone)
    assert number(phone, "lai")[0] == pytest.approx(area)
    assert phone.value("page.shown.genome") == genome
    click(phone, "#redo")
    settle(phone)
    assert number(phone, "lai")[0] == pytest.approx(moved)
    click(phone, "#again")
    settle(phone)
    assert phone.value("page.shown.genome") == genome


def test_stop_is_readable_below_the_mouse(phone: Phone) -> None:
    click(phone, "#improve")
    phone.value("byId('improve').scrollIntoView({ block: 'center' })")
    x, y = phone.value(
        "(({ x, y, width, height }) => [x + width / 2, y + height / 2])"
        "(byId('improve').getBoundingClientRect())"
    )
    phone.ask("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
    assert phone.value("byId('improve').matches(':hover')")
    assert text(phone, "#improve") == "Stop"
    ink, paper = (
        luminance(phone.value(f"getComputedStyle(byId('improve')).{name}"))
        for name in ("color", "backgroundColor")
    )
    # Contrast by WCAG 2.1.
    assert (max(ink, paper) + 0.05) / (min(ink, paper) + 0.05) > 4.5
    phone.wait("byId('progress').value > 0", 60)
    assert "provisional" in text(phone, "#improve-text")
    click(phone, "#improve")
    phone.wait("!search", 120)
    assert "provisional" not in text(phone, "#improve-text")
    assert "Absorbed PAR" in text(phone, "#improve-text")


def luminance(color: str) -> float:
    """Returns the relative luminance of a colour such as rgb(1, 2, 3)."""
    parts = [int(x) / 255 for x in re.findall(r"\d+", color)[:3]]
    red, green, blue = (
        x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4
        for x in parts
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def test_no_button_covers_the_scale(phone: Phone) -> None:
    for zoom in (0.5, 1.25, 2.0, 4.0):
        phone.value(f"look({{ zoom: {zoom} }})")
        view(phone)
        view_box, *buttons = phone.value(
            """[byId("view"), ...document.querySelectorAll(".looks button")]
              .map((e) => { const r = e.getBoundingClientRect();
                return [r.left, r.top, r.right, r.bottom]; })"""
        )
        metres, scale = phone.value(
            "[Number(byId('view').dataset.metres), "
            "Number(byId('view').dataset.scale)]"
        )
        end = view_box[0] + 12 + metres * scale
        for left, top, _, _ in buttons:
            assert left > end or top >= view_box[3]


def test_the_sticky_box_shows_whole_lines(phone: Phone) -> None:
    # A page about a season has several goals.
    phone.value(
        "page.hello.goals = page.hello.quantities.slice(0, 3)"
        ".map((q) => q.name); showStrip(field.numbers)"
    )
    cut = phone.value(
        """(() => {
          const box = byId("strip").getBoundingClientRect();
          return [...byId("strip").children].filter((span) => {
            const { top, bottom } = span.getBoundingClientRect();
            return top < box.bottom && bottom > box.bottom;
          }).map((span) => span.textContent);
        })()"""
    )
    assert cut == []


def test_names_and_hours_are_written_as_usual(phone: Phone) -> None:
    phone.value("byId('all').open = true")
    phone.wait("byId('all-numbers').children.length > 0")
    names = phone.value(
        "[...document.querySelectorAll('#all-numbers dt')]"
        ".map((e) => e.textContent)"
    )
    assert "Absorbed PAR per leaf area" in names
    assert not re.search(r"\b(par|Co2|co2|lai|nir)\b", " ".join(names))
    ticks = phone.value(
        "[...document.querySelectorAll('#by-hour .tick')]"
        ".map((e) => e.textContent)"
    )
    assert len([each for each in ticks if re.fullmatch(r"\d+:00", each)]) > 3


def test_single_leaves_are_behind_a_fold(phone: Phone) -> None:
    click(phone, "#leaves summary")
    phone.value("byId('leaf').value = '8'; byId('leaf').onchange()")
    name = phone.value("document.querySelector('#leaf-traits input').id")
    picture = view(phone)
    move(phone, name[2:], 0.9)
    assert view(phone) != picture


def test_plants_stand_side_by_side(phone: Phone) -> None:
    move(phone, SHAPE, 0.9)
    click(phone, "#keep")
    settle(phone)
    assert phone.value("byId('pair').checked")
    assert text(phone, "#titles").split("\n") == [
        "reference plant",
        "this plant",
    ]
    kept, before = phone.value("page.shown.reference"), view(phone)
    move(phone, SHAPE, 0.1)
    assert phone.value("page.shown.reference") == kept
    assert view(phone) != before
    assert "clear" in phone.value(
        "document.querySelector('[data-name=lai] .apart').className"
    )


def test_panels_shade_the_field(phone: Phone) -> None:
    light, picture = number(phone, "absorbed_par")[0], view(phone)
    click(phone, "[data-tab=stand]")
    click(phone, "#panels")
    settle(phone)
    assert number(phone, "absorbed_par")[0] < 0.9 * light
    assert view(phone) != picture
    shaded = number(phone, "absorbed_par")[0]
    move(phone, "panel_rows", 0.9)
    assert number(phone, "absorbed_par")[0] > 1.1 * shaded
    click(phone, "#panels")
    settle(phone)
    assert number(phone, "absorbed_par")[0] == pytest.approx(light, rel=0.1)


def test_density_rows_place_and_time_change_the_light(phone: Phone) -> None:
    click(phone, "[data-tab=stand]")
    for name, part in (
        # A dense stand absorbs nearly all light at any row direction.
        *(("direction", 0.3), ("density", 0.8), ("row", 0.2)),
        *(("latitude", 0.2), ("day", 0.1)),
    ):
        before = number(phone, "absorbed_par")[0]
        move(phone, name, part)
        after, error = number(phone, "absorbed_par")
        assert after != before and error > 0, name
    click(phone, "[data-when=hour]")
    settle(phone)
    noon = number(phone, "absorbed_par")[0]
    move(phone, "hour", 0.3)
    assert 0 <= number(phone, "absorbed_par")[0] < noon


def test_an_hour_of_the_night_has_no_light_and_ends_nothing(
    phone: Phone,
) -> None:
    click(phone, "[data-tab=stand]")
    click(phone, "[data-when=hour]")
    settle(phone)
    phone.value("byId('s-hour').value = 3;"
                "byId('s-hour').dispatchEvent(new Event('input'))")  # fmt: skip
    phone.wait("!byId('notice').hidden")
    assert "sun" in text(phone, "#notice")
    move(phone, "hour", 0.5)
    assert phone.value("byId('notice').hidden")


def test_all_is_done_with_keys(day: Served, tmp_path: Path) -> None:
    with shown(day, tmp_path) as phone:
        reached = set()
        for _ in range(80):
            key(phone, "Tab", code=9)
            reached.add(phone.value(
                "document.activeElement.id || document.activeElement.innerText"
            ))  # fmt: skip
        assert {f"s-{SHAPE}", "view", "color", "goal", "improve", "keep",
                "pair"} <= reached  # fmt: skip
        phone.value(f"byId('s-{SHAPE}').focus()")
        outline = "getComputedStyle(document.activeElement).outlineStyle"
        assert phone.value(outline) != "none"
        before = phone.value(f"byId('s-{SHAPE}').value")
        phone.press("ArrowRight")
        settle(phone)
        after = phone.value(f"byId('s-{SHAPE}').value")
        assert float(after) > float(before)
        said = phone.value(f"byId('s-{SHAPE}').getAttribute('aria-valuetext')")
        assert said.endswith(" cm")
        key(phone, "z", modifiers=2, code=90)
        settle(phone)
        assert phone.value(f"byId('s-{SHAPE}').value") == before
        key(phone, "y", modifiers=2, code=89)
        settle(phone)
        assert phone.value(f"byId('s-{SHAPE}').value") == after
        phone.value("byId('view').focus()")
        picture = view(phone)
        phone.press("ArrowLeft")
        assert view(phone) != picture
        phone.press("Home")
        assert view(phone) == picture


def test_a_finger_turns_the_plants_and_the_page_scrolls(
    day: Served, tmp_path: Path
) -> None:
    with shown(day, tmp_path, 390) as phone:
        x, y = phone.value(
            "(() => { const b = byId('view').getBoundingClientRect();"
            "return [b.left + 100, b.top + 100]; })()"
        )
        turned = phone.value("field.view.turn")
        phone.swipe((x, y), (12, 0))
        assert phone.value("field.view.turn") != turned
        phone.swipe((200, 700), (0, -30))
        phone.wait("scrollY > 50")


@pytest.mark.parametrize("what", ["plant", "stand", "pair"])
def test_axe_finds_nothing_serious(phone: Phone, what: str) -> None:
    if what == "pair":
        move(phone, SHAPE, 0.9)
        click(phone, "#keep")
        click(phone, "#save-menu summary")
        phone.value("for (const d of document.querySelectorAll('details'))"
                    "d.open = true")  # fmt: skip
    else:
        click(phone, f"[data-tab={what}]")
        phone.value("if (!byId('panels').checked) byId('panels').click()")
    settle(phone)
    assert serious_findings(phone) == []
