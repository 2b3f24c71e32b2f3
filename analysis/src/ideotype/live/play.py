# SPDX-License-Identifier: Apache-2.0
"""`ideotype play`: a page on which a user changes a plant and sees the light
that it absorbs."""

from __future__ import annotations

import argparse
import json
import tomllib
from collections.abc import Sequence
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any

import tomli_w
from tornado.web import HTTPError
from tornado.websocket import WebSocketClosedError

from ..errors import Error
from ..report.programme import describe_reach
from ..stand.stand import Stand
from .bench import Bench, Shown
from .conditions import Tables, make_tables
from .opened import CROPS, open_place
from .server import (
    UNUSABLE,
    Guarded,
    Socket,
    add_options,
    make_application,
    read_message,
    run_page,
    serve,
)
from .session import Session

_SCRIPTS = (
    *("state.js", "sliders.js", "numbers.js", "field.js", "map.js", "play.js"),
)


class _Talk(Socket):
    def initialize(self, bench: Bench) -> None:
        self.bench = bench

    def open(self, *_: str, **__: str) -> None:
        super().open()
        self.session = Session(self.bench, self._send)
        self.session.greet()

    def on_message(self, message: str | bytes) -> None:
        try:
            self.session.hear(read_message(message))
        except UNUSABLE as error:
            text = (
                str(error)
                if isinstance(error, Error)
                else f"a message is invalid ({error}); load the page again"
            )
            self._send({"kind": "problem", "text": text})

    def on_close(self) -> None:
        super().on_close()
        if hasattr(self, "session"):
            self.session.close()

    def _send(self, message: dict[str, Any]) -> None:
        try:
            future = self.write_message(json.dumps(message))
        except WebSocketClosedError:
            return
        # A closed page is no failure.
        future.add_done_callback(lambda done: done.exception())


class _Save(Guarded):
    """Sends the plant of a page as a crop file, or the campaign of the
    plant."""

    def initialize(self, bench: Bench) -> None:
        self.bench = bench

    def post(self, _token: str, form: str) -> None:
        try:
            message = read_message(self.request.body)
            shown = Session(self.bench, lambda _: None).shown(message)
            text = format_saved(self.bench, shown, form)
        except UNUSABLE as error:
            raise HTTPError(400, reason="The plant cannot be saved") from error
        self.set_header("Content-Type", "application/toml; charset=utf-8")
        self.finish(text)


def format_saved(bench: Bench, shown: Shown, form: str) -> str:
    """Returns the text of a "crop" file of the component that is shown, or of
    a "campaign" with the plant that is shown as its baseline."""
    stand = bench.place(shown.conditions).stand
    if form == "crop":
        return stand.crop_file(shown.genome, shown.component)
    tables: Tables = make_tables(
        bench.opened.base, bench.own, shown.conditions
    )

    def crop(component: int) -> Tables:
        return tomllib.loads(stand.crop_file(shown.genome, component))

    tables["plant"] = tables["plant"] | {"baseline": crop(0)}
    tables["component"] = [
        each | {"crop": crop(i + 1)}
        for i, each in enumerate(tables.get("component", []))
    ]
    Stand(tables)
    return (
        "# A campaign saved from ideotype play, with the plant of the page as "
        "its\n# baseline: ideotype check FILE, then ideotype run FILE.\n\n"
        + tomli_w.dumps(tables)
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Serves the page and returns the exit code: 0, 2 for a wrong command
    line, 3 for an input that cannot be used."""
    parser = argparse.ArgumentParser(
        prog="ideotype play",
        description="Opens a page on this machine with a plant in its field "
        "and a slider for each trait. Absorbed light, net carbon balance and "
        "other quantities follow the sliders.",
    )
    add = parser.add_argument
    add("plant", nargs="?", default="maize", metavar="PLANT",
        help="a campaign or crop file (.toml), a history (.h5), a measured "
        "plant (.csv, .obj, .ply, .dat), or a crop: "
        f"{', '.join(CROPS)} (default: maize)")  # fmt: skip
    add("--case", type=int, default=0, metavar="N",
        help="case of the campaign, from 0")  # fmt: skip
    add("--of", metavar="NAME", help="plant of a CSV file with several")
    add("--crop", default="maize", metavar="CROP",
        help="crop, by name or file, for traits that were not measured")  # fmt: skip
    add("--selection", type=Path, metavar="FOLDER",
        help="folder of ideotype select; the page states the gains of its "
        "programme")  # fmt: skip
    add_options(parser)
    options = parser.parse_args(arguments)

    def work() -> int:
        opened = open_place(
            options.plant, case=options.case, plant=options.of,
            crop=options.crop,
        )  # fmt: skip
        if options.selection:
            sentences = describe_reach(options.selection)
            opened = replace(opened, about=f"{opened.about} {sentences}")
        with closing(Bench(opened)) as bench:
            given = {"bench": bench}
            app = make_application(
                [
                    ("talk", _Talk, given),
                    ("save/(crop|campaign)", _Save, given),
                ],
                "play",
                _SCRIPTS,
            )
            return serve(app, options, f"ideotype play: {opened.title}")

    return run_page("play", work)
