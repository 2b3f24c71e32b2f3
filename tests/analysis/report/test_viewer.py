# SPDX-License-Identifier: Apache-2.0
"""The 3D view is drawn correctly, as its pixels show."""

from __future__ import annotations

import base64
import json
from pathlib import Path

import numpy as np
import pytest
from browser import run_in_browser
from phone import WIDTH, phone_with

from ideotype.report.blocks import Picture, Section, Viewer
from ideotype.report.page import render
from ideotype.report.scene import pack_vertices

TURN = 0.6
"""The turn of the view at its start, about the vertical."""
PURPLE, YELLOW = (68, 1, 84), (253, 231, 37)
"""The ends of the colour map."""
GREEN = (126, 148, 112)
"""The colour of groups whose light is not shown."""
TITLE = "9.4317 ± 0.0092 MJ m⁻² day⁻¹"
NEIGHBOURS = [[-0.7, 0.0], [0.7, 0.0]]


def upright(ends: list[tuple[float, float]]) -> list[list[float]]:
    """Returns the corners of an upright leaf. Its ends are given in the
    initial view: to the right, and away from the viewer."""
    c, s = np.cos(TURN), np.sin(TURN)
    low, high = [
        [[c * r + s * away, c * away - s * r, z] for r, away in ends]
        for z in (0.2, 2.0)
    ]
    return [*low, *high[::-1]]


def make_scene(direction: float | None = 90.0) -> str:
    """Returns two crossing leaves: the first is nearer at its left end, the
    second at its right end."""
    vertices = upright([(-0.5, -0.5), (0.5, 0.5)])
    vertices += upright([(-0.5, 0.5), (0.5, -0.5)])
    shape = {
        "faces": [[0, 1, 2, 3], [4, 5, 6, 7]],
        "groups": ["leaf01", "leaf02"],
        "group": [0, 1],
        "colors": [list(GREEN), list(GREEN)],
    }
    case = {
        "name": "made",
        "front": None,
        "plants": [
            {
                "title": f"{name}: {TITLE}",
                "shape": 0,
                **pack_vertices(np.array(vertices)),
            }
            for name in ("baseline", "best")
        ],
        "quantities": [
            {
                "label": "of each leaf [MJ m⁻² day⁻¹ of ground]",
                "values": [[0.0, 1.0], [1.0, 0.0]],
            }
        ],
        "row_direction": direction,
        "neighbours": NEIGHBOURS,
    }
    return json.dumps({"shapes": [shape], "cases": [case]})


def page_of(folder: Path, scene: str) -> Path:
    """Writes a page with two pictures below the 3D view."""
    section = Section("View", [Viewer(scene, "What is shown.")])
    drawing = (
        '<svg xmlns="http://www.w3.org/2000/svg" width="900" height="600"/>'
    )
    code = base64.b64encode(drawing.encode()).decode()
    section.blocks += [
        Picture(name, f"How is {name}?", "Well.", name, code)
        for name in ("one", "two")
    ]
    page = folder / "view.html"
    page.write_text(render("Made", "view", [section]), encoding="utf-8")
    return page


PIXELS = """
  const view = document.getElementById("view");
  const click = (name) => document.querySelector(name).click();
  const context = view.getContext("2d");
  const dense = view.width / view.clientWidth;
  const panel = view.clientWidth / 2;
  const color = (x, y) =>
    [...context.getImageData(dense * x, dense * y, 1, 1).data].slice(0, 3);
"""


NEARER = (
    PIXELS
    + """
  const at = (plant, side) => color(
    panel * (plant + 0.5) + side * 0.25 * view.dataset.scale,
    view.clientHeight / 2);
  return [[at(0, -1), at(0, 1)], [at(1, -1), at(1, 1)]];
"""
)
"""The colours of the nearer leaf on the left and on the right of each
plant."""


def hue(color: list[int]) -> np.ndarray:
    """Returns a colour without shading."""
    return np.array(color) / max(color)


def test_nearer_leaves_hide_leaves_behind_them(tmp_path: Path) -> None:
    page = page_of(tmp_path, make_scene())
    shown, errors = run_in_browser(page, NEARER, tmp_path)
    assert errors == []
    for plant, colors in zip(shown, ((PURPLE, YELLOW), (YELLOW, PURPLE))):
        for found, expected in zip(plant, colors):
            assert hue(found) == pytest.approx(hue(list(expected)), abs=0.03)


def test_plants_have_their_size(tmp_path: Path) -> None:
    script = (
        PIXELS
        + """
      const at = (across) => color(
        panel / 2 + across * view.dataset.scale, view.clientHeight / 2);
      return [0.48, 0.52].map((across) => at(across));
    """
    )
    shown, errors = run_in_browser(
        page_of(tmp_path, make_scene()), script, tmp_path
    )
    assert errors == []
    assert shown[0] != [255, 255, 255] == shown[1]


def test_organs_without_light_have_separate_colours(
    tmp_path: Path,
) -> None:
    scene = json.loads(make_scene())
    scene["cases"][0]["quantities"][0]["values"] = [[None, 1.0], [0.0, None]]
    page = page_of(tmp_path, json.dumps(scene))
    ((left, _), (_, right)), errors = run_in_browser(page, NEARER, tmp_path)
    assert errors == []
    for found in (left, right):
        assert hue(found) == pytest.approx(hue(list(GREEN)), abs=0.03)


