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
    and the caption of the figure."""

    draw: Callable[[Case], Figure]
    question: str
    caption: str


CASE_FIGURES: dict[str, CaseFigure] = {
    "convergence": CaseFigure(
        draw_convergence,
        "Has the search converged?",
        "Grey band: 95 % confidence interval of the baseline. Coloured bands: "
        "range over seeds or, with a single seed, standard deviation of the "
        "population. The trend is fitted to the second half of the generations.",
    ),
    "traits": CaseFigure(
        draw_traits,
        "Which leaf traits do the fittest plants have?",
        "Optimised traits by leaf rank; the ten fittest plants of all seeds. "
        "Orange: mean and standard deviation (circular for azimuths).",
    ),
    "profiles": CaseFigure(
        draw_profiles,
        "How do the traits of the fittest plants vary with leaf position?",
        "Optimised profiles over leaf position; the ten fittest plants. Points: "
        "genes. Factors [1] multiply the values of the baseline; other genes "
        "are added to them or replace them.",
    ),
    "plant_traits": CaseFigure(
        draw_plant_traits,
        "Which whole-plant traits do the fittest plants have?",
        "Optimised traits of the whole plant; the ten fittest plants. Factors "
        "[1] multiply the values of the baseline.",
    ),
    "azimuths": CaseFigure(
        draw_azimuths,
        "Which azimuths do the leaves of the fittest plants have?",
        "View from above. Arcs: circular standard deviation.",
    ),
    "hours": CaseFigure(
        draw_hours,
        "When do the leaves absorb light?",
        "PAR absorbed by leaves, by hour; mean over days. Error bars of the "
        "difference treat baseline and best as independent.",
    ),
    "sunlit": CaseFigure(
        draw_sunlit,
        "How much of the leaf area is sunlit?",
        "Sunlit fraction of leaf area, by hour; mean over days.",
    ),
    "assimilation": CaseFigure(
        draw_assimilation,
        "When do the leaves assimilate, and which leaves?",
        "Gross CO₂ assimilation by hour; gross and net assimilation (less leaf "
        "respiration) by leaf rank. Per ground area.",
    ),
    "days": CaseFigure(
        draw_days,
        "On which days is the best plant better?",
        "Daily values over the season. Respiration and construction cost of "
        "leaves are known as seasonal means only, and subtracted as such.",
    ),
    "leaves": CaseFigure(
        draw_leaves,
        "Which leaves absorb the light?",
        "By leaf rank, per ground area.",
    ),
    "layers": CaseFigure(
        draw_layers,
        "At which height is the light absorbed?",
        "By height layer, per ground area.",
    ),
    "parts": CaseFigure(
        draw_parts,
        "Which light is absorbed, and on which leaf side?",
        "Beam: direct sunlight. Scattered: light from other surfaces. Adaxial: "
        "upper leaf side.",
    ),
    "leaf_area": CaseFigure(
        draw_leaf_area,
        "How does leaf area develop over the season?",
        "At each evaluated plant age.",
    ),
    "carbon": CaseFigure(
        draw_carbon,
        "When does the stand gain carbon?",
        "Weekly sums since emergence, interpolated linearly between evaluated "
        "plant ages. The last week may be shorter.",
    ),
}
"""The figures by name, in the order of the page."""

_FRONT_FIGURES: dict[str, CaseFigure] = {
    "front": CaseFigure(
        draw_front,
        "How do the objectives trade off?",
        "Pareto front of each seed: no other plant is at least as good in all "
        "objectives and better in one. Open symbols: plants that are dominated "
        "after re-evaluation.",
    ),
    "hypervolume": CaseFigure(
        draw_hypervolume,
        "Does the Pareto front still improve?",
        "Hypervolume: fraction of the objective space above the reference of "
        "the seed that the Pareto front dominates. Bands: 95 % confidence "
        "intervals.",
    ),
}


_ATLAS = {
    "atlas": CaseFigure(
        draw_atlas,
        "How good can a plant of each kind be?",
        "Objective of the best plant of each kind after re-evaluation; with a "
        "third axis, the best over it. A plant that is not confirmed was "
        "evaluated only once in the search, and may lead by chance.",
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
