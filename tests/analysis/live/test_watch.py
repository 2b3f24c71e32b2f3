# SPDX-License-Identifier: Apache-2.0
"""The page of `ideotype watch` in a browser, on made histories."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import WriterProcess
from live_browser import WIDTHS, bare, click, fits, serious_findings, shown
from live_browser import text as seen
from live_page import Served, served
from made_history import MadeHistory
from phone import Phone

HOSTILE = "<img src=x onerror='window.hacked=1'>"


@pytest.fixture(scope="module")
def folder(
    tmp_path_factory: pytest.TempPathFactory,
    finished: Path,
    tiny_run: Path,
) -> Path:
    """Provides finished, stopped and broken histories, and a history with HTML
    in its names."""
    path = tmp_path_factory.mktemp("runs")
    (path / "a_real.h5").write_bytes(tiny_run.read_bytes())
    (path / "case.h5").write_bytes(finished.read_bytes())
    (path / "broken.h5").write_bytes(finished.read_bytes()[:5000])
    (path / f"{HOSTILE}.h5").write_bytes(b"no history")
    made = MadeHistory(
        path / "stopped.h5",
        attributes={"case": HOSTILE, "campaign": HOSTILE},
    )
    made.evolve(2)
    made.close()
    return path


@pytest.fixture(scope="module")
def page(folder: Path) -> Iterator[Served]:
    with served("watch", folder) as found:
        yield found


@pytest.fixture(params=WIDTHS)
def phone(
    page: Served, tmp_path: Path, request: pytest.FixtureRequest
) -> Iterator[Phone]:
    with shown(page, tmp_path, request.param) as found:
        yield found


def choose(phone: Phone, file: str) -> None:
    click(phone, f"[data-file='{file}']")
    phone.wait(f"seen.chosen === '{file}'")


def test_the_page_shows_cases_and_their_best_plants(phone: Phone) -> None:
    assert fits(phone)
    sums = seen(phone, "#sums")
    assert "2 of 5" in sums
    choose(phone, "a_real.h5")
    phone.wait("seen.plants && !byId('plants').hidden", 60)
    assert 0.1 < bare(phone) < 0.97
    before = phone.value("byId('view').toDataURL()")
    phone.value("document.querySelector('[data-look=left]').click()")
    assert phone.value("byId('view').toDataURL()") != before
    lines = "document.querySelectorAll('#convergence .line').length"
    assert phone.value(lines) == 2
    assert "±" in seen(phone, "#facts")


def test_gains_that_are_not_re_evaluated_are_marked(phone: Phone) -> None:
    stopped = seen(phone, "[data-file='stopped.h5']")
    assert "expected gain" in stopped
    assert "not yet re-evaluated" in stopped
    ended = seen(phone, "[data-file='case.h5']")
    assert re.search(r"gain [+\N{MINUS SIGN}][\d.]+ ± [\d.]+ %", ended)
    assert "expected" not in ended and "not yet" not in ended
    for file, label in (
        ("stopped.h5", "best plant, expected"),
        ("case.h5", "best plant, re-evaluated"),
    ):
        choose(phone, file)
        assert label in seen(phone, "#facts")


def test_broken_files_hide_no_others(phone: Phone) -> None:
    assert phone.value("document.querySelectorAll('.bad-file').length") == 2
    assert "broken.h5" in seen(phone, "#cases")
    choose(phone, "case.h5")
    assert "finished after" in seen(phone, "#cases")
    assert "Last failure" in seen(phone, "#failure")
    phone.wait("byId('plants-text').textContent.includes('No picture')")


def test_names_are_no_html(phone: Phone) -> None:
    assert seen(phone, "#cases").count(HOSTILE) >= 2
    choose(phone, "stopped.h5")
    assert seen(phone, "#chosen-name") == HOSTILE
    assert phone.value("window.hacked") is None
    assert phone.value("document.images.length") == 0


def test_axe_finds_nothing_serious(phone: Phone) -> None:
    choose(phone, "a_real.h5")
    phone.wait("seen.plants", 60)
    assert serious_findings(phone) == []


def test_cases_are_chosen_with_keys(page: Served, tmp_path: Path) -> None:
    with shown(page, tmp_path) as phone:
        phone.value(
            "document.querySelector('[data-file=\"case.h5\"]').focus()"
        )
        for kind in ("keyDown", "keyUp"):
            phone.ask("Input.dispatchKeyEvent", type=kind, key="Enter",
                      code="Enter", text="\r", windowsVirtualKeyCode=13)  # fmt: skip
        phone.wait("seen.chosen === 'case.h5'")
        at = phone.value("seen.state && performance.now()")
        phone.wait(f"performance.now() > {at} + 4500")
        # The list was rebuilt, and the focus remained.
        assert phone.value("document.activeElement.dataset.file") == "case.h5"


def test_tabs_show_the_same_state_and_nothing_is_written(
    page: Served, folder: Path, tmp_path: Path
) -> None:
    def digest() -> dict[str, str]:
        return {
            path.name: hashlib.sha256(path.read_bytes()).hexdigest()
            for path in folder.iterdir()
        }

    before = digest()
    with shown(page, tmp_path) as phone:
        first = phone.tab
        phone.open(page.address, 390)
        phone.wait("document.body.dataset.cases")
        choose(phone, "case.h5")
        second = seen(phone, "#sums")
        phone.tab = first
        assert phone.value("seen.chosen") != "case.h5"
        assert seen(phone, "#sums") == second
    assert digest() == before


def test_a_running_case_grows_until_it_is_killed(
    writer: WriterProcess, tmp_path: Path
) -> None:
    with (
        served("watch", writer.path.parent) as page,
        shown(page, tmp_path) as phone,
    ):
        assert "running" in seen(phone, "#cases")
        for slot in range(3):
            writer.do(f"record 0 {slot}")
        phone.wait("seen.state.evaluations === 3", 20)
        writer.kill()
        phone.wait("seen.state.cases[0].state === 'interrupted'", 20)
        assert "interrupted" in seen(phone, "#cases")


def test_an_empty_folder_waits_for_its_first_case(
    finished: Path, tmp_path: Path
) -> None:
    runs = tmp_path / "runs"
    runs.mkdir()
    with served("watch", runs) as page, shown(page, tmp_path) as phone:
        assert "There is no history" in seen(phone, "#none")
        (runs / "case.h5").write_bytes(finished.read_bytes())
        phone.wait("document.body.dataset.cases === '1'", 20)
        assert phone.value("byId('none').hidden")


def test_the_page_reports_the_end_of_the_program(
    folder: Path, tmp_path: Path
) -> None:
    with served("watch", folder) as page, shown(page, tmp_path) as phone:
        page.process.kill()
        page.process.wait()
        phone.wait("!byId('lost').hidden", 20)
        assert "ended" in seen(phone, "#lost")
        assert "2 of 5" in seen(phone, "#sums")
        assert all("ERR_CONNECTION" in each for each in phone.errors)
        phone.errors.clear()
