# SPDX-License-Identifier: Apache-2.0
"""The part of a report about a single case."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path

from matplotlib.figure import Figure

from ..errors import Error
from ..figures.case import figures_of
from ..figures.field import draw_field
from ..figures.front_plants import draw_front_plants
from ..figures.importance import draw_importance
from ..figures.season import DAY, choose_stages, draw_stages, read_stages
from ..history.case import Case
from ..history.file import HistoryError
from .blocks import Note, Section
from .importance import evaluate_changes
from .scene import Plants, build_plants

_FIELD = (
    "Views at eye height (1.6 m) and from above. Leaf colour: PAR absorbed "
    "over the day per leaf area, as the mean over the leaf, slightly shaded. "
    "Other organs are dull green or grey. All plants are the same, in random "
    "orientations."
)
_ALONG = (
    "The baseline, and plants at equal steps along the Pareto front in the "
    "order of the first objective; side views at one scale."
)


def make_plants(case: Case, plant_files: Sequence[Path] = ()) -> Plants | Note:
    """Returns the shapes of the plants of a case and of the user's own plants,
    or the reason why shapes are not known."""
    try:
        return build_plants(case, plant_files)
    except Error as reason:
        return Note(f"Plants are not drawn: {reason}.")


def make_section(
    case: Case, plants: Plants | Note, threads: int = 1
) -> Section:
    """Returns the section of a case. Plants with a changed trait, which take
    most of the time, are evaluated by `threads` threads."""
    section = Section(case.name, is_folded=True)
    if isinstance(plants, Note):
        section.blocks.append(plants)
    else:
        if case.fronts:
            section.draw(
                f"{case.name}_front_plants",
                "How do plants change along the Pareto front?",
                _ALONG,
                partial(
                    draw_front_plants, case, plants.baseline, plants.members
                ),
            )
        section.draw(
            f"{case.name}_field",
            "How does the optimised field look, and which leaves absorb the light?",
            _FIELD,
            partial(draw_field, case, plants.baseline, plants.best),
        )
    section.draw(
        f"{case.name}_importance",
        "Which traits cause the gain, and which are the most sensitive?",
        "The best plant with one trait changed, evaluated with common random "
        "numbers. Error bars: 95 % confidence intervals of paired differences.",
        partial(_draw_importance, case, threads),
    )
    if case.pairs and DAY in case.best.row.quantities:
        section.draw(
            f"{case.name}_stages",
            "How do the plants grow and age?",
            "Side views at one scale.",
            partial(_draw_stages, case),
        )
    for name, (draw, question, caption) in figures_of(case).items():
        section.draw(
            f"{case.name}_{name}", question, caption, partial(draw, case)
        )
    return section


def _draw_importance(case: Case, threads: int) -> Figure:
    """Draws the importance of traits.

    Raises HistoryError if plants cannot be evaluated on this machine."""
    case.need_pairs()
    try:
        changes = evaluate_changes(case, threads)
    except Error as reason:
        raise HistoryError(str(reason)) from reason
    return draw_importance(case, changes)


def _draw_stages(case: Case) -> Figure:
    """Draws baseline and best at each stage.

    Raises HistoryError if the shapes of the plants are not known."""
    times = read_stages(case).labels
    try:
        from ..stand.stand import Stand

        stand = Stand.from_history(case.best_history.path, same_isa=False)
        plants = [
            (
                name,
                [
                    stand.mesh(plant.row.genome[0], 0, float(times[k]))
                    for k in choose_stages(len(times))
                ],
            )
            for name, plant in (
                ("baseline", case.baseline), ("best", case.best),
            )
        ]  # fmt: skip
    except Error as reason:
        raise HistoryError(str(reason)) from reason
    return draw_stages(case, plants)
