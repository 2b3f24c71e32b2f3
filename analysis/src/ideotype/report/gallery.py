# SPDX-License-Identifier: Apache-2.0
"""Draws figures for files and for the page, and writes the figures'
numbers."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TypeGuard

import matplotlib
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from PIL import Image

from ..common.output import file_name, write_file
from ..figures.numbers import read_numbers
from ..figures.style import RC, get_answer
from ..history.file import HistoryError
from .blocks import Block, Drawing, Note, Picture, Section
from .workers import Map

_QUALITY = 80
"""The quality of painted parts of a figure, such as fields."""


def draw_all(
    sections: Sequence[Section],
    folder: Path,
    run: Map,
    tell: Callable[[int, int, str], object],
    has_pdf: bool,
) -> list[Path]:
    """Replaces drawings by pictures, and returns their files in the
    folder "figures" of a report: SVG, the numbers as CSV and, if wanted, PDF.
    `run` is map() or a parallel map(); `tell` gets the number of drawn figures,
    the number of all figures, and the kind of work."""
    drawings = [b for s in sections for b in s.blocks if _is_drawing(b)]
    drawn = iter(run(partial(draw, folder, has_pdf), drawings))
    done = 0
    for section in sections:
        blocks = []
        for block in section.blocks:
            if _is_drawing(block):
                block = next(drawn)
                done += 1
                tell(done, len(drawings), section.title)
            blocks.append(block)
        section.blocks = blocks
    return [
        folder / f"{block.name}.{end}"
        for section in sections
        for block in section.blocks
        if isinstance(block, Picture)
        for end in ("svg", "csv", "pdf")[: 2 + has_pdf]
    ]


def _is_drawing(block: Block) -> TypeGuard[Drawing]:
    return isinstance(block, Drawing)


def draw(folder: Path, has_pdf: bool, drawing: Drawing) -> Block:
    """Returns the picture and writes its files; or returns a sentence that
    names the missing data."""
    name = file_name(drawing.name)
    with matplotlib.rc_context({**RC, "svg.hashsalt": name}):
        try:
            figure = drawing.make()
        except HistoryError as reason:
            return Note(f"{drawing.question} Not drawn: {reason}.", True)
        svg = format_svg(figure)
        files: dict[str, str | bytes] = {
            "svg": svg,
            "csv": read_numbers(figure),
        }
        if has_pdf:
            # The figure is laid out once, so that both files are alike.
            figure.set_layout_engine("none")
            files["pdf"] = format_pdf(figure)
    for end, content in files.items():
        write_file(folder / f"{name}.{end}", content, folder.parent)
    data = base64.b64encode(svg.encode()).decode("ascii")
    return Picture(
        name, drawing.question, get_answer(figure), drawing.caption, data
    )


def format_pdf(figure: Figure) -> bytes:
    """Returns a figure as PDF without a date."""
    out = io.BytesIO()
    FigureCanvasPdf(figure).print_pdf(  # type: ignore[no-untyped-call]
        out, metadata={"CreationDate": None}
    )
    return out.getvalue()


def format_svg(figure: Figure) -> str:
    """Returns a figure as SVG without a date; texts stay texts, and painted
    parts have a compact format."""
    out = io.StringIO()
    canvas = FigureCanvasSVG(figure)
    canvas.print_svg(out, metadata={"Date": None})  # type: ignore[no-untyped-call]
    text = re.sub("<[^>]+>", _with_short_numbers, out.getvalue())
    text = text.replace("'DejaVu Sans'", "'DejaVu Sans', Verdana, sans-serif")
    return re.sub(
        r"data:image/png;base64,([^\"]*)", lambda m: _smaller(m[1]), text
    )


def _with_short_numbers(tag: re.Match[str]) -> str:
    """Rounds the coordinates of a tag, but no words between tags: hundredths
    of a point are finer than screens and printers."""
    return re.sub(r"\d+\.\d{3,}", lambda m: f"{float(m[0]):.2f}", tag[0])


def _smaller(png: str) -> str:
    image = Image.open(io.BytesIO(base64.b64decode(png)))
    out = io.BytesIO()
    image.save(out, format="WEBP", quality=_QUALITY)
    return (
        "data:image/webp;base64," + base64.b64encode(out.getvalue()).decode()
    )
