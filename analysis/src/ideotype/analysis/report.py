# SPDX-License-Identifier: Apache-2.0
"""Writes the report: one page that needs nothing else, and figures as
files."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from .._errors import Error
from . import tables
from .blocks import Note, Section, Viewer
from .case import Case
from .case_figures import figures_of
from .comparison import draw_energy, draw_gains, intervals_of
from .cross import Cross, draw_cross
from .field import draw_field
from .file import HistoryError
from .front_plants import draw_front_plants
from .gallery import draw_all
from .indices import draw_indices
from .page import render
from .places import (
    draw_gain_map,
    draw_latitudes,
    draw_set_map,
    draw_spacings,
    two_sets,
)
from .provenance import provenance
from .scene import Plants, build_plants, scene_of
from .study import Study
from .workers import workers

_FIELD = (
    "The field of the baseline and of the best plant at eye height, 1.6 m, "
    "and from above. Leaves have the colour of the PAR that they absorb over "
    "the day per area of leaf, as a mean over the leaf, shaded a little; other "
    "organs are dull green or grey. Plants are alike and turned at random."
)
_ALONG = (
    "The baseline, and plants at equal steps along the front in the order of "
    "the first objective, from the side at one scale; objectives with standard "
    "errors."
)
_VIEW = (
    "The baseline is on the left and the {} on the right. Leaves are coloured "
    "by what they absorb over the day; sheaths are dull green, stalks and other "
    "organs grey, neighbours pale and all turned alike. Numbers are ± standard "
    "errors. Lines on the ground are the rows. "
    "Drag (on a touch screen sideways) or use the arrow keys to turn; pinch, "
    "Ctrl and the wheel, or + and - zoom; Home starts again."
)
_FRONT = (
    "The front has plants that no other betters in all objectives, evaluated "
    "again, with standard errors. Choose one with a click, a tap or the arrow "
    "keys: it is shown beside the baseline, with its numbers ± standard errors. "
    "Differences from the baseline have paired errors in objectives, and take "
    "both plants as independent in all else. The last generation is pale, and "
    "drawn as far as it lies within the axes. "
)
_READING = (
    "All figures use the palette of Okabe and Ito and the maps viridis and "
    "PuOr, which the colour-blind can tell apart; lines also differ by marker "
    "or dash. Black is always the baseline, blue the best plant. Axes of "
    "photons take 4.57 mol for each MJ of PAR (McCree 1972). In tables and "
    "figures over cases ± is half of the interval that they name; in what is "
    "told of a single plant it is a standard error."
)


@dataclass(frozen=True)
class Written:
    """The files that a report left on the disk."""

    page: Path
    figures: list[Path] = field(default_factory=list)


def write_report(
    study: Study,
    folder: str | Path,
    *,
    cross: Cross | None = None,
    command: str = "",
    tell: Callable[[str], object] = lambda line: None,
    has_pdf: bool = False,
    jobs: int = 1,
) -> Written:
    """Writes report.html and figures/ into the folder, over those of an
    earlier report. `command` is what the page names as its origin; `tell`
    gets a line for each part of the page. With
    `has_pdf` each figure is a PDF file too, besides PNG. `jobs` processes
    draw the figures; with several, a script needs
    `if __name__ == "__main__":`.

    Raises HistoryError if nothing is evaluated in any history, OSError if
    the folder can't be written."""
    folder = Path(folder)
    every = study.cases()
    cases = [case for case in every if not case.is_sensitivity]
    studies = [case for case in every if case.is_sensitivity]
    if not studies and not any(case.pairs for case in cases):
        raise HistoryError(
            f"{study[0].path}: baseline and best are not evaluated yet"
            f"{'' if len(study) == 1 else ', nor in the other histories'}; "
            "try again when a generation is complete"
        )
    for case in cases:
        case.remember()
    with workers(jobs) as run:
        plants = list(run(_plants, cases))
        shapes = [
            (case, found if isinstance(found, Plants) else None)
            for case, found in zip(cases, plants)
            if isinstance(found, Plants) or case.fronts
        ]
        searched = [
            _overview(study, cases, cross),
            _places(cases, cross),
            _view(shapes),
            *map(_case, cases, plants),
        ]
        if len(cases) == 1:
            searched[3].is_folded = False
        sections = [
            *(searched if cases else ()),
            *map(_study, studies),
            _provenance(every, command),
        ]
        figures = draw_all(
            sections,
            folder / "figures",
            run,
            tell,
            has_pdf,
        )
    page = folder / "report.html"
    fresh = page.with_suffix(".html.part")
    fresh.write_text(render(_title(every), _subtitle(study), sections))
    fresh.replace(page)
    return Written(page, figures)


