"""Figures as files, and small enough for a page."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Callable
from pathlib import Path

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
            image = io.BytesIO()
            figure.savefig(image, format="png")
            pdf = self.folder / f"{name}.pdf"
            figure.savefig(pdf, metadata={"CreationDate": None})
        png = self.folder / f"{name}.png"
        png.write_bytes(image.getvalue())
        self.paths += [png, pdf]
        return Picture(name, caption, _small(image, self._bytes))


def file_name(name: str) -> str:
    """Letters, digits, - and _ of a name; the rest becomes _."""
    return re.sub(r"[^\w-]+", "_", name)


def _small(image: io.BytesIO, most: float) -> str:
    """For the page: a format made for it, and as many pixels as fit into so
    many bytes."""
    with Image.open(image) as file:
        full = file.convert("RGB")
    for scale, quality in _SIZES:
        size = round(scale * full.width), round(scale * full.height)
        small = full.resize(size, Image.Resampling.LANCZOS)
        data = io.BytesIO()
        small.save(data, format="WEBP", quality=quality)
        if data.tell() <= most:
            break
    return base64.b64encode(data.getvalue()).decode("ascii")
