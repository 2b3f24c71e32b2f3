# SPDX-License-Identifier: Apache-2.0
"""Writes the report: one self-contained page, and figures as files."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from ..common.output import require_output, write_file
from ..figures.comparison import draw_energy, draw_gains, intervals_of
from ..figures.cross import Cross, draw_cross
from ..figures.gain_maps import draw_gain_map, draw_set_map, two_sets
from ..figures.indices import draw_indices
from ..figures.places import draw_latitudes, draw_spacings
from ..history.case import Case
from ..history.file import HistoryError
from ..history.results import results_of
from ..history.study import Study
from . import tables
from .answer import answer, leaf_table
from .blocks import Note, Section, Viewer
from .case_section import plants_of, section_of
from .gallery import draw_all
from .light_tables import balance, organs
from .organ_split import Split, by_name, columns_of, split_of, table_of
from .page import render
from .provenance import provenance
from .scenario_table import scenarios
from .scene import Plants, scene_of
from .workers import workers

_VIEW = (
    "Choose any two plants; report --plant FILE adds plants of your own. Leaves are coloured by what they absorb over the "
    "day; sheaths are dull green, stalks and other organs grey, neighbours "
    "pale and all turned alike. Lines on the ground are the rows. "
    "Drag (on a touch screen sideways) or use the arrow keys to turn; pinch, "
    "Ctrl and the wheel, or + and - zoom; Home starts again."
)
_FRONT = (
    "The front has plants that no other betters in all objectives, evaluated "
    "again. Choose one with a click, a tap or the arrow keys: it is shown "
    "beside the baseline, with its numbers. Differences from the baseline have "
    "paired errors in objectives, and take both plants as independent in all "
    "else. The last generation is pale, and drawn as far as it lies within the "
    "axes. "
)
_READING = (
    "On this page ± is half of a 95 % interval, and so is each error bar; "
    "\N{MINUS SIGN} and + are its two parts where they differ. The interval of "
    "a gain holds how searches differ and, towards more, where the optimum may "
    "be; that of a number of a single plant holds the noise of the light and of "
    "the field. Black is always the "
    "baseline, blue the best plant. Each figure is a file of its name in "
    "figures/, its numbers are in the .csv beside it."
)

_FEW = 3
"""The largest number of cases that each get separate figures by default."""


@dataclass(frozen=True)
class Written:
    """The files of a report on the disk."""

    page: Path
    figures: list[Path] = field(default_factory=list)


def write_report(
    study: Study,
    folder: str | Path,
    *,
    cross: Cross | None = None,
    command: str = "",
    tell: Callable[[int, int, str], object] = lambda done, count, what: None,
    has_pdf: bool = False,
    jobs: int = 1,
    figures_of: Sequence[str] | None = None,
    plants: Sequence[str | Path] = (),
    has_split: bool = True,
) -> Written:
    """Writes report.html, results.csv and figures/ into the folder, over those
    of an earlier report. `command` is the command that the page names as its
    origin; `tell` gets the number of drawn figures, the number of all figures,
    and the kind of work. With `has_pdf` each figure is a PDF file too, besides
    SVG. `jobs` processes draw the figures; with several, a script needs `if
    __name__ == "__main__":`. Cases whose name contains one of the words
    `figures_of` get separate figures; without words all cases do if there are
    few. `plants` are files of the user's own plants for the 3D view, as for
    own_plants(). With `has_split` the best plant of each case and its baseline
    are evaluated again with leaves alone.

    Raises HistoryError if no history has an evaluation, OutputRefused if a
    symbolic link is where a file or folder is to be written, OSError if the
    folder can't be written."""
    folder = Path(folder)
    page, table = folder / "report.html", folder / "results.csv"
    pictures = folder / "figures"
    for path in (page, table, pictures / "any"):
        require_output(path, folder)
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
    single = _with_figures(cases, figures_of)
    with workers(jobs) as run:
        splits = by_name(cases, run(split_of, cases)) if has_split else {}
        own = [Path(path) for path in plants]
        built = list(run(partial(plants_of, own=own), cases))
        shapes = [
            (case, found if isinstance(found, Plants) else None)
            for case, found in zip(cases, built)
            if isinstance(found, Plants) or case.fronts
        ]
        searched = [
            _answer(study, cases, splits),
            _gains(cases, cross, splits),
            _places(cases, cross),
            _view(shapes),
            *(
                section_of(case, found)
                for case, found in zip(cases, built)
                if case in single
            ),
        ]
        if len(single) == 1:
            searched[-1].is_folded = False
        sections = [
            *(searched if cases else ()),
            *map(_study, studies),
            _about(cases, cross),
            _provenance(every, command),
        ]
        figures = draw_all(sections, pictures, run, tell, has_pdf)
    write_file(
        table,
        results_of(cases, columns_of(splits)).to_csv(index=False),
        folder,
    )
    write_file(
        page,
        render(
            _title(every), _subtitle(study), [s for s in sections if s.blocks]
        ),
        folder,
    )
    return Written(page, figures)


