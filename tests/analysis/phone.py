# SPDX-License-Identifier: Apache-2.0
"""Shows a page on a phone: Chromium without a window, 390 points wide, with a
touch screen; or on a wider screen. Commands of the DevTools protocol are sent
through a pipe."""

from __future__ import annotations

import base64
import contextlib
import fcntl
import json
import os
import shutil
import signal
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from browser import NAMES, OPTIONS

WIDTH, HEIGHT = 390, 844
Page = Path | str
"""A file, or an address on this machine."""


class Phone:
    """One open page."""

    def __init__(self, read: int, write: int) -> None:
        self._from, self._to = os.fdopen(read, "rb"), os.fdopen(write, "wb")
        self._session = ""
        self._count = 0
        self.errors: list[str] = []
        """Errors of scripts, of the console and of refused loads."""

    def open(self, page: Page, width: int, height: int = HEIGHT) -> None:
        """Opens a page in a new tab, and returns when it is loaded."""
        self._session = ""
        target = self.ask("Target.createTarget", url="about:blank")
        session = self.ask("Target.attachToTarget", flatten=True, **target)
        self._session = session["sessionId"]
        self.ask(
            "Emulation.setDeviceMetricsOverride",
            width=width, height=height, deviceScaleFactor=2,
            mobile=width < 1000,
        )  # fmt: skip
        self.ask("Emulation.setTouchEmulationEnabled", enabled=width < 1000)
        # Scrollbars would reduce the width of a wide window.
        self.ask("Emulation.setScrollbarsHidden", hidden=True)
        for domain in ("Page", "Runtime", "Log"):
            self.ask(f"{domain}.enable")
        self.show(page)

    @property
    def tab(self) -> str:
        """The tab that receives commands; another tab can be assigned."""
        return self._session

    @tab.setter
    def tab(self, session: str) -> None:
        self._session = session

    def show(self, page: Page) -> None:
        """Opens another page in this tab, and returns when it is loaded."""
        url = page.as_uri() if isinstance(page, Path) else page
        self.ask("Page.navigate", url=url)
        while self._message().get("method") != "Page.loadEventFired":
            pass

    def value(self, expression: str) -> Any:
        """Returns the value of a JavaScript expression in the page."""
        said = self.ask(
            "Runtime.evaluate", expression=expression, returnByValue=True,
            awaitPromise=True,
        )  # fmt: skip
        assert "exceptionDetails" not in said, said
        return said["result"].get("value")

    def wait(self, condition: str, seconds: float = 30) -> Any:
        """Waits until a JavaScript expression is true, and returns its
        value."""
        end = time.monotonic() + seconds
        while not (found := self.value(condition)):
            assert time.monotonic() < end, (condition, self.errors)
            time.sleep(0.05)
        return found

    def picture(self, path: Path) -> None:
        """Writes a screenshot to a PNG file."""
        data = self.ask("Page.captureScreenshot")["data"]
        path.write_bytes(base64.b64decode(data))

    def swipe(
        self, start: tuple[float, float], step: tuple[float, float]
    ) -> None:
        """Moves one finger across the screen in ten steps."""
        x, y = start
        touch = "Input.dispatchTouchEvent"
        self.ask(touch, type="touchStart", touchPoints=[{"x": x, "y": y}])
        for _ in range(10):
            x, y = x + step[0], y + step[1]
            self.ask(touch, type="touchMove", touchPoints=[{"x": x, "y": y}])
        self.ask(touch, type="touchEnd", touchPoints=[])

    def tap(self, x: float, y: float) -> None:
        """Taps with one finger."""
        for kind, points in (("Start", [{"x": x, "y": y}]), ("End", [])):
            self.ask(
                "Input.dispatchTouchEvent",
                type=f"touch{kind}",
                touchPoints=points,
            )

    def press(self, key: str) -> None:
        """Presses the key with the given name."""
        for kind in ("keyDown", "keyUp"):
            self.ask(
                "Input.dispatchKeyEvent", type=kind, key=key, code=key,
                windowsVirtualKeyCode=_CODES.get(key, 0),
            )  # fmt: skip

    def ask(self, method: str, **params: Any) -> dict[str, Any]:
        """Sends a command and waits for its answer."""
        self._count += 1
        message: dict[str, Any] = {"id": self._count, "method": method}
        message["params"] = params
        if self._session:
            message["sessionId"] = self._session
        self._to.write(json.dumps(message).encode() + b"\0")
        self._to.flush()
        while (answer := self._message()).get("id") != self._count:
            pass
        assert "error" not in answer, answer
        return answer["result"]

    def _message(self) -> dict[str, Any]:
        data = bytearray()
        while (byte := self._from.read(1)) != b"\0":
            assert byte, "the browser ended"
            data += byte
        message = json.loads(data)
        self._note(message)
        return message

    def _note(self, message: dict[str, Any]) -> None:
        params = message.get("params", {})
        if message.get("method") == "Runtime.exceptionThrown":
            self.errors.append(str(params["exceptionDetails"]))
        elif (
            message.get("method") == "Log.entryAdded"
            and params["entry"]["level"] == "error"
        ):
            self.errors.append(str(params["entry"]))


_CODES = {"ArrowRight": 39, "ArrowLeft": 37}
"""The key codes, without which sliders do not move."""


@contextlib.contextmanager
def phone_with(
    page: Page, folder: Path, width: int = WIDTH, height: int = HEIGHT
) -> Iterator[Phone]:
    """Shows a page on a phone, or on a wider screen."""
    name = next(filter(shutil.which, NAMES), None)
    if name is None:
        pytest.fail(f"no browser: install one of {', '.join(NAMES)}")
    orders, to_browser = os.pipe()
    from_browser, answers = os.pipe()
    # The file descriptors must not be 3 and 4, which the browser uses.
    ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (orders, answers)]
    command = [
        *(name, *OPTIONS, "--remote-debugging-pipe"),
        f"--user-data-dir={folder / 'phone'}",
    ]
    process = subprocess.Popen(
        command,
        stderr=subprocess.DEVNULL,
        close_fds=False,
        preexec_fn=lambda: (os.dup2(ends[0], 3), os.dup2(ends[1], 4)),  # noqa: PLW1509
        start_new_session=True,
    )
    for end in (orders, answers, *ends):
        os.close(end)
    try:
        phone = Phone(from_browser, to_browser)
        phone.open(page, width, height)
        yield phone
    finally:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
