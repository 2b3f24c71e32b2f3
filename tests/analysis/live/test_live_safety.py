# SPDX-License-Identifier: Apache-2.0
"""Live pages in a browser under difficulties: other tabs, other sites, a
program that has ended, and long use."""

from __future__ import annotations

import functools
import http.server
import threading
from pathlib import Path

import pytest
from live_browser import memory, move, settle, shown, text
from live_page import CAMPAIGNS, Served, served
from phone import phone_with

SHAPE = "insertion_angle_profile_2"
MOVES = 1000


def test_tabs_do_not_disturb_each_other(day: Served, tmp_path: Path) -> None:
    with shown(day, tmp_path) as phone:
        first = phone.tab
        genome = phone.value("page.shown.genome")
        move(phone, SHAPE, 0.9)
        assert phone.value("page.shown.genome") != genome
        phone.open(day.address, 1280)
        settle(phone)
        assert phone.value("page.shown.genome") == genome
        second = phone.tab
        # Both pages send requests at the same time.
        ask = (
            f"byId('s-{SHAPE}').value = %s;"
            f"byId('s-{SHAPE}').dispatchEvent(new Event('input'))"
        )
        for tab, value in ((first, 20), (second, 30)):
            phone.tab = tab
            phone.value(ask % value)
        found = []
        for tab in (first, second):
            phone.tab = tab
            phone.ask("Page.bringToFront")
            settle(phone)
            found.append(phone.value(f"Number(byId('s-{SHAPE}').value)"))
        assert found == [20, 30]
        phone.tab = first
        phone.ask("Page.bringToFront")
        phone.value("byId('undo').click()")
        settle(phone)
        phone.tab = second
        assert phone.value(f"Number(byId('s-{SHAPE}').value)") == 30


def test_a_lost_connection_is_reported_and_restored(
    day: Served, tmp_path: Path
) -> None:
    with shown(day, tmp_path) as phone:
        move(phone, SHAPE, 0.9)
        genome = phone.value("page.shown.genome")
        phone.value("socket.close()")
        phone.wait("!byId('lost').hidden")
        phone.wait("byId('lost').hidden", 20)
        settle(phone)
        assert phone.value("page.shown.genome") == genome
        move(phone, SHAPE, 0.2)
        assert phone.value("page.shown.genome") != genome


@pytest.mark.parametrize("how", ["kill", "terminate"])
def test_the_page_reports_the_end_of_the_program(
    how: str, tmp_path: Path
) -> None:
    with (
        served("play", CAMPAIGNS / "ames.toml") as page,
        phone_with(page.address, tmp_path) as phone,
    ):
        settle(phone)
        phone.value("byId('improve').click()")
        phone.wait("byId('progress').value > 0", 60)
        getattr(page.process, how)()
        page.process.wait(20)
        phone.wait("!byId('lost').hidden")
        assert "has ended" in text(phone, "#lost")
        phone.value(f"byId('s-{SHAPE}').value = 60;"
                    f"byId('s-{SHAPE}').dispatchEvent(new Event('input'))")  # fmt: skip
        assert phone.value("byId('progress').hidden")
        # Only connections that fail permanently are reported on the console.
        assert all("ERR_CONNECTION_REFUSED" in e for e in phone.errors)


def test_a_wrong_token_is_explained(day: Served, tmp_path: Path) -> None:
    wrong = f"http://127.0.0.1:{day.port}/wrong/"
    with phone_with(wrong, tmp_path) as phone:
        message = phone.value("document.body.innerText")
        assert "key in the address is wrong" in message
        assert "Use the complete address" in message


def test_pages_of_other_sites_learn_nothing(
    day: Served, tmp_path: Path
) -> None:
    """A page served by another server on this machine is tested; it even knows
    the token."""
    (tmp_path / "site").mkdir()
    (tmp_path / "site" / "index.html").write_text("<title>evil</title>")
    handler = functools.partial(
        http.server.SimpleHTTPRequestHandler, directory=tmp_path / "site"
    )
    handler.log_message = lambda *_: None  # type: ignore[attr-defined]
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as other:
        threading.Thread(target=other.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{other.server_address[1]}/"
        with phone_with(address, tmp_path) as phone:
            found = phone.value(
                f"""(async () => {{
                  const page = {day.address!r};
                  const get = (how) => fetch(page + how.path, how)
                    .then((answer) => answer.type, () => "refused");
                  const talk = new WebSocket(page.replace("http", "ws") + "talk");
                  const link = await new Promise((done) => {{
                    talk.onopen = () => done("open");
                    talk.onerror = () => done("refused");
                  }});
                  const frame = document.createElement("iframe");
                  frame.src = page;
                  document.body.append(frame);
                  await new Promise((done) => {{ frame.onload = done; }});
                  let inside = "refused";
                  try {{ inside = frame.contentDocument.title; }} catch {{}}
                  const script = document.createElement("script");
                  script.src = page + "state.js";
                  document.body.append(script);
                  await new Promise((done) => {{
                    script.onload = script.onerror = done;
                  }});
                  return {{
                    link, inside, script: typeof copyOf,
                    read: await get({{ path: "" }}),
                    save: await get({{ path: "save/crop", method: "POST", body: "{{}}" }}),
                  }};
                }})()"""
            )
        other.shutdown()
    assert found == {
        "link": "refused",
        "inside": "refused",
        "script": "undefined",
        "read": "refused",
        "save": "refused",
    }


def test_long_use_leaves_nothing_behind(day: Served, tmp_path: Path) -> None:
    """The memory of page and program after 200 moves is compared with that
    after 1,000 more."""

    with shown(day, tmp_path) as phone:

        def drag(count: int) -> None:
            # A page draws sixty times per second, and a mouse moves as often.
            phone.value(
                f"""(async () => {{
                  const s = byId("s-{SHAPE}");
                  for (let i = 0; i < {count}; ++i) {{
                    if (i % 10 === 0) s.dispatchEvent(new PointerEvent("pointerdown"));
                    s.value = i % 45;
                    s.dispatchEvent(new Event("input"));
                    await new Promise((done) => setTimeout(done, 20));
                  }}
                }})()"""
            )
            settle(phone)

        drag(MOVES // 5)
        page, program = memory(phone), day.resident()
        drag(MOVES)
        later = memory(phone)
        assert later["JSHeapUsedSize"] < page["JSHeapUsedSize"] + 4e6
        assert later["Nodes"] < 1.1 * page["Nodes"] + 200
        assert later["JSEventListeners"] < 1.1 * page["JSEventListeners"] + 20
        assert day.resident() < program + 30_000
        assert phone.value("page.past.length") <= 200
        assert phone.value("page.latencies.length") > 50
