# SPDX-License-Identifier: Apache-2.0
"""The report of a front lets a reader choose one of its plants."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from browser import run_in_browser
from made_front import AREA, KEPT, LEAVES, LIGHT, SCENARIOS, make
from made_kinds import Measured
from made_numbers import (
    ERROR,
    POPULATION,
    absorbed,
    baseline_genome,
    final_absorbed,
    genome,
)
from phone import HEIGHT, WIDTH, phone_with
from real_program import output_of, write_campaign

import ideotype
from ideotype.history import open_history, open_study
from ideotype.report.blocks import Section, Viewer
from ideotype.report.page import render
from ideotype.report.scene import build_plants, make_scene
from ideotype.tools.commands import report


@pytest.fixture
def history(tmp_path: Path) -> Path:
    return make(tmp_path / "case_r1.h5")


CHART = 'document.getElementById("view-chart")'
CANVAS = 'document.getElementById("view")'
LOOK = f"{CANVAS}.toDataURL()"
BOXES = """
  Object.fromEntries(
    ["view-chart", "view", "view-numbers"].map((name) => {
      const box = document.getElementById(name).getBoundingClientRect();
      return [name, [box.left, box.top, box.right, box.bottom]];
    }))
"""
MEMBER = """
  (() => {
    const mark = document
      .querySelector("[data-member='%d'] > path:not(.error)")
      .getBoundingClientRect();
    return [mark.left + mark.width / 2, mark.top + mark.height / 2];
  })()
"""
CELLS = """
  [...document.querySelectorAll("#view-tables tr")].map((row) =>
    [...row.cells].map((cell) => cell.textContent))
"""
LABELS = f"""
  [...{CHART}.querySelectorAll("text")].map((text) => {{
    const box = text.getBoundingClientRect();
    return [box.left, box.top, box.right, box.bottom];
  }})
