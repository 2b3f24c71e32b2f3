# SPDX-License-Identifier: Apache-2.0
"""Live pages seen by a client program: which requests are permitted, and which
files are served."""

from __future__ import annotations

import asyncio
import http.client
from pathlib import Path

import pytest
from live_page import Served, token
from tornado.httpclient import HTTPClientError, HTTPRequest
from tornado.websocket import websocket_connect


def answer(
    day: Served, path: str, method: str = "GET", **headers: str
) -> tuple[int, dict[str, str], str]:
    link = http.client.HTTPConnection("127.0.0.1", day.port, timeout=20)
    link.request(method, path, headers=headers)
    found = link.getresponse()
    text = found.read().decode()
    link.close()
    return found.status, dict(found.getheaders()), text


def test_the_page_and_its_parts_are_there(day: Served) -> None:
    status, headers, text = answer(day, f"/{token(day)}/")
    assert status == 200 and "<title>ideotype play</title>" in text
    assert "default-src 'none'" in headers["Content-Security-Policy"]
    assert "http://" not in text.replace("http://www.w3.org", "")
    assert "https://" not in text
    for name in ("play.js", "play.css", "base.css", "raster.js", "chart.js"):
        status, _, text = answer(day, f"/{token(day)}/{name}")
        assert status == 200 and "SPDX-License-Identifier" in text


@pytest.mark.parametrize(
    "path",
    ["/", "/talk", "/wrong/", "/wrong/talk", "/wrong/play.js",
     "/wrong/save/crop", "//", "/%00/"],
)  # fmt: skip
def test_a_wrong_token_is_refused(day: Served, path: str) -> None:
    status, _, text = answer(day, path)
    assert status == 403
    assert token(day) not in text


def test_no_other_file_is_served(day: Served) -> None:
    for path in ("../server.py", "..%2fserver.py", "server.py", "x/y"):
        status, _, text = answer(day, f"/{token(day)}/{path}")
        assert status in (403, 404) and "import" not in text


def test_other_origins_are_refused(day: Served) -> None:
    path = f"/{token(day)}/"
    own = f"http://127.0.0.1:{day.port}"
    assert answer(day, path, Origin=own)[0] == 200
    for origin in (
        "http://evil.example",
        "null",
        f"{own}0",
        f"https{own[4:]}",
    ):
        assert answer(day, path, Origin=origin)[0] == 403
        save = answer(day, f"{path}save/crop", "POST", Origin=origin)
        assert save[0] == 403


def test_names_of_this_machine_that_are_not_local_are_refused(
    day: Served,
) -> None:
    path = f"/{token(day)}/"
    for host in ("localhost:9", "127.0.0.1:9", "[::1]:9"):
        assert answer(day, path, Host=host)[0] == 200
    for host in ("evil.example", "127.0.0.1.evil.example", "", "[::1"):
        assert answer(day, path, Host=host)[0] == 403


@pytest.mark.parametrize("case", ["origin", "token"])
def test_talks_with_others_are_refused(day: Served, case: str) -> None:
    address = f"{day.address}talk".replace("http", "ws")
    headers = {"Origin": "http://evil.example"} if case == "origin" else {}
    if case == "token":
        address = address.replace(token(day), "x" * len(token(day)))

    async def knock() -> None:
        await websocket_connect(HTTPRequest(address, headers=headers))

    with pytest.raises(HTTPClientError, match="403"):
        asyncio.run(knock())


def test_only_this_machine_is_listened_to(day: Served) -> None:
    lines = Path("/proc/net/tcp").read_text().splitlines()[1:]
    listening = [line.split()[1] for line in lines if line.split()[3] == "0A"]
    port = f"{day.port:04X}"
    mine = [address for address in listening if address.endswith(f":{port}")]
    assert mine == [f"0100007F:{port}"]
