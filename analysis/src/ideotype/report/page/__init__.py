# SPDX-License-Identifier: Apache-2.0
"""The HTML of a report: one page that holds all its data and loads no other
file."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.resources import files

from jinja2 import Environment, StrictUndefined

from ..blocks import Section

_VIEWER = ("raster.js", "drawing.js", "front.js", "viewer.js")


def render(title: str, subtitle: str, sections: Sequence[Section]) -> str:
    """Returns one page; all texts are escaped."""
    environment = Environment(
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.tests["a"] = lambda block, kind: type(block).__name__ == kind
    environment.tests["aside"] = lambda block: getattr(
        block, "is_aside", False
    )
    template = environment.from_string(_text("page.html"))
    return template.render(
        title=title,
        subtitle=subtitle,
        sections=sections,
        css=_text("page.css"),
        viewer="".join(map(_text, _VIEWER)),
    )


def _text(name: str) -> str:
    return files(__package__).joinpath(name).read_text(encoding="utf-8")
