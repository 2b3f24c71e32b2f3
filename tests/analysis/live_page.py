# SPDX-License-Identifier: Apache-2.0
"""Starts live pages as a user does, and talks with them."""

from __future__ import annotations

import asyncio
import contextlib
import json
import re
import subprocess
import sys
from collections.abc import Awaitable, Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from tornado.websocket import WebSocketClientConnection, websocket_connect

CAMPAIGNS = Path(__file__).parents[2] / "campaigns"
T = TypeVar("T")


@dataclass
class Served:
    """A running live page."""

    address: str
    """The whole address, with the token."""
    process: subprocess.Popen[str]

    @property
    def port(self) -> int:
        return int(re.findall(r":(\d+)/", self.address)[0])


@contextlib.contextmanager
def served(*words: object) -> Iterator[Served]:
    """Serves `ideotype play` or `ideotype watch` while it is used."""
    command = [sys.executable, "-m", "ideotype", *map(str, words)]
    with subprocess.Popen(
        [*command, "--no-browser"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout and process.stderr
        try:
            line = process.stdout.readline()
            found = re.search(r"http://\S+/", line)
            assert found, line + process.stderr.read()
            yield Served(found[0], process)
        finally:
            process.terminate()


class Talk:
    """Talks to the program as a page does."""

    def __init__(self, link: WebSocketClientConnection) -> None:
        self._link = link
        self.hello: dict[str, Any] = {}

    async def hear(self, kind: str) -> dict[str, Any]:
        """Returns the next message of a kind."""
        while True:
            text = await asyncio.wait_for(self._link.read_message(), 60)
            assert text is not None, "the program has closed the link"
            message = json.loads(text)
            if message["kind"] == kind:
                return message
            assert message["kind"] != "problem", message

    def say(self, **message: Any) -> None:
        """Sends a message."""
        self._link.write_message(json.dumps(message))

    async def first(self, number: int) -> dict[str, Any]:
        """Returns the first numbers of a question."""
        while True:
            told = await self.hear("numbers")
            if told["number"] == number:
                return told

    async def final(self, number: int) -> dict[str, Any]:
        """Returns the refined numbers of a question."""
        while True:
            told = await self.hear("numbers")
            if told["number"] == number and told.get("is_final"):
                return told


def talk_with(page: Served, do: Callable[[Talk], Awaitable[T]]) -> T:
    """Returns what a talk with the page comes to."""

    async def work() -> T:
        address = f"{page.address}talk".replace("http", "ws")
        link = await websocket_connect(address)
        try:
            talk = Talk(link)
            talk.hello = await talk.hear("hello")
            return await do(talk)
        finally:
            link.close()

    return asyncio.run(work())
