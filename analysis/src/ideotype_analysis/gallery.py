"""Figures as files, and small enough for a page."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib
from matplotlib.figure import Figure
from PIL import Image

from .blocks import Block, Note, Picture
from .file import HistoryError
from .style import RC

_BYTES = 5_000_000
"""Of all pictures in a page: in base64, and with plants, less than 8 MB."""

_SIZES = ((0.7, 80), (0.6, 75), (0.5, 65), (0.5, 40), (0.4, 30))
"""Pixels of a picture in the page over those of the file, and quality; the
first is sharp when enlarged, the last still legible."""

_FILE_BYTES = 150_000
"""Of a PNG file, for documents."""

_COLORS = 256


class Gallery:
    """Draws figures into a folder, each as PNG and PDF."""

    def __init__(
        self, folder: Path, count: int, step: Callable[[str], None]
    ) -> None:
        """For about `count` figures; `step` is told each one's name."""
        self.folder = folder
        self.folder.mkdir(parents=True, exist_ok=True)
        self.paths: list[Path] = []
        self._step = step
        self._bytes = _BYTES / max(count, 1)

    def draw(
        self, name: str, caption: str, make: Callable[[], Figure]
    ) -> Block:
        """The picture; or where the data are missing, a sentence that says
        so."""
        self._step(name)
        name = file_name(name)
        with matplotlib.rc_context(RC):
            try:
                figure = make()
            except HistoryError as reason:
                return Note(f"{caption.split('.')[0]}: not drawn, {reason}.")
            image = _painted(figure)
            pdf = self.folder / f"{name}.pdf"
            # Laid out once is enough, and the same in both files.
            figure.set_layout_engine("none")
            figure.savefig(pdf, metadata={"CreationDate": None})
        png = self.folder / f"{name}.png"
        png.write_bytes(_png(image))
        self.paths += [png, pdf]
        return Picture(name, caption, _small(image, self._bytes))


def _painted(figure: Figure) -> Image.Image:
    data = io.BytesIO()
    figure.savefig(data, format="png", pil_kwargs={"compress_level": 1})
    with Image.open(data) as file:
        return file.convert("RGB")


def _png(image: Image.Image) -> bytes:
    """The content of a file: with all colours and pixels if there is room,
    else with the best 256 colours and, of very large figures, fewer
    pixels."""
    data = _encoded(image, "PNG", optimize=True)
    while len(data) > _FILE_BYTES:
        few = image.quantize(_COLORS, dither=Image.Dither.NONE)
        data = _encoded(few, "PNG", optimize=True)
        image = _scaled(image, 0.85)
    return data


def _encoded(image: Image.Image, kind: str, **options: Any) -> bytes:
    data = io.BytesIO()
    image.save(data, format=kind, **options)
    return data.getvalue()


def _scaled(image: Image.Image, scale: float) -> Image.Image:
    size = round(scale * image.width), round(scale * image.height)
    return image.resize(size, Image.Resampling.LANCZOS)


def file_name(name: str) -> str:
    """Letters, digits, - and _ of a name; the rest becomes _."""
    return re.sub(r"[^\w-]+", "_", name)


def _small(image: Image.Image, most: float) -> str:
    """For the page: a format made for it, and as many pixels as fit into so
    many bytes."""
    for scale, quality in _SIZES:
        data = _encoded(_scaled(image, scale), "WEBP", quality=quality)
        if len(data) <= most:
            break
    return base64.b64encode(data).decode("ascii")
