# SPDX-License-Identifier: Apache-2.0
"""A web server for one user of this machine.

It listens on the loopback interface alone. Every address begins with a random
token. Requests with another token are refused, and so are requests from other
sites (`Origin`) or with a host name that is not local (`Host`, against DNS
rebinding)."""

from __future__ import annotations

import argparse
import asyncio
import hmac
import json
import logging
import mimetypes
import secrets
import signal
import sys
import webbrowser
from collections.abc import Callable, Iterable
from importlib.resources import files
from typing import Any
from urllib.parse import urlsplit

from jinja2 import Environment, PackageLoader
from tornado.httpserver import HTTPServer
from tornado.netutil import bind_sockets
from tornado.web import Application, HTTPError, RequestHandler
from tornado.websocket import WebSocketHandler

from ..errors import Error, printable_lines

_HEADERS = {
    "Content-Security-Policy": (
        "default-src 'none'; script-src 'self'; style-src 'self'; "
        "connect-src 'self'; img-src 'self' data: blob:; base-uri 'none'; "
        "form-action 'none'; frame-ancestors 'none'"
    ),
    "Cache-Control": "no-store",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "Server": "ideotype",
    "X-Content-Type-Options": "nosniff",
}
_LOCAL = {"127.0.0.1", "localhost", "::1"}
_LARGEST = 1_000_000
"""The largest request or message that is read [bytes]."""

_SHARED = {
    "raster.js": "ideotype.report.page",
    "drawing.js": "ideotype.report.page",
    **dict.fromkeys(("base.js", "chart.js"), "ideotype.live.page"),
}
"""The packages of the scripts that both pages load."""


UNUSABLE = (Error, ValueError, TypeError, ArithmeticError, RecursionError)
"""Exceptions of invalid messages, such as numbers beyond the range of
floating-point numbers or deeply nested lists."""


def read_message(data: str | bytes) -> dict[str, Any]:
    """Returns the object in a message of a page. Raises Error if the message
    is no JSON, or no object."""
    try:
        message = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise Error(
            f"a message cannot be read ({error}); load the page again"
        ) from None
    if not isinstance(message, dict):
        raise Error("a message is no JSON object; load the page again")
    return message


class Guarded(RequestHandler):
    """Answers only requests with the token from the page itself."""

    def set_default_headers(self) -> None:
        for name, value in _HEADERS.items():
            self.set_header(name, value)

    def prepare(self) -> None:
        try:
            host = urlsplit(f"//{self.request.host}").hostname
            given = (self.path_args or [""])[0].encode()
        except ValueError:
            raise HTTPError(403, reason="The address is malformed") from None
        if host not in _LOCAL:
            raise HTTPError(403, reason="Only this machine may ask")
        origin = self.request.headers.get("Origin")
        if origin is not None and not self.is_own(origin):
            raise HTTPError(403, reason="Another site may not ask")
        token = self.application.settings["token"]
        if not hmac.compare_digest(given, token.encode()):
            raise HTTPError(403, reason="The key in the address is wrong")

    def is_own(self, origin: str) -> bool:
        """Returns whether an origin is the origin of this server's pages."""
        return origin == f"http://{self.request.host}"

    def write_error(self, status_code: int, **_: Any) -> None:
        self.set_header("Content-Type", "text/plain; charset=utf-8")
        self.finish(
            f"{self._reason}. Use the complete address that the command "
            "printed at its start.\n"
        )


class Socket(Guarded, WebSocketHandler):
    """Exchanges messages with one open page, until the page or the server
    ends."""

    def check_origin(self, origin: str) -> bool:
        return self.is_own(origin)

    def open(self, *_: str, **__: str) -> None:
        self.settings["sockets"].add(self)

    def on_close(self) -> None:
        self.settings["sockets"].discard(self)


class _Refused(Guarded):
    def prepare(self) -> None:
        super().prepare()
        raise HTTPError(404, reason="There is no such page")


class _File(Guarded):
    def get(self, _token: str, name: str) -> None:
        pages: dict[str, bytes] = self.application.settings["pages"]
        if name not in pages:
            raise HTTPError(404, reason="There is no such page")
        kind = mimetypes.guess_type(name or "index.html")[0]
        self.set_header("Content-Type", f"{kind}; charset=utf-8")
        self.finish(pages[name])


def make_application(
    handlers: Iterable[tuple[Any, ...]], page: str, scripts: Iterable[str]
) -> Application:
    """Returns the application of a page: its handlers, with patterns that follow
    the token, and its files: `page`.html, `page`.css and `scripts`, in the
    order in which they are loaded."""
    own = ("base.css", f"{page}.css", *scripts)
    places = _SHARED | dict.fromkeys(own, "ideotype.live.page")
    pages = {
        name: files(package).joinpath(name).read_bytes()
        for name, package in places.items()
    }
    heads = Environment(
        loader=PackageLoader("ideotype.live", "page"), autoescape=True
    )
    html = heads.get_template(f"{page}.html").render(
        page=page, scripts=[*_SHARED, *scripts]
    )
    pages[""] = html.encode()
    return Application(
        [
            *((rf"/([^/]+)/{tail}", *rest) for tail, *rest in handlers),
            (r"/([^/]+)/([\w.]*)", _File),
            (r"/([^/]*).*", _Refused),
        ],
        token=secrets.token_urlsafe(18),
        pages=pages,
        sockets=set(),
        websocket_max_message_size=_LARGEST,
        log_function=lambda _: None,
    )


def add_options(parser: argparse.ArgumentParser) -> None:
    """Declares the options of every live page."""
    add = parser.add_argument
    add("--port", type=int, default=0, metavar="N",
        help="port of this machine (default: a free one)")  # fmt: skip
    add("--no-browser", action="store_true",
        help="print the address without opening a browser")  # fmt: skip


def run_page(command: str, work: Callable[[], int]) -> int:
    """Returns the exit code of a function that serves a page, or 3 with a
    message on the error output if the input cannot be used."""
    logging.getLogger("tornado").setLevel(logging.CRITICAL)
    try:
        return work()
    except (Error, OSError) as error:
        print(printable_lines(f"ideotype {command}: {error}"), file=sys.stderr)
        return 3


def serve(app: Application, options: argparse.Namespace, about: str) -> int:
    """Serves until SIGINT or SIGTERM, and returns the exit code.

    Raises Error if the port is not available."""
    return asyncio.run(_serve(app, options, about))


async def _serve(
    app: Application, options: argparse.Namespace, about: str
) -> int:
    if not 0 <= options.port < 65536:
        raise Error(
            f"--port {options.port} is no port (0 to 65535); give another "
            "port, or omit --port"
        )
    try:
        sockets = bind_sockets(options.port, "127.0.0.1")
    except OSError as error:
        raise Error(
            f"--port {options.port}: {error}; give another port, or omit --port"
        ) from None
    server = HTTPServer(app, max_body_size=_LARGEST)
    server.add_sockets(sockets)
    port = sockets[0].getsockname()[1]
    address = f"http://127.0.0.1:{port}/{app.settings['token']}/"
    print(f"{about}: {address}", flush=True)
    print(
        "Only this machine can open the page; Ctrl-C ends the program. From "
        f"another machine: ssh -L {port}:127.0.0.1:{port} HOST, then the same "
        "address there.",
        flush=True,
    )
    if not options.no_browser:
        webbrowser.open(address)
    ended = asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, ended.set)
    await ended.wait()
    server.stop()
    # The stopped server has dropped its sockets, but their work continues.
    for socket in list(app.settings["sockets"]):
        socket.close(1001, "the program ends")
        socket.on_close()
    await server.close_all_connections()
    return 0