@pytest.mark.parametrize("direction", [0.0, 90.0, 225.0, None])
def test_the_ground_shows_north_from_above(
    tmp_path: Path, direction: float | None
) -> None:
    """The black pixels are those of the arrow, which lies on the ground around
    the plant."""
    script = (
        PIXELS
        + """
      click("[data-view=above]");
      const { data, width } = context.getImageData(
        0, 0, dense * panel, view.height - 30 * dense);
      const found = [];
      for (let i = 0; i < data.length / 4; ++i)
        if (data[4 * i] + data[4 * i + 1] + data[4 * i + 2] === 0)
          found.push([
            (i % width) / dense - panel / 2,
            view.clientHeight / 2 - Math.floor(i / width) / dense]);
      const mean = (k) => found.reduce((a, f) => a + f[k], 0) / found.length;
      return {
        count: found.length, at: [mean(0), mean(1)],
        ground: color(panel / 2 + 0.3 * view.dataset.scale,
          view.clientHeight / 2 + 0.5 * view.dataset.scale),
      };
    """
    )
    page = page_of(tmp_path, make_scene(direction))
    shown, errors = run_in_browser(page, script, tmp_path)
    assert errors == []
    assert shown["ground"] == [240, 233, 222]
    if direction is None:
        # The only black pixels are those of the word at the row.
        assert shown["count"] < 200
        return
    assert shown["count"] > 500
    x, y = shown["at"]
    # The row points to the top of the view.
    off = np.rad2deg(np.arctan2(x, y)) + direction
    assert abs((off + 180) % 360 - 180) < 25
    assert np.hypot(x, y) > 50


def test_neighbours_come_on_request(tmp_path: Path) -> None:
    script = (
        PIXELS
        + """
      const look = () => [Number(view.dataset.faces), view.toDataURL()];
      const [alone, first] = look();
      click("#view-neighbours");
      const [many, second] = look();
      click("#view-neighbours");
      const [again, third] = look();
      return [alone, many, again, first !== second, first === third];
    """
    )
    shown, errors = run_in_browser(
        page_of(tmp_path, make_scene()), script, tmp_path
    )
    assert errors == []
    assert shown == [4, 4 * (1 + len(NEIGHBOURS)), 4, True, True]


def test_scale_and_colour_bar_are_labelled(tmp_path: Path) -> None:
    script = (
        PIXELS
        + """
      const row = context.getImageData(
        0, dense * (view.clientHeight - 10), dense * panel, 1).data;
      let dark = 0;
      for (let i = 0; i < row.length; i += 4) dark += row[i] < 100;
      const text = (name) => document.getElementById(name).textContent;
      return {
        dark: dark / dense, scale: Number(view.dataset.scale),
        metres: Number(view.dataset.metres),
        texts: ["view-bar", "view-low", "view-high"].map(text),
        ramp: getComputedStyle(document.getElementById("view-ramp"))
          .backgroundImage,
      };
    """
    )
    shown, errors = run_in_browser(
        page_of(tmp_path, make_scene()), script, tmp_path
    )
    assert errors == []
    assert shown["metres"] in (0.5, 1)
    length = shown["metres"] * shown["scale"]
    assert shown["dark"] == pytest.approx(length, abs=2)
    assert shown["texts"] == [
        "absorbed PAR of each leaf [MJ m⁻² day⁻¹ of ground]",
        *("0.0", "1.0"),
    ]
    assert shown["ramp"].startswith("linear-gradient(to right, rgb(68, 1, 84)")


def test_wide_screens_use_their_width(tmp_path: Path) -> None:
    script = """
      const [one, two] = [...document.images]
        .map((image) => image.getBoundingClientRect());
      const view = document.getElementById("view");
      return [innerWidth, view.clientWidth, two.left - one.right,
        two.top - one.top];
    """
    page = page_of(tmp_path, make_scene())
    shown, errors = run_in_browser(page, script, tmp_path, width=2000)
    assert errors == []
    width, view, gap, step = shown
    assert width == 2000 and view > 0.9 * width
    assert gap > 0 and step == 0


def test_a_phone_scrolls_past_the_view_and_turns_it(tmp_path: Path) -> None:
    canvas = 'document.getElementById("view")'
    look = f"{canvas}.toDataURL()"
    titles = """
      [...document.querySelectorAll("#view-titles span")].map((span) => {
        const range = document.createRange();
        range.selectNodeContents(span);
        const { left, right } = range.getBoundingClientRect();
        return [left, right];
      })
    """
    page = page_of(tmp_path, make_scene())
    with phone_with(page, tmp_path) as phone:
        assert phone.value("innerWidth") == WIDTH
        assert phone.value("document.documentElement.scrollWidth") == WIDTH
        left, right = phone.value(titles)
        assert 0 <= left[0] < left[1] < right[0] < right[1] <= WIDTH
        phone.value(f'{canvas}.scrollIntoView({{block: "center"}})')
        first, start = phone.value(look), phone.value("scrollY")
        top = f"{canvas}.getBoundingClientRect().top"
        middle = (WIDTH / 2, phone.value(top) + 150)
        phone.swipe(middle, (10, 0))
        assert phone.value("scrollY") == start
        turned = phone.value(look)
        assert turned != first
        phone.swipe(middle, (0, 12))
        assert phone.value("scrollY") < start - 50
        assert phone.value(look) == turned
