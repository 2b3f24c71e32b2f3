# SPDX-License-Identifier: Apache-2.0
"""The blocks that a report is made of."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Drawing:
    """A figure that is still to be drawn, by any process: `make` is a
    function of a module, or a partial of one."""

    name: str
    question: str
    """The title, which is the question that the figure answers."""
    caption: str
    make: Callable[[], Figure]


@dataclass(frozen=True)
class Picture:
    """A figure in the page; the files of the figure have its name."""

    name: str
    question: str
    answer: str
    """A sentence that answers the question from the data."""
    caption: str
    data: str
    """The picture as SVG in base64."""


@dataclass(frozen=True)
class Note:
    """A plain sentence on the page."""

    text: str
    is_aside: bool = False
    """Whether the note is about the report and not about the plants, and is
    therefore folded."""


@dataclass(frozen=True)
class Table:
    """A table of texts; cells of the first column are headings."""

    header: Sequence[str]
    rows: Sequence[Sequence[str]]
    caption: str = ""
    has_long_cells: bool = False
    """Whether cells have long texts, so that a narrow screen shows them below
    each other."""


@dataclass(frozen=True)
class Fact:
    """A number of the first screen with its name."""

    name: str
    value: str


@dataclass(frozen=True)
class Answer:
    """The first screen: the gain, its uncertainty, its costs and the limits of
    the search."""

    gain: str
    """The gain with its unit, for large type."""
    claim: str
    """The quantity that is gained, and by which plants."""
    uncertainty: Sequence[Fact]
    costs: Sequence[Fact]
    limits: Sequence[str]
    """Sentences about the parts of the design space that were not searched."""
    is_provisional: bool = False


@dataclass(frozen=True)
class PaperFigure:
    """The figure for a paper with its caption."""

    caption: str
    files: Sequence[str]
    """The names of its files in the folder of the page."""
    data: str
    """The figure as SVG in base64."""


@dataclass(frozen=True)
class Listing:
    """A text that is shown unchanged and folded."""

    title: str
    text: str


@dataclass(frozen=True)
class Viewer:
    """The 3D view; its scene is JSON."""

    scene: str
    caption: str


Block = (
    Drawing | Picture | PaperFigure | Note | Table | Listing | Viewer | Answer
)


@dataclass
class Section:
    """A part of the page. A folded section opens at a click."""

    title: str
    blocks: list[Block] = field(default_factory=list)
    is_folded: bool = False

    def note(self, text: str) -> None:
        """Adds a sentence."""
        self.blocks.append(Note(text))

    def draw(
        self,
        name: str,
        question: str,
        caption: str,
        make: Callable[[], Figure],
    ) -> None:
        """Adds a figure; the arguments are the members of Drawing."""
        self.blocks.append(Drawing(name, question, caption, make))
