# SPDX-License-Identifier: Apache-2.0
"""Writes the report: one self-contained page, and figures as files."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from ..common.output import require_output, write_file
from ..figures.comparison import describe_intervals, draw_energy, draw_gains
from ..figures.cross import Cross, draw_cross
from ..figures.gain_maps import draw_gain_map, draw_set_map, find_sets
from ..figures.indices import draw_indices
from ..figures.pair import draw_pair
from ..figures.places import draw_latitudes, draw_spacings
from ..history.case import Case
from ..history.file import HistoryError
from ..history.results import results_of
from ..history.study import Study
from . import tables
from .answer import make_answer, tabulate_leaves
from .blocks import Note, Section, Viewer
from .case_section import make_plants, make_section
from .decision_section import decide_case, make_decision_section
from .estimates import DrawnGains, evaluate_draws
from .gallery import draw_all
from .light_tables import describe_balance, tabulate_organs
from .organ_split import (
    Split,
    columns_of,
    name_results,
    split_case,
    tabulate_splits,
)
from .page import render
from .paper import FILES, make_paper_figure
from .programme import tabulate_reach
from .provenance import tabulate_provenance
from .scenario_table import tabulate_scenarios
from .scene import Plants, make_scene, select_best
from .workers import start_workers

if TYPE_CHECKING:
    from ..calibration.parameters import Parameter

_VIEW = (
    "Choose any two plants; ideotype report --plant FILE adds plants of your "
    "own. Leaf colour: PAR absorbed over the day. Sheaths are dull green, stalks "
    "and other organs grey, neighbours pale and all in the same orientation. "
    "Lines on the ground are the rows. Turn: drag (on a touch screen sideways) "
    "or arrow keys. Zoom: pinch, Ctrl and the wheel, or + and -. Home resets "
    "the view."
)
_FRONT = (
    "Pareto front after re-evaluation: no other plant is at least as good in "
    "all objectives and better in one. Choose a plant with a click, a tap or "
    "the arrow keys; it appears next to the baseline, with its numbers. "
    "Differences from the baseline have paired standard errors for objectives; "
    "for other quantities both plants are treated as independent. The last "
    "generation is pale, and shown where it lies within the axes. "
)
_READING = (
    "On this page ± is half of a 95 % confidence interval, and so is each "
    "error bar; where the two halves differ, both follow with \N{MINUS SIGN} "
    "and +. The interval of a gain includes the differences between searches "
    "and, towards an improvement, the possible optimum. The interval of a "
    "single plant includes the noise of light and field. Black is the "
    "baseline, blue the best plant. Each figure is a file of its name in "
    "figures/, with its numbers in a .csv file."
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
    tell: Callable[[int, int, str], object] = lambda done, count, part: None,
    has_pdf: bool = False,
    jobs: int = 1,
    figures_of: Sequence[str] | None = None,
    plants: Sequence[str | Path] = (),
    has_split: bool = True,
    selection: Path | None = None,
    estimates: Sequence[Parameter] = (),
    has_decision: bool = True,
) -> Written:
    """Writes report.html, results.csv, the figure for a paper (figure.pdf and
    figure.png) and figures/ into the folder, over those of an earlier report.

    The page names `command` as its origin, and contains `cross`, a
    cross-evaluation of plants and cases. `tell` gets the number of drawn
    figures, the number of all figures, and the kind of work, or the same of
    options that are re-evaluated for a decision. With `has_pdf`
    each figure is written as PDF in addition to SVG. `jobs` is the number of
    processes that draw figures; with several, a script needs
    `if __name__ == "__main__":`. Cases with one of the words `figures_of` in
    their name get separate figures; without words, all cases do if there are
    few. `plants` are files of the user's plants for the 3D view, as for
    own_plants(). With `has_split` the best plant of each case and its baseline
    are re-evaluated with leaves alone, and with `estimates` under 20 draws of
    these parameters of the crop. `selection` is a folder that
    ideotype.selection.write_selection() has written; its programme is a
    section of the page. With `has_decision` cases with prices or with an
    objective over scenarios have a section that decides between a few plants
    with their managements, which are re-evaluated for it; decision.html has that
    section alone, to be printed.

    Raises HistoryError if no history has an evaluation, OutputRefused if a
    symbolic link is where a file or folder is to be written, OSError if the
    folder can't be written."""
    folder = Path(folder)
    page, table = folder / "report.html", folder / "results.csv"
    pictures = folder / "figures"
    paper = [folder / name for name in FILES]
    for path in (
        page, table, folder / "decision.html", *paper, pictures / "any"
    ):  # fmt: skip
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
    single = _choose_cases(cases, figures_of)
    with start_workers(jobs) as run:
        splits = (
            name_results(cases, run(split_case, cases)) if has_split else {}
        )
        drawn = (
            name_results(
                cases,
                run(partial(evaluate_draws, parameters=estimates), cases),
            )
            if estimates
            else {}
        )
        decision = make_decision_section(
            [decide_case(case, tell) for case in cases if has_decision]
        )
        files = [Path(path) for path in plants]
        built = list(run(partial(make_plants, plant_files=files), cases))
        shapes = [
            plants if isinstance(plants, Plants) else None for plants in built
        ]
        searched = [
            _result(study, cases, shapes, splits, drawn),
            decision,
            _gains(cases, cross, splits),
            _programme(selection),
            _places(cases, cross),
            _view(
                [
                    (case, plants)
                    for case, plants in zip(cases, shapes)
                    if plants is not None or case.fronts
                ]
            ),
            *(
                make_section(case, plants, max(1, jobs // len(single)))
                for case, plants in zip(cases, built)
                if case in single
            ),
        ]
        if len(single) == 1:
            searched[-1].is_folded = False
        sections = [
            *(searched if cases else ()),
            _paper(folder, cases, shapes),
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
    if decision.blocks:
        write_file(
            folder / "decision.html",
            render(f"Decision: {_title(every)}", _subtitle(study), [decision]),
            folder,
        )
    if any(case.pairs for case in cases):
        figures += paper
    return Written(page, figures)


def _choose_cases(
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


def _result(
    study: Study,
    cases: Sequence[Case],
    shapes: Sequence[Plants | None],
    splits: Mapping[str, Split | Note],
    drawn: Mapping[str, DrawnGains | Note],
) -> Section:
    """Returns the first screen of the page, with the leaves of the best
    plant."""
    section = Section("Result")
    for error in study.damaged:
        section.note(f"A history is left out. {error}.")
    known = [case for case in cases if case.pairs]
    if not known:
        return section
    section.blocks.append(make_answer(cases, splits, drawn))
    section.blocks += [x for x in drawn.values() if isinstance(x, Note)]
    best, plants = select_best(cases, shapes)
    of_case = f" of {best.name}, the largest gain" if len(known) > 1 else ""
    if plants is not None:
        section.draw(
            "plants",
            "How does the best plant differ from the baseline?",
            f"Baseline and best plant{of_case}, from the side, 30° off the "
            "row, at one scale.",
            partial(draw_pair, best, plants.baseline, plants.best),
        )
    section.note(_READING)
    if len(known) > 1:
        section.note(
            f"The table lists the leaves of the best plant of {best.name}, the "
            "case with the largest gain. The 3D view below shows the plants of "
            "all cases; ideotype export writes their leaves."
        )
    section.blocks.append(tabulate_leaves(best))
    return section


def _paper(
    folder: Path, cases: Sequence[Case], shapes: Sequence[Plants | None]
) -> Section:
    """Returns the page with the figure for a paper."""
    section = Section("Figure for a paper")
    if any(case.pairs for case in cases):
        section.blocks.append(make_paper_figure(folder, cases, shapes))
    return section


def _gains(
    cases: Sequence[Case],
    cross: Cross | None,
    splits: Mapping[str, Split | Note],
) -> Section:
    section = Section("Gains")
    section.draw(
        "gains",
        "How much better than the baseline are the best plants?",
        f"Mean of searches; error bars: {describe_intervals(cases)}.",
        partial(draw_gains, cases, cross),
    )
    section.draw(
        "energy",
        "Where does the light go?",
        "Fractions of incident PAR.",
        partial(draw_energy, cases),
    )
    section.blocks += tables.tabulate_gains(cases, cross)[:1]
    section.blocks += [*tabulate_splits(splits), *tabulate_scenarios(cases)]
    return section


def _programme(selection: Path | None) -> Section:
    section = Section("Breeding programme")
    if selection:
        section.blocks.append(tabulate_reach(selection))
    return section


def _about(cases: Sequence[Case], cross: Cross | None) -> Section:
    """Returns the folded section about methods and remarks."""
    section = Section("Methods and remarks", is_folded=True)
    if cases:
        section.blocks += tables.tabulate_gains(cases, cross)[1:]
        if len(cases) <= _FEW * 4:
            section.blocks += tabulate_organs(cases)
        section.blocks.append(describe_balance(cases))
    return section


def _places(cases: Sequence[Case], cross: Cross | None) -> Section:
    caption = "Top: baseline and best plants. Bottom: mean gain."
    section = Section("Places")
    if len(cases) < 2 and cross is None:
        return section
    section.draw(
        "latitudes",
        "How do absorbed PAR and gain depend on latitude?",
        caption,
        partial(draw_latitudes, cases),
    )
    section.draw(
        "spacings",
        "How do absorbed PAR and gain depend on plant density?",
        caption,
        partial(draw_spacings, cases),
    )
    section.draw(
        "gain_map",
        "Where is the gain largest?",
        "Gain over the baseline [%].",
        partial(draw_gain_map, cases),
    )
    if sets := find_sets(cases):
        section.draw(
            "set_map",
            f"Where is the best plant of {sets[0]} better than that of "
            f"{sets[1]}?",
            "Difference [%]; it is 0 on the line. Both plants are treated as "
            "independent.",
            partial(draw_set_map, cases, sets),
        )
    if cross is None:
        return section
    section.draw(
        "cross",
        "How does each plant perform in the light of each case?",
        "In % of the best plant in the same light, as the mean over the seeds "
        f"of a case. Intervals: {cross.intervals()}.",
        partial(draw_cross, cross),
    )
    return section


def _view(shapes: list[tuple[Case, Plants | None]]) -> Section:
    has_front = any(case.fronts for case, _ in shapes)
    section = Section(
        "Pareto front and its plants in 3D" if has_front else "Plants in 3D"
    )
    if shapes:
        caption = _FRONT + _VIEW if has_front else _VIEW
        section.blocks.append(Viewer(make_scene(shapes), caption))
    else:
        section.note(
            "No plants are shown; the sections of the cases state why."
        )
    return section


def _study(case: Case) -> Section:
    section = Section(f"Sensitivity of {case.name}")
    section.draw(
        f"{case.name}_indices",
        "Which factors does the objective depend on?",
        "First-order and total Sobol' indices, or elementary effects (Morris). "
        "Factors are uniformly distributed over their ranges. Evaluation noise "
        "is subtracted, except from μ*. The 15 most influential factors.",
        partial(draw_indices, case),
    )
    return section


def _provenance(cases: Sequence[Case], command: str) -> Section:
    section = Section("Provenance", tabulate_provenance(cases))
    if command:
        section.note(f"Command that made this page: {command}")
    return section
