# SPDX-License-Identifier: Apache-2.0
"""Starts live pages like a user, and exchanges messages with the program."""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import re
import subprocess
import sys
import tempfile
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
    errors: int
    """The open file of the error output."""

    def complaints(self) -> str:
        """Returns the error output, without moving the file position that the
        program uses."""
        return os.pread(self.errors, 1 << 20, 0).decode()

    @property
    def port(self) -> int:
        return int(re.findall(r":(\d+)/", self.address)[0])

    def resident(self) -> int:
        """Returns the resident memory of the program [KiB]."""
        status = Path(f"/proc/{self.process.pid}/status").read_text()
        line = next(x for x in status.splitlines() if x.startswith("VmRSS"))
        return int(line.split()[1])


def token(page: Served) -> str:
    """Returns the secret part of the address."""
    return page.address.rstrip("/").rpartition("/")[2]


@contextlib.contextmanager
def served(*words: object) -> Iterator[Served]:
    """Serves `ideotype play` or `ideotype watch` within a context. If the
    program does not end at the signal, it is killed and the test fails."""
    command = [sys.executable, "-m", "ideotype", *map(str, words)]
    # Errors are written to a file: nobody would read a pipe, and a full pipe
    # would block the program.
    with (
        tempfile.TemporaryFile("w+") as errors,
        subprocess.Popen(
            [*command, "--no-browser"],
            stdout=subprocess.PIPE,
            stderr=errors,
            text=True,
        ) as process,
    ):
        assert process.stdout
        try:
            line = process.stdout.readline()
            found = re.search(r"http://\S+/", line)
            if not found:
                process.wait(_ENDING)
                errors.seek(0)
            assert found, line + errors.read()
            yield Served(found[0], process, errors.fileno())
            process.terminate()
            process.wait(_ENDING)
        finally:
            process.kill()


_ENDING = 30
"""The longest time between the signal and the end of a program [s]."""


class Talk:
    """Exchanges messages with the program, like a page."""

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

    def say_raw(self, data: str | bytes) -> None:
        """Sends a text or bytes, which may be invalid JSON."""
        self._link.write_message(data, binary=isinstance(data, bytes))

    async def first(self, number: int) -> dict[str, Any]:
        """Returns the first numbers that answer a question."""
        while True:
            numbers = await self.hear("numbers")
            if numbers["number"] == number:
                return numbers

    async def final(self, number: int) -> dict[str, Any]:
        """Returns the refined numbers that answer a question."""
        while True:
            numbers = await self.hear("numbers")
            if numbers["number"] == number and numbers.get("is_final"):
                return numbers


def talk_with(page: Served, do: Callable[[Talk], Awaitable[T]]) -> T:
    """Returns the result of an exchange of messages with the program."""

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
