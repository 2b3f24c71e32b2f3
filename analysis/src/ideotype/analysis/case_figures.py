# SPDX-License-Identifier: Apache-2.0
"""The figures of one case, and what to know when reading them."""

from __future__ import annotations

from collections.abc import Callable

from matplotlib.figure import Figure

from .case import Case
from .convergence import draw_convergence
from .correlation import draw_correlation
from .front_figures import draw_front, draw_hypervolume
from .plan import draw_roses
from .profiles import draw_hours, draw_layers, draw_leaves, draw_parts
from .sensitivity import draw_sensitivity
from .shape import (
    draw_azimuths,
    draw_plant_traits,
    draw_profiles,
    draw_traits,
)

CASE_FIGURES: dict[str, tuple[Callable[[Case], Figure], str]] = {
    "convergence": (
        draw_convergence,
        "Convergence. Error bars and the grey band are standard errors, "
        "coloured bands the range of seeds or, of a single seed, the standard "
        "deviation of the population.",
    ),
    "traits": (
        draw_traits,
        "Bred traits by leaf of the ten fittest plants of all seeds. Orange: "
        "their mean and standard deviation, on the circle for azimuths.",
    ),
    "profiles": (
        draw_profiles,
        "Bred profiles over leaf position of the ten fittest plants. Points "
        "are what is bred; factors [1] multiply the baseline's measures, "
        "other numbers are added to them or take their place.",
    ),
    "plant_traits": (
        draw_plant_traits,
        "Bred traits of the whole plant of the ten fittest plants. Factors "
        "[1] multiply the baseline's measures.",
    ),
    "azimuths": (
        draw_azimuths,
        "Leaf azimuths of the ten fittest plants from above. Arcs are the "
        "circular standard deviation.",
    ),
    "roses": (
        draw_roses,
        "Azimuth roses. The area of a wedge is the share of leaves that point "
        "there.",
    ),
    "hours": (
        draw_hours,
        "PAR by hour, of several days the mean, and then by day. Error bars are standard errors; those of the difference "
        "take baseline and best as independent.",
    ),
    "leaves": (
        draw_leaves,
        "Light by leaf rank, per area of ground. Error bars are standard errors.",
    ),
    "layers": (
        draw_layers,
        "Light by height layer, per area of ground. Error bars are standard errors.",
    ),
    "parts": (
        draw_parts,
        "Light by origin and face of the leaf. Beam comes straight from the "
        "sun, scattered light from other surfaces; adaxial is the upper face. "
        "Error bars are standard errors.",
    ),
    "sensitivity": (
        draw_sensitivity,
        "Which traits matter. Coefficients of a linear regression of the "
        "objective on all free traits over all evaluated plants, each in its "
        "standard deviations and less the mean of its seed; circular ones enter "
        "as cosine and sine and show the length of both coefficients. Hatched "
        "are traits that have no effect of their own: their variance inflation "
        "is above 10, since they go together with others, or the fittest hold "
        "them at a bound that the coefficient points away from. Bred plants are relatives, not a "
        "random sample: read it as a ranking within this evolution.",
    ),
    "correlation": (
        draw_correlation,
        "Which traits go together. Spearman's rank correlation over all "
        "evaluated plants, less the means of their seeds, circular ones as "
        "cosine and sine; what evolution fixes together correlates too.",
    ),
}
"""What draws a figure of a case, and its caption."""

_FRONT_FIGURES: dict[str, tuple[Callable[[Case], Figure], str]] = {
    "front": (
        draw_front,
        "Front. Plants that no other of their seed betters in all objectives, "
        "evaluated again, and those that fell off it then; error bars are "
        "standard errors.",
    ),
    "hypervolume": (
        draw_hypervolume,
        "Hypervolume. What the front of each generation dominates, of what is "
        "better than the reference of its seed; bands are standard errors.",
    ),
}


def figures_of(case: Case) -> dict[str, tuple[Callable[[Case], Figure], str]]:
    """Those of a case, and of several objectives first those of its front."""
    first = case.histories[0]
    fronts = dict(_FRONT_FIGURES)
    if first.generations().hypervolume is None:
        del fronts["hypervolume"]
    return (fronts if len(first.objectives) > 1 else {}) | CASE_FIGURES
