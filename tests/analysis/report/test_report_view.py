# SPDX-License-Identifier: Apache-2.0
"""A browser shows the page of a report with its plants."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from browser import run_in_browser
from made_report import CASES, DRAWN, OWN, Made

from ideotype.history.study import open_study
from ideotype.report.scene import build_plants


def test_a_browser_shows_the_page(made: Made, tmp_path: Path) -> None:
    script = """
      const view = document.getElementById("view");
      const { data } = view.getContext("2d")
        .getImageData(0, 0, view.width, view.height);
      const look = () => view.toDataURL();
      const press = (key) =>
        view.dispatchEvent(new KeyboardEvent("keydown", { key }));
      const [left, right] = ["left", "right"].map((side) =>
        document.getElementById(`view-${side}`));
      const quantity = document.getElementById("view-quantity");
      const choose = (list, i) => {
        list.selectedIndex = i;
        list.dispatchEvent(new Event("change"));
      };
      const first = look();
      press("ArrowLeft");
      const turned = look();
      for (const [kind, clientX, clientY] of
          [["pointerdown", 10, 10], ["pointermove", 50, 20]])
        view.dispatchEvent(
          new PointerEvent(kind, { buttons: 1, clientX, clientY }));
      const dragged = look();
      const turn = (ctrlKey) => view.dispatchEvent(
        new WheelEvent("wheel", { deltaY: -200, ctrlKey, cancelable: true }));
      const scrolls = turn(false) && look() === dragged;
      const zooms = !turn(true);
      const zoomed = look();
      press("Home");
      const home = look();
      choose(quantity, 1);
      const area = look();
      choose(left, 1);
      const same = look();
      choose(right, right.options.length - 1);
      const other = look();
      const states = [first, turned, dragged, zoomed, area, same, other];
      return {
        colors: new Set(new Uint32Array(data.buffer)).size,
        faces: Number(view.dataset.faces),
        cases: [...left.children].map((group) => group.label),
        plants: right.options.length,
        quantities: quantity.options.length,
        states: new Set(states).size,
        isHome: home === first,
        scrolls, zooms,
        pictures: [...document.images].map((image) => image.naturalWidth),
        wide: document.documentElement.scrollWidth <= innerWidth,
      };
    """
    shown, errors = run_in_browser(made.page, script, tmp_path)
    assert errors == []
    # Each plant has ten leaves of 12 x 2 faces, and a stalk of eight sides and
    # eight faces at its top.
    assert shown["faces"] == 2 * (10 * 24 + 16)
    # Ten leaves on two plants with smooth edges give many colours.
    assert shown["colors"] > 100
    assert shown["states"] == 7 and shown["isHome"]
    assert shown["scrolls"] and shown["zooms"]
    assert shown["cases"] == list(CASES) and shown["quantities"] == 2
    # The plants are baseline and best of each case, and the other finalists of
    # two searches.
    assert shown["plants"] > 2 * len(CASES)
    assert len(shown["pictures"]) == 6 + 2 * (len(DRAWN) + len(OWN))
    assert min(shown["pictures"]) > 200
    assert shown["wide"]


def test_the_browser_test_sees_errors(tmp_path: Path) -> None:
    page = tmp_path / "bad.html"
    page.write_text(
        "<html><head></head><body><script>missing()</script></body></html>"
    )
    _, errors = run_in_browser(page, "return 1;", tmp_path)
    assert any("missing is not defined" in error for error in errors)


def test_leaf_colours_are_per_ground_and_per_leaf_area(
    made: Made, sweep: Path
) -> None:
    (text,) = re.findall(r'(?s)id="scene">(.*?)</script>', made.text)
    scene = json.loads(text)
    # All plants have the same organs, so that they share one shape.
    (shape,) = scene["shapes"]
    first = scene["cases"][0]
    assert len(first["neighbours"]) == 3 * 7 - 1
    ground, leaf = (q["values"] for q in first["quantities"])
    with open_study(sweep) as study:
        built = build_plants(study.cases()[0])
    meshes = built.baseline, built.best
    plants = zip(first["plants"], ground, leaf, meshes)
    for plant, by_ground, by_leaf, mesh in plants:
        assert plant["shape"] == 0 and shape["groups"][-1] == "stalk"
        assert by_ground[-1] is by_leaf[-1] is None
        # The value per ground area is all light that the leaves absorb,
        # divided by the ground area of the plant.
        taken = sum(
            value * mesh.area(group)
            for value, group in zip(by_leaf[:-1], shape["groups"])
        )
        assert taken == pytest.approx(sum(by_ground[:-1]) * 0.762 * 0.1524)
