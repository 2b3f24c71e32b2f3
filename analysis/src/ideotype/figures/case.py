# SPDX-License-Identifier: Apache-2.0
"""The figures of one case, with captions that explain them."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from matplotlib.figure import Figure

from ..history.case import Case
from .atlas import draw_atlas
from .azimuths import draw_azimuths
from .convergence import draw_convergence
from .days import draw_days
from .front import draw_front, draw_hypervolume
from .profiles import draw_hours, draw_layers, draw_leaves, draw_sunlit
from .season import draw_carbon, draw_leaf_area
from .shape import draw_plant_traits, draw_profiles, draw_traits
from .shares import draw_assimilation, draw_parts


class CaseFigure(NamedTuple):
    """A function that draws a figure, the question that the figure answers,
    and its caption."""

    draw: Callable[[Case], Figure]
    question: str
    caption: str


CASE_FIGURES: dict[str, CaseFigure] = {
    "convergence": CaseFigure(
        draw_convergence,
        "Has the search converged?",
        "The grey band is the interval of the baseline. Coloured bands are the "
        "range of seeds or, with a single seed, the standard deviation of the "
        "population. The trend is that of the second half of the generations.",
    ),
    "traits": CaseFigure(
        draw_traits,
        "Which traits do the leaves of the fittest plants have?",
        "Bred traits by leaf of the ten fittest plants of all seeds. Orange: "
        "their mean and standard deviation, on the circle for azimuths.",
    ),
    "profiles": CaseFigure(
        draw_profiles,
        "How do traits of the fittest plants change from leaf to leaf?",
        "Bred profiles over leaf position of the ten fittest plants. Points "
        "are bred numbers; factors [1] multiply the baseline's measures, other "
        "numbers are added to them or take their place.",
    ),
    "plant_traits": CaseFigure(
        draw_plant_traits,
        "Which traits do the fittest plants have as a whole?",
        "Bred traits of the whole plant of the ten fittest plants. Factors "
        "[1] multiply the baseline's measures.",
    ),
    "azimuths": CaseFigure(
        draw_azimuths,
        "Where do the leaves of the fittest plants point?",
        "Plants are seen from above. Arcs are the circular standard "
        "deviation.",
    ),
    "hours": CaseFigure(
        draw_hours,
        "When do the leaves absorb light?",
        "PAR by hour; several days are shown by their mean. Bars of the "
        "difference take baseline and best as independent.",
    ),
    "sunlit": CaseFigure(
        draw_sunlit,
        "How much of the leaf area does the sun shine on?",
        "Sunlit over all leaf area, by hour; several days are shown by their "
        "mean.",
    ),
    "assimilation": CaseFigure(
        draw_assimilation,
        "When do the leaves assimilate, and which of them?",
        "CO₂ that leaves take up, gross by hour, and gross and net of their "
        "respiration by leaf rank, per area of ground.",
    ),
    "days": CaseFigure(
        draw_days,
        "On which days is the best plant better?",
        "Each day of the season. Respiration and the building of leaves are not "
        "known by day: where they are subtracted, each day has those of the "
        "mean day.",
    ),
    "leaves": CaseFigure(
        draw_leaves,
        "Which leaves absorb the light?",
        "By leaf rank, per area of ground.",
    ),
    "layers": CaseFigure(
        draw_layers,
        "How high above the soil is the light absorbed?",
        "By height layer, per area of ground.",
    ),
    "parts": CaseFigure(
        draw_parts,
        "Where does the absorbed light come from, and on which face?",
        "Beam comes straight from the sun, scattered light from other "
        "surfaces; adaxial is the upper face.",
    ),
    "leaf_area": CaseFigure(
        draw_leaf_area,
        "How much leaf area has the stand over the season?",
        "At each age at which plants are evaluated.",
    ),
    "carbon": CaseFigure(
        draw_carbon,
        "In which weeks does the stand gain carbon?",
        "Sums of each week since emergence; ages between those that are "
        "evaluated are linear in time. The last week may be short.",
    ),
}
"""The figures by name, in the order of the page."""

_FRONT_FIGURES: dict[str, CaseFigure] = {
    "front": CaseFigure(
        draw_front,
        "What does more of one objective cost in the other?",
        "The front has plants that no other of their seed betters in all "
        "objectives. They were evaluated again, and some fell off it then. "
        "",
    ),
    "hypervolume": CaseFigure(
        draw_hypervolume,
        "Does the front still grow?",
        "The hypervolume is the part that the front of each generation "
        "dominates of all that is better than the reference of its seed. "
        "Bands are 95 % confidence intervals.",
    ),
}


_ATLAS = {
    "atlas": CaseFigure(
        draw_atlas,
        "How good can a plant of each kind be?",
        "The objective of the best plant of each kind, evaluated again at the "
        "end; where a third quantity tells kinds apart, the best over it. A "
        "plant that is not confirmed was evaluated only once in the search, and "
        "may lead by luck.",
    )
}


def figures_of(case: Case) -> dict[str, CaseFigure]:
    """Returns the figures of a case, which begin with those of its front where
    there are several objectives, or with its atlas."""
    first = case.histories[0]
    fronts = dict(_FRONT_FIGURES)
    if first.generations().hypervolume is None:
        del fronts["hypervolume"]
    atlas = _ATLAS if case.resolved.get("search", {}).get("axes") else {}
    fronts = fronts if len(first.objectives) > 1 else {}
    return fronts | atlas | CASE_FIGURES
