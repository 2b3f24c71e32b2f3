# SPDX-License-Identifier: Apache-2.0
"""The figure of a report for a paper: a vector file, a picture and the
caption."""

from __future__ import annotations

import base64
import io
from collections.abc import Sequence
from pathlib import Path

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg

from ..common.labels import describe_span, words
from ..common.output import write_file
from ..figures.comparison import describe_intervals, select_known
from ..figures.paper import draw_paper_figure
from ..figures.style import RC
from ..history.case import Case
from ..history.results import count_evaluations
from .blocks import PaperFigure
from .gallery import format_pdf, format_svg
from .scene import Plants, select_best
from .tables import select_extremes

_NAME = "figure"
_DOTS = 300
"""The resolution of the picture [dots per inch]."""

_DIGITS = 12
"""The number of digits of a hash in the caption."""

FILES = (f"{_NAME}.pdf", f"{_NAME}.png")
"""The files of the figure."""


def make_paper_figure(
    folder: Path, cases: Sequence[Case], shapes: Sequence[Plants | None]
) -> PaperFigure:
    """Draws the figure, writes its files into the folder, and returns it with
    a caption in standard terms. `shapes` are the plants of each case; the
    plants of the case with the largest gain are drawn.

    Raises HistoryError if nothing is evaluated yet."""
    known = select_known(cases)
    best, plants = select_best(cases, shapes)
    shown = select_extremes(known)
    with matplotlib.rc_context(
        {**RC, "font.size": 8.0, "legend.fontsize": 8.0, "svg.hashsalt": _NAME}
    ):
        figure = draw_paper_figure(
            shown, (plants.baseline, plants.best) if plants else None
        )
        svg = format_svg(figure)
        # The figure is laid out once, so that all files are alike.
        figure.set_layout_engine("none")
        png = io.BytesIO()
        figure.set_dpi(_DOTS)
        canvas = FigureCanvasAgg(figure)
        canvas.print_png(png)  # type: ignore[no-untyped-call]
        pdf = format_pdf(figure)
    for name, content in zip(FILES, (pdf, png.getvalue()), strict=True):
        write_file(folder / name, content, folder)
    return PaperFigure(
        _caption(known, shown, best, plants is not None),
        FILES,
        base64.b64encode(svg.encode()).decode("ascii"),
    )


def _caption(
    known: Sequence[Case], shown: Sequence[Case], best: Case, has_plants: bool
) -> str:
    goals = {words(case.best.row.goals[0].name) for case in known}
    quantity = goals.pop() if len(goals) == 1 else "the objective"
    of_case = f" of {best.name}" if len(known) > 1 else ""
    panels = (
        f"(a) Baseline and (b) best plant{of_case}, from the side, 30° off the "
        "row, at one scale. (c) "
        if has_plants
        else ""
    )
    return " ".join(
        (
            f"Plants optimised for {quantity}.",
            f"{panels}Gain in {quantity} over the baseline"
            + (
                f" ({len(shown)} of {len(known)} cases, those with the largest "
                "and the smallest gains)."
                if len(shown) < len(known)
                else "."
            ),
            *_statistics(known),
            _origin(known),
        )
    )


def _statistics(known: Sequence[Case]) -> list[str]:
    """Returns sentences about searches, intervals and errors."""
    histories = [history for case in known for history in case.histories]
    optimizers = {
        str(h.resolved.get("search", {}).get("optimizer", ""))
        for h in histories
    } - {""}
    evaluations = describe_span([*map(count_evaluations, histories)], ",")
    number = describe_span([len(case.pairs) for case in known])
    plural = "es" if number != "1" else ""
    optimizer = f" (optimiser {', '.join(sorted(optimizers))})" * bool(
        optimizers
    )
    per_case = " in each case" if len(known) > 1 else ""
    return [
        f"{number} independent search{plural}{per_case}{optimizer} of {evaluations} "
        "evaluations.",
        f"Blue: mean of searches; error bars: {describe_intervals(known)}, extended "
        "towards an improvement to include the possible optimum.",
        "Baseline and best plants were re-evaluated with independent random "
        "numbers, which both share (paired standard errors)."
        if all(pair.is_final for case in known for pair in case.pairs)
        else "Provisional: the final re-evaluation is missing.",
    ]


def _origin(known: Sequence[Case]) -> str:
    """Returns versions and campaigns."""
    has = [history.attributes for case in known for history in case.histories]
    programs = sorted(
        {f"{x.get('program', 'ideotype')} {x.get('program_version', '')}".strip()
         for x in has}
    )  # fmt: skip
    hashes = sorted({str(x["campaign_sha256"])[:_DIGITS] for x in has
                     if "campaign_sha256" in x})  # fmt: skip
    digest = f", campaign SHA-256 {', '.join(hashes)}" if hashes else ""
    return f"Program: {', '.join(programs)}{digest}."
