# SPDX-License-Identifier: Apache-2.0
"""Draws the absorbed light and the assimilation of leaves by hour, leaf rank
and height, and the sunlit part of leaf area."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..history.case import Case
from ..history.file import HistoryError
from ..history.quantity import Axis, Profile
from . import style
from .style import axis_label, half_width, set_answer

_SUNLIT = "sunlit_lai_by_hour"
BY_HOUR = "assimilation_by_hour"
BY_LEAF = {"gross": "assimilation_by_leaf", "net": "net_assimilation_by_leaf"}
_ELSEWHERE = (_SUNLIT, BY_HOUR, *BY_LEAF.values())
"""Quantities that have separate figures."""

PLANTS: dict[str, dict[str, Any]] = {
    "baseline": {
        "color": style.BASELINE,
        "marker": "D",
        "linestyle": "--",
        "label": "baseline",
    },
    "best": {
        "color": style.BEST,
        "marker": "o",
        "label": "best",
    },
}
_SIZE = {"markersize": 4}


@dataclass(frozen=True)
class Course:
    """A quantity of baseline and best over the labels of an axis."""

    title: str
    """The name of the quantity, as in words()."""
    plants: Mapping[str, Profile]


def make_course(case: Case, name: str) -> Course:
    """Returns a quantity of a history as a course."""
    return Course(
        make_title(name),
        {who: getattr(case, who).profile(name) for who in PLANTS},
    )


def draw_hours(case: Case) -> Figure:
    """Draws PAR absorbed by leaves at each hour, and best minus baseline. The
    error of the difference assumes that both plants are independent. Each part
    of the light has a panel if the history distinguishes parts."""
    names = list_names(case, "hour", "hour")
    figure = draw_courses([make_course(case, name) for name in names])
    hour, more = _find_largest_difference(case, names[0])
    set_answer(
        figure,
        f"The largest difference is at {_clock(hour)}: the leaves of the best "
        f"plant absorb {more}.",
    )
    return figure


def _find_largest_difference(case: Case, name: str) -> tuple[Any, str]:
    """Returns the label of the largest difference between baseline and best
    plant, and this difference."""
    was, now = case.baseline.profile(name), case.best.profile(name)
    by = now.values - was.values
    at = int(np.argmax(np.abs(by)))
    unit = style.unit_label(now.unit)
    sense = "more" if by[at] > 0 else "less"
    return now.labels[at], f"{abs(by[at]):.3g} {unit} {sense}"


def _clock(hour: float) -> str:
    minutes = round(60 * float(hour))
    return f"{minutes // 60}:{minutes % 60:02}"


def draw_courses(courses: Sequence[Course]) -> Figure:
    """Draws quantities over the labels of an axis, and best minus baseline
    below each."""
    count = len(courses)
    figure = style.new_figure(style.WIDTH, 4.4 * count)
    grid = figure.subplots(2 * count, 1, height_ratios=(2, 1) * count)
    for (upper, lower), course in zip(grid.reshape(-1, 2), courses):
        baseline, best = course.plants["baseline"], course.plants["best"]
        _draw_course(upper, course)
        lower.axhline(0, color=style.QUIET, linewidth=1)
        lower.errorbar(
            _instants(best),
            best.values - baseline.values,
            half_width(np.hypot(best.standard_error, baseline.standard_error)),
            **PLANTS["best"] | _SIZE | {"label": None},
        )
        upper.set_ylabel(_two_lines(axis_label(course.title, best.unit)))
        lower.set_ylabel("best −\nbaseline")
        lower.set_xlabel(upper.get_xlabel())
        upper.set_xlabel("")
        labels = [label.get_text() for label in upper.get_xticklabels()]
        lower.set_xticks(upper.get_xticks(), labels)
        lower.set_xlim(upper.get_xlim())
        upper.set_xticklabels([])
        upper.legend()
    return figure


def draw_sunlit(case: Case) -> Figure:
    """Draws sunlit over all leaf area by hour [%], for baseline and best.

    Raises HistoryError if the history has no sunlit leaf area."""
    case.need_pairs()
    figure, (axes,) = new_panels(1, 3.2)
    draw_course(axes, case, _SUNLIT, over="lai", factor=100)
    axes.set_ylabel("sunlit fraction of leaf area [%]")
    axes.legend()
    was, now = (
        100 * plant.profile(_SUNLIT).values.max() / plant.estimate("lai").mean
        for plant in (case.baseline, case.best)
    )
    set_answer(
        figure,
        f"At the maximum, {now:.0f} % of the leaf area of the best plant is "
        f"sunlit, and {was:.0f} % of that of the baseline.",
    )
    return figure


def draw_course(
    axes: Axes, case: Case, name: str, over: str = "", factor: float = 1
) -> None:
    """Draws a quantity of both plants by whole hours with their clock, or by
    day; relative to another quantity if wanted."""
    plants = {}
    for who in PLANTS:
        plant = getattr(case, who)
        scale = factor / plant.estimate(over).mean if over else factor
        plants[who] = plant.profile(name).scaled(scale)
    _draw_course(axes, Course(make_title(name), plants))


def _draw_course(axes: Axes, course: Course) -> None:
    for who, looks in PLANTS.items():
        profile = course.plants[who]
        axes.errorbar(
            _instants(profile),
            profile.values,
            half_width(profile.standard_error),
            **looks | _SIZE,
        )
    lowest = min(map(_lowest, course.plants.values()))
    axes.set_ylim(bottom=min(0.0, 1.1 * lowest))
    if profile.labels.dtype.kind == "U":
        days = _instants(profile)[:: -(-len(profile.labels) // 4)]
        axes.set_xticks(days, [f"{day:%-d %b}" for day in days.tolist()])
        return
    axes.set_xlabel(f"{profile.meaning} [h]")
    first, last = np.floor(profile.labels.min()), np.ceil(profile.labels.max())
    step = max(1, round((last - first) / 8))
    axes.set_xticks(np.arange(first, last + 1, step))


def _lowest(profile: Profile) -> float:
    """Returns the lower end of the lowest error bar."""
    ends = profile.values - np.nan_to_num(half_width(profile.standard_error))
    return float(np.nanmin(ends))


def _instants(profile: Profile) -> NDArray:
    """Returns the labels as hours, or as dates."""
    is_date = profile.labels.dtype.kind == "U"
    return (
        profile.labels.astype("datetime64[D]") if is_date else profile.labels
    )


def draw_leaves(case: Case) -> Figure:
    """Draws quantities by leaf rank, such as absorbed PAR: baseline and best
    with standard errors, each quantity in a panel."""
    names = list_names(case, "leaf", "leaf rank")
    figure, panels = _draw_along(case, names)
    leaf = cast(Axis, case.best.row.with_axis("leaf")[0].axis)
    for axes in panels:
        axes.set_yticks(leaf.labels)
        axes.set_ylabel("leaf rank (1 = lowest)")
    shares = []
    for plant in (case.best, case.baseline):
        values = plant.profile(names[0]).values
        upper = values[len(values) // 2 :].sum()
        shares.append(f"{100 * upper / values.sum():.0f} %")
    set_answer(
        figure,
        f"The upper half of the leaves absorbs {shares[0]} of all light that "
        f"the leaves absorb in the best plant, and {shares[1]} in the baseline.",
    )
    return figure


def draw_layers(case: Case) -> Figure:
    """Draws quantities by height above the soil like draw_leaves(); points are
    at the middle of their layers."""
    names = list_names(case, "layer", "height layer")
    figure, panels = _draw_along(case, names)
    for axes, name in zip(panels, names):
        axes.set_ylim(0, _top(case, name))
        axes.set_ylabel("height above the soil [m]")
    heights = []
    for plant in (case.best, case.baseline):
        found = plant.profile(names[0])
        weights = found.values / found.values.sum()
        heights.append(f"{float(weights @ found.labels):.2f} m")
    set_answer(
        figure,
        f"The mean height of absorption is {heights[0]} in the best plant and "
        f"{heights[1]} in the baseline.",
    )
    return figure


def _top(case: Case, name: str) -> float:
    """Returns the height of the lowest layer that is above both plants."""
    heights: NDArray[np.float64] = case.best.profile(name).labels
    reached = [
        np.flatnonzero(getattr(case, who).profile(name).values)
        for who in PLANTS
    ]
    top = max((int(each[-1]) for each in reached if len(each)), default=0)
    if top + 1 < len(heights):
        return float(heights[top + 1])
    return float(heights[-1] + np.diff(heights, prepend=0.0)[-1])


def _draw_along(case: Case, names: list[str]) -> tuple[Figure, NDArray]:
    """Draws labels upwards and values to the right."""
    figure, panels = new_panels(len(names))
    for axes, name in zip(panels, names):
        for who, looks in PLANTS.items():
            found = getattr(case, who).profile(name)
            draw_profile(axes, found, **looks)
        axes.set_xlabel(axis_label(make_title(name), found.unit))
        axes.set_xlim(left=min(0, axes.get_xlim()[0]))
    panels[0].legend()
    return figure, panels


def list_names(case: Case, axis: str, description: str) -> list[str]:
    """Returns the quantities with an axis that have no figure elsewhere.

    Raises HistoryError if there is none."""
    case.need_pairs()
    names = [
        q.name
        for q in case.best.row.with_axis(axis)
        if q.name not in _ELSEWHERE
    ]
    if not names:
        raise HistoryError(f"the history has no quantities by {description}")
    return names


def new_panels(count: int, height: float = 3.4) -> tuple[Figure, NDArray]:
    figure = style.new_figure(style.WIDTH, height * count)
    return figure, figure.subplots(count, 1, squeeze=False)[:, 0]


def draw_profile(axes: Axes, profile: Profile, **looks: Any) -> None:
    axes.errorbar(
        profile.values, profile.labels, xerr=half_width(profile.standard_error),
        **_SIZE | looks,
    )  # fmt: skip


def make_title(name: str) -> str:
    title = style.words(name).split(" by ")[0]
    return "absorbed PAR" if title == "absorbed" else title


def _two_lines(label: str) -> str:
    return label.replace(" [", "\n[", 1)
