# SPDX-License-Identifier: Apache-2.0
"""Draws parts of the light that leaves absorb, and their assimilation."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ..history.case import Case
from ..history.file import HistoryError
from ..history.quantity import Profile
from . import style
from .profiles import (
    BY_HOUR,
    BY_LEAF,
    PLANTS,
    draw_course,
    draw_profile,
    make_title,
)
from .style import axis_label, set_answer


def draw_parts(case: Case) -> Figure:
    """Draws the absorbed light of leaves by origin, by face of the leaf, or by
    any axis with words as labels, in the unit of the objective."""
    case.need_pairs()
    unit = case.best.objective.unit
    names = [
        q.name
        for q in case.best.row.quantities.values()
        if q.axis
        and q.axis.labels.dtype.kind == "U"
        and q.axis.name not in ("organ", "day")
        and q.unit == unit
    ]
    if not names:
        raise HistoryError(
            "the history does not distinguish parts of the light"
        )
    counts = [len(case.best.profile(name).labels) for name in names]
    figure = style.new_figure(
        style.WIDTH, 1.0 + sum(0.5 + 0.45 * count for count in counts)
    )
    panels = figure.subplots(
        len(names), 1, squeeze=False, sharex=True, height_ratios=counts
    )[:, 0]
    for axes, name, count in zip(panels, names, counts):
        for (who, looks), shift in zip(PLANTS.items(), (-0.15, 0.15)):
            part = getattr(case, who).profile(name)
            place = np.arange(count) + shift
            profile = Profile(place, unit, part.values, part.standard_error)
            draw_profile(axes, profile, **looks | {"linestyle": "none"})
        axes.set_yticks(range(count), part.labels)
        axes.set_ylim(count - 0.5, -0.5)
    panels[-1].set_xlim(left=0)
    panels[-1].set_xlabel(axis_label(make_title(names[0]), unit))
    panels[0].legend()
    now, was = (
        plant.profile(names[0]) for plant in (case.best, case.baseline)
    )
    change = now.values - was.values
    at = int(np.argmax(np.abs(change)))
    sense = "more" if change[at] > 0 else "less"
    set_answer(
        figure,
        f"The largest difference is in {now.labels[at]}: the best plant "
        f"absorbs {abs(change[at]):.3g} {style.unit_label(unit)} {sense}.",
    )
    return figure


def draw_assimilation(case: Case) -> Figure:
    """Draws gross assimilation by hour above, gross and net by leaf rank
    below, as far as the history has these quantities, for baseline and best.

    Raises HistoryError if the history has no assimilation."""
    case.need_pairs()
    known = case.best.row.quantities
    by_leaf = {kind: n for kind, n in BY_LEAF.items() if n in known}
    count = (BY_HOUR in known) + bool(by_leaf)
    if not count:
        raise HistoryError("the history has no assimilation by leaf or hour")
    figure = style.new_figure(style.WIDTH, 0.8 + 3.0 * count)
    panels = list(figure.subplots(count, 1, squeeze=False)[:, 0])
    if BY_HOUR in known:
        axes = panels.pop(0)
        draw_course(axes, case, BY_HOUR)
        unit = style.unit_label(known[BY_HOUR].unit).replace("umol", "µmol")
        axes.set_ylabel(f"gross assimilation\n[{unit} of ground]")
        axes.legend()
    for axes in panels:
        for who, looks in PLANTS.items():
            for kind, name in by_leaf.items():
                profile = getattr(case, who).profile(name)
                changes: dict[str, Any] = {"label": f"{who}, {kind}"}
                if kind == "net":
                    changes |= {"alpha": 0.55, "fillstyle": "none"}
                draw_profile(axes, profile, **looks | changes)
        unit = style.unit_label(profile.unit)
        axes.set_xlabel(f"assimilation [{unit} of ground]")
        axes.set_ylabel("leaf rank (1 = lowest)")
        axes.set_yticks(profile.labels)
        axes.set_xlim(left=min(0, axes.get_xlim()[0]))
        axes.legend()
    total = [
        plant.estimate("gross_assimilation")
        for plant in (case.best, case.baseline)
        if "gross_assimilation" in known
    ]
    if len(total) == 2:
        unit = style.unit_label(total[0].unit)
        set_answer(
            figure,
            f"Gross assimilation is {total[0].mean:.3g} {unit} in the best "
            f"plant and {total[1].mean:.3g} in the baseline.",
        )
    return figure
