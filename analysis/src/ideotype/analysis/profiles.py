# SPDX-License-Identifier: Apache-2.0
"""Draws where and when the leaves absorb and assimilate: by hour, day, leaf
rank and height; and how much of them the sun shines on."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .case import Case
from .file import HistoryError
from .quantity import Axis, Profile
from .style import label_light

_SUNLIT = "sunlit_lai_by_hour"
_BY_HOUR = "assimilation_by_hour"
_BY_LEAF = {"gross": "assimilation_by_leaf", "net": "net_assimilation_by_leaf"}
_ELSEWHERE = (_SUNLIT, _BY_HOUR, *_BY_LEAF.values())
"""Quantities that have figures of their own."""

_PLANTS: dict[str, dict[str, Any]] = {
    "baseline": {
        "color": style.BASELINE,
        "marker": "D",
        "linestyle": "--",
        "label": "baseline ± standard error",
    },
    "best": {
        "color": style.BEST,
        "marker": "o",
        "label": "best ± standard error",
    },
}
_SIZE = {"markersize": 4}


def draw_hours(case: Case) -> Figure:
    """Draws PAR absorbed by leaves at each hour, and best minus baseline. The
    error of the difference takes both as independent. Parts of the light have
    a panel each if the history tells them apart."""
    figure = _draw_courses(case, "hour")
    span = "season" if case.best.row.with_axis("day") else "day"
    kind = "" if case.best_pair.is_final else "provisional "
    gain = case.best_pair.gain.number().replace("+-", "±")
    figure.suptitle(
        f"{case.name}: {kind}gain over the {span} {gain} % (standard error)",
        fontsize=10,
    )
    return figure


def draw_days(case: Case) -> Figure:
    """Draws what is known by day of a season, as draw_hours() does by hour.

    Raises HistoryError if there is nothing by day."""
    figure = _draw_courses(case, "day")
    figure.suptitle(case.name, fontsize=10)
    return figure


def _draw_courses(case: Case, axis: str) -> Figure:
    names = _names(case, axis, axis)
    figure = style.new_figure(max(6.4, 3.6 * len(names)), 5.2)
    grid = figure.subplots(
        2, len(names), sharex="col", height_ratios=(2, 1), squeeze=False
    )
    for (upper, lower), name in zip(grid.T, names):
        baseline, best = case.baseline.profile(name), case.best.profile(name)
        _draw_course(upper, case, name)
        lower.axhline(0, color=style.QUIET, linewidth=1)
        lower.errorbar(
            _instants(best),
            best.values - baseline.values,
            np.hypot(best.standard_error, baseline.standard_error),
            **_PLANTS["best"] | _SIZE | {"label": None},
        )
        label_light(upper, "y", _title(name), best.unit)
        lower.set_ylabel(style.axis_label("best − baseline\n", best.unit))
        lower.set_xlabel(upper.get_xlabel())
        upper.set_xlabel("")
        upper.legend()
    return figure


def draw_sunlit(case: Case) -> Figure:
    """Draws sunlit over all leaf area by hour [%], for baseline and best.

    Raises HistoryError if the history does not tell it."""
    case.need_pairs()
    figure, (axes,) = _panels(case, 1, 3.2)
    _draw_course(axes, case, _SUNLIT, over="lai", factor=100)
    axes.set_ylabel("sunlit part of the leaf area [%]")
    axes.legend(fontsize=8)
    return figure


def _draw_course(
    axes: Axes, case: Case, name: str, over: str = "", factor: float = 1
) -> None:
    """Draws both plants by day, or by whole hours, as many as there is room for, and
    their clock; over another quantity if that is wanted."""
    for who, looks in _PLANTS.items():
        plant = getattr(case, who)
        found = plant.profile(name)
        scale = factor / plant.estimate(over).mean if over else factor
        axes.errorbar(
            _instants(found),
            scale * found.values,
            scale * found.standard_error,
            **looks | _SIZE,
        )
    axes.set_ylim(bottom=0)
    if found.labels.dtype.kind == "U":
        days = _instants(found)[:: -(-len(found.labels) // 8)]
        axes.set_xticks(days, [f"{day:%-d %b}" for day in days.tolist()])
        return
    axes.set_xlabel(f"{found.meaning} [h]")
    first, last = np.floor(found.labels.min()), np.ceil(found.labels.max())
    step = max(1, round((last - first) / 14))
    axes.set_xticks(np.arange(first, last + 1, step))


def _instants(found: Profile) -> NDArray:
    """Returns the labels as hours, or as dates."""
    is_date = found.labels.dtype.kind == "U"
    return found.labels.astype("datetime64[D]") if is_date else found.labels


def draw_leaves(case: Case) -> Figure:
    """Draws what is known by leaf rank, such as absorbed PAR: baseline and
    best with standard errors, a panel each."""
    figure, panels = _draw_along(case, _names(case, "leaf", "leaf rank"))
    leaf = cast(Axis, case.best.row.with_axis("leaf")[0].axis)
    for axes in panels:
        axes.set_yticks(leaf.labels)
    panels[0].set_ylabel("leaf rank (1 = lowest)")
    return figure


def draw_layers(case: Case) -> Figure:
    """Draws what is known by height above the soil, as by leaf rank; points
    are at the middle of their layers."""
    figure, panels = _draw_along(case, _names(case, "layer", "height layer"))
    for axes in panels:
        axes.set_ylim(bottom=0)
    panels[0].set_ylabel("height above the soil [m]")
    return figure


def _draw_along(case: Case, names: list[str]) -> tuple[Figure, NDArray]:
    """Draws labels upwards and values to the right."""
    figure, panels = _panels(case, len(names))
    for axes, name in zip(panels, names):
        for who, looks in _PLANTS.items():
            found = getattr(case, who).profile(name)
            _draw(axes, found, **looks)
        label_light(axes, "x", _title(name), found.unit)
        axes.set_xlim(left=min(0, axes.get_xlim()[0]))
    panels[0].legend(fontsize=8)
    return figure, panels


def draw_parts(case: Case) -> Figure:
    """Draws light that leaves absorb by origin, face of the leaf, or whatever
    else has words for labels and the objective's unit."""
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
        raise HistoryError("the history does not tell parts of the light")
    words = [w for name in names for w in case.best.profile(name).labels]
    figure, (axes,) = _panels(case, 1, 1.6 + 0.45 * len(words))
    place = np.arange(len(words))
    for (who, looks), shift in zip(_PLANTS.items(), (-0.15, 0.15)):
        parts = [getattr(case, who).profile(name) for name in names]
        values, errors = (
            np.concatenate([getattr(part, what) for part in parts])
            for what in ("values", "standard_error")
        )
        found = Profile(place + shift, unit, values, errors)
        _draw(axes, found, **looks | {"linestyle": "none"})
    axes.set_yticks(place, words)
    axes.set_ylim(len(words) - 0.5, -0.5)
    axes.set_xlim(left=0)
    label_light(axes, "x", _title(names[0]), unit)
    axes.legend(fontsize=8)
    return figure


