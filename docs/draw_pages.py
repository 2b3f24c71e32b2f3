#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the pictures of pages in the manual: those of `ideotype play` and
`ideotype watch` and of a report, as Chromium shows them on a screen and on a
telephone.

draw_pages.py

IDEOTYPE_EXECUTABLE names the program, else it is that on PATH."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

DOCS = Path(__file__).resolve().parent
TOP = DOCS.parent
sys.path.insert(0, str(TOP / "tests" / "analysis"))
from live_browser import move, settle, shown  # noqa: E402
from live_page import served  # noqa: E402
from phone import HEIGHT, Phone, phone_with  # noqa: E402

PROGRAM = os.environ.get("IDEOTYPE_EXECUTABLE", "ideotype")


def keep(phone: Phone, name: str) -> None:
    """Saves a screenshot; those of phones are scaled down."""
    path = DOCS / "figures" / name
    with tempfile.TemporaryDirectory() as folder:
        phone.picture(whole := Path(folder) / "page.png")
        page = Image.open(whole).convert("RGB")
    width = 480 if page.width < 1000 else 1280
    page = page.resize((width, round(page.height * width / page.width)))
    if path.suffix == ".jpg":
        page.save(path, quality=80, optimize=True)
    else:
        page.quantize(96).save(path, optimize=True)


def play(folder: Path) -> None:
    """Draws a plant, longer leaves, panels, and the page on a telephone."""
    with served("play", "maize") as page:
        with shown(page, folder) as phone:
            keep(phone, "play.jpg")
            move(phone, "length_profile_2", 0.9)
            keep(phone, "play_moved.jpg")
            phone.value("byId('panels').click()")
            settle(phone)
            keep(phone, "play_panels.jpg")
        with shown(page, folder, 390) as phone:
            keep(phone, "play_phone.jpg")


def watch(folder: Path) -> None:
    """Draws the page of the campaigns in a folder."""
    os.chdir(folder)  # The page shows the path as given.
    with served("watch", "results") as page:
        with shown(page, folder) as phone:
            keep(phone, "watch.jpg")
        with shown(page, folder, 390) as phone:
            keep(phone, "watch_phone.jpg")


def report(folder: Path, results: Path) -> None:
    """Draws the first screen of a report."""
    ideotype = [sys.executable, "-m", "ideotype"]
    subprocess.run(
        [*ideotype, "report", results, "-o", folder / "report"], check=True
    )
    page = folder / "report" / "report.html"
    with phone_with(page, folder, 1280, HEIGHT + 156) as phone:
        keep(phone, "report.png")


def main() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        results = folder / "results"
        subprocess.run(
            [PROGRAM, "run", TOP / "campaigns" / "quickstart.toml",
             "--out", results], check=True,
        )  # fmt: skip
        play(folder)
        watch(folder)
        report(folder, results)


if __name__ == "__main__":
    main()
