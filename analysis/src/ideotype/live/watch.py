# SPDX-License-Identifier: Apache-2.0
"""`ideotype watch`: a page about running campaigns, which follows their
files."""

from __future__ import annotations

import argparse
import asyncio
import json
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from pathlib import Path
from typing import Any

from tornado.web import HTTPError

from ..errors import Error
from ..history.file import HistoryError
from .runs import Folder
from .server import Guarded, add_options, make_application, run_page, serve

_FRESH = 1.0
"""The age up to which data are sent again without reading files [s]."""


class Watcher:
    """Reads a folder in a separate thread for all pages."""

    def __init__(self, folder: Folder) -> None:
        self._folder = folder
        self._pool = ThreadPoolExecutor(1, "watch")
        self._text = ""
        self._at = float("-inf")

    async def state(self) -> str:
        """Returns JSON about all cases."""
        return await self._run(self._read)

    async def plants(self, name: str) -> str:
        """Returns JSON of the baseline and the best plant of a file. Raises
        Error if the file is no history of the folder, or has no plants yet."""
        return await self._run(self._build, name)

    async def _run(self, work: Any, *words: Any) -> Any:
        loop = asyncio.get_running_loop()
        return await loop.run_in_executor(self._pool, work, *words)

    def _read(self) -> str:
        if time.monotonic() - self._at > _FRESH:
            self._text = json.dumps(self._folder.summarise())
            self._at = time.monotonic()
        return self._text

    def _build(self, name: str) -> str:
        from .pictures import make_plants

        for path in self._folder.histories():
            if str(path.relative_to(self._folder.path)) == name:
                return json.dumps(make_plants(path))
        raise Error("this folder has no such history; load the page again")

    def close(self) -> None:
        """Ends the thread after the present reading."""
        self._pool.shutdown(cancel_futures=True)


class _State(Guarded):
    def initialize(self, watcher: Watcher) -> None:
        self.watcher = watcher

    async def get(self, _token: str) -> None:
        self.set_header("Content-Type", "application/json; charset=utf-8")
        self.finish(await self.watcher.state())


class _Plants(_State):
    async def get(self, _token: str) -> None:
        try:
            text = await self.watcher.plants(self.get_query_argument("file"))
        except (Error, HistoryError, OSError) as error:
            text = json.dumps({"problem": str(error)})
        except KeyError as error:
            raise HTTPError(404, reason="There is no such plant") from error
        self.set_header("Content-Type", "application/json; charset=utf-8")
        self.finish(text)


def main(arguments: Sequence[str] | None = None) -> int:
    """Serves the page and returns the exit code: 0, 2 for a wrong command
    line, 3 for a folder that cannot be used."""
    parser = argparse.ArgumentParser(
        prog="ideotype watch",
        description="Opens a page on this machine about the histories in a "
        "folder, and follows running campaigns, here or on a cluster that "
        "shares the folder. Nothing is written.",
    )
    parser.add_argument(
        "folder", nargs="?", type=Path, default=Path("results"),
        metavar="FOLDER", help="folder of histories (default: results)",
    )  # fmt: skip
    add_options(parser)
    options = parser.parse_args(arguments)

    def work() -> int:
        folder = Folder(options.folder)
        with closing(Watcher(folder)) as watcher:
            given = {"watcher": watcher}
            app = make_application(
                [("state.json", _State, given), ("plants", _Plants, given)],
                "watch",
                ("watch.js",),
            )
            return serve(app, options, f"ideotype watch: {folder.name}")

    return run_page("watch", work)