"""


def page_of(folder: Path, history: Path, *, has_shapes: bool = True) -> Path:
    with open_study(history) as study:
        (case,) = study.cases()
        plants = build_plants(case) if has_shapes else None
        scene = make_scene([(case, plants)])
    page = folder / "front.html"
    view = Section("Front", [Viewer(scene, "What is shown.")])
    page.write_text(render("Made", "front", [view]), encoding="utf-8")
    return page


def test_each_plant_has_the_shape_of_its_row(history: Path) -> None:
    with open_study(history) as study:
        (case,) = study.cases()
        plants = build_plants(case)
        sizes = [case.genes.columns(trait)[0] for trait in ("length", "width")]
    rows = [baseline_genome(), *(genome(3, POPULATION - i) for i in (1, 2, 3))]
    parts = [
        mesh.area("leaf01") / row[sizes].prod()
        for mesh, row in zip([plants.baseline, *plants.members], rows)
    ]
    # The area of a blade is a fraction of its bounding rectangle; all blades
    # have the same outline.
    assert parts == pytest.approx([parts[0]] * 4, rel=0.01)
    assert np.array_equal(plants.best.vertices, plants.members[1].vertices)


def test_shapes_need_no_special_processor(tmp_path: Path) -> None:
    path = make(tmp_path / "case_r1.h5", attributes={"isa": "avx1024"})
    with pytest.raises(ideotype.Error, match="avx1024"):
        ideotype.Stand.from_history(path)
    with open_study(path) as study:
        (case,) = study.cases()
        assert len(build_plants(case).members) == 3


def test_a_hidden_view_is_drawn_when_it_shows(
    history: Path, tmp_path: Path
) -> None:
    page = page_of(tmp_path, history)
    panel = "document.getElementById('view-panel')"
    frame = (
        "new Promise((done) => requestAnimationFrame(() => setTimeout(done)))"
    )
    with phone_with(page, tmp_path, WIDTH) as phone:
        phone.value(frame)
        before = phone.value(LOOK)
        phone.value(f"{panel}.style.display = 'none'")
        phone.value("dispatchEvent(new Event('resize'))")
        # While the view is hidden, keys and lists must not cause errors.
        phone.value(
            "for (const id of ['view-quantity', 'view-right']) document"
            ".getElementById(id).dispatchEvent(new Event('change'))"
        )
        phone.value(frame)
        assert not phone.errors, phone.errors
        phone.value(f"{panel}.style.cssText = 'width: 300px'")
        narrow = (
            "document.getElementById('view').width === 2 * 300 "
            "&& Number(document.getElementById('view').dataset.faces) > 0"
        )
        phone.wait(narrow)
        assert phone.value(LOOK) != before
        assert not phone.errors, phone.errors


@pytest.mark.parametrize("width", [390, 1280])
def test_a_plant_of_the_front_is_chosen(
    history: Path, tmp_path: Path, width: int
) -> None:
    page = page_of(tmp_path, history)
    with phone_with(page, tmp_path, width) as phone:
        assert phone.value("document.documentElement.scrollWidth") == width
        phone.value(f"{CHART}.scrollIntoView()")
        boxes = phone.value(BOXES)
        chart, plant, numbers = boxes.values()
        if width == 1280:
            # Chart and plant are next to each other, with the numbers below
            # the chart.
            assert chart[2] < plant[0] and plant[1] < chart[3] < numbers[1]
            assert numbers[2] < plant[0]
        else:  # Chart and plant fit on one screen.
            assert chart[3] < plant[1] < plant[3] < min(HEIGHT, numbers[1])
        for i, (left, top, right, bottom) in enumerate(
            labels := phone.value(LABELS)
        ):
            assert chart[0] - 1 <= left < right <= chart[2] + 1
            assert chart[1] - 1 <= top < bottom <= chart[3] + 1
            for a, b, c, d in labels[:i]:
                assert right < a or c < left or bottom < b or d < top
        first, looks = phone.value(CELLS), [phone.value(LOOK)]
        assert first[0] == ["", "baseline", "plant 2", "difference [%]"]
        assert first[2] == ["LAI [m² m⁻²]", "3.44", "3.5", "+1.74"]
        # A finger may touch the screen slightly off the point.
        x, y = phone.value(MEMBER % 0)
        phone.tap(x + 9, y - 9)
        looks.append(phone.value(LOOK))
        chosen = phone.value(CELLS)
        assert chosen[0][2] == "plant 1"
        assert re.fullmatch(r"\+1\.0+ ±\u00a00\.0\d+", chosen[1][3])
        assert chosen[2][1:] == ["3.44", "3", "−12.79"]
        # The arrow keys move from left to right: 3.0, 3.2, 3.5.
        phone.press("ArrowRight")
        looks.append(phone.value(LOOK))
        assert phone.value(CELLS)[0][2] == "plant 3"
        about = phone.value(
            'document.activeElement.getAttribute("aria-label")'
        )
        assert about.endswith("dominated after re-evaluation")
        phone.press("End")
        looks.append(phone.value(LOOK))
        assert looks[3] == looks[0] and len(set(looks)) == 3
        for key in ("ArrowRight", "ArrowDown", "Home", "ArrowUp"):
            phone.press(key)
        assert phone.value(CELLS)[0][2] == "plant 3"


def test_the_chart_has_error_bars_in_the_scale_of_its_axes(
    history: Path, tmp_path: Path
) -> None:
    page = page_of(tmp_path, history)
    tall = """
      [...document.querySelectorAll(".member > .error")]
        .map((bar) => bar.getBBox().height)
    """
    with phone_with(page, tmp_path, 1280) as phone:
        heights = phone.value(tall)
        places = [phone.value(MEMBER % i)[1] for i in range(3)]
        kinds = phone.value(
            """[...document.querySelectorAll("[data-member]")].map((member) =>
              [member.dataset.member, member.classList.contains("fallen")])"""
        )
    assert {int(i): not fell for i, fell in kinds} == dict(enumerate(KEPT))
    # The objectives of plants 1 and 2 differ by 0.005 of the baseline.
    step = (places[0] - places[1]) / (final_absorbed(2) - final_absorbed(1))
    assert heights == pytest.approx(
        [1.96 * step * 2 * ERROR / 4] * 3, rel=0.01
    )


def test_without_shapes_the_front_is_there_all_the_same(
    history: Path, tmp_path: Path
) -> None:
    page = page_of(tmp_path, history, has_shapes=False)
    with phone_with(page, tmp_path) as phone:
        phone.value(f"{CHART}.scrollIntoView()")
        phone.tap(*phone.value(MEMBER % 0))
        assert phone.value(CELLS)[0][2] == "plant 1"
        assert phone.value(f"{CANVAS}.clientHeight") == 0
        assert "No plants are shown; the" in phone.value(
            "document.body.innerText"
        )


def test_of_three_objectives_two_are_chosen(tmp_path: Path) -> None:
    path = make(tmp_path / "case.h5", [LIGHT, LEAVES, AREA])
    page = page_of(tmp_path, path)
    choose = """
      (() => {
        const list = document.getElementById("view-pair");
        list.selectedIndex = 2;
        list.dispatchEvent(new Event("change"));
        return [...list.options].map((option) => option.text);
      })()
    """
    text = f"[...{CHART}.querySelectorAll('text')].slice(-2).map((t) => t.textContent)"
    with phone_with(page, tmp_path, 1280) as phone:
        before = phone.value(text)
        light, leaves = "absorbed PAR", "absorbed PAR per leaf area"
        assert phone.value(choose) == [
            f"{leaves}, {light}", f"LAI, {light}", f"LAI, {leaves}",
        ]  # fmt: skip
        after = phone.value(text)
    assert before[0].startswith(f"{leaves} [MJ") and before[0].endswith(
        "maximised →"
    )
    assert after[0] == "← LAI [m² m⁻²], minimised"
    assert after[1].startswith(f"↑ {leaves} [MJ")


def test_the_page_shows_the_scenarios_of_a_plant(tmp_path: Path) -> None:
    """Unknown axes of scenarios are shown too."""
    path = make(
        tmp_path / "case.h5",
        labels={"scenario": SCENARIOS},
        extra={
            "absorbed_par_by_scenario": (
                Measured("MJ m-2 day-1", "scenario"),
                np.array([1.0, 0.5]),
            )
        },
    )
    rows = ideotype.open(path)
    assert list(rows.absorbed_par_by_scenario.scenario.values) == SCENARIOS
    with open_study(path) as study:
        frame = study.frame()
    found = frame["absorbed_par_by_scenario wide rows"].to_numpy()
    assert np.nanmax(found) == pytest.approx(absorbed(4, POPULATION - 1) / 2)
    page = page_of(tmp_path, path)
    (text,) = re.findall(r'(?s)id="scene">(.*?)</script>', page.read_text())
    members = json.loads(text)["cases"][0]["front"]["members"]
    ((table,),) = [m["scenarios"] for m in members if m["title"] == "plant 2"]
    assert table["title"] == "absorbed PAR by scenario [MJ m⁻² day⁻¹]"
    assert [row[0] for row in table["rows"]] == SCENARIOS
    assert table["rows"][1][1].startswith("5.5000 ±")
    assert table["rows"][1][3].startswith("+1.50 ±")
    with phone_with(page, tmp_path) as phone:
        assert SCENARIOS[1] in [row[0] for row in phone.value(CELLS)]


def test_a_report_of_a_front_that_the_program_bred(tmp_path: Path) -> None:
    campaign = write_campaign(tmp_path, 3)
    keys = (
        "search.optimizer=nsga2",
        "objective.minimise=lai",
        "final.candidates=4",
    )
    sets = [word for key in keys for word in ("--set", key)]
    output_of("run", campaign, "--out", tmp_path, *sets)
    (path,) = (tmp_path / "tiny").glob("*.h5")
    with open_history(path) as opened:
        front = opened.front()
        assert front is not None
        found = [
            (plant.objective.mean, plant.estimate("lai").mean)
            for plant in map(front.one, range(len(front.members)))
        ]
    kept = sum(
        not any(
            other != own and other[0] >= own[0] and other[1] <= own[1]
            for other in found
        )
        for own in found
    )
    out = tmp_path / "report"
    arguments = [path, "-o", out]
    assert report([str(argument) for argument in arguments]) == 0
    assert (
        out / "figures" / f"{path.stem.removesuffix('_r1')}_front.svg"
    ).exists()
    script = """
      const look = () => document.getElementById("view").toDataURL();
      const before = look();
      const points = [...document.querySelectorAll("[data-member]")];
      const other = points.find((point) => point.tabIndex < 0);
      const { left, top, width, height } = other.getBoundingClientRect();
      other.dispatchEvent(new MouseEvent("click", { bubbles: true,
        clientX: left + width / 2, clientY: top + height / 2 }));
      return {
        count: points.length, changes: look() !== before,
        told: document.getElementById("view-text").textContent,
        heading: document.querySelector("#s3 h2").textContent,
      };
    """
    shown, errors = run_in_browser(out / "report.html", script, tmp_path, 1280)
    assert errors == []
    assert shown["heading"] == "Pareto front and its plants in 3D"
    assert shown["count"] == len(found) and shown["changes"]
    sentence = (
        f"After re-evaluation {kept} of {len(found)} plants remain in the "
        "Pareto front"
    )
    assert shown["told"].startswith(sentence)