def _title(cases: Sequence[Case]) -> str:
    names = {str(c.attributes.get("campaign", c.name)) for c in cases}
    return f"Ideotypes of {', '.join(sorted(names))}"


def _subtitle(study: Study) -> str:
    cases = len(study.cases())
    return (
        f"{cases} case{'s' * (cases != 1)}, {len(study)} "
        f"histor{'ies' if len(study) > 1 else 'y'}"
    )


def _overview(
    study: Study, cases: Sequence[Case], cross: Cross | None
) -> Section:
    section = Section("Gains")
    for error in study.damaged:
        section.note(f"A history is left out. {error}.")
    section.blocks += tables.gains(cases, cross)
    section.blocks += tables.scenarios(cases)
    section.draw(
        "gains",
        "How much better than the baseline are the bred plants?",
        f"Mean over seeds with its interval ({intervals_of(cases)}); grey "
        "strokes are single seeds.",
        partial(draw_gains, cases, cross),
    )
    section.draw(
        "energy",
        "Where does the light go?",
        f"Parts of the incident PAR. Error bars: {intervals_of(cases)}.",
        partial(draw_energy, cases),
    )
    section.blocks += tables.organs(cases)
    section.blocks += [tables.balance(cases), Note(_READING)]
    return section


def _places(cases: Sequence[Case], cross: Cross | None) -> Section:
    bars = f"Error bars: {intervals_of(cases)}."
    section = Section("Latitudes, spacings, cross-evaluation")
    cells = f"Numbers are % ± half of the interval ({intervals_of(cases)})."
    section.draw(
        "latitudes",
        "What does latitude do to light and gain?",
        bars,
        partial(draw_latitudes, cases),
    )
    section.draw(
        "spacings",
        "What does plant density do to light and gain?",
        bars,
        partial(draw_spacings, cases),
    )
    section.draw(
        "gain_map",
        "Where does breeding gain most?",
        f"Gain over the baseline. {cells}",
        partial(draw_gain_map, cases),
    )
    if sets := two_sets(cases):
        section.draw(
            "set_map",
            f"Where is the best plant of {sets[0]} better than that of "
            f"{sets[1]}?",
            "There is no difference on the line. Both are taken as independent. "
            + cells,
            partial(draw_set_map, cases, sets),
        )
    if cross is None:
        section.note("Cross-evaluation: none is given (--cross FILE).")
        return section
    section.draw(
        "cross",
        "How does each plant do under the light of each case?",
        "Each plant under the light of each case, in % of the best there ± "
        f"half of the interval ({cross.intervals()}); the seeds of a case are "
        "put together.",
        partial(draw_cross, cross),
    )
    return section


def _view(shapes: list[tuple[Case, Plants | None]]) -> Section:
    has_front = any(case.fronts for case, _ in shapes)
    front = "Front, and its " if has_front else ""
    section = Section((front + "plants in three dimensions").capitalize())
    if shapes:
        caption = (
            _FRONT + _VIEW.format("plant that is chosen, or the best")
            if has_front
            else _VIEW.format("best plant")
        )
        section.blocks.append(Viewer(scene_of(shapes), caption))
    else:
        section.note("The plants are not shown; each case below says why.")
    return section


def _plants(case: Case) -> Plants | Note:
    """Returns the shapes of baseline and best, or why they are not known."""
    try:
        return build_plants(case)
    except Error as reason:
        return Note(f"Plants: not drawn, {reason}.")


def _case(case: Case, plants: Plants | Note) -> Section:
    section = Section(case.name, is_folded=True)
    if isinstance(plants, Note):
        section.blocks.append(plants)
    else:
        if case.fronts:
            section.draw(
                f"{case.name}_front_plants",
                "How do plants change along the front?",
                _ALONG,
                partial(
                    draw_front_plants, case, plants.baseline, plants.members
                ),
            )
        section.draw(
            f"{case.name}_field",
            "How does the bred field look, and which leaves get the light?",
            _FIELD,
            partial(draw_field, case, plants.baseline, plants.best),
        )
    for name, (draw, question, caption) in figures_of(case).items():
        section.draw(
            f"{case.name}_{name}", question, caption, partial(draw, case)
        )
    return section


def _study(case: Case) -> Section:
    section = Section(f"Sensitivity of {case.name}")
    section.draw(
        f"{case.name}_indices",
        "What does the objective depend on?",
        "Sobol' indices: the share of its variance that a factor makes by "
        "itself, and together with all others; or elementary effects by "
        "Morris. Factors vary evenly in their ranges. Noise is taken off, but "
        "not of μ*. The 15 that matter most, with 95 % intervals.",
        partial(draw_indices, case),
    )
    return section


def _provenance(cases: Sequence[Case], command: str) -> Section:
    section = Section("Provenance", provenance(cases))
    if command:
        section.note(f"This page was made by: {command}")
    return section