def draw_assimilation(case: Case) -> Figure:
    """Draws gross assimilation by hour above, gross and net by leaf rank
    below, as far as the history tells them, for baseline and best.

    Raises HistoryError if it tells none."""
    case.need_pairs()
    known = case.best.row.quantities
    by_leaf = {kind: n for kind, n in _BY_LEAF.items() if n in known}
    count = (_BY_HOUR in known) + bool(by_leaf)
    if not count:
        raise HistoryError("the history has no assimilation by leaf or hour")
    figure = style.new_figure(5.4, 0.8 + 3.0 * count)
    panels = list(figure.subplots(count, 1, squeeze=False)[:, 0])
    if _BY_HOUR in known:
        axes = panels.pop(0)
        _draw_course(axes, case, _BY_HOUR)
        unit = style.unit_label(known[_BY_HOUR].unit).replace("umol", "µmol")
        axes.set_ylabel(f"gross assimilation\n[{unit} of ground]")
        axes.legend(fontsize=8)
    for axes in panels:
        for who, looks in _PLANTS.items():
            for kind, name in by_leaf.items():
                found = getattr(case, who).profile(name)
                own: dict[str, Any] = {"label": f"{who}, {kind}"}
                if kind == "net":
                    own |= {"alpha": 0.55, "fillstyle": "none"}
                _draw(axes, found, **looks | own)
        unit = style.unit_label(found.unit)
        axes.set_xlabel(f"assimilation [{unit} of ground]")
        axes.set_ylabel("leaf rank (1 = lowest)")
        axes.set_yticks(found.labels)
        axes.set_xlim(left=min(0, axes.get_xlim()[0]))
        axes.legend(fontsize=8)
    figure.suptitle(case.name, fontsize=10)
    return figure


def _names(case: Case, axis: str, what: str) -> list[str]:
    case.need_pairs()
    names = [
        q.name
        for q in case.best.row.with_axis(axis)
        if q.name not in _ELSEWHERE
    ]
    if not names:
        raise HistoryError(f"the history has no figures by {what}")
    return names


def _panels(
    case: Case, count: int, height: float = 4.2
) -> tuple[Figure, NDArray]:
    figure = style.new_figure(max(5.2, 3.4 * count), height)
    panels = figure.subplots(1, count, sharey=True, squeeze=False)[0]
    figure.suptitle(case.name, fontsize=10)
    return figure, panels


def _draw(axes: Axes, found: Profile, **looks: Any) -> None:
    axes.errorbar(
        found.values, found.labels, xerr=found.standard_error,
        **_SIZE | looks,
    )  # fmt: skip


def _title(name: str) -> str:
    what = style.words(name).split(" by ")[0]
    return "absorbed PAR" if what == "absorbed" else what
