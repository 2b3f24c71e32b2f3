"""The report: one page that needs nothing else, and figures as files."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from . import tables
from .blocks import Block, Note, Section, Viewer
from .case import Case
from .case_figures import CASE_FIGURES
from .comparison import draw_energy, draw_gains
from .cross import Cross, draw_cross
from .fidelity import Fidelity, draw_fidelity
from .file import HistoryError
from .gallery import Gallery
from .page import render
from .places import draw_latitudes, draw_spacings
from .plan import draw_plan
from .progress import Progress
from .provenance import provenance
from .scene import Plants, export_plants, scene_of
from .study import Study

_PLAN = (
    "Plan view. The plant among its neighbours, all turned alike; dashed: "
    "rows."
)
_VIEW = (
    "Baseline (left) and best plant (right). Leaves are coloured by what they "
    "absorb over the day; stalks are grey, neighbours pale and all turned "
    "alike. Lines on the ground are the rows. Drag (on a touch screen "
    "sideways) or use the arrow keys to turn; pinch, Ctrl and the wheel, or + "
    "and - to zoom; Home to start again."
)
_READING = (
    "All figures use the palette of Okabe and Ito and the maps viridis and "
    "PuOr, which the colour-blind can tell apart; lines also differ by marker "
    "or dash. Black is always the baseline, blue the best plant."
)


@dataclass(frozen=True)
class Written:
    """What a report left on the disk."""

    page: Path
    figures: list[Path] = field(default_factory=list)


def write_report(
    study: Study,
    folder: str | Path,
    *,
    cross: Cross | None = None,
    fidelity: Fidelity | None = None,
    program: Path | None = None,
    command: str = "",
    progress: Progress | None = None,
) -> Written:
    """Writes report.html and figures/ into the folder, over those of an
    earlier report. `program` is the ideotype that exports shapes of plants,
    `command` what the page names as its origin.

    Raises HistoryError if nothing is evaluated in any history, OSError if
    the folder can't be written."""
    folder = Path(folder)
    cases = study.cases()
    if not any(case.pairs for case in cases):
        raise HistoryError(
            f"{study[0].path}: baseline and best are not evaluated yet"
            f"{'' if len(study) == 1 else ', nor in the other histories'}; "
            "try again when a generation is complete"
        )
    progress = progress or Progress(len(cases) + 1, io.StringIO())
    count = len(cases) * len(CASE_FIGURES)
    gallery = Gallery(folder / "figures", count, progress.step)
    shapes: list[tuple[Case, Plants]] = []
    each = [_case(case, gallery, progress, program, shapes) for case in cases]
    if len(each) == 1:
        each[0].is_folded = False
    progress.part("all cases together")
    sections = [
        _overview(study, cases, cross, gallery),
        _places(cases, cross, gallery),
        _view(shapes),
        *each,
        *_trade(fidelity, gallery),
        _provenance(cases, command),
    ]
    progress.done()
    page = folder / "report.html"
    fresh = page.with_suffix(".html.part")
    fresh.write_text(render(_title(cases), _subtitle(study), sections))
    fresh.replace(page)
    return Written(page, gallery.paths)


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
    study: Study, cases: Sequence[Case], cross: Cross | None, gallery: Gallery
) -> Section:
    section = Section("Gains")
    for error in study.damaged:
        section.note(f"A history is left out. {error}.")
    section.blocks += tables.gains(cases, cross)
    section.blocks.append(
        gallery.draw(
            "gains",
            "Gains over the baseline by case. Mean over seeds with its 95 % "
            "confidence interval; grey strokes are single seeds.",
            partial(draw_gains, cases, cross),
        )
    )
    section.blocks.append(
        gallery.draw(
            "energy",
            "Energy balance. Parts of the incident PAR; error bars are 95 % "
            "confidence intervals over seeds.",
            partial(draw_energy, cases),
        )
    )
    section.blocks += [tables.balance(cases), Note(_READING)]
    return section


def _places(
    cases: Sequence[Case], cross: Cross | None, gallery: Gallery
) -> Section:
    bars = "Error bars are 95 % confidence intervals over seeds."
    section = Section("Latitudes, spacings, cross-evaluation")
    section.blocks += [
        gallery.draw(
            "latitudes",
            f"Latitudes compared. {bars}",
            partial(draw_latitudes, cases),
        ),
        gallery.draw(
            "spacings",
            f"Spacings compared. {bars}",
            partial(draw_spacings, cases),
        ),
    ]
    if cross is None:
        section.note("Cross-evaluation: none is given (--cross FILE).")
    else:
        section.blocks.append(
            gallery.draw(
                "cross",
                "Cross-evaluation. Each plant under the light of each case, "
                "in % of the best there ± half of the 95 % confidence "
                "interval; the seeds of a case are put together.",
                partial(draw_cross, cross),
            )
        )
    return section


def _view(shapes: list[tuple[Case, Plants]]) -> Section:
    section = Section("Plants in three dimensions")
    if shapes:
        section.blocks.append(Viewer(scene_of(shapes), _VIEW))
    else:
        section.note("The plants are not shown; each case below says why.")
    return section


def _case(
    case: Case,
    gallery: Gallery,
    progress: Progress,
    program: Path | None,
    shapes: list[tuple[Case, Plants]],
) -> Section:
    progress.part(case.name)
    section = Section(case.name, is_folded=True)
    for name, (draw, caption) in CASE_FIGURES.items():
        section.blocks.append(
            gallery.draw(f"{case.name}_{name}", caption, partial(draw, case))
        )
        if name == "roses":
            section.blocks.append(_plan(case, gallery, program, shapes))
    return section


def _plan(
    case: Case,
    gallery: Gallery,
    program: Path | None,
    shapes: list[tuple[Case, Plants]],
) -> Block:
    """The plan view; remembers the shapes for the 3D view."""
    try:
        plants = export_plants(case, program)
    except HistoryError as reason:
        return Note(f"Plan view and 3D view: not drawn, {reason}.")
    shapes.append((case, plants))
    return gallery.draw(
        f"{case.name}_plan",
        _PLAN,
        partial(draw_plan, case, plants.baseline, plants.best),
    )


def _trade(fidelity: Fidelity | None, gallery: Gallery) -> list[Section]:
    if fidelity is None:
        return []
    section = Section("Speed for accuracy")
    section.blocks.append(
        gallery.draw(
            "fidelity",
            f"Speed for accuracy in {fidelity.case}. Lines: the cheapest "
            "settings for each error, as predicted; points: some of them "
            "evaluated anew, with standard errors. One field serves all "
            "randomisations of a generation; finalists have a field each.",
            partial(draw_fidelity, fidelity),
        )
    )
    return [section]


def _provenance(cases: Sequence[Case], command: str) -> Section:
    section = Section("Provenance", provenance(cases))
    if command:
        section.note(f"This page was made by: {command}")
    return section
