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

_MANY = 80
"""So many pictures fit into a page of less than 8 MB in the better size."""


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
        # of the pixels of a file; the better is still sharp when enlarged
        self._scale = 0.7 if count <= _MANY else 0.5

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
        return Picture(name, caption, _small(image, self._scale))


def file_name(name: str) -> str:
    """Letters, digits, - and _ of a name; the rest becomes _."""
    return re.sub(r"[^\w-]+", "_", name)


def _small(image: io.BytesIO, scale: float) -> str:
    """For the page: fewer pixels, and a format made for it."""
    with Image.open(image) as picture:
        size = (
            round(scale * picture.width),
            round(scale * picture.height),
        )
        small = picture.convert("RGB").resize(size, Image.Resampling.LANCZOS)
    data = io.BytesIO()
    small.save(data, format="WEBP", quality=85)
    return base64.b64encode(data.getvalue()).decode("ascii")
