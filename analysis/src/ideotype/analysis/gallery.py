# SPDX-License-Identifier: Apache-2.0
"""Draws figures as files, and small enough for a page."""

from __future__ import annotations

import base64
import io
import re
import textwrap
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any, TypeGuard

import matplotlib
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.figure import Figure
from matplotlib.text import Text
from PIL import Image

from .blocks import Block, Drawing, Note, Picture, Section
from .file import HistoryError
from .style import RC, pixels
from .workers import Map

_BYTES = 5_000_000
"""The bytes of all pictures in a page: in base64, and with plants, less than 8
MB."""

_SIZES = (
    *((33_000, 0.7, 80), (25_000, 0.6, 75), (18_500, 0.5, 65)),
    *((15_500, 0.5, 40), (0, 0.4, 30)),
)
"""The bytes that a picture in the page takes on average, its pixels over those
of the file, and its quality. The first is sharp when enlarged; the last, of 10
kB, is still legible."""

_FILE_BYTES = 150_000
"""The bytes of a PNG file, which is for documents."""

_COLORS = 256


def draw_all(
    sections: Sequence[Section],
    folder: Path,
    run: Map,
    tell: Callable[[str], object],
    has_pdf: bool,
) -> list[Path]:
    """Puts pictures in the place of drawings, and returns their files, PNG
    and, if wanted, PDF. `run` is map() or does as it does; each section is
    told before its figures."""
    folder.mkdir(parents=True, exist_ok=True)
    drawings = [b for s in sections for b in s.blocks if _is_drawing(b)]
    most = _BYTES / max(len(drawings), 1)
    drawn = iter(run(partial(draw, folder, most, has_pdf), drawings))
    parts = [s for s in sections if any(map(_is_drawing, s.blocks))]
    for i, section in enumerate(parts, start=1):
        tell(f"[{i}/{len(parts)}] {section.title}")
        section.blocks = [
            next(drawn) if _is_drawing(block) else block
            for block in section.blocks
        ]
    return [
        folder / f"{block.name}.{end}"
        for section in parts
        for block in section.blocks
        if isinstance(block, Picture)
        for end in ("png", "pdf")[: 1 + has_pdf]
    ]


def _is_drawing(block: Block) -> TypeGuard[Drawing]:
    return isinstance(block, Drawing)


def draw(folder: Path, most: float, has_pdf: bool, drawing: Drawing) -> Block:
    """Returns the picture, of about so many bytes in the page, and its files;
    or where the data are missing, a sentence that says so."""
    name = file_name(drawing.name)
    with matplotlib.rc_context(RC):
        try:
            figure = drawing.make()
        except HistoryError as reason:
            return Note(f"{drawing.question} Not drawn: {reason}.")
        title, part = _entitle(figure, drawing.question)
        figure.set_dpi(RC["savefig.dpi"])
        image = Image.fromarray(pixels(figure)).convert("RGB")
        if has_pdf:
            # The figure is laid out once, and both files are alike; savefig()
            # would draw it once more to lay it out.
            figure.set_layout_engine("none")
            FigureCanvasPdf(figure).print_pdf(  # type: ignore[no-untyped-call]
                folder / f"{name}.pdf", metadata={"CreationDate": None}
            )
    (folder / f"{name}.png").write_bytes(_png(image))
    data = _small(_below(image, figure, title, part), most)
    return Picture(name, drawing.question, drawing.caption, data)


def _entitle(figure: Figure, question: str) -> tuple[Text, float]:
    """Puts the question above what the figure tells of itself, and returns its
    text and the part of the title's height that it takes."""
    lines = textwrap.wrap(question, round(12 * figure.get_figwidth()))
    every = [*lines, *filter(None, figure.get_suptitle().split("\n"))]
    title = figure.suptitle("\n".join(every), fontsize=10)
    return title, len(lines) / len(every)


def _below(
    image: Image.Image, figure: Figure, title: Text, part: float
) -> Image.Image:
    """Returns the image without the lines of the question, which the page
    tells."""
    box, whole = title.get_window_extent(), figure.bbox.height
    top = whole - box.y1 + part * box.height
    rows = round(top / whole * image.height)
    return image.crop((0, rows, *image.size))


def _png(image: Image.Image) -> bytes:
    """Returns the content of a file: with all colours and pixels if there is
    room, else with 256 good colours and, if the figure is very large, fewer
    pixels."""
    data = _encoded(image, "PNG")
    while len(data) > _FILE_BYTES:
        # This way is by far the fastest; figures have few colours that matter.
        few = image.quantize(_COLORS, Image.Quantize.FASTOCTREE)
        data = _encoded(few, "PNG")
        # Bytes fall more slowly than pixels do.
        scale = 0.95 * (_FILE_BYTES / len(data)) ** 0.5
        image = _scaled(image, min(scale, 0.95))
    return data


def _encoded(image: Image.Image, kind: str, **options: Any) -> bytes:
    data = io.BytesIO()
    image.save(data, format=kind, **options)
    return data.getvalue()


def _scaled(image: Image.Image, scale: float) -> Image.Image:
    size = round(scale * image.width), round(scale * image.height)
    # This is nearly as sharp as the best filter, in half its time.
    return image.resize(size, Image.Resampling.HAMMING)


def file_name(name: str) -> str:
    """Returns letters, digits, - and _ of a name; the rest becomes _."""
    return re.sub(r"[^\w-]+", "_", name)


def _small(image: Image.Image, most: float) -> str:
    """Returns a picture for the page: in a format made for it, with as many
    pixels as pictures have that take at most so many bytes on average."""
    scale, quality = next(size for least, *size in _SIZES if least <= most)
    data = _encoded(_scaled(image, scale), "WEBP", quality=quality)
    return base64.b64encode(data).decode("ascii")