def _with_figures(
    cases: Sequence[Case], words: Sequence[str] | None
) -> list[Case]:
    """Returns the cases that have separate figures.

    Raises HistoryError if no name contains a word."""
    if words is None:
        return [*cases] if len(cases) <= _FEW else []
    for word in words:
        if not any(word in case.name for case in cases):
            raise HistoryError(
                f"no case has '{word}' in its name; there are "
                + ", ".join(case.name for case in cases[:_FEW])
                + (", ..." if len(cases) > _FEW else "")
            )
    return [case for case in cases if any(w in case.name for w in words)]


def _title(cases: Sequence[Case]) -> str:
    names = {str(c.attributes.get("campaign", c.name)) for c in cases}
    return f"Ideotypes of {', '.join(sorted(names))}"


def _subtitle(study: Study) -> str:
    cases = len(study.cases())
    return (
        f"{cases} case{'s' * (cases != 1)}, {len(study)} "
        f"histor{'ies' if len(study) > 1 else 'y'}"
    )


def _answer(
    study: Study, cases: Sequence[Case], splits: Mapping[str, Split | Note]
) -> Section:
    """Returns the answer with which the page begins."""
    section = Section("The answer")
    for error in study.damaged:
        section.note(f"A history is left out. {error}.")
    if known := [case for case in cases if case.pairs]:
        section.blocks.append(answer(cases, splits))
        section.note(_READING)
        best = max(known, key=lambda case: case.relative_gain().mean)
        if len(known) > 1:
            section.note(
                f"The leaves below are those bred in the case that gains most, "
                f"{best.name}; those of any other are in three dimensions "
                "below, and ideotype export writes them."
            )
        section.blocks.append(leaf_table(best))
    return section


def _gains(
    cases: Sequence[Case],
    cross: Cross | None,
    splits: Mapping[str, Split | Note],
) -> Section:
    section = Section("Gains")
    section.draw(
        "gains",
        "How much better than the baseline are the bred plants?",
        f"Means of searches; intervals: {intervals_of(cases)}.",
        partial(draw_gains, cases, cross),
    )
    section.draw(
        "energy",
        "Where does the light go?",
        "Parts of the incident PAR.",
        partial(draw_energy, cases),
    )
    section.blocks += tables.gains(cases, cross)[:1]
    section.blocks += [*table_of(splits), *scenarios(cases)]
    return section


def _about(cases: Sequence[Case], cross: Cross | None) -> Section:
    """Returns the folded section that explains the numbers."""
    section = Section("How the numbers were made", is_folded=True)
    if cases:
        section.blocks += tables.gains(cases, cross)[1:]
        if len(cases) <= _FEW * 4:
            section.blocks += organs(cases)
        section.blocks.append(balance(cases))
    return section


def _places(cases: Sequence[Case], cross: Cross | None) -> Section:
    bars = "The upper panel has the best plants, the lower one the mean gain."
    section = Section("Places")
    if len(cases) < 2 and cross is None:
        return section
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
        "Gain over the baseline. Numbers are %.",
        partial(draw_gain_map, cases),
    )
    if sets := two_sets(cases):
        section.draw(
            "set_map",
            f"Where is the best plant of {sets[0]} better than that of "
            f"{sets[1]}?",
            "There is no difference on the line. Both are taken as independent. "
            "Numbers are %.",
            partial(draw_set_map, cases, sets),
        )
    if cross is None:
        return section
    section.draw(
        "cross",
        "How does each plant do under the light of each case?",
        "In % of the best under the same light; the seeds of a case are put "
        f"together. Intervals: {cross.intervals()}.",
        partial(draw_cross, cross),
    )
    return section


def _view(shapes: list[tuple[Case, Plants | None]]) -> Section:
    has_front = any(case.fronts for case, _ in shapes)
    front = "Front, and its " if has_front else ""
    section = Section((front + "plants in three dimensions").capitalize())
    if shapes:
        caption = _FRONT + _VIEW if has_front else _VIEW
        section.blocks.append(Viewer(scene_of(shapes), caption))
    else:
        section.note("The plants are not shown; each case below says why.")
    return section


def _study(case: Case) -> Section:
    section = Section(f"Sensitivity of {case.name}")
    section.draw(
        f"{case.name}_indices",
        "What does the objective depend on?",
        "Sobol' indices: the share of its variance that a factor makes by "
        "itself, and together with all others; or elementary effects by "
        "Morris. Factors vary evenly in their ranges. Noise is taken off, but "
        "not of μ*. The 15 that matter most.",
        partial(draw_indices, case),
    )
    return section


def _provenance(cases: Sequence[Case], command: str) -> Section:
    section = Section("Provenance", provenance(cases))
    if command:
        section.note(f"This page was made by: {command}")
    return section
